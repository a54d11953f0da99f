"""What a step among others costs, term by term: the one objective by which a step is chosen (weights: planner.round.weights).

    cost = progress lost + turn + touch + near + side + rank + stand

each a number without unit, times its weight. How fast one may go in a direction is none of them: spacing (speed_behind) and
density (pace_at) tell. Others are expected to keep their pace.
"""

from math import cos, exp, hypot, inf, pi, sin
from typing import Any

from motion.arithmetic.angles import wrapped
from planner.crowd.bodies import extent, gap_between, way_to_touch
from planner.crowd.candidates import Bearing, Candidate
from planner.crowd.walker import Walker, squeeze
from worlds.compiled.jit import jit_borrowing, jit_inline

SOON = 0.5
"""Touches sooner than this, in swings, cost no more."""
FADED = 4.0
"""Others further away than so many distances are not felt."""
SURE = 1e-9
"""What is beyond a bound by this [m], or share, is so however numbers are rounded."""
STEEP, FULL, SLOWEST = 0.41, 0.95, 0.2
"""Weidmann's curve, by the share of the ground that bodies cover instead of how many there are on a square metre. STEEP
is 1.2 times his, fitted: with his own, bottlenecks let fewer through than in laboratories. And the least share of the
full speed: who presses on in a jam finds gaps that the mean does not tell."""
SHOULDER = 0.85
"""Who would touch another only further aside than this, in the width of both, does not slow down: it turns the shoulder."""
NARROWER = 0.95
"""Whom one passes by is told of bodies so much narrower; that bodies do not touch is seen to afterwards (is_free)."""


@jit_borrowing
def progress_lost(walker: Walker, vx: float, vy: float) -> float:
    """Speed lost on the wished course, in the full one (the driving term of all models since Helbing & Molnar 1995).

    Who is calm wishes for a velocity, and loses by every other one: who arrives would overshoot.
    """
    if walker.calm:
        return hypot(vx - walker.wish_x, vy - walker.wish_y) / walker.full
    return max(1 - (vx * cos(walker.course) + vy * sin(walker.course)) / walker.full, 0.0)


@jit_borrowing
def turned(walker: Walker, step: Candidate) -> float:
    """Radians that the foot turns off the wished course, and how far the step slants off the foot (0 ahead, 1 aside)."""
    dx, dy = step.x - walker.x, step.y - walker.y
    far = hypot(dx, dy)
    slant = 0.0 if far <= 0 else 1 - (dx * cos(step.heading) + dy * sin(step.heading)) / far
    return abs(wrapped(step.heading - walker.course)) + slant


@jit_inline
def _largest(walker: Walker, other: Any) -> float:
    """Two whose middles are further apart than this [m] do not touch."""
    return max(walker.deep, walker.wide) + max(other.deep, other.wide)


@jit_inline
def way_to(
    walker: Walker, other: Any, px: float, py: float, dx: float, dy: float, part: float, most: float = inf
) -> float:  # fmt: skip
    """The way [m] in direction d until my body touches the other's, which is at p; both are only `part` as wide as they are.

    inf: they do not, or certainly not within `most` [m].
    """
    largest, along = _largest(walker, other), px * dx + py * dy
    if along <= 0 or abs(px * dy - py * dx) >= largest or along - largest > most + SURE:
        return inf
    return _way_to_body(walker, other, px, py, dx, dy, part)


@jit_borrowing
def _way_to_body(walker: Walker, other: Any, px: float, py: float, dx: float, dy: float, part: float) -> float:
    """The same, of one who is not far aside."""
    mine, face = (walker.deep, walker.wide), (walker.face_x, walker.face_y)
    its, looks = (other.deep, other.wide), (other.face_x, other.face_y)
    deep = extent(mine, face, dx, dy) + extent(its, looks, dx, dy)
    wide = part * (extent(mine, face, -dy, dx) + extent(its, looks, -dy, dx))
    return way_to_touch(px, py, dx, dy, deep, wide)


@jit_inline
def speed_behind(walker: Walker, other: Any, dx: float, dy: float, time: float, gap: float, most: float = inf) -> float:
    """The speed [m/s] in the direction of a unit vector d that the time gap [s] to one ahead allows; inf: I pass it by, or it
    allows more than `most`.

    v = s / gap (collision-free speed model, Tordeux, Chraibi & Seyfried 2016), where s is the way until the bodies touch when
    my step, which takes `time` [s], has landed, and the other has kept its pace along d: s = way - v time, so v = way / (gap +
    time). Its pace across d, or against it, does not count: those who converge on a door would all wait for each other.
    """
    far = time * max(other.vx * dx + other.vy * dy, 0.0)
    way = way_to(walker, other, other.x + far * dx, other.y + far * dy, dx, dy, SHOULDER, most * (gap + time))
    return inf if way == inf else max(way + squeeze(walker, dx, dy), 0.0) / (gap + time)


