"""Values as the compiler lays them in memory: kept where kernels find them, read and written by plain Python.

Handing a tuple of a hundred arrays to a kernel takes longer than many a kernel; an address takes no time. The compiler's array
is two owners (none here), its items and their size, where the data lie, its shape and its strides; its tuple is a C struct.
"""

import ctypes
from functools import cache
from typing import Any, Generic, TypeVar, get_type_hints

import numba
import numpy as np

Value = TypeVar("Value", bound=tuple)
_NUMBERS = {int: ctypes.c_int64, float: ctypes.c_double, bool: ctypes.c_uint8}


class Held(Generic[Value]):
    """A value that is held at an `address`, together with the arrays in it, for as long as this lives."""

    def __init__(self, value: Value, kind: Any) -> None:
        """kind: the compiler's type that whoever opens it expects (Handle.kind). Raises TypeError for another one."""
        found = numba.typeof(value)
        if found != kind:
            raise TypeError(f"a value of type {found} cannot be held as {kind}")
        self.value = value
        self._memory = _in_memory(value)
        self.address = ctypes.addressof(self._memory)


def _in_memory(value: Any) -> Any:
    """A number, an array or a tuple of them, laid out."""
    if isinstance(value, tuple):
        return _struct_of(tuple(_in_memory(member) for member in value))
    if isinstance(value, np.ndarray):
        numbers = (0, 0, value.size, value.itemsize, value.ctypes.data, *value.shape, *value.strides)
        return (ctypes.c_int64 * len(numbers))(*numbers)
    return np.ctypeslib.as_ctypes_type(np.asarray(value).dtype)(value)


def _struct_of(members: tuple) -> Any:
    fields = [(f"field{k}", type(member)) for k, member in enumerate(members)]
    return type("Struct", (ctypes.Structure,), {"_fields_": fields})(*members)


@cache
def _layout(kind: type) -> Any:
    """How a NamedTuple of numbers, and of such tuples, lies in memory."""
    fields = [(name, _NUMBERS.get(hint) or _layout(hint)) for name, hint in get_type_hints(kind).items()]
    return type(kind.__name__, (ctypes.Structure,), {"_fields_": fields})


def read(kind: type, address: int) -> Any:
    """The tuple of numbers, of this NamedTuple's class, that lies at an address."""
    return _tuple_of(kind, _layout(kind).from_address(address))


def _tuple_of(kind: type, memory: Any) -> Any:
    hints = get_type_hints(kind)
    values = {name: getattr(memory, name) for name in hints}
    return kind(*(hint(values[name]) if hint in _NUMBERS else _tuple_of(hint, values[name]) for name, hint in hints.items()))


def write(kind: type, value: Any, address: int) -> None:
    """Puts a tuple of numbers where the compiler looks for it. Raises TypeError, ValueError for one of another form."""
    memory = _memory_of(kind, value)
    ctypes.memmove(address, ctypes.byref(memory), ctypes.sizeof(memory))


def _memory_of(kind: type, value: Any) -> Any:
    if not isinstance(value, kind):
        raise TypeError(f"{value!r}: a {kind.__module__}.{kind.__name__} is needed")
    parts = [(hint, getattr(value, name)) for name, hint in get_type_hints(kind).items()]
    return _layout(kind)(*(hint(part) if hint in _NUMBERS else _memory_of(hint, part) for hint, part in parts))
