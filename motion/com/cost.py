"""The two costs of a moment, with their derivatives (paper, section 2.4).

Unit mass; a is the acceleration of the centre of mass c and w = a - g the force per mass that is needed. A standing leg
can push along K = unit(c - s), s its point of support, and never pull.

    flight         F = 0                                    r = w - F, e = |r|
    single stance  F = max(0, w.K) K                        r = P w,  P = I - K K^T
    double stance  F = a1 K1 + a2 K2, a1, a2 >= 0, nearest  r = (n.w) n inside the cone, n = unit(K1 x K2)
    comfort        e = k (l - l_nominal)^2 per standing leg, l = |c - q|, q = ankle minus the hip's offset from c

Not in the paper: reach. Beyond l_max the comfort cost is STRETCH times as stiff, and k * 20 s * (l - l_max)^2 counts once at
either end of a segment, where legs are longest: both lower the body before a leg would have to be longer than it is. And
strength: a force |w| beyond what the legs can give costs weight (|w| - strength)^2, or a short double stance would be a hammer:
within the cone of its two legs any force is free.

Derivatives: N, the projector on what the legs cannot give, is I, P, or n n^T. Moving c by dc turns leg j by P_j dc / d_j,
d_j = |c - s_j|, and with it its push a_j K_j; as N P_j = N,

    dr = N (dw - phi dc) + terms of size |r|,    phi = sum of a_j / d_j,    de/dw = r / |r|,    de/dc = -phi r / |r| (exactly)

so a moment's model is one 3x3 matrix M = N / max(|r|, eps) in the single variable dw - phi dc: Gauss-Newton on the
reweighted squared norm. It leaves out that a push cannot turn into a pull: inside the cone it would shift weight between
the legs for nothing and jump out of it. So each share a_j of a double stance is held by CAUTION / max(a_j, 1)^2 (da_j)^2, the
barrier's metric: it vanishes at the solution, and the full step needs no other damping.
"""

from math import sqrt
from typing import Any, NamedTuple

import numpy as np

from motion.arithmetic.gravity import GRAVITY
from motion.track.curve import Weights
from worlds.compiled.jit import jit_borrowing, jit_inline
from worlds.compiled.lanes import Some, choose, fused, larger, root

STRETCH = 100.0
"""Stiffness of a leg beyond full extension, in comfort weights: more keeps it shorter, and solves slower."""
REACH_TIME = 20.0
"""Weight of a leg beyond full extension, in seconds of discomfort: more keeps it shorter, and solves slower."""
CAUTION = 0.01
"""Stiffness of the shares in double stance [m/s^2]: less overshoots the cone, more creeps."""
_LEAST_SHARE = 1.0
"""Push [m/s^2] below which a leg's share gets no stiffer, so that it can still vanish."""
_NEARLY_PARALLEL = 1e-9
Three = tuple[Some, Some, Some]
Lower = tuple[Some, Some, Some, Some, Some, Some]
"""A lower triangle: 00, 10, 11, 20, 21, 22."""


class PhysicsModel(NamedTuple):
    """e_physics and its model in dw - phi dc."""

    size: Some  # |r|
    phi: Some
    gradient: Three
    matrix: Lower  # M


class ComfortModel(NamedTuple):
    """e_comfort of one leg and its model in dc."""

    cost: Some
    gradient: Three
    matrix: Lower


@jit_inline
def mix(weights: Weights, u: Any) -> Some:
    """Sum of the four knots u by their weights."""
    w = weights
    return fused(w[3], u[3], fused(w[2], u[2], fused(w[1], u[1], w[0] * u[0])))


@jit_inline
def smooth_norm(r: Some, eps: float) -> Some:
    """Huber's |r|: a parabola below eps, never below |r|; its weight is 1 / max(|r|, eps)."""
    return choose(r >= eps, r, 0.5 * (r * r / eps + eps))


@jit_inline
def _leg(com: Three, w: Three, s: Three) -> tuple[Some, Some, Some, Some, Some]:
    """Unit leg K (three numbers), 1 / its length, and the push w.K that it would have to give."""
    x, y, z = com[0] - s[0], com[1] - s[1], com[2] - s[2]
    inverse = 1 / (root(x * x + y * y + z * z) + 1e-300)
    x, y, z = x * inverse, y * inverse, z * inverse
    return x, y, z, inverse, w[0] * x + w[1] * y + w[2] * z


