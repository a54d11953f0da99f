"""A command: a change of a running simulation, as plain values that can be logged, kept and done again."""

from dataclasses import asdict, dataclass, fields
from numbers import Integral, Real
from typing import Any, ClassVar, get_type_hints

import numpy as np

from motion.track.footprints import Step
from sim.stage.simulation import Simulation
from worlds.errors import InputError

_WORDS = {float: "a number", int: "a whole number", bool: "true or false", str: "text", dict: "a table", tuple: "Steps"}


@dataclass(frozen=True)
class Command:
    """A change of a running simulation. Its values are plain, whatever kinds of numbers they were given as."""

    name: ClassVar[str]

    def __post_init__(self) -> None:
        """Raises InputError for a value of another type than the field's."""
        hints = get_type_hints(type(self))
        for field in fields(self):
            said = f"{self.name}: {field.name}"
            object.__setattr__(self, field.name, plain(getattr(self, field.name), hints[field.name], said))

    def apply(self, sim: Simulation) -> None:
        """Does it, or raises InputError or NoWay and does nothing."""
        raise NotImplementedError

    def as_plain(self) -> dict:
        """The command as plain JSON values."""
        return {"command": self.name, **{k: list(v) if isinstance(v, tuple) else v for k, v in asdict(self).items()}}


def plain(value: Any, kind: Any, said: str) -> Any:
    """A value as Python's own number, text or table of its kind; or raises InputError, which begins with `said`."""
    origin = getattr(kind, "__origin__", kind)
    if origin is tuple and kind.__args__[0] is not Step:
        return _plain_many(value, kind.__args__[0], said)
    if origin is tuple and isinstance(value, (list, tuple)):
        return tuple(_plain_step(step, f"{said}.{k}") for k, step in enumerate(value))
    whole = isinstance(value, Integral) and not isinstance(value, bool)
    if origin is bool and type(value).__name__ in ("bool", "bool_"):
        return bool(value)
    if (origin is int and whole) or (origin is float and (whole or isinstance(value, Real)) and not isinstance(value, bool)):
        return origin(value)  # type: ignore[operator]
    if origin in (str, dict) and isinstance(value, origin):
        return value
    raise InputError(f"{said} = {value!r}: {_WORDS[origin]} is needed")


def _plain_many(values: Any, kind: type, said: str) -> tuple:
    """A value, or several in a list, tuple or array, as a tuple of plain ones."""
    if isinstance(values, np.ndarray):
        values = values.tolist()
    several = values if isinstance(values, (list, tuple)) else (values,)
    return tuple(plain(value, kind, f"{said}.{k}") for k, value in enumerate(several))


def _plain_step(step: Any, said: str) -> Step:
    """A Step, or the table that one was logged as."""
    values, hints = step._asdict() if isinstance(step, Step) else step, get_type_hints(Step)
    needed = {"side", "x", "y", "heading"}
    if not isinstance(values, dict) or not needed <= set(values) <= set(hints):
        raise InputError(f"{said} = {step!r}: a motion.track.footprints.Step is needed")
    return Step(**{name: plain(value, hints[name], f"{said}.{name}") for name, value in values.items()})


def check_character(sim: Simulation, character: int) -> None:
    """Raises InputError where no character has that number."""
    if not 0 <= character < len(sim.characters):
        raise InputError(f"character {character}: there are {len(sim.characters)}, counted from 0")
