"""What looks across the lanes (worlds.compiled.lanes), where all else goes lane by lane."""

from llvmlite import ir
from numba.core import types
from numba.core.typing.templates import signature

from worlds.compiled.jit import intrinsic, intrinsic_of_literals
from worlds.compiled.lanes import KIND, LANES, bits


@intrinsic
def total(_, x):
    """Sum of the lanes, the first first."""

    def codegen(context, builder, sig, args):
        each = [builder.extract_element(args[0], ir.Constant(ir.IntType(32), k)) for k in range(LANES)]
        found = each[0]
        for one in each[1:]:
            found = builder.fadd(found, one)
        return found

    return signature(types.float64, x), codegen


@intrinsic
def bits_of(_, mask):
    """A whole number with bit k set where lane k is true."""

    def codegen(context, builder, sig, args):
        return builder.zext(builder.bitcast(bits(builder, args[0]), ir.IntType(LANES)), ir.IntType(64))

    return signature(types.int64, mask), codegen


@intrinsic_of_literals
def shifted(_, x, y, by):
    """Lanes `by`, a plain number from 0 to LANES, of x and those of y after it: as if read from so far on in memory."""

    def codegen(context, builder, sig, args):
        first = sig.args[2].literal_value
        order = ir.Constant(ir.VectorType(ir.IntType(32), LANES), [first + k for k in range(LANES)])
        return builder.shuffle_vector(args[0], args[1], order)

    return (signature(KIND, x, y, by), codegen) if isinstance(by, types.IntegerLiteral) else None


@intrinsic_of_literals
def lane(_, x, k):
    """Lane k, a plain number, of x."""

    def codegen(context, builder, sig, args):
        return builder.extract_element(args[0], ir.Constant(ir.IntType(32), sig.args[1].literal_value))

    return (signature(types.float64, x, k), codegen) if isinstance(k, types.IntegerLiteral) else None
