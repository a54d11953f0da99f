"""Kernels that others call are lowered alone, and do what they do when they are called from Python."""

import numpy as np
from llvmlite.binding import Linkage

from worlds.compiled import jit
from worlds.compiled.inner import Compiled


@jit.jit_borrowing
def _weighed(x: float, weights: np.ndarray, scale: float = 2.0) -> float:
    return scale * x * weights[0]


@jit.jit
def _twice(x: float, weights: np.ndarray) -> np.ndarray:
    out = np.zeros(2)
    out[0], out[1] = _weighed(x, weights), _weighed(x, weights, 3.0)
    return out


@jit.jit
def _sum_of_twice(x: float, weights: np.ndarray) -> float:
    both = _twice(x, weights)
    return both[0] + both[1]


def test_what_is_called_by_kernels_alone_is_not_made_whole():
    weights = np.array([1.5])
    assert _sum_of_twice(2.0, weights) == 15.0
    assert isinstance(_twice, Compiled) and isinstance(_weighed, Compiled)
    assert len(_sum_of_twice.signatures) == 1 and not _twice.signatures and not _weighed.signatures
    assert _weighed(2.0, weights) == 6.0 and _weighed(2, weights, scale=3.0) == 9.0
    np.testing.assert_array_equal(_twice(2.0, weights), [6.0, 9.0])
    assert [len(kernel.signatures) for kernel in (_weighed, _twice)] == [2, 1]


def test_what_a_kernel_has_linked_is_its_own():
    _sum_of_twice(2.0, np.array([1.5]))
    (whole,) = _sum_of_twice.overloads.values()
    names = {function.name for function in whole.library._final_module.functions if not function.is_declaration}
    own = {name for name in names if whole.library._final_module.get_function(name).linkage == Linkage.internal}
    assert {name for name in names if "8_weighed" in name or "6_twice" in name} <= own


def test_errors_of_inner_kernels_reach_python():
    @jit.jit
    def fails(x: float) -> float:
        if x < 0:
            raise ValueError("below zero")
        return x

    @jit.jit
    def calls(x: float) -> float:
        return fails(x) + 1.0

    assert calls(1.0) == 2.0
    try:
        calls(-1.0)
    except ValueError as error:
        assert str(error) == "below zero"
    else:
        raise AssertionError("no error came")
