"""What a command ends with."""

DONE, BAD_INPUT, IMPOSSIBLE = 0, 2, 3
