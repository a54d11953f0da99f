"""Programs in parts: kernels that are compiled by themselves, and arguments that are handed on by their address.

The compiler takes whatever a kernel calls into it and works on all of it once more, and a parallel loop takes every array that
it uses apart. Here the crowd's loop knows of the planning and the optimising of a step no more than where they lie.
"""

from collections.abc import Callable
from functools import cached_property
from typing import Any, NamedTuple

import numba
from llvmlite import ir
from numba.core import cgutils, types

from worlds.compiled.jit import compiled_callback, intrinsic


class Part:
    """A kernel of so many numbers (int64) that is compiled by itself, and called by where it lies."""

    def __init__(self, kernel: Callable, numbers: int = 2) -> None:
        self.kernel, self.numbers = kernel, numbers

    @cached_property
    def address(self) -> int:
        """Where it lies; compiled, or loaded from the cache, the first time that one asks."""
        self._kept_alive = compiled_callback(self.kernel, types.void(*[types.int64] * self.numbers))
        return self._kept_alive.address or 0

    def compile(self, signature: tuple = ()) -> int:
        """As a kernel's `compile` does for types of arguments; a Part's are fixed."""
        return self.address


def _call(builder, arguments):
    """Calls what lies at the first of the arguments with the others."""
    kind = ir.FunctionType(ir.VoidType(), [ir.IntType(64)] * (len(arguments) - 1))
    builder.call(builder.inttoptr(arguments[0], kind.as_pointer()), arguments[1:])


@intrinsic
def call(_, part, first, second):
    """Calls the Part of two numbers that lies at `part`."""

    def codegen(context, builder, signature, arguments):
        _call(builder, arguments)
        return context.get_dummy_value()

    return types.none(types.int64, types.int64, types.int64), codegen


@intrinsic
def call_three(_, part, first, second, third):
    """Calls the Part of three numbers that lies at `part`."""

    def codegen(context, builder, signature, arguments):
        _call(builder, arguments)
        return context.get_dummy_value()

    return types.none(types.int64, types.int64, types.int64, types.int64), codegen


@intrinsic
def take(_, counter):
    """The next number of an array's first element (int64), no thread's but this one's: who is done early takes more."""

    def codegen(context, builder, signature, arguments):
        array = context.make_array(signature.args[0])(context, builder, arguments[0])
        return builder.atomic_rmw("add", array.data, ir.Constant(ir.IntType(64), 1), "monotonic")

    return types.int64(counter), codegen


@intrinsic
def fetch(_, array, index):
    """Asks for the memory at array[index] and 63 bytes beyond, which is wanted soon."""

    def codegen(context, builder, signature, arguments):
        struct = context.make_array(signature.args[0])(context, builder, arguments[0])
        indices = cgutils.unpack_tuple(builder, arguments[1], len(signature.args[1]))
        at = cgutils.get_item_pointer(context, builder, signature.args[0], struct, indices, wraparound=False)
        at, flag = builder.bitcast(at, ir.IntType(8).as_pointer()), ir.IntType(32)
        kind = ir.FunctionType(ir.VoidType(), [at.type, flag, flag, flag])
        wanted = cgutils.get_or_insert_function(builder.module, kind, "llvm.prefetch.p0")
        builder.call(wanted, [at, flag(0), flag(3), flag(1)])
        return context.get_dummy_value()

    return types.none(array, index), codegen


class Handle(NamedTuple):
    """How values of one type are handed on by their address."""

    lend: Callable[..., Any]  # lend(value) is an address, good while the kernel that has lent it runs
    opened: Callable[..., Any]  # opened(address) is the value again
    put: Callable[..., Any]  # put(address, value) writes another one there
    kind: Any  # their type, as the compiler knows it: for worlds.compiled.memory.Held


def handle(sample: Any) -> Handle:
    """The Handle of values of the type of `sample`, a tuple of numbers, arrays and tuples of them."""
    kind = numba.typeof(sample)

    @intrinsic
    def lend(_, value):
        def codegen(context, builder, signature, arguments):
            place = cgutils.alloca_once(builder, context.get_data_type(kind))
            builder.store(context.data_model_manager[kind].as_data(builder, arguments[0]), place)
            return builder.ptrtoint(place, ir.IntType(64))

        return types.int64(kind), codegen

    @intrinsic
    def opened(_, address):
        def codegen(context, builder, signature, arguments):
            place = builder.inttoptr(arguments[0], context.get_data_type(kind).as_pointer())
            return context.data_model_manager[kind].from_data(builder, builder.load(place))

        return kind(types.int64), codegen

    @intrinsic
    def put(_, address, value):
        def codegen(context, builder, signature, arguments):
            place = builder.inttoptr(arguments[0], context.get_data_type(kind).as_pointer())
            builder.store(context.data_model_manager[kind].as_data(builder, arguments[1]), place)
            return context.get_dummy_value()

        return types.none(types.int64, kind), codegen

    return Handle(lend, opened, put, kind)
