"""The two costs of a moment, with their derivatives (paper, section 2.4).

Unit mass; a is the acceleration of the centre of mass c and w = a - g the force per mass that is needed. A standing leg
can push along K = unit(c - s), s its point of support, and never pull.

    flight         F = 0                                    e = |w|
    single stance  F = max(0, w.K) K                        e = |w - F| = |p|,  p = P w,  P = I - K K^T
    double stance  F = a1 K1 + a2 K2, a1, a2 >= 0, nearest  e = |n.w| inside the cone, n = unit(K1 x K2)
    comfort        e = k (l - l_nominal)^2 per standing leg, l = |c - q|, q = ankle minus the hip's offset from c

Not in the paper: reach, k * 20 s * (l - l_max)^2 where l > l_max, once at either end of a segment, where legs are longest: it
lowers the body before a leg would have to be longer than it is.

Derivatives: for single stance r = -p has dr/da = -P and dr/dc = ((w.K) P + K p^T) / d, d = |c - s|. In double stance
m = (c - s1) x (c - s2) turns with c as dm = dc x (s1 - s2), so d(n.w)/dc = (s1 - s2) x w_perp / |m|, w_perp the part of w in
the plane. Gauss-Newton weights each residual by 1 / max(|r|, eps): the exact gradient where |r| > eps.
"""

from math import sqrt

from motion.jit import jit

GRAVITY = 9.81
"""m/s^2, along -z."""

REACH_TIME = 20.0
"""Weight of a leg beyond full extension, in seconds of discomfort: more keeps it shorter, and solves slower."""
_NEARLY_PARALLEL = 1e-9


@jit
def smooth_norm(r, eps):
    """Huber's |r|: a parabola below eps, never below |r|; its weight is 1 / max(|r|, eps)."""
    return r if r >= eps else 0.5 * (r * r / eps + eps)


@jit
def _pushes(c0, c1, c2, w0, w1, w2, s):
    """Unit leg K, its length d and the push w.K that it would have to give. s (3,)."""
    x, y, z = c0 - s[0], c1 - s[1], c2 - s[2]
    d = sqrt(x * x + y * y + z * z) + 1e-300
    x, y, z = x / d, y / d, z / d
    return x, y, z, d, w0 * x + w1 * y + w2 * z


@jit
def active_set(c0, c1, c2, w0, w1, w2, s, standing):
    """Which legs carry: 0 none, 1 left, 2 right, 3 both (two-column non-negative least squares). s (2, 3), standing (2,)."""
    x0, y0, z0, _, b0 = _pushes(c0, c1, c2, w0, w1, w2, s[0])
    x1, y1, z1, _, b1 = _pushes(c0, c1, c2, w0, w1, w2, s[1])
    left, right = standing[0] and b0 > 0, standing[1] and b1 > 0
    if standing[0] and standing[1]:
        k = x0 * x1 + y0 * y1 + z0 * z1
        if 1 - k * k > _NEARLY_PARALLEL and b0 > k * b1 and b1 > k * b0:
            return 3
    if left and right:
        return 1 if b0 >= b1 else 2
    return 1 if left else (2 if right else 0)


@jit
def physics_cost(c0, c1, c2, w0, w1, w2, s, standing):
    """e_physics [m/s^2] at com c with needed force w; s (2, 3) points of support, standing (2,)."""
    legs = active_set(c0, c1, c2, w0, w1, w2, s, standing)
    if legs == 0:
        return sqrt(w0 * w0 + w1 * w1 + w2 * w2)
    if legs == 3:
        n0, n1, n2, _ = _plane_normal(c0, c1, c2, s)
        return abs(n0 * w0 + n1 * w1 + n2 * w2)
    x, y, z, _, push = _pushes(c0, c1, c2, w0, w1, w2, s[legs - 1])
    p0, p1, p2 = w0 - push * x, w1 - push * y, w2 - push * z
    return sqrt(p0 * p0 + p1 * p1 + p2 * p2)


@jit
def comfort_cost(c0, c1, c2, q, standing, nominal_length, weight):
    """e_comfort at com c: weight * sum of (leg length - nominal)^2 over the standing legs. q (2, 3), nominal_length (2,)."""
    e = 0.0
    for leg in range(2):
        if standing[leg]:
            x, y, z = c0 - q[leg, 0], c1 - q[leg, 1], c2 - q[leg, 2]
            stretch = sqrt(x * x + y * y + z * z) - nominal_length[leg]
            e += weight * stretch * stretch
    return e


@jit
def reach_cost(c, q, standing, max_length, weight):
    """Penalty of legs longer than max_length at com c (3,). q (2, 3), max_length (2,)."""
    e = 0.0
    for leg in range(2):
        if standing[leg]:
            x, y, z = c[0] - q[leg, 0], c[1] - q[leg, 1], c[2] - q[leg, 2]
            over = max(sqrt(x * x + y * y + z * z) - max_length[leg], 0.0)
            e += REACH_TIME * weight * over * over
    return e


