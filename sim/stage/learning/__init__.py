"""Worlds to learn in: a footprint is an action."""