@jit_inline
def _either(truth: Some, yes: Any, no: Any) -> Three:
    """yes where it is true, else no, of the first three numbers."""
    return choose(truth, yes[0], no[0]), choose(truth, yes[1], no[1]), choose(truth, yes[2], no[2])


@jit_inline
def _single_model(w: Three, left: Any, right: Any, on0: Some, on1: Some, eps: float) -> PhysicsModel:
    """The leg that stands and pushes more carries; where none pushes, nothing does: flight."""
    push0, push1 = choose(on0, left[4], -np.inf), choose(on1, right[4], -np.inf)
    first = push0 >= push1
    push = larger(choose(first, push0, push1), 0.0)
    nearer = choose(first, left[3], right[3])
    x, y, z = _either(push > 0, _either(first, left, right), (0.0, 0.0, 0.0))  # a foot in the air may be nowhere: NaN
    r0, r1, r2 = w[0] - push * x, w[1] - push * y, w[2] - push * z
    r = root(r0 * r0 + r1 * r1 + r2 * r2)
    q = 1 / larger(r, eps)
    matrix = (q - q * x * x, -q * y * x, q - q * y * y, -q * z * x, -q * z * y, q - q * z * z)
    return PhysicsModel(r, choose(push > 0, push * nearer, 0.0), (q * r0, q * r1, q * r2), matrix)


@jit_inline
def _double_model(w: Three, left: Any, right: Any, k: Some, eps: float) -> PhysicsModel:
    """Both legs (from _leg) carry; k = K1.K2."""
    x0, y0, z0, near0, push0 = left
    x1, y1, z1, near1, push1 = right
    inverse = 1 / (1 - k * k)
    a0, a1 = (push0 - k * push1) * inverse, (push1 - k * push0) * inverse
    t = root(inverse)
    n0, n1, n2 = t * (y0 * z1 - z0 * y1), t * (z0 * x1 - x0 * z1), t * (x0 * y1 - y0 * x1)
    r = n0 * w[0] + n1 * w[1] + n2 * w[2]
    size = larger(r, -r)
    q = 1 / larger(size, eps)
    g = q * r
    t0, t1 = inverse / larger(a0, _LEAST_SHARE), inverse / larger(a1, _LEAST_SHARE)
    h0, h1 = CAUTION * t0 * t0, CAUTION * t1 * t1
    u0, u1, u2 = x0 - k * x1, y0 - k * y1, z0 - k * z1
    v0, v1, v2 = x1 - k * x0, y1 - k * y0, z1 - k * z0
    matrix = (
        q * n0 * n0 + h0 * u0 * u0 + h1 * v0 * v0,
        q * n1 * n0 + h0 * u1 * u0 + h1 * v1 * v0,
        q * n1 * n1 + h0 * u1 * u1 + h1 * v1 * v1,
        q * n2 * n0 + h0 * u2 * u0 + h1 * v2 * v0,
        q * n2 * n1 + h0 * u2 * u1 + h1 * v2 * v1,
        q * n2 * n2 + h0 * u2 * u2 + h1 * v2 * v2,
    )
    return PhysicsModel(size, a0 * near0 + a1 * near1, (g * n0, g * n1, g * n2), matrix)


@jit_inline
def physics_model(com: Three, w: Three, s0: Three, s1: Three, on0: Some, on1: Some, eps: float) -> PhysicsModel:
    """e_physics = |r| at a com with needed force w, and its model in dw - phi dc, the norm smoothed below eps.

    s0 and s1 are the points of support of left and right leg, on0 and on1 whether they stand. Of numbers or of lanes.
    Two-column non-negative least squares: both legs where both would push, or else the one that pushes more.
    """
    left, right = _leg(com, w, s0), _leg(com, w, s1)
    k = left[0] * right[0] + left[1] * right[1] + left[2] * right[2]
    both = on0 & on1 & (1 - k * k > _NEARLY_PARALLEL) & (left[4] > k * right[4]) & (right[4] > k * left[4])
    one, two = _single_model(w, left, right, on0, on1, eps), _double_model(w, left, right, k, eps)
    matrix = _either(both, two.matrix[:3], one.matrix[:3]) + _either(both, two.matrix[3:], one.matrix[3:])
    phi = choose(both, two.phi, one.phi)
    return PhysicsModel(choose(both, two.size, one.size), phi, _either(both, two.gradient, one.gradient), matrix)