@jit
def add_reach(c, q, standing, max_length, weight, h, g):
    """Adds the Gauss-Newton block of the reach penalty in c: h (6, 6), lower triangle; g (6,). Returns e."""
    e = 0.0
    for leg in range(2):
        if standing[leg]:
            u = (c[0] - q[leg, 0], c[1] - q[leg, 1], c[2] - q[leg, 2])
            length = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2])
            over = length - max_length[leg]
            if over > 0:
                stiffness = 2 * REACH_TIME * weight
                e += 0.5 * stiffness * over * over
                for i in range(3):
                    g[i] += stiffness * over * u[i] / length
                    for j in range(i + 1):
                        h[i, j] += stiffness * u[i] * u[j] / (length * length)
    return e


@jit
def _plane_normal(c0, c1, c2, s):
    """Unit normal of the plane through com and both points of support, and |m|, twice the triangle's area."""
    ax, ay, az = c0 - s[0, 0], c1 - s[0, 1], c2 - s[0, 2]
    bx, by, bz = c0 - s[1, 0], c1 - s[1, 1], c2 - s[1, 2]
    m0, m1, m2 = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
    area = sqrt(m0 * m0 + m1 * m1 + m2 * m2) + 1e-300
    return m0 / area, m1 / area, m2 / area, area


@jit
def _add_flight(w0, w1, w2, eps, h, g):
    r = sqrt(w0 * w0 + w1 * w1 + w2 * w2)
    q = 1 / max(r, eps)
    h[3, 3] += q
    h[4, 4] += q
    h[5, 5] += q
    g[3] += q * w0
    g[4] += q * w1
    g[5] += q * w2
    return smooth_norm(r, eps)


@jit
def _add_single(c0, c1, c2, w0, w1, w2, s, eps, h, g):
    k0, k1, k2, d, push = _pushes(c0, c1, c2, w0, w1, w2, s)
    k = (k0, k1, k2)
    p = (w0 - push * k0, w1 - push * k1, w2 - push * k2)
    r = sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2])
    q = 1 / max(r, eps)
    f = push / d
    dd = q / (d * d)
    for i in range(3):
        g[3 + i] += q * p[i]
        g[i] -= q * f * p[i]
        for j in range(3):
            normal = q * ((1.0 if i == j else 0.0) - k[i] * k[j])
            h[3 + i, 3 + j] += normal
            h[i, 3 + j] -= f * normal
            h[i, j] += f * f * normal + dd * p[i] * p[j]
    return smooth_norm(r, eps)


@jit
def _add_double(c0, c1, c2, w0, w1, w2, s, eps, h, g):
    n0, n1, n2, area = _plane_normal(c0, c1, c2, s)
    n = (n0, n1, n2)
    r = n0 * w0 + n1 * w1 + n2 * w2
    v0, v1, v2 = w0 - r * n0, w1 - r * n1, w2 - r * n2
    x, y, z = s[0, 0] - s[1, 0], s[0, 1] - s[1, 1], s[0, 2] - s[1, 2]
    turn = ((y * v2 - z * v1) / area, (z * v0 - x * v2) / area, (x * v1 - y * v0) / area)
    q = 1 / max(abs(r), eps)
    for i in range(3):
        g[i] += q * r * turn[i]
        g[3 + i] += q * r * n[i]
        for j in range(3):
            h[i, j] += q * turn[i] * turn[j]
            h[i, 3 + j] += q * turn[i] * n[j]
            h[3 + i, 3 + j] += q * n[i] * n[j]
    return smooth_norm(abs(r), eps)


@jit
def add_physics(c0, c1, c2, w0, w1, w2, s, standing, eps, h, g):
    """Adds the Gauss-Newton block of e_physics in (c, a): h (6, 6) without its lower left block, g (6,). Returns e."""
    legs = active_set(c0, c1, c2, w0, w1, w2, s, standing)
    if legs == 0:
        return _add_flight(w0, w1, w2, eps, h, g)
    if legs == 3:
        return _add_double(c0, c1, c2, w0, w1, w2, s, eps, h, g)
    return _add_single(c0, c1, c2, w0, w1, w2, s[legs - 1], eps, h, g)


@jit
def add_comfort(c0, c1, c2, q, standing, nominal_length, weight, h, g):
    """Adds the Gauss-Newton block of e_comfort in c. Returns e."""
    e = 0.0
    for leg in range(2):
        if standing[leg]:
            x, y, z = c0 - q[leg, 0], c1 - q[leg, 1], c2 - q[leg, 2]
            length = sqrt(x * x + y * y + z * z) + 1e-300
            u = (x / length, y / length, z / length)
            stretch = length - nominal_length[leg]
            e += weight * stretch * stretch
            for i in range(3):
                g[i] += 2 * weight * stretch * u[i]
                for j in range(3):
                    h[i, j] += 2 * weight * u[i] * u[j]
    return e
