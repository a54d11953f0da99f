"""What a command ends with, and that it is said: stdout may be full, and whoever reads may have read enough.

One that a signal has ended: 128 and its number, as 130 for Ctrl-C.
"""

import os
import sys
from contextlib import suppress

DONE, FAULT, BAD_INPUT, IMPOSSIBLE = 0, 1, 2, 3
"""Done; a fault of the program itself; bad usage or input; a task that cannot be done."""


def takes_words() -> bool:
    """Whether stdout takes anything more: an empty line, as what it has refused before it may have forgotten."""
    try:
        print(flush=True)
    except (OSError, ValueError):
        return False
    return True


def forget_stdout() -> None:
    """What is still to be written goes nowhere: else Python would complain once more at its end."""
    with suppress(OSError, ValueError, AttributeError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def refuse_words(error: OSError) -> int:
    """Says that stdout takes nothing more; returns the exit status. Nothing is said of whoever has read enough."""
    forget_stdout()
    if isinstance(error, BrokenPipeError):
        return DONE
    with suppress(OSError, ValueError):
        print(f"footfall: standard output: cannot be written: {error.strerror or error}", file=sys.stderr, flush=True)
    return BAD_INPUT
