"""Numbers side by side, that one instruction works on: kernels written with them are vectorised by construction.

`Lanes` hold float64, a `Mask` as many truths. Arithmetic and comparisons go lane by lane, with a number on either
side spread over all lanes; `choose`, `root`, `larger` work alike on lanes and on plain numbers, so that one kernel serves both.
No lane sees another, and none is rounded differently from a plain number: results are the same for any width of the machine's
registers. (LLVM's loop vectoriser would have to prove that arrays do not overlap; it cannot.)
"""

from typing import Any

from llvmlite import ir
from numba.core import cgutils, types
from numba.core.typing.templates import signature

from worlds.compiled.jit import intrinsic
from worlds.compiled.kinds import KIND, MASK, LanesType, MaskType, WholesType, bits, by_llvm, spread, truths, wide
from worlds.compiled.kinds import LANES as LANES

Some = Any
"""A number or Lanes of them; a bool or a Mask; an index or Wholes."""


def _joined(*kinds: Any) -> Any:
    """The type that values of all of these fit in: whole numbers only where all are."""
    count, whole = wide(*kinds), all(isinstance(kind, (WholesType, types.Integer)) for kind in kinds)
    if not count:
        return types.int64 if whole else types.float64
    return WholesType(count) if whole else LanesType(count)


def _fit(context, builder, kinds, values, wanted):
    """Values of these types as one."""
    if isinstance(wanted, (LanesType, WholesType)):
        return [spread(context, builder, kind, value, wanted) for kind, value in zip(kinds, values, strict=True)]
    return [context.cast(builder, value, kind, wanted) for kind, value in zip(kinds, values, strict=True)]


@intrinsic
def choose(_, condition, yes, no):
    """yes where the condition holds, else no: of lanes or numbers by a Mask, of numbers by a bool. Both are worked out."""
    result = _joined(yes, no)
    if isinstance(condition, MaskType) and not wide(yes, no):
        result = WholesType(condition.count) if result == types.int64 else LanesType(condition.count)

    def codegen(context, builder, sig, args):
        a, b = _fit(context, builder, sig.args[1:], args[1:], result)
        if isinstance(condition, MaskType):
            return builder.select(bits(builder, args[0]), a, b)
        return builder.select(context.cast(builder, args[0], sig.args[0], types.boolean), a, b)

    return signature(result, condition, yes, no), codegen


def _of_one(name):
    @intrinsic
    def function(_, x):
        result = x if isinstance(x, LanesType) else types.float64

        def codegen(context, builder, sig, args):
            return by_llvm(builder, name, args[0] if x == result else context.cast(builder, args[0], x, result))

        return signature(result, x), codegen

    return function


root: Any = _of_one("sqrt")
"""Square root."""
nearest: Any = _of_one("rint")
"""The nearest whole number, as float64; the even one of two."""


def _of_two(sign):
    @intrinsic
    def function(_, x, y):
        result = _joined(x, y)

        def codegen(context, builder, sig, args):
            a, b = _fit(context, builder, sig.args, args, result)
            whole = isinstance(result, (WholesType, types.Integer))
            return builder.select((builder.icmp_signed if whole else builder.fcmp_ordered)(sign, a, b), a, b)

        return signature(result, x, y), codegen

    return function


larger: Any = _of_two(">")
"""The larger of two; the second where the first is not a number."""
smaller: Any = _of_two("<")
"""The smaller of two; the second where the first is not a number."""


@intrinsic
def fused(_, x, y, z):
    """x y + z, rounded once: one instruction, with the same bits wherever it stands."""
    result = _joined(x, y, z) if wide(x, y, z) else types.float64

    def codegen(context, builder, sig, args):
        return by_llvm(builder, "fma", *_fit(context, builder, sig.args, args, result))

    return signature(result, x, y, z), codegen


