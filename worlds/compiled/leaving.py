"""What is to be done when the program ends at once: nothing half made is left, and no child goes on."""

from collections.abc import Callable
from contextlib import suppress

_LAST: dict[object, Callable[[], object]] = {}


def remember(what: object, last: Callable[[], object]) -> None:
    """From now on `last` is done for this where the program ends at once."""
    _LAST[what] = last


def forget(what: object) -> None:
    """It has come to its own end."""
    _LAST.pop(what, None)


def leave_nothing() -> None:
    """Does what there is to do."""
    for last in list(_LAST.values()):
        with suppress(OSError, ValueError):
            last()
