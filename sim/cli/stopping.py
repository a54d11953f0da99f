"""Ctrl-C and its kin: a run that is stopped leaves whole what it has made so far.

Anything else is ended at once, and so is a run by the second signal. A thread listens: the first one may be in the compiler
for half a minute, which hears nothing and swallows what is raised meanwhile.
"""

import os
import signal
import socket
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress

from worlds.compiled.leaving import leave_nothing
from worlds.compiled.telling import tell

KINDS = [getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGBREAK") if hasattr(signal, name)]


class Stopped(Exception):
    """A signal has stopped a run between two ticks."""

    def __init__(self, number: int) -> None:
        super().__init__(f"stopped by {signal.Signals(number).name}")
        self.status = 128 + number
        """The exit status by which shells know what happened: 130 for Ctrl-C, 143 for SIGTERM."""


class _Wish:
    """Whether a run goes on that can be stopped between two ticks, and the signal that has asked it to."""

    running = False
    asked: int | None = None


def _heard(number: int) -> None:
    name = signal.Signals(number).name
    if _Wish.running and _Wish.asked is None:
        _Wish.asked = number
        tell(f"\n{name}: stopping, and keeping what there is so far; once more ends at once.")
        return
    leave_nothing()
    tell(f"footfall: ended by {name}")
    os._exit(128 + number)


def _listen(ear: socket.socket) -> None:
    with suppress(OSError):
        while numbers := ear.recv(16):
            for number in numbers:
                _heard(number)


@contextmanager
def listening() -> Iterator[None]:
    """While this lasts, signals are heard, but for those that were not to be (nohup)."""
    if threading.current_thread() is not threading.main_thread():  # only that one is told of signals
        yield
        return
    ear, mouth = socket.socketpair()
    mouth.setblocking(False)
    thread = threading.Thread(target=_listen, args=(ear,), daemon=True)
    thread.start()
    heard_before = signal.set_wakeup_fd(mouth.fileno(), warn_on_full_buffer=False)
    before = {kind: signal.getsignal(kind) for kind in KINDS if signal.getsignal(kind) != signal.SIG_IGN}
    for kind in before:
        signal.signal(kind, lambda number, frame: None)
    try:
        yield
    finally:
        for kind, handler in before.items():
            signal.signal(kind, handler)
        signal.set_wakeup_fd(heard_before)
        mouth.close()
        if not sys.is_finalizing():
            thread.join(1.0)
        ear.close()


@contextmanager
def between_ticks() -> Iterator[None]:
    """While this lasts, the first signal is only noted: `asked`. Raises Stopped afterwards where there was one."""
    _Wish.running, _Wish.asked = True, None
    try:
        yield
    finally:
        _Wish.running, number, _Wish.asked = False, _Wish.asked, None
    if number is not None:
        raise Stopped(number)


def asked() -> bool:
    """Whether the run is to stop."""
    return _Wish.asked is not None
