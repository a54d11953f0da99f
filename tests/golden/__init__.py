"""Runs whose every bit is kept: what a change of the house must not change."""
