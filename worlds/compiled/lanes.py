"""Four numbers side by side, that one instruction works on: kernels written with them are vectorised by construction.

A `Lanes` holds LANES float64, a `Mask` as many truths. Arithmetic and comparisons go lane by lane, with a number on either
side spread over all lanes; `choose`, `root`, `larger` work alike on lanes and on plain numbers, so that one kernel serves both.
No lane sees another, and none is rounded differently from a plain number: results are the same for any width of the machine's
registers. (LLVM's loop vectoriser would have to prove that arrays do not overlap; it cannot.)
"""

import operator
from typing import Any

from llvmlite import ir
from numba.core import cgutils, types
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numba.extending import lower_builtin, models, register_model

from worlds.compiled.jit import intrinsic

LANES = 4
"""Doubles in a register of today's common machines; wider ones gain little, as segments come in tens."""


class LanesType(types.Type):
    """LANES numbers."""

    def __init__(self) -> None:
        super().__init__(name="lanes")


class MaskType(types.Type):
    """LANES truths, all bits of a lane set or none."""

    def __init__(self) -> None:
        super().__init__(name="mask")


KIND, MASK = LanesType(), MaskType()
"""Types, as the compiler knows them."""
_NUMBERS, _TRUTHS, _BYTES = (ir.VectorType(one, LANES) for one in (ir.DoubleType(), ir.IntType(64), ir.IntType(8)))


class _Vector(models.PrimitiveModel):
    VECTOR: Any = _NUMBERS

    def __init__(self, manager, fe_type) -> None:
        super().__init__(manager, fe_type, self.VECTOR)


@register_model(LanesType)
class _LanesModel(_Vector):
    VECTOR = _NUMBERS


@register_model(MaskType)
class _MaskModel(_Vector):
    VECTOR = _TRUTHS


def _spread(context, builder, kind, value):
    """A plain number in every lane."""
    if kind == KIND:
        return value
    number = context.cast(builder, value, kind, types.float64)
    one = builder.insert_element(ir.Constant(_NUMBERS, ir.Undefined), number, ir.Constant(ir.IntType(32), 0))
    zeros = ir.Constant(ir.VectorType(ir.IntType(32), LANES), [0] * LANES)
    return builder.shuffle_vector(one, ir.Constant(_NUMBERS, ir.Undefined), zeros)


def _truths(builder, bits):
    return builder.sext(bits, _TRUTHS)


def bits(builder, mask):
    """LLVM's truths of a Mask."""
    return builder.icmp_signed("<", mask, ir.Constant(_TRUTHS, [0] * LANES))


def _define(op, emit, result):
    """Operator `op` on two lanes, or on lanes and a number."""

    @infer_global(op)
    class _Typing(AbstractTemplate):
        def generic(self, args, kws):
            if len(args) == 2 and KIND in args and all(a == KIND or isinstance(a, types.Number) for a in args):
                return signature(result, *args)
            return None

    def lower(context, builder, sig, args):
        a, b = (_spread(context, builder, kind, value) for kind, value in zip(sig.args, args, strict=True))
        return emit(builder, a, b)

    for pair in ((LanesType, LanesType), (LanesType, types.Number), (types.Number, LanesType)):
        lower_builtin(op, *pair)(lower)


for _op, _own, _name in (
    (operator.add, operator.iadd, "fadd"),
    (operator.sub, operator.isub, "fsub"),
    (operator.mul, operator.imul, "fmul"),
    (operator.truediv, operator.itruediv, "fdiv"),
):
    for _one in (_op, _own):
        _define(_one, lambda builder, a, b, name=_name: getattr(builder, name)(a, b), KIND)
for _op, _sign in ((operator.gt, ">"), (operator.ge, ">="), (operator.lt, "<"), (operator.le, "<=")):
    _define(_op, lambda builder, a, b, sign=_sign: _truths(builder, builder.fcmp_ordered(sign, a, b)), MASK)


@infer_global(operator.and_)
@infer_global(operator.or_)
class _Both(AbstractTemplate):
    def generic(self, args, kws):
        return signature(MASK, *args) if args == (MASK, MASK) else None


@lower_builtin(operator.and_, MaskType, MaskType)
def _and(context, builder, sig, args):
    return builder.and_(*args)


