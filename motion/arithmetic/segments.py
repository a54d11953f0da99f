"""Where two straight pieces are nearest to each other."""

from motion.arithmetic.triples import Triple, dot, minus
from worlds.compiled.jit import jit_borrowing


@jit_borrowing
def nearest(p: Triple, q: Triple, r: Triple, s: Triple) -> tuple[float, float]:
    """Shares (x, y) of the segments p q and r s, which may be as short as they like, at which they are nearest.

    |p + x u - r - y v| with u = q - p, v = s - r is least at the x of the lines' nearest points, cut to 0..1, then at the y
    nearest to that point, cut to 0..1, and then at the x nearest to that one.
    """
    u, v, w = minus(q, p), minus(s, r), minus(p, r)
    uu, uv, vv, uw, vw = dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w)
    across = uu * vv - uv * uv
    x = min(max((uv * vw - vv * uw) / across, 0.0), 1.0) if across > 1e-12 * uu * vv else 0.0
    y = min(max((uv * x + vw) / vv, 0.0), 1.0) if vv > 0 else 0.0
    x = min(max((uv * y - uw) / uu, 0.0), 1.0) if uu > 0 else 0.0
    return x, y


@jit_borrowing
def gap(p: Triple, q: Triple, r: Triple, s: Triple) -> tuple[Triple, float, float]:
    """Vector to p q from r s where they are nearest, and the shares of both."""
    x, y = nearest(p, q, r, s)
    return (
        (
            p[0] + x * (q[0] - p[0]) - r[0] - y * (s[0] - r[0]),
            p[1] + x * (q[1] - p[1]) - r[1] - y * (s[1] - r[1]),
            p[2] + x * (q[2] - p[2]) - r[2] - y * (s[2] - r[2]),
        ),
        x,
        y,
    )
