"""The compiler's types of numbers side by side (worlds.compiled.lanes), and what operators make of them.

`Lanes` are float64, a `Mask` truths, `Wholes` int64, so many of each as their type says. A plain number beside lanes is
spread over all of them, also where one branch of a kernel returns a number and another one lanes.
"""

import operator
from typing import Any

from llvmlite import ir
from numba.core import types
from numba.core.typeconv import Conversion
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numba.extending import lower_builtin, lower_cast, models, register_model


class _Side(types.Type):
    """So many side by side."""

    ELEMENT: Any = None
    PLAIN: Any = None

    def __init__(self, count: int) -> None:
        self.count = count
        super().__init__(name=f"{type(self).__name__}{count}")

    @property
    def vector(self) -> Any:
        """As LLVM knows it."""
        return ir.VectorType(self.ELEMENT, self.count)

    def can_convert_from(self, typingctx: Any, other: Any) -> Any:
        """Whether the compiler may spread a plain one."""
        return Conversion.safe if isinstance(other, self.PLAIN) else None


class LanesType(_Side):
    """Numbers."""

    ELEMENT, PLAIN = ir.DoubleType(), types.Number


class WholesType(_Side):
    """Whole numbers."""

    ELEMENT, PLAIN = ir.IntType(64), types.Integer


class MaskType(_Side):
    """Truths, all bits of one set or none."""

    ELEMENT, PLAIN = ir.IntType(64), types.Boolean


LANES = 4
"""Entries of a column of banded equations that are worked on at once: twelve are three times as many."""
KIND, MASK = LanesType(LANES), MaskType(LANES)


@register_model(LanesType)
@register_model(WholesType)
@register_model(MaskType)
class _Vector(models.PrimitiveModel):
    def __init__(self, manager: Any, fe_type: Any) -> None:
        super().__init__(manager, fe_type, fe_type.vector)


SIDES = (LanesType, WholesType, MaskType)


def wide(*kinds: Any) -> int:
    """How many there are side by side in values of these types; 0 where all are plain."""
    return max((kind.count for kind in kinds if isinstance(kind, SIDES)), default=0)


def spread_all(builder: Any, number: Any, kind: Any) -> Any:
    """A value of LLVM's in every lane."""
    one = builder.insert_element(ir.Constant(kind, ir.Undefined), number, ir.Constant(ir.IntType(32), 0))
    zeros = ir.Constant(ir.VectorType(ir.IntType(32), kind.count), [0] * kind.count)
    return builder.shuffle_vector(one, ir.Constant(kind, ir.Undefined), zeros)


def spread(context: Any, builder: Any, kind: Any, value: Any, wanted: Any) -> Any:
    """A plain number in every lane of the wanted type; lanes as they are."""
    if kind == wanted:
        return value
    if isinstance(wanted, MaskType):
        return builder.sext(spread_all(builder, value, ir.VectorType(ir.IntType(1), wanted.count)), wanted.vector)
    plain = types.float64 if isinstance(wanted, LanesType) else types.int64
    return spread_all(builder, context.cast(builder, value, kind, plain), wanted.vector)


@lower_cast(types.Number, LanesType)
@lower_cast(types.Integer, WholesType)
@lower_cast(types.Boolean, MaskType)
def _cast(context: Any, builder: Any, source: Any, goal: Any, value: Any) -> Any:
    return spread(context, builder, source, value, goal)


def truths(builder: Any, bits: Any) -> Any:
    """A Mask of LLVM's truths."""
    return builder.sext(bits, ir.VectorType(ir.IntType(64), bits.type.count))


def bits(builder: Any, mask: Any) -> Any:
    """LLVM's truths of a Mask."""
    return builder.icmp_signed("<", mask, ir.Constant(mask.type, [0] * mask.type.count))


def _define(op: Any, side: type, plain: type, result: type, emit: Any) -> None:
    """Operator `op` on two of a kind, or on one and a plain number."""

    @infer_global(op)
    class _Typing(AbstractTemplate):
        def generic(self, args: Any, kws: Any) -> Any:
            if len(args) == 2 and any(isinstance(a, side) for a in args) and all(isinstance(a, (side, plain)) for a in args):
                return signature(result(wide(*args)), *args)
            return None

    def lower(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        kind = side(wide(*sig.args))
        return emit(builder, *(spread(context, builder, each, value, kind) for each, value in zip(sig.args, args, strict=True)))

    for pair in ((side, side), (side, plain), (plain, side)):
        lower_builtin(op, *pair)(lower)


for _op, _own, _name in (
    (operator.add, operator.iadd, "add"),
    (operator.sub, operator.isub, "sub"),
    (operator.mul, operator.imul, "mul"),
    (operator.truediv, operator.itruediv, "div"),
):
    for _one in (_op, _own):
        _define(_one, LanesType, types.Number, LanesType, lambda b, x, y, name=_name: getattr(b, f"f{name}")(x, y))
        if _name in ("add", "sub"):
            _define(_one, WholesType, types.Integer, WholesType, lambda b, x, y, name=_name: getattr(b, name)(x, y))
_define(operator.rshift, WholesType, types.Integer, WholesType, lambda b, x, y: b.ashr(x, y))
for _op, _sign in (
    (operator.gt, ">"), (operator.ge, ">="), (operator.lt, "<"), (operator.le, "<="), (operator.eq, "=="), (operator.ne, "!="),
):  # fmt: skip
    _compare = "fcmp_unordered" if _sign == "!=" else "fcmp_ordered"
    _define(
        _op, LanesType, types.Number, MaskType,
        lambda b, x, y, sign=_sign, how=_compare: truths(b, getattr(b, how)(sign, x, y)),
    )  # fmt: skip
    _define(_op, WholesType, types.Integer, MaskType, lambda b, x, y, sign=_sign: truths(b, b.icmp_signed(sign, x, y)))
for _op, _name in ((operator.and_, "and_"), (operator.or_, "or_")):
    _define(_op, MaskType, types.Boolean, MaskType, lambda b, x, y, name=_name: getattr(b, name)(x, y))


@infer_global(operator.neg)
class _Negative(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        return signature(args[0], *args) if isinstance(args[0], LanesType) else None


@lower_builtin(operator.neg, LanesType)
def _neg(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    return builder.fneg(args[0])


@infer_global(abs)
class _Absolute(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        return signature(args[0], *args) if isinstance(args[0], LanesType) else None


@lower_builtin(abs, LanesType)
def _abs(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    return by_llvm(builder, "fabs", args[0])


def by_llvm(builder: Any, name: str, *values: Any) -> Any:
    """LLVM's function of numbers, or of as many as there are lanes of each."""
    one = values[0].type
    lanes = one.count if isinstance(one, ir.VectorType) else 0
    called = f"llvm.{name}.{f'v{lanes}f64' if lanes else 'f64'}"
    kind = ir.FunctionType(one, [one] * len(values))
    known = builder.module.globals.get(called)
    return builder.call(known or ir.Function(builder.module, kind, called), values)
