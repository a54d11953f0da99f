"""Text files of other programs: read in bounds, every number by its line."""

from math import isfinite
from pathlib import Path

from worlds import reading
from worlds.errors import InputError

LARGEST = 200_000_000
"""Bytes of a file that is read at all."""
FARTHEST = 1e7
"""No number of a place, a time or an identity is larger than this, in whatever unit."""
SAID = 8
"""So many faults are told one by one."""
MISSING = ("", "na", "nan", "-")
"""How a value is written that nobody has measured."""


def text_of(path: str | Path, what: str, most: int = LARGEST) -> str:
    """What a text file holds. Raises InputError where it cannot be read, is too large, or is no text."""
    raw = content_of(path, what, most)
    try:
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        place = f"byte {error.start} is {raw[error.start]:#04x}"
        raise InputError(f"{path}: is no text in UTF-8 ({place}); {what} is a text file") from None


def content_of(path: str | Path, what: str, most: int = LARGEST) -> bytes:
    """What a file holds. Raises InputError where it cannot be read or is too large."""
    try:
        raw = reading.content_of(Path(path), most)
    except IsADirectoryError:
        raise InputError(f"{path}: is a folder; {what} is a file") from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise InputError(f"{path}: cannot be read: {reason}{_beside(path)}") from None
    if raw is None:
        raise InputError(f"{path}: more than {most:,} bytes; {what} has at most that many")
    return raw


def _beside(path: str | Path) -> str:
    """The nearest of the names in the same folder, where there is one."""
    try:
        names = [one.name for one in Path(path).parent.iterdir()][:10_000]
    except (OSError, ValueError):
        return ""
    return reading.nearest(Path(path).name[:100], names)


def number(text: str) -> float | None:
    """The number that a word says, None where it says none that can be used."""
    try:
        value = float(text)
    except ValueError:
        return None
    return value if isfinite(value) and abs(value) <= FARTHEST else None


def is_missing(text: str) -> bool:
    """Whether a word says that there is no value."""
    return text.strip().lower() in MISSING


def refuse(path: str | Path, faults: list[str]) -> None:
    """Raises InputError with the faults of a file, where there are any."""
    if faults:
        more = [f"and {len(faults) - SAID} more like these"] if len(faults) > SAID else []
        raise InputError("\n".join(f"{path}: {fault}" for fault in [*faults[:SAID], *more]))