@jit_borrowing
def physics_cost(com: np.ndarray, acceleration: np.ndarray, support: np.ndarray, standing: np.ndarray) -> float:
    """e_physics [m/s^2] of a com (3,) and its acceleration (3,); support (2, 3) points of support, standing (2,) bool."""
    s0, s1 = (support[0, 0], support[0, 1], support[0, 2]), (support[1, 0], support[1, 1], support[1, 2])
    w = (acceleration[0], acceleration[1], acceleration[2] + GRAVITY)
    return physics_model((com[0], com[1], com[2]), w, s0, s1, standing[0], standing[1], 1.0).size


@jit_inline
def comfort_model(com: Three, q: Three, on: Some, nominal_length: Some, max_length: float, weight: Some) -> ComfortModel:
    """weight * ((leg length - nominal)^2 + STRETCH * (what it is longer than max_length)^2) of one leg, by Gauss-Newton.

    0 unless `on`; of numbers or of lanes. q: where the leg begins, less the hip's offset from the com.
    """
    x, y, z = com[0] - q[0], com[1] - q[1], com[2] - q[2]
    length = root(x * x + y * y + z * z) + 1e-300
    inverse = 1 / length
    x, y, z = x * inverse, y * inverse, z * inverse
    soft = choose(on, weight, 0.0 * weight)
    over = larger(length - max_length, 0.0)
    hard = choose(over > 0, STRETCH * soft, 0.0 * soft)
    stretch = length - nominal_length
    e = soft * stretch * stretch + hard * over * over
    g, h = 2 * (soft * stretch + hard * over), 2 * (soft + hard)
    hx, hy, hz = h * x, h * y, h * z
    return ComfortModel(e, (g * x, g * y, g * z), (hx * x, hy * x, hy * y, hz * x, hz * y, hz * z))


@jit_borrowing
def reach_cost(com: np.ndarray, q: np.ndarray, standing: np.ndarray, max_length: Any, weight: float) -> float:
    """Penalty of legs longer than max_length (2,) at a com (3,); q (2, 3) as in comfort_model."""
    e = 0.0
    for leg in range(2):
        if standing[leg]:
            x, y, z = com[0] - q[leg, 0], com[1] - q[leg, 1], com[2] - q[leg, 2]
            over = max(sqrt(x * x + y * y + z * z) - max_length[leg], 0.0)
            e += REACH_TIME * weight * over * over
    return e


@jit_inline
def reach_model(com: Three, q: Three, on: Some, max_length: Some, weight: float) -> ComfortModel:
    """reach_cost of one leg with its gradient and Gauss-Newton matrix in the com; of numbers or of lanes."""
    x, y, z = com[0] - q[0], com[1] - q[1], com[2] - q[2]
    length = root(x * x + y * y + z * z) + 1e-300
    over = larger(length - max_length, 0.0)
    stiff = choose(on & (over > 0), 2 * REACH_TIME * weight, 0.0 * over)
    x, y, z, force = x / length, y / length, z / length, stiff * over
    hx, hy, hz = stiff * x, stiff * y, stiff * z
    matrix = (hx * x, hy * x, hy * y, hz * x, hz * y, hz * z)
    return ComfortModel(0.5 * force * over, (force * x, force * y, force * z), matrix)


@jit_inline
def strength_model(w: Three, strength: float, weight: float) -> PhysicsModel:
    """weight * (|w| - strength)^2 where the needed force w is beyond the legs' strength [m/s^2], in dw (paper, section 3)."""
    size = root(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]) + 1e-300
    over = larger(size - strength, 0.0)
    x, y, z = w[0] / size, w[1] / size, w[2] / size
    g, aside = 2 * weight * over, 2 * weight * over / size
    along = choose(over > 0, 2 * weight, 0.0) - aside
    matrix = (
        aside + along * x * x, along * y * x, aside + along * y * y, along * z * x, along * z * y, aside + along * z * z,
    )  # fmt: skip
    return PhysicsModel(weight * over * over, 0.0 * size, (g * x, g * y, g * z), matrix)
