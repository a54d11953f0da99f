"""Three numbers: points and vectors of kernels, which make no arrays for them."""

from math import sqrt

from worlds.compiled.jit import jit_inline

Triple = tuple[float, float, float]


@jit_inline
def dot(u: Triple, v: Triple) -> float:
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
def times(a: float, u: Triple) -> Triple:
    """a u"""
    return a * u[0], a * u[1], a * u[2]


@jit_inline
def norm(u: Triple) -> float:
    """|u|"""
    return sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2])


@jit_inline
def unit(u: Triple) -> Triple:
    """u / |u|; nothing comes of nothing."""
    scale = 1 / max(norm(u), 1e-300)
    return scale * u[0], scale * u[1], scale * u[2]