@jit_borrowing
def room_in(walker: Walker, others: Any, to: Bearing, enough: float) -> float:
    """How long a step in a direction may be until my body rests in another's that stops [m]; `enough` or more: so long.

    The body, between the feet, goes half as far as the foot.
    """
    x = 0.5 * (walker.foot_x + (walker.x + to.aside_x)) - walker.rest_x
    y = 0.5 * (walker.foot_y + (walker.y + to.aside_y)) - walker.rest_y
    room = inf
    for i in range(len(others)):
        px, py = others[i].rest_x - x, others[i].rest_y - y
        way = way_to(walker, others[i], px, py, to.ahead_x, to.ahead_y, NARROWER, 0.5 * enough)
        if way > 0:
            room = min(room, way)
    return 2 * (room + squeeze(walker, to.ahead_x, to.ahead_y))


@jit_inline
def covered(other: Any, far: float) -> float:
    """The share that another covers of the ground ahead, where it is ahead: of half a disc, `far` [m] deep, in which what is
    near counts more (weights 2 (1 - r^2 / far^2), whose mean is 1)."""
    room = far * far - other.x * other.x - other.y * other.y
    return 16 / pi * other.deep * other.wide * room / far**4 if room > 0 else 0.0


@jit_borrowing
def pace_at(cover: float) -> float:
    """The share of the full speed that is left where bodies cover such a share of the ground (after Weidmann 1993)."""
    return 1.0 if cover <= 0 else max(1 - exp(-STEEP * (1 / cover - 1 / FULL)), SLOWEST)


@jit_inline
def danger(walker: Walker, other: Any, vx: float, vy: float, horizon: float, swing: float) -> float:
    """1 / time to touch, in swings, beyond that of the horizon (time to collision; Karamouzas et al. 2014), times the speed at
    which they would touch, in the full one: who shuffles harms nobody."""
    wx, wy, largest = vx - other.vx, vy - other.vy, _largest(walker, other)
    along, aside, square = other.x * wx + other.y * wy, other.x * wy - other.y * wx, wx * wx + wy * wy
    late, reach = along - horizon * swing * square, (1 + SURE) * largest * largest * square
    if along < -SURE or aside * aside > reach or (late > 0 and late * late > reach):
        return 0.0  # most do not touch, or too late: seen without a root, and with room for what is rounded
    return _danger(walker, other, wx, wy, horizon, swing)


@jit_borrowing
def _danger(walker: Walker, other: Any, wx: float, wy: float, horizon: float, swing: float) -> float:
    """The same, at a velocity w against the other."""
    speed = hypot(wx, wy)
    if speed < 1e-9:
        return 0.0
    time = max(way_to(walker, other, other.x, other.y, wx / speed, wy / speed, 1.0), 0.0) / speed / swing
    return speed / walker.full * (1 / max(time, SOON) - 1 / horizon) if time < horizon else 0.0


@jit_inline
def nearness(walker: Walker, other: Any, vx: float, vy: float, time: float, distance: float) -> float:
    """exp(-gap / distance) to another when my step has landed (social distance; Helbing & Molnar 1995)."""
    px, py = other.x + time * (other.vx - vx), other.y + time * (other.vy - vy)
    if px * px + py * py > (FADED * distance + walker.wide + other.wide) ** 2:
        return 0.0
    return exp(-max(_gap(walker, other, px, py), 0.0) / distance)


@jit_borrowing
def _gap(walker: Walker, other: Any, px: float, py: float) -> float:
    """The gap [m] between my body and the other's, which is at p."""
    mine, face = (walker.deep, walker.wide), (walker.face_x, walker.face_y)
    return gap_between(mine, face, (other.deep, other.wide), (other.face_x, other.face_y), px, py)


@jit_inline
def in_the_way(walker: Walker, other: Any, x: float, y: float) -> float:
    """How deep my body, resting at x, y, lies in the claim of one who has the right of way, in my half depth; at most 1.

    Who has waited longer has it (right of way; Curtis, Zafar, Gutub & Manocha 2013).
    """
    px, py = other.claim_x - x, other.claim_y - y
    far = walker.wide + other.wide + walker.deep + other.deep
    if not (abs(px) < far and abs(py) < far):
        return 0.0
    return min(max(-_gap(walker, other, px, py), 0.0) / walker.deep, 1.0)