@lower_builtin(operator.or_, MaskType, MaskType)
def _or(context, builder, sig, args):
    return builder.or_(*args)


@infer_global(operator.neg)
class _Negative(AbstractTemplate):
    def generic(self, args, kws):
        return signature(KIND, KIND) if args == (KIND,) else None


@lower_builtin(operator.neg, LanesType)
def _neg(context, builder, sig, args):
    return builder.fneg(args[0])


@intrinsic
def choose(_, condition, yes, no):
    """yes where the condition holds, else no: of lanes or numbers by a Mask, of numbers by a bool. Both are worked out."""
    wide = condition == MASK
    result = KIND if wide else types.float64

    def codegen(context, builder, sig, args):
        truth, a, b = args
        if wide:
            a, b = (_spread(context, builder, kind, value) for kind, value in zip(sig.args[1:], (a, b), strict=True))
            return builder.select(bits(builder, truth), a, b)
        a, b = (context.cast(builder, v, kind, types.float64) for kind, v in zip(sig.args[1:], (a, b), strict=True))
        return builder.select(context.cast(builder, truth, sig.args[0], types.boolean), a, b)

    return signature(result, condition, yes, no), codegen


@intrinsic
def root(_, x):
    """Square root."""
    result = x if x == KIND else types.float64

    def codegen(context, builder, sig, args):
        value = args[0] if x == KIND else context.cast(builder, args[0], x, types.float64)
        kind = ir.FunctionType(value.type, [value.type])
        name = f"llvm.sqrt.{'f64' if value.type == ir.DoubleType() else f'v{LANES}f64'}"
        return builder.call(cgutils.get_or_insert_function(builder.module, kind, name), [value])

    return signature(result, x), codegen


@intrinsic
def larger(_, x, y):
    """The larger of two; y where x is not a number."""
    wide = KIND in (x, y)

    def codegen(context, builder, sig, args):
        if wide:
            a, b = (_spread(context, builder, kind, value) for kind, value in zip(sig.args, args, strict=True))
        else:
            a, b = (context.cast(builder, value, kind, types.float64) for kind, value in zip(sig.args, args, strict=True))
        return builder.select(builder.fcmp_ordered(">", a, b), a, b)

    return signature(KIND if wide else types.float64, x, y), codegen


def _pointer(context, builder, kind, array, index_kind, index, vector):
    struct = context.make_array(kind)(context, builder, array)
    indices = cgutils.unpack_tuple(builder, index, len(index_kind))
    indices = [context.cast(builder, one, each, types.intp) for one, each in zip(indices, index_kind, strict=True)]
    at = cgutils.get_item_pointer(context, builder, kind, struct, indices, wraparound=False)
    return builder.bitcast(at, vector.as_pointer())


@intrinsic
def load(_, array, index):
    """Lanes from array[index] on, contiguous; a Mask of a bool array."""
    truths = array.dtype == types.boolean

    def codegen(context, builder, sig, args):
        vector = _BYTES if truths else _NUMBERS
        at = _pointer(context, builder, sig.args[0], args[0], sig.args[1], args[1], vector)
        found = builder.load(at, align=1 if truths else 8)
        if truths:
            return _truths(builder, builder.icmp_unsigned("!=", found, ir.Constant(_BYTES, [0] * LANES)))
        return found

    return signature(MASK if truths else KIND, array, index), codegen


@intrinsic
def store(_, array, index, value):
    """array[index] and the next ones, contiguous, become the lanes."""

    def codegen(context, builder, sig, args):
        at = _pointer(context, builder, sig.args[0], args[0], sig.args[1], args[1], _NUMBERS)
        builder.store(_spread(context, builder, sig.args[2], args[2]), at, align=8)
        return context.get_dummy_value()

    return signature(types.none, array, index, value), codegen


@intrinsic
def lanes_of(_, a, b, c, d):
    """Four numbers side by side."""

    def codegen(context, builder, sig, args):
        found = ir.Constant(_NUMBERS, ir.Undefined)
        for k, (kind, value) in enumerate(zip(sig.args, args, strict=True)):
            number = context.cast(builder, value, kind, types.float64)
            found = builder.insert_element(found, number, ir.Constant(ir.IntType(32), k))
        return found

    return signature(KIND, a, b, c, d), codegen
