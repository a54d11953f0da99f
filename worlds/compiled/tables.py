"""Tables: NamedTuples of arrays whose first axes agree, such as footprints; whatever is done to a row is done to all columns.

A table's class declares each column once, by its type: `heading: Numbers`, `position: Vectors`, or an array annotated with a
Column of its own. Making, slicing and copying ask the class, so a new column needs no other line.
"""

from functools import cache
from typing import Annotated, Any, NamedTuple, TypeVar, get_type_hints

import numpy as np
from llvmlite import ir
from numba.core import cgutils, types

from worlds.compiled.across import any_of, isnt
from worlds.compiled.jit import intrinsic, jit_borrowing
from worlds.compiled.lanes import Some, choose, smaller

Table = TypeVar("Table", bound=tuple)


class Column(NamedTuple):
    """What a column holds in each row."""

    dtype: Any = np.float64
    shape: tuple[int, ...] = ()
    fill: Any = 0


Numbers = Annotated[np.ndarray, Column()]
Vectors = Annotated[np.ndarray, Column(shape=(3,))]
Pairs = Annotated[np.ndarray, Column(shape=(2,))]
Quaternions = Annotated[np.ndarray, Column(shape=(4,))]
Integers = Annotated[np.ndarray, Column(np.int64)]
Indices = Annotated[np.ndarray, Column(np.int64, fill=-1)]
"""-1 is none."""
Truths = Annotated[np.ndarray, Column(np.bool_)]


@cache
def columns_of(kind: type) -> dict[str, Column]:
    """The columns of a table's class."""
    hints = get_type_hints(kind, include_extras=True)
    return {name: next(extra for extra in hint.__metadata__ if isinstance(extra, Column)) for name, hint in hints.items()}


def empty(kind: type[Table], *shape: int) -> Table:
    """A table of this shape, its columns filled as they declare."""
    return kind(*(_filled(column, shape) for column in columns_of(kind).values()))


def _filled(column: Column, shape: tuple[int, ...]) -> np.ndarray:
    array = np.empty(shape + column.shape, column.dtype)
    array[...] = column.fill
    return array


def picked(table: Table, index: Any) -> Table:
    """The table of these rows, for Python: any index of arrays."""
    return type(table)(*(column[index] for column in table))


def copied(table: Table) -> Table:
    """The same, to keep; its columns may be tables, too."""
    return type(table)(*(column.copy() if isinstance(column, np.ndarray) else copied(column) for column in table))


def tuple_type(columns: list, kind: type) -> Any:
    """The type that the compiler gives a NamedTuple of these: another one where all columns are alike."""
    if len(set(columns)) == 1:
        return types.NamedUniTuple(columns[0], len(columns), kind)
    return types.NamedTuple(columns, kind)


def _view(context: Any, builder: Any, kind: Any, source: Any, data: Any, sizes: list) -> Any:
    """An array of type `kind` at `data` that borrows what `source` holds, of these last sizes; its strides are the source's."""
    array = context.make_array(kind)(context, builder)
    strides = cgutils.unpack_tuple(builder, source.strides, len(source.strides.type.elements))[-kind.ndim :]
    context.populate_array(
        array,
        data=builder.bitcast(data, array.data.type),
        shape=cgutils.pack_array(builder, sizes),
        strides=cgutils.pack_array(builder, strides),
        itemsize=source.itemsize,
        meminfo=None,
    )
    return array._getvalue()


def _each(context: Any, builder: Any, kind: Any, value: Any) -> Any:
    """(place, type, array, its sizes) of each column of a table's value."""
    for place, column in enumerate(kind.types):
        array = context.make_array(column)(context, builder, builder.extract_value(value, place))
        yield place, column, array, cgutils.unpack_tuple(builder, array.shape, column.ndim)


def _stride(builder: Any, array: Any) -> Any:
    return builder.extract_value(array.strides, 0)


@intrinsic
def row(_, table, index):
    """Row `index` of a table of more than one axis, for kernels: a table that borrows it."""
    result = tuple_type([types.Array(each.dtype, each.ndim - 1, each.layout) for each in table.types], table.instance_class)

    def codegen(context, builder, signature, arguments):
        value, at = arguments
        at = context.cast(builder, at, signature.args[1], types.intp)
        found = context.get_constant_undef(result)
        for place, _, array, sizes in _each(context, builder, signature.args[0], value):
            data = cgutils.pointer_add(builder, array.data, builder.mul(at, _stride(builder, array)))
            view = _view(context, builder, result.types[place], array, data, sizes[1:])
            found = builder.insert_value(found, view, place)
        return found

    return result(table, index), codegen


@intrinsic
def part(_, table, begin, end):
    """Rows begin to end - 1 of a table, for kernels: a table that borrows them."""

    def codegen(context, builder, signature, arguments):
        value = arguments[0]
        first, last = (context.cast(builder, arguments[k], signature.args[k], types.intp) for k in (1, 2))
        found = context.get_constant_undef(table)
        for place, column, array, sizes in _each(context, builder, table, value):
            data = cgutils.pointer_add(builder, array.data, builder.mul(first, _stride(builder, array)))
            view = _view(context, builder, column, array, data, [builder.sub(last, first), *sizes[1:]])
            found = builder.insert_value(found, view, place)
        return found

    return table(table, begin, end), codegen


@intrinsic
def copy_row(_, table, source, goal):
    """Row `goal` of a table becomes what row `source` is, for kernels. Columns are contiguous."""

    def codegen(context, builder, signature, arguments):
        value = arguments[0]
        here, there = (context.cast(builder, arguments[k], signature.args[k], types.intp) for k in (1, 2))
        for _, _, array, _ in _each(context, builder, table, value):
            stride = _stride(builder, array)
            data = builder.bitcast(array.data, ir.IntType(8).as_pointer())
            cgutils.raw_memmove(
                builder,
                builder.gep(data, [builder.mul(there, stride)]),
                builder.gep(data, [builder.mul(here, stride)]),
                stride,
                1,
            )
        return context.get_dummy_value()

    return types.none(table, source, goal), codegen


@jit_borrowing
def newest(times: Some, t: Some) -> Some:
    """Index of the last of ascending times (n,) that is not after t; -1 where all are. np.searchsorted compiles for long."""
    high = len(times)
    low, last = high - high, high - 1
    while any_of(low < high):
        middle = (low + high) >> 1
        later, seeks = t < times[smaller(middle, last)], low < high
        high = choose(later & seeks, middle, high)
        low = choose(isnt(later) & seeks, middle + 1, low)
    return low - 1
