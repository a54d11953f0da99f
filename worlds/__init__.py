"""Worlds: terrain, trees, rivers and rocks, with the questions that planners ask."""
