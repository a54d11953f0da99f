"""Rows of tables side by side: what is asked of one character's arrays is asked of WIDE characters' at once.

`side_by_side(table, rows, counts)` is a table whose columns are rows side by side: `column[n]`, with n an index or Wholes, is
the n-th entry of each of these rows, as Lanes, Wholes or a Mask, and `len` tells how many entries each has. So a kernel that is
written for one character's arrays serves WIDE of them. An index must lie within the array, also in lanes of which nobody asks.
"""

import operator
from typing import Any

from llvmlite import ir
from numba.core import cgutils, types
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numba.extending import lower_builtin, models, register_model

from worlds.compiled.beside.wide import NUMBERS, WHOLES, WIDE, addresses, element_of, gather
from worlds.compiled.jit import intrinsic
from worlds.compiled.kinds import WholesType, spread
from worlds.compiled.tables import tuple_type


class RowsType(types.Type):
    """Rows of arrays of this element and of so many axes."""

    def __init__(self, dtype: Any, ndim: int) -> None:
        self.dtype, self.ndim = dtype, ndim
        super().__init__(name=f"rows({dtype}, {ndim})")


@register_model(RowsType)
class _RowsModel(models.StructModel):
    def __init__(self, manager: Any, fe_type: Any) -> None:
        members = [("base", WHOLES), ("counts", WHOLES), ("strides", types.UniTuple(types.intp, fe_type.ndim))]
        super().__init__(manager, fe_type, members)


@intrinsic
def side_by_side(_, table, rows, counts):
    """The table whose columns are these rows of it, side by side, each of so many entries."""
    columns = [RowsType(each.dtype, each.ndim - 1) for each in table.types]
    result = tuple_type(columns, table.instance_class)

    def codegen(context, builder, sig, args):
        found = context.get_constant_undef(result)
        for place, (kind, column) in enumerate(zip(columns, table.types, strict=True)):
            array = context.make_array(column)(context, builder, builder.extract_value(args[0], place))
            strides = cgutils.unpack_tuple(builder, array.strides, column.ndim)
            strides[-1] = context.get_constant(types.intp, context.get_abi_sizeof(context.get_data_type(column.dtype)))
            struct = cgutils.create_struct_proxy(kind)(context, builder)
            struct.base = addresses(context, builder, builder.ptrtoint(array.data, ir.IntType(64)), args[1], strides[0])
            struct.counts, struct.strides = args[2], cgutils.pack_array(builder, strides[1:])
            found = builder.insert_value(found, struct._getvalue(), place)
        return found

    return signature(result, table, rows, counts), codegen


@infer_global(len)
class _Length(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        return signature(WHOLES, *args) if isinstance(args[0], RowsType) else None


@lower_builtin(len, RowsType)
def _len(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    return cgutils.create_struct_proxy(sig.args[0])(context, builder, args[0]).counts


@infer_global(operator.getitem)
class _Indexed(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        if not isinstance(args[0], RowsType):
            return None
        left = args[0].ndim - (len(args[1]) if isinstance(args[1], types.BaseTuple) else 1)
        return signature(RowsType(args[0].dtype, left) if left else element_of(args[0].dtype), *args)


@lower_builtin(operator.getitem, RowsType, types.Integer)
@lower_builtin(operator.getitem, RowsType, WholesType)
@lower_builtin(operator.getitem, RowsType, types.BaseTuple)
def _getitem(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    kind, struct = sig.args[0], cgutils.create_struct_proxy(sig.args[0])(context, builder, args[0])
    many = isinstance(sig.args[1], types.BaseTuple)
    kinds = sig.args[1].types if many else (sig.args[1],)
    values = cgutils.unpack_tuple(builder, args[1], len(kinds)) if many else [args[1]]
    strides, base = cgutils.unpack_tuple(builder, struct.strides, kind.ndim), struct.base
    for each, value, stride in zip(kinds, values, strides, strict=False):
        base = addresses(context, builder, base, spread(context, builder, each, value, WHOLES), stride)
    if isinstance(sig.return_type, RowsType):
        part = cgutils.create_struct_proxy(sig.return_type)(context, builder)
        part.base, part.counts, part.strides = base, struct.counts, cgutils.pack_array(builder, strides[len(kinds) :])
        return part._getvalue()
    return gather(context, builder, kind.dtype, base)


@intrinsic
def ends_of(_, array, n):
    """The twelve numbers of rows n and n + 1 of an array of six columns, or of such arrays side by side, as two tuples.

    They lie one after the other: of WIDE arrays they are read as vectors, and turned over.
    """
    one = NUMBERS if isinstance(array, RowsType) else types.float64
    each = types.UniTuple(one, 6)

    def codegen(context, builder, sig, args):
        if isinstance(array, RowsType):
            struct = cgutils.create_struct_proxy(array)(context, builder, args[0])
            stride = cgutils.unpack_tuple(builder, struct.strides, 2)[0]
            index = spread(context, builder, n, args[1], WHOLES)
            found = _turned_over(builder, addresses(context, builder, struct.base, index, stride))
        else:
            struct, row = context.make_array(array)(context, builder, args[0]), context.cast(builder, args[1], n, types.intp)
            rows = (row, builder.add(row, ir.Constant(row.type, 1)))
            at = [(one, context.get_constant(types.intp, k)) for one in rows for k in range(6)]
            found = [builder.load(cgutils.get_item_pointer(context, builder, array, struct, place, False)) for place in at]
        both = [context.make_tuple(builder, each, found[k : k + 6]) for k in (0, 6)]
        return context.make_tuple(builder, sig.return_type, both)

    return signature(types.UniTuple(each, 2), array, n), codegen


def _turned_over(builder: Any, addresses: Any) -> list[Any]:
    """The twelve numbers from each of WIDE addresses on, by their place: eight and four of each are read at once."""
    lanes: list[list[Any]] = []
    for first, many in ((0, 8), (8, 4)):
        kind = ir.VectorType(ir.DoubleType(), many)
        at = [builder.extract_element(addresses, ir.Constant(ir.IntType(32), k)) for k in range(WIDE)]
        at = [builder.add(one, ir.Constant(ir.IntType(64), 8 * first)) for one in at]
        parts = [builder.load(builder.inttoptr(one, kind.as_pointer()), align=8) for one in at]
        while len(parts) > 1:  # pairs of vectors become one of both, entry by entry
            half = len(parts) // 2
            parts = [_interleaved(builder, parts[k], parts[k + half]) for k in range(half)]
        lanes.append([_piece(builder, parts[0], WIDE * k) for k in range(many)])
    return lanes[0] + lanes[1]


def _interleaved(builder: Any, a: Any, b: Any) -> Any:
    many = a.type.count
    order = [k + many * side for k in range(many) for side in (0, 1)]
    return builder.shuffle_vector(a, b, ir.Constant(ir.VectorType(ir.IntType(32), 2 * many), order))


def _piece(builder: Any, whole: Any, first: int) -> Any:
    order = ir.Constant(ir.VectorType(ir.IntType(32), WIDE), [first + k for k in range(WIDE)])
    return builder.shuffle_vector(whole, ir.Constant(whole.type, ir.Undefined), order)
