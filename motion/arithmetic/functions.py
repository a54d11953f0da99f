"""Elementary functions of numbers and of lanes, without a branch: calls of the system's would keep lanes apart.

Within 5e-16 of the truth, or of its size where that is more than 1: a reduction of the argument, and the polynomials of
fdlibm (Sun Microsystems 1993) and of Cephes (Moshier 1989).
"""

from worlds.compiled.jit import jit_inline
from worlds.compiled.lanes import Some, choose, fused, larger, nearest, parts_of, root, scaled, smaller

_QUARTER = (1.57079632673412561417e00, 6.07710050630396597660e-11, 2.02226624879595063154e-21)
"""pi / 2 as a sum whose first two parts have few digits: a whole number of turns times them is exact."""
_SINE = (
    -1.66666666666666324348e-01, 8.33333333332248946124e-03, -1.98412698298579493134e-04, 2.75573137070700676789e-06,
    -2.50507602534068634195e-08, 1.58969099521155010221e-10,
)  # fmt: skip
_COSINE = (
    4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05, -2.75573143513906633035e-07,
    2.08757232129817482790e-09, -1.13596475577881948265e-11,
)  # fmt: skip
_OF_PI = (0.7853981633974483, 1.5707963267948966, 3.141592653589793)
"""pi / 4, pi / 2, pi."""
_LOG_2 = (6.93147180369123816490e-01, 1.90821492927058770002e-10)
_LOG = (
    6.666666666666735130e-01, 3.999999999940941908e-01, 2.857142874366239149e-01, 2.222219843214978396e-01,
    1.818357216161805012e-01, 1.531383769920937332e-01, 1.479819860511658591e-01,
)  # fmt: skip


@jit_inline
def _series(z: Some, c: tuple[float, ...]) -> Some:
    """c[0] + c[1] z + ..., six of them."""
    return fused(fused(fused(fused(fused(c[5], z, c[4]), z, c[3]), z, c[2]), z, c[1]), z, c[0])


@jit_inline
def turn(x: Some) -> tuple[Some, Some]:
    """(cosine, sine) of an angle [rad] of up to a million."""
    quarters = nearest(x * 0.63661977236758134308)
    r = fused(-quarters, _QUARTER[2], fused(-quarters, _QUARTER[1], fused(-quarters, _QUARTER[0], x)))
    z = r * r
    sine = fused(r * z, _series(z, _SINE), r)
    cosine = 1.0 - fused(-z * z, _series(z, _COSINE), 0.5 * z)
    k = fused(-4.0, nearest(0.25 * quarters), quarters)
    odd, back = abs(k) == 1.0, abs(k) == 2.0
    x, y = choose(odd, k * -sine, cosine), choose(odd, k * cosine, sine)
    return choose(back, -x, x), choose(back, -y, y)


@jit_inline
def angle(x: Some, y: Some) -> Some:
    """Of the way (x, y), counter-clockwise from +x [rad]; 0 of no way."""
    ax, ay = abs(x), abs(y)
    low, high = smaller(ax, ay), larger(ax, ay)
    steep = low > 0.41421356237309503 * high
    t = choose(steep, low - high, low) / larger(choose(steep, low + high, high), 1e-300)
    z = t * t
    p = fused(-8.750608600031904122785e-1, z, -1.615753718733365076637e1)
    p = fused(fused(fused(p, z, -7.500855792314704667340e1), z, -1.228866684490136173410e2), z, -6.485021904942025371773e1)
    q = fused(z + 2.485846490142306297962e1, z, 1.650270098316988542046e2)
    q = fused(fused(fused(q, z, 4.328810604912902668951e2), z, 4.853903996359136964868e2), z, 1.945506571482613964425e2)
    found = choose(steep, _OF_PI[0], 0.0) + fused(t * z, p / q, t)
    found = choose(ay > ax, _OF_PI[1] - found, found)
    found = choose(x < 0.0, _OF_PI[2] - found, found)
    return choose(y < 0.0, -found, found)


@jit_inline
def arc_cosine(x: Some) -> Some:
    """Angle from 0 to pi of that cosine [rad]; of a number beyond -1 to 1 as of the nearest of these."""
    return angle(x, root(larger((1.0 - x) * (1.0 + x), 0.0)))


@jit_inline
def arc_sine(x: Some) -> Some:
    """Angle from -pi / 2 to pi / 2 of that sine [rad]."""
    return angle(root(larger((1.0 - x) * (1.0 + x), 0.0)), x)


@jit_inline
def exponential(x: Some) -> Some:
    """e^x; beyond +-700 as there."""
    x = smaller(larger(x, -700.0), 700.0)
    k = nearest(1.4426950408889634073599 * x)
    r = fused(-k, 1.42860682030941723212e-6, fused(-k, 6.93145751953125e-1, x))
    z = r * r
    p = r * fused(fused(1.26177193074810590878e-4, z, 3.02994407707441961300e-2), z, 9.99999999999999999910e-1)
    q = fused(3.00198505138664455042e-6, z, 2.52448340349684104192e-3)
    q = fused(fused(q, z, 2.27265548208155028766e-1), z, 2.0)
    return scaled(1.0 + 2.0 * (p / (q - p)), k)


@jit_inline
def logarithm(x: Some) -> Some:
    """Natural logarithm of what is at least 1e-300; of less as of that."""
    m, k = parts_of(larger(x, 1e-300))
    f = m - 1.0
    s = f / (2.0 + f)
    z, g, half = s * s, _LOG, 0.5 * f * f
    r = z * fused(_series(z, g[1:]), z, g[0])
    return k * _LOG_2[0] - ((half - (s * (half + r) + k * _LOG_2[1])) - f)


@jit_inline
def power(x: Some, exponent: Some) -> Some:
    """x^exponent of x >= 0 and exponent > 0."""
    return choose(x > 0.0, exponential(exponent * logarithm(x)), 0.0)


@jit_inline
def levelled(x: Some) -> Some:
    """The hyperbolic tangent: x where that is small, and never beyond -1 or 1."""
    t = exponential(-2.0 * abs(x))
    found = (1.0 - t) / (1.0 + t)
    return choose(x < 0.0, -found, found)
