"""Tables: rows of many columns at once, by Python and by kernels."""

from typing import NamedTuple

import numpy as np

from motion.track.footprints import Footprints
from worlds.compiled.jit import jit
from worlds.compiled.tables import Integers, Numbers, Vectors, copied, copy_row, empty, part, picked, row


class Stones(NamedTuple):
    weight: Numbers
    place: Vectors
    kind: Integers


class OneColumn(NamedTuple):
    weight: Numbers


def stones(*shape):
    made = empty(Stones, *shape)
    made.weight[...] = np.arange(made.weight.size).reshape(shape)
    made.place[...] = 10.0 * np.arange(made.place.size).reshape(made.place.shape)
    made.kind[...] = np.arange(made.kind.size).reshape(shape)
    return made


def same(a, b):
    for x, y in zip(a, b, strict=True):
        np.testing.assert_array_equal(x, y)


def test_columns_are_filled_as_they_declare():
    made = empty(Footprints, 2)
    assert (made.rock == -1).all() and (made.normal == (0, 0, 1)).all() and not made.stands.any()
    assert made.position.shape == (2, 3) and made.side.dtype == np.int64
    assert empty(Stones, 4, 5).place.shape == (4, 5, 3)


@jit
def look(table, c, begin, end):
    mine = part(row(table, c), begin, end)
    total = 0.0
    for i in range(len(mine.weight)):
        total += mine.weight[i] + mine.place[i, 2]
        mine.kind[i] = 100 + i
    return total


def test_rows_and_parts_borrow():
    table = stones(3, 4)
    expected = table.weight[1, 1:3].sum() + table.place[1, 1:3, 2].sum()
    assert look(table, 1, 1, 3) == expected
    assert table.kind[1].tolist() == [4, 100, 101, 7] and table.kind[0].tolist() == [0, 1, 2, 3]


@jit
def move(table, source, goal):
    copy_row(table, source, goal)


def test_a_row_is_copied_whole():
    table, was = stones(5), stones(5)
    move(table, 4, 1)
    same(picked(table, 1), picked(was, 4))
    same(picked(table, [0, 2, 3, 4]), picked(was, [0, 2, 3, 4]))


@jit
def heaviest(table):
    return part(table, 1, 3).weight.max()


def test_a_table_of_one_column_is_one_too():
    assert heaviest(OneColumn(np.array([9.0, 1.0, 2.0, 7.0]))) == 2.0


def test_picking_and_copying_do_not_borrow():
    table = stones(4)
    kept = copied(picked(table, slice(0, 2)))
    table.weight[:] = -1
    assert kept.weight.tolist() == [0, 1]


def test_every_column_of_the_tables_in_use_is_declared():
    from motion.pose.bones import Bones
    from motion.pose.pose import Pose
    from motion.track.curve import Curve
    from planner.round.reservations import Intents

    for kind in (Footprints, Curve, Pose, Bones, Intents):
        made = empty(kind, 3)
        assert all(len(column) == 3 for column in made)
