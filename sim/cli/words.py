"""What is said on stdout: a disk may be full there, too, and whoever reads may have read enough."""

import os
import sys
from contextlib import suppress

from sim.cli.status import BAD_INPUT


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
    """Says that stdout takes nothing more; returns the exit status."""
    forget_stdout()
    with suppress(OSError, ValueError):
        print(f"footfall: standard output: cannot be written: {error.strerror or error}", file=sys.stderr, flush=True)
    return BAD_INPUT
