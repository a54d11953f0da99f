"""Tuples as the compiler lays them in memory: how plain Python reads and answers what a round asks, and hands plans to it."""

import ctypes
from functools import cache
from typing import Any, get_type_hints

import numpy as np

_NUMBERS = {int: ctypes.c_int64, float: ctypes.c_double, bool: ctypes.c_uint8}


@cache
def _layout(kind: type) -> Any:
    """How a NamedTuple of numbers, and of such tuples, lies in memory."""
    fields = [(name, _NUMBERS.get(hint) or _layout(hint)) for name, hint in get_type_hints(kind).items()]
    return type(kind.__name__, (ctypes.Structure,), {"_fields_": fields})


def read(kind: type, address: int) -> Any:
    """The tuple of this kind that lies at an address."""
    return _tuple_of(kind, _layout(kind).from_address(address))


def _tuple_of(kind: type, memory: Any) -> Any:
    hints = get_type_hints(kind)
    values = {name: getattr(memory, name) for name in hints}
    return kind(*(hint(values[name]) if hint in _NUMBERS else _tuple_of(hint, values[name]) for name, hint in hints.items()))


def write(kind: type, value: Any, address: int) -> None:
    """Puts a tuple where the compiler looks for it. Raises TypeError, ValueError for one of another form."""
    memory = _memory_of(kind, value)
    ctypes.memmove(address, ctypes.byref(memory), ctypes.sizeof(memory))


def _memory_of(kind: type, value: Any) -> Any:
    if not isinstance(value, kind):
        raise TypeError(f"next_step returned {value!r}; a planner.round.round.{kind.__name__} is needed")
    parts = [(hint, getattr(value, name)) for name, hint in get_type_hints(kind).items()]
    return _layout(kind)(*(hint(part) if hint in _NUMBERS else _memory_of(hint, part) for hint, part in parts))


def as_memory(arrays: tuple) -> np.ndarray:
    """Numbers (int64) that are, where they lie, the NamedTuple of these arrays; the arrays must outlive their use.

    The compiler's array is two owners (none), its items and their size, where the data lie, its shape and its strides.
    """
    rows = [(0, 0, array.size, array.itemsize, array.ctypes.data, *array.shape, *array.strides) for array in arrays]
    return np.array([number for row in rows for number in row], np.int64)
