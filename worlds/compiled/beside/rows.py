"""Rows of tables side by side: what is asked of one character's arrays is asked of WIDE characters' at once.

`side_by_side(table, rows, counts)` is a table whose columns are rows side by side: `column[n]`, with n an index or Wholes, is
the n-th entry of each of these rows, as Lanes, Wholes or a Mask, and `len` tells how many entries each has. So a kernel that is
written for one character's arrays serves WIDE of them. An index must lie within the array, also in lanes of which nobody asks.
"""

import operator
from math import prod
from typing import Any

import numpy as np
from llvmlite import ir
from numba.core import cgutils, types
from numba.core.typing.templates import AbstractTemplate, AttributeTemplate, infer_getattr, infer_global, signature
from numba.extending import lower_builtin, lower_getattr_generic, models, register_model

from worlds.compiled.beside.wide import NUMBERS, WHOLES, WIDE, element_of, gather, lanes_in
from worlds.compiled.jit import intrinsic
from worlds.compiled.kinds import WholesType, spread
from worlds.compiled.tables import Column, columns_of


class RowsType(types.Type):
    """Rows of arrays of this element, of so many bytes, with such axes behind an entry; or what is left of them behind an
    index.

    A cell is the entry that a lane is at, `unit` bytes long.
    """

    def __init__(self, dtype: Any, size: int, behind: tuple[int, ...], ndim: int, unit: int) -> None:
        self.dtype, self.size, self.behind, self.ndim, self.unit = dtype, size, behind, ndim, unit
        super().__init__(name=f"rows({dtype}, {behind}, {ndim}, {unit})")

    def step(self, axis: int) -> int:
        """Bytes from one entry of an axis of what is left to the next."""
        return self.size * prod(self.behind[len(self.behind) + 1 + axis - self.ndim :])

    def left(self, axes: int, unit: int) -> Any:
        """The type behind an index of so many axes, with cells of such a unit."""
        return RowsType(self.dtype, self.size, self.behind, self.ndim - axes, unit) if axes < self.ndim else None


@register_model(RowsType)
class _RowsModel(models.StructModel):
    """Each lane is at its cell of what begins at `base`."""

    def __init__(self, manager: Any, fe_type: Any) -> None:
        super().__init__(manager, fe_type, [("base", types.int64), ("cell", WHOLES), ("counts", WHOLES)])


class TableBesideType(types.Type):
    """A table of such a class whose columns are rows side by side."""

    def __init__(self, table: type, columns: dict[str, RowsType]) -> None:
        self.columns = columns
        super().__init__(name=f"rows of {table.__module__}.{table.__name__}({', '.join(map(str, columns.values()))})")


@register_model(TableBesideType)
class _TableModel(models.StructModel):
    """Where each column begins, and the lanes' cells, which are those of all columns: so they are handed on, and taken out of
    their vector, once."""

    def __init__(self, manager: Any, fe_type: Any) -> None:
        bases = [(name, types.int64) for name in fe_type.columns]
        super().__init__(manager, fe_type, [("cell_", WHOLES), ("counts_", WHOLES), *bases])


@infer_getattr
class _Column(AttributeTemplate):
    key = TableBesideType

    def generic_resolve(self, kind: Any, name: str) -> Any:  # type: ignore[override]
        return kind.columns.get(name)


@lower_getattr_generic(TableBesideType)
def _column(context: Any, builder: Any, kind: Any, value: Any, name: str) -> Any:
    struct = cgutils.create_struct_proxy(kind)(context, builder, value)
    return _rows(context, builder, kind.columns[name], getattr(struct, name), struct.cell_, struct.counts_)


def _rows(context: Any, builder: Any, kind: RowsType, base: Any, cell: Any, counts: Any) -> Any:
    struct = cgutils.create_struct_proxy(kind)(context, builder)
    struct.base, struct.cell, struct.counts = base, cell, counts
    return struct._getvalue()


def _whole(dtype: Any, column: Column) -> RowsType:
    size = np.dtype(column.dtype).itemsize
    return RowsType(dtype, size, column.shape, 1 + len(column.shape), size * prod(column.shape))


