"""Three numbers: points and vectors of kernels, which make no arrays for them; or three Lanes of numbers."""

from worlds.compiled.jit import jit_inline
from worlds.compiled.lanes import Some, choose, larger, root

Triple = tuple[Some, Some, Some]


@jit_inline
def dot(u: Triple, v: Triple) -> Some:
    """u . v"""
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


@jit_inline
def cross(u: Triple, v: Triple) -> Triple:
    """u x v"""
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


@jit_inline
def plus(u: Triple, v: Triple) -> Triple:
    """u + v"""
    return u[0] + v[0], u[1] + v[1], u[2] + v[2]


@jit_inline
def minus(u: Triple, v: Triple) -> Triple:
    """u - v"""
    return u[0] - v[0], u[1] - v[1], u[2] - v[2]


@jit_inline
def times(a: Some, u: Triple) -> Triple:
    """a u"""
    return a * u[0], a * u[1], a * u[2]


@jit_inline
def norm(u: Triple) -> Some:
    """|u|"""
    return root(u[0] * u[0] + u[1] * u[1] + u[2] * u[2])


@jit_inline
def unit(u: Triple) -> Triple:
    """u / |u|; nothing comes of nothing."""
    scale = 1 / larger(norm(u), 1e-300)
    return scale * u[0], scale * u[1], scale * u[2]


@jit_inline
def pick(truth: Some, u: Triple, v: Triple) -> Triple:
    """u where it is true, else v."""
    return choose(truth, u[0], v[0]), choose(truth, u[1], v[1]), choose(truth, u[2], v[2])


@jit_inline
def between(u: Triple, v: Triple, share: Some) -> Triple:
    """From u, at share 0, to v."""
    return u[0] + share * (v[0] - u[0]), u[1] + share * (v[1] - u[1]), u[2] + share * (v[2] - u[2])


@jit_inline
def entries(row: Some) -> Triple:
    """The three entries of an array, or of rows of them."""
    return row[0], row[1], row[2]
