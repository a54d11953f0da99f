"""Values in memory: what Python lays down, kernels read; what kernels lay down, Python reads."""

from typing import NamedTuple

import numpy as np
import pytest

from worlds.compiled.jit import jit
from worlds.compiled.memory import Held, read, write
from worlds.compiled.parts import handle


class Inner(NamedTuple):
    small: bool
    number: float
    count: int
    open: bool


class Whole(NamedTuple):
    flag: bool
    matrix: np.ndarray
    inner: Inner
    truths: np.ndarray
    number: int


def whole():
    return Whole(True, np.arange(6.0).reshape(2, 3), Inner(False, 0.5, -7, True), np.array([True, False]), 3)


lend, opened, put, KIND = handle(whole())
lend_inner, open_inner, put_inner, _ = handle(whole().inner)


@jit
def sum_of(address):
    one = opened(address)
    return (
        one.flag, one.matrix[1, 2], one.matrix.shape[1], one.inner.small, one.inner.number, one.inner.count, one.inner.open,
        one.truths[0], one.truths[1], one.number,
    )  # fmt: skip


@jit
def change(address):
    one = opened(address)
    one.matrix[0, 0] = 9.0


@jit
def answer(address):
    was = open_inner(address)
    put_inner(address, Inner(not was.small, was.number + 1, was.count - 1, was.open))


def test_kernels_read_what_is_held():
    held = Held(whole(), KIND)
    assert sum_of(held.address) == (True, 5.0, 3, False, 0.5, -7, True, True, False, 3)
    change(held.address)
    assert held.value.matrix[0, 0] == 9.0


def test_python_reads_what_kernels_write():
    held = Held(whole().inner, handle(whole().inner).kind)
    answer(held.address)
    assert read(Inner, held.address) == Inner(True, 1.5, -8, True)
    write(Inner, Inner(False, 2.0, 1, False), held.address)
    answer(held.address)
    assert read(Inner, held.address) == Inner(True, 3.0, 0, False)


@pytest.mark.parametrize(
    "changed",
    [{"matrix": np.zeros((2, 3), np.float32)}, {"matrix": np.zeros((3, 2)).T}, {"number": 1.0}, {"truths": np.zeros(2)}],
)
def test_another_type_is_not_held(changed):
    with pytest.raises(TypeError, match="cannot be held"):
        Held(whole()._replace(**changed), KIND)


def test_a_tuple_of_another_form_is_not_written():
    held = Held(whole().inner, handle(whole().inner).kind)
    with pytest.raises(TypeError, match="Inner is needed"):
        write(Inner, (True, 1.0), held.address)
