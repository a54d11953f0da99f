"""What a command ends with. One that a signal has ended: 128 and its number, as 130 for Ctrl-C."""

DONE, FAULT, BAD_INPUT, IMPOSSIBLE = 0, 1, 2, 3
"""Done; a fault of the program itself; bad usage or input; a task that cannot be done."""
