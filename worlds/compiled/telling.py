"""Words to whoever waits: on stderr, and never a reason to stop."""

import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress

SILENCE = 2.0
"""Seconds after which it is said that something still goes on."""


def tell(text: str, end: str = "\n") -> None:
    """Says something on stderr, where somebody listens: a terminal may have been closed, a pipe read to its end."""
    _Work.said, _Work.known = time.monotonic(), True
    if sys.stderr is not None:
        with suppress(OSError, ValueError):
            print(text, end=end, file=sys.stderr, flush=True)


def is_watched() -> bool:
    """Whether it is a terminal that is told, on which a line can be written over."""
    with suppress(AttributeError, ValueError):
        return sys.stderr.isatty()
    return False


class _Work:
    """What is being waited for: how deep in it we are, when something was last said, if anything was."""

    lock = threading.Lock()
    depth = 0
    said = 0.0
    quiet = known = False
    watch: threading.Thread | None = None


def be_quiet() -> None:
    """From now on somebody else says that this goes on."""
    _Work.quiet = True


@contextmanager
def compiling() -> Iterator[None]:
    """While this lasts, there is a word every few seconds."""
    begin()
    try:
        yield
    finally:
        end()


def begin() -> None:
    """Something is compiled from now on; that may need something else to be compiled first."""
    with _Work.lock:
        _Work.depth += 1
        if _Work.depth == 1:
            if _Work.watch is None and not _Work.quiet:
                _Work.said = max(_Work.said, time.monotonic() - SILENCE / 2)
                _Work.watch = threading.Thread(target=_watch, daemon=True)
                _Work.watch.start()


def end() -> None:
    """It is done."""
    with _Work.lock:
        _Work.depth -= 1


def _watch() -> None:
    """Speaks whenever it was silent for too long; goes when nothing has been compiled for a while."""
    idle = 0
    while True:
        time.sleep(SILENCE / 4)
        with _Work.lock:
            idle = 0 if _Work.depth else idle + 1
            if idle > 4:
                _Work.watch = None
                return
        if _Work.depth and time.monotonic() - _Work.said > SILENCE:
            tell("  ... still compiling" if _Work.known else "compiling, once for these sources and this machine ...")
