"""Where numbers side by side come from, and where they are put: entries of an array, contiguous or of any rows."""

from typing import Any

from llvmlite import ir
from numba.core import cgutils, types
from numba.core.typing.templates import signature

from worlds.compiled.beside.wide import NUMBERS, WHOLES, WIDE, addresses, element_of, gather, lanes_in
from worlds.compiled.jit import intrinsic, jit_inline
from worlds.compiled.kinds import spread
from worlds.compiled.lanes import choose, loaded, pointer


@intrinsic
def counted(_, first, end):
    """first, first + 1, ... of what is before `end`; the last of these again from there on."""

    def codegen(context, builder, sig, args):
        steps = ir.Constant(WHOLES.vector, list(range(WIDE)))
        begin, last = (spread(context, builder, kind, value, WHOLES) for kind, value in zip(sig.args, args, strict=True))
        each, last = builder.add(begin, steps), builder.sub(last, ir.Constant(WHOLES.vector, [1] * WIDE))
        return builder.select(builder.icmp_signed("<", each, last), each, last)

    return signature(WHOLES, first, end), codegen


@jit_inline
def counting(first: int, end: int) -> Any:
    """1.0 in the lanes of counted(first, end) that tell of one for the first time, 0.0 in the others."""
    return choose(counted(0, WIDE) < end - first, 1.0, 0.0)


@intrinsic
def each_of(_, array, rows, index):
    """array[row, *index] of each of the rows."""

    def codegen(context, builder, sig, args):
        struct = context.make_array(array)(context, builder, args[0])
        strides = cgutils.unpack_tuple(builder, struct.strides, array.ndim)
        base = _behind(context, builder, builder.ptrtoint(struct.data, ir.IntType(64)), index, args[2], strides[1:])
        return gather(context, builder, array.dtype, lanes_in(builder, addresses(context, builder, base, args[1], strides[0])))

    return signature(element_of(array.dtype), array, rows, index), codegen


@intrinsic
def put(_, array, rows, index, value):
    """array[row, *index] of each of the rows becomes its lane of a value; array[row, *index, k] that of entry k of a tuple."""

    def codegen(context, builder, sig, args):
        struct = context.make_array(array)(context, builder, args[0])
        strides = cgutils.unpack_tuple(builder, struct.strides, array.ndim)
        at, many = builder.ptrtoint(struct.data, ir.IntType(64)), isinstance(value, types.BaseTuple)
        at = _behind(context, builder, at, index, args[2], strides[1:])
        kinds = value.types if many else (value,)
        for kind, one in zip(kinds, cgutils.unpack_tuple(builder, args[3], len(kinds)) if many else [args[3]], strict=True):
            found = addresses(context, builder, at, args[1], strides[0])
            _scatter(context, builder, array.dtype, found, spread(context, builder, kind, one, element_of(array.dtype)))
            at = builder.add(at, strides[-1])
        return context.get_dummy_value()

    return signature(types.none, array, rows, index, value), codegen


def _behind(context: Any, builder: Any, address: Any, kinds: Any, index: Any, strides: Any) -> Any:
    """The address of an entry behind that of the first one, by its index and what each axis of it strides."""
    for kind, one, stride in zip(kinds, cgutils.unpack_tuple(builder, index, len(kinds)), strides, strict=False):
        address = builder.add(address, builder.mul(context.cast(builder, one, kind, types.intp), stride))
    return address


def _scatter(context: Any, builder: Any, dtype: Any, found: Any, number: Any) -> None:
    """Each lane of a number to its address."""
    element = context.get_data_type(dtype)
    for k in range(WIDE):
        lane = ir.Constant(ir.IntType(32), k)
        one = builder.extract_element(number, lane)
        one = builder.zext(builder.trunc(one, ir.IntType(1)), element) if element == ir.IntType(8) else one
        builder.store(one, builder.inttoptr(builder.extract_element(found, lane), element.as_pointer()))


@intrinsic
def load_wide(_, array, index):
    """WIDE numbers from array[index] on, contiguous; truths of a bool array."""

    def codegen(context, builder, sig, args):
        return loaded(context, builder, sig, args, WIDE)

    return signature(element_of(array.dtype), array, index), codegen


@intrinsic
def store_some(_, array, index, value, count):
    """array[index] and the next ones, contiguous, become the first `count` of the lanes."""

    def codegen(context, builder, sig, args):
        number = spread(context, builder, sig.args[2], args[2], NUMBERS)
        at = pointer(context, builder, sig.args[0], args[0], sig.args[1], args[1], NUMBERS.vector)
        many = spread(context, builder, sig.args[3], args[3], WHOLES)
        mask = builder.icmp_signed("<", ir.Constant(WHOLES.vector, list(range(WIDE))), many)
        kind = ir.FunctionType(ir.VoidType(), [number.type, at.type, ir.IntType(32), mask.type])
        called = cgutils.get_or_insert_function(builder.module, kind, f"llvm.masked.store.v{WIDE}f64.p0")
        builder.call(called, [number, at, ir.IntType(32)(8), mask])
        return context.get_dummy_value()

    return signature(types.none, array, index, value, count), codegen
