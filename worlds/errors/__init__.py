"""Faults of what a person handed in."""


class InputError(ValueError):
    """Bad input. The message names every fault: file, key, value, what is allowed. Ends a command with status 2."""
