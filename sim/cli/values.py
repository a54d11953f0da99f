"""What is typed behind options, as numbers; what cannot be is refused with what is allowed. It needs nothing but Python."""

import argparse


def _number(text: str, kind: type, allowed: str) -> float:
    try:
        return kind(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r}: {allowed} is allowed") from None


def _checked(text: str, value: float, fits: bool, allowed: str) -> float:
    """The value, where it fits."""
    if not fits:
        raise argparse.ArgumentTypeError(f"{text}: {allowed} is allowed")
    return value


def _whole(text: str, low: int, below: int, allowed: str) -> int:
    value = int(_number(text, int, allowed))
    return int(_checked(text, value, low <= value < below, allowed))


def _up_to(text: str, most: float) -> float:
    allowed = f"more than 0, at most {most:.0f},"
    value = float(_number(text, float, allowed))
    return _checked(text, value, 0 < value <= most, allowed)


def positive(text: str) -> int:
    """How many characters or processes."""
    return _whole(text, 1, 100_001, "a whole number, 1 to 100000,")


def index(text: str) -> int:
    """Which of several; how many there are is known later."""
    return int(_number(text, int, "a whole number, from 0,"))


def length(text: str) -> float:
    """Metres, and other sizes of things."""
    return _up_to(text, 1e3)


def seconds(text: str) -> float:
    """Simulated seconds."""
    return _up_to(text, 1e6)


def seed(text: str) -> int:
    """Of chance."""
    return _whole(text, 0, 2**63, "a whole number, 0 or more, below 2^63,")


def seeds(text: str) -> tuple[int, int]:
    """From the first on, up to but not the last."""
    first, _, last = text.partition(":")
    if not (first.isdigit() and last.isdigit() and int(first) < int(last) < 2**63):
        raise argparse.ArgumentTypeError(f"{text}: A:B is allowed, whole numbers, A less than B, as in 0:100")
    return int(first), int(last)


def size(text: str) -> tuple[int, int]:
    """Of a picture [pixels]."""
    width, _, height = text.lower().partition("x")
    if not (width.isdigit() and height.isdigit() and 64 <= int(width) <= 8192 and 64 <= int(height) <= 8192):
        raise argparse.ArgumentTypeError(f"{text}: WIDTHxHEIGHT in pixels, 64 to 8192 each, as in 960x540")
    return int(width), int(height)
