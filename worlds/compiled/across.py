"""What looks across the lanes (worlds.compiled.lanes), where all else goes lane by lane."""

from llvmlite import ir
from numba.core import types
from numba.core.typing.templates import signature

from worlds.compiled.jit import intrinsic, intrinsic_of_literals
from worlds.compiled.kinds import KIND, LANES, MaskType, bits


@intrinsic
def total(_, x):
    """Sum of the lanes, the first first."""

    def codegen(context, builder, sig, args):
        each = [builder.extract_element(args[0], ir.Constant(ir.IntType(32), k)) for k in range(x.count)]
        found = each[0]
        for one in each[1:]:
            found = builder.fadd(found, one)
        return found

    return signature(types.float64, x), codegen


@intrinsic
def total_in_turn(_, x, y):
    """Sum of the lanes of both, the first of x, then of y, then the second ones."""

    def codegen(context, builder, sig, args):
        found = ir.Constant(ir.DoubleType(), 0.0)
        for k in range(x.count):
            for one in args:
                found = builder.fadd(found, builder.extract_element(one, ir.Constant(ir.IntType(32), k)))
        return found

    return signature(types.float64, x, y), codegen


@intrinsic
def bits_of(_, mask):
    """A whole number with bit k set where lane k is true."""

    def codegen(context, builder, sig, args):
        return builder.zext(builder.bitcast(bits(builder, args[0]), ir.IntType(mask.count)), ir.IntType(64))

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


@intrinsic
def turned(_, a, b, c, d):
    """Four lanes as rows of a square, by its columns: what lane k of each holds becomes the k-th of what is returned."""

    def codegen(context, builder, sig, args):
        kind = ir.VectorType(ir.IntType(32), LANES)
        low, high = ir.Constant(kind, [0, 4, 2, 6]), ir.Constant(kind, [1, 5, 3, 7])
        pairs = [builder.shuffle_vector(x, y, order) for x, y in (args[:2], args[2:]) for order in (low, high)]
        first, last = ir.Constant(kind, [0, 1, 4, 5]), ir.Constant(kind, [2, 3, 6, 7])
        columns = [builder.shuffle_vector(pairs[k], pairs[k + 2], order) for order in (first, last) for k in (0, 1)]
        return context.make_tuple(builder, sig.return_type, columns)

    return signature(types.UniTuple(KIND, LANES), a, b, c, d), codegen


@intrinsic
def any_of(_, truth):
    """Whether a truth holds in any lane; of a plain one, whether it holds."""

    def codegen(context, builder, sig, args):
        if not isinstance(truth, MaskType):
            return context.cast(builder, args[0], truth, types.boolean)
        whole = ir.IntType(truth.count)
        return builder.icmp_unsigned("!=", builder.bitcast(bits(builder, args[0]), whole), ir.Constant(whole, 0))

    return signature(types.boolean, truth), codegen


@intrinsic
def isnt(_, truth):
    """Whether a truth does not hold, lane by lane."""

    def codegen(context, builder, sig, args):
        return builder.not_(args[0] if isinstance(truth, MaskType) else context.cast(builder, args[0], truth, types.boolean))

    return signature(truth if isinstance(truth, MaskType) else types.boolean, truth), codegen