@intrinsic
def side_by_side(_, table, rows, counts):
    """The table whose columns are these rows of it, side by side, each of so many entries."""
    made = columns_of(table.instance_class)
    columns = {name: _whole(each.dtype, made[name]) for name, each in zip(made, table.types, strict=True)}
    result = TableBesideType(table.instance_class, columns)

    def codegen(context, builder, sig, args):
        found = cgutils.create_struct_proxy(result)(context, builder)
        for place, (name, column) in enumerate(zip(made, table.types, strict=True)):
            array = context.make_array(column)(context, builder, builder.extract_value(args[0], place))
            setattr(found, name, builder.ptrtoint(array.data, ir.IntType(64)))
            if place == 0:
                many = cgutils.unpack_tuple(builder, array.shape, column.ndim)[1]
                found.cell_ = builder.mul(args[1], spread(context, builder, types.int64, many, WHOLES))
        found.counts_ = args[2]
        return found._getvalue()

    return signature(result, table, rows, counts), codegen


@infer_global(len)
class _Length(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        return signature(WHOLES, *args) if isinstance(args[0], RowsType) else None


@lower_builtin(len, RowsType)
def _len(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    return cgutils.create_struct_proxy(sig.args[0])(context, builder, args[0]).counts


def _behind(kind: RowsType, index: Any) -> tuple[int, int]:
    """Of an index of this type: how many axes it has, and the unit of the cells that it leads to."""
    many = isinstance(index, types.BaseTuple)
    each = index.types if many else (index,)
    wholes = [axis for axis, one in enumerate(each) if isinstance(one, WholesType)]
    return len(each), kind.step(wholes[-1]) if wholes else kind.unit


@infer_global(operator.getitem)
class _Indexed(AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        if not isinstance(args[0], RowsType):
            return None
        return signature(args[0].left(*_behind(*args)) or element_of(args[0].dtype), *args)


@lower_builtin(operator.getitem, RowsType, types.Integer)
@lower_builtin(operator.getitem, RowsType, WholesType)
@lower_builtin(operator.getitem, RowsType, types.BaseTuple)
def _getitem(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    kind, struct = sig.args[0], cgutils.create_struct_proxy(sig.args[0])(context, builder, args[0])
    many = isinstance(sig.args[1], types.BaseTuple)
    kinds = sig.args[1].types if many else (sig.args[1],)
    values = cgutils.unpack_tuple(builder, args[1], len(kinds)) if many else [args[1]]
    base, cell, unit = struct.base, struct.cell, kind.unit
    for axis, (each, value) in enumerate(zip(kinds, values, strict=True)):
        step = kind.step(axis)
        if isinstance(each, WholesType):
            finer = ir.Constant(WHOLES.vector, [unit // step] * WIDE)
            cell, unit = builder.add(builder.mul(cell, finer), value), step
        else:
            base = builder.add(base, builder.mul(context.cast(builder, value, each, types.int64), base.type(step)))
    if isinstance(sig.return_type, RowsType):
        return _rows(context, builder, sig.return_type, base, cell, struct.counts)
    return gather(context, builder, kind.dtype, _places(builder, base, cell, unit))


def _places(builder: Any, base: Any, cell: Any, unit: int) -> list[Any]:
    """The addresses of the lanes' cells."""
    return [builder.add(base, builder.mul(one, one.type(unit))) for one in lanes_in(builder, cell)]


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
            cell = builder.add(struct.cell, spread(context, builder, n, args[1], WHOLES))
            found = _turned_over(builder, _places(builder, struct.base, cell, array.unit))
        else:
            struct, row = context.make_array(array)(context, builder, args[0]), context.cast(builder, args[1], n, types.intp)
            rows = (row, builder.add(row, ir.Constant(row.type, 1)))
            at = [(one, context.get_constant(types.intp, k)) for one in rows for k in range(6)]
            found = [builder.load(cgutils.get_item_pointer(context, builder, array, struct, place, False)) for place in at]
        both = [context.make_tuple(builder, each, found[k : k + 6]) for k in (0, 6)]
        return context.make_tuple(builder, sig.return_type, both)

    return signature(types.UniTuple(each, 2), array, n), codegen


def _turned_over(builder: Any, places: list[Any]) -> list[Any]:
    """The twelve numbers from each of WIDE addresses on, by their place: eight and four of each are read at once."""
    lanes: list[list[Any]] = []
    for first, many in ((0, 8), (8, 4)):
        kind = ir.VectorType(ir.DoubleType(), many)
        at = [builder.add(one, one.type(8 * first)) for one in places]
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