@intrinsic
def scaled(_, x, k):
    """x 2^k, k a whole number in float64, of what is not too small or large for it."""
    result = _joined(x, k)

    def codegen(context, builder, sig, args):
        a, b = _fit(context, builder, sig.args, args, result)
        count = wide(result)
        whole = ir.VectorType(ir.IntType(64), count) if count else ir.IntType(64)
        shift = builder.shl(builder.fptosi(b, whole), _filled(whole, 52))
        return builder.bitcast(builder.add(builder.bitcast(a, whole), shift), a.type)

    return signature(result, x, k), codegen


@intrinsic
def parts_of(_, x):
    """(m, k) with x = m 2^k, m from sqrt(1/2) to sqrt(2), of a positive number that is neither infinite nor next to nothing."""
    result = x if isinstance(x, LanesType) else types.float64

    def codegen(context, builder, sig, args):
        value = args[0] if x == result else context.cast(builder, args[0], x, result)
        whole = ir.VectorType(ir.IntType(64), x.count) if isinstance(x, LanesType) else ir.IntType(64)
        found = builder.bitcast(value, whole)
        above = builder.sub(found, _filled(whole, 0x3FE6A09E667F3BCD))
        exponent = builder.ashr(above, _filled(whole, 52))
        mantissa = builder.sub(found, builder.shl(exponent, _filled(whole, 52)))
        return context.make_tuple(
            builder, sig.return_type, [builder.bitcast(mantissa, value.type), builder.sitofp(exponent, value.type)]
        )

    return signature(types.UniTuple(result, 2), x), codegen


def _filled(kind, number):
    return ir.Constant(kind, [number] * kind.count) if isinstance(kind, ir.VectorType) else ir.Constant(kind, number)


def pointer(context, builder, kind, array, index_kind, index, vector):
    """Where array[index] lies, as the beginning of such a vector."""
    struct = context.make_array(kind)(context, builder, array)
    indices = cgutils.unpack_tuple(builder, index, len(index_kind))
    indices = [context.cast(builder, one, each, types.intp) for one, each in zip(indices, index_kind, strict=True)]
    at = cgutils.get_item_pointer(context, builder, kind, struct, indices, wraparound=False)
    return builder.bitcast(at, vector.as_pointer())


def loaded(context, builder, sig, args, count):
    """So many numbers or truths from array[index] on."""
    truth = sig.args[0].dtype == types.boolean
    vector = ir.VectorType(ir.IntType(8) if truth else ir.DoubleType(), count)
    at = pointer(context, builder, sig.args[0], args[0], sig.args[1], args[1], vector)
    found = builder.load(at, align=1 if truth else 8)
    return truths(builder, builder.icmp_unsigned("!=", found, ir.Constant(vector, [0] * count))) if truth else found


@intrinsic
def load(_, array, index):
    """Lanes from array[index] on, contiguous; a Mask of a bool array."""

    def codegen(context, builder, sig, args):
        return loaded(context, builder, sig, args, LANES)

    return signature(MASK if array.dtype == types.boolean else KIND, array, index), codegen


@intrinsic
def store(_, array, index, value):
    """array[index] and the next ones, contiguous, become the lanes, as many as there are; a plain number LANES times."""
    lanes = value if isinstance(value, LanesType) else KIND

    def codegen(context, builder, sig, args):
        number = spread(context, builder, sig.args[2], args[2], lanes)
        at = pointer(context, builder, sig.args[0], args[0], sig.args[1], args[1], lanes.vector)
        builder.store(number, at, align=8)
        return context.get_dummy_value()

    return signature(types.none, array, index, value), codegen


@intrinsic
def lanes_of(_, a, b, c, d):
    """Four numbers side by side."""

    def codegen(context, builder, sig, args):
        found = ir.Constant(KIND.vector, ir.Undefined)
        for k, (kind, value) in enumerate(zip(sig.args, args, strict=True)):
            number = context.cast(builder, value, kind, types.float64)
            found = builder.insert_element(found, number, ir.Constant(ir.IntType(32), k))
        return found

    return signature(KIND, a, b, c, d), codegen
