"""Laying a sole on the ground, and lifting the foot over what lies between two footprints."""

from math import cos, sin, sqrt

from motion.pose import swing
from planner.stepping import timing
from worlds import queries
from worlds.arrays import FLAT, HEIGHTMAP, HILLS
from worlds.compiled.jit import jit_borrowing

SAMPLES = 41
"""Shares of the swing at which the ground below the foot is asked for."""
LEVEL_SAMPLES = 11
"""The same on level ground, where only the foot itself, pitched, reaches below its line."""
SHORT = 0.15
"""A step shorter than this [m] does not roll over the whole foot."""
HIGH = 1.6
"""A lift above this many clearances has an edge to go over."""
EDGE = 0.02
"""A rock carries a sole whose middle lies at least this far [m] from the rock's edge."""


@jit_borrowing
def lay_sole(b, w, x, y, heading, rock):
    """(z, normal x, y, z) of a sole whose middle is at x, y: on a rock's flat top, or resting on the terrain.

    On sloping ground the sole takes the slope between its ends and its sides, raised until no end is in the ground.
    """
    if rock >= 0:
        return w.rocks[rock, 3], 0.0, 0.0, 1.0
    if w.terrain_kind == FLAT:
        return 0.0, 0.0, 0.0, 1.0
    c, s = cos(heading), sin(heading)
    half, wide = 0.5 * b.foot_length, 0.5 * b.foot_width
    toe = queries.terrain_height(w, x + half * c, y + half * s)
    heel = queries.terrain_height(w, x - half * c, y - half * s)
    left = queries.terrain_height(w, x - wide * s, y + wide * c)
    right = queries.terrain_height(w, x + wide * s, y - wide * c)
    middle = queries.terrain_height(w, x, y)
    if w.terrain_kind != HILLS and w.terrain_kind != HEIGHTMAP:
        return max(max(toe, heel), middle), 0.0, 0.0, 1.0
    along, across = (toe - heel) / (2 * half), (left - right) / (2 * wide)
    dx, dy = along * c - across * s, along * s + across * c
    length = sqrt(dx * dx + dy * dy + 1)
    return max(middle, 0.5 * (toe + heel)), -dx / length, -dy / length, 1 / length


@jit_borrowing
def forwardness(p, q, heading):
    """How far the step from p to q goes along the heading: 1 forward, -1 backward, 0 sideways or on the spot."""
    dx, dy = q[0] - p[0], q[1] - p[1]
    length = sqrt(dx * dx + dy * dy)
    share = (dx * cos(heading) + dy * sin(heading)) / max(length, SHORT)
    return min(max(1.25 * share, -1.0), 1.0)


@jit_borrowing
def lay_swing(b, w, track, n, m):
    """Sets lift and hold of the swing from footprint n to m, after the ground between: over edges the foot goes up first.

    Smooth ways go with little hold; where that needs a high lift, as on stairs, more hold needs less.
    """
    track.hold[m] = swing.HOLD
    track.lift[m] = _lift(b, w, track, n, m)
    if track.lift[m] > HIGH * b.clearance:
        smooth = track.lift[m]
        track.hold[m] = swing.EDGE_HOLD
        track.lift[m] = _lift(b, w, track, n, m)
        if track.lift[m] > 0.9 * smooth:
            track.hold[m], track.lift[m] = swing.HOLD, smooth
    track.lift[m] += b.run_lift * _runs(b, track, n, m)


@jit_borrowing
def _runs(b, track, n, m):
    """How much of a run the stride from footprint n to m is: 0 at Froude number RUNS_FROM or less, 1 at 1 or more."""
    dx, dy = track.position[m, 0] - track.position[n, 0], track.position[m, 1] - track.position[n, 1]
    time = track.contact_time[m] - track.contact_time[n]
    froude = (dx * dx + dy * dy) / (time * time * timing.GRAVITY * b.hip_height)
    return min(max((froude - timing.RUNS_FROM) / (1 - timing.RUNS_FROM), 0.0), 1.0)


@jit_borrowing
def is_level(b, w, track, n, m):
    """Whether the ground below the swing from footprint n to m is flat, without a rock: no cell that it crosses lists one."""
    if w.terrain_kind != FLAT:
        return False
    p, q = track.position[n], track.position[m]
    bow = swing.outward(b, track, n, m, (p[0], p[1], p[2]), (q[0], q[1], q[2]))
    x, y = abs(bow[0]) + b.foot_length, abs(bow[1]) + b.foot_length
    first = queries.cell_of(w, min(p[0], q[0]) - x, min(p[1], q[1]) - y)
    last = queries.cell_of(w, max(p[0], q[0]) + x, max(p[1], q[1]) + y)
    for row in range(first // w.columns, last // w.columns + 1):
        begin, end = row * w.columns + first % w.columns, row * w.columns + last % w.columns
        if w.rock_start[begin] != w.rock_start[end + 1]:
            return False
    return True


@jit_borrowing
def _lift(b, w, track, n, m):
    """Lift [m] with which heel, ball and toe clear the ground below by b.clearance at mid-swing."""
    lift = b.clearance
    back, ahead = -0.5 * b.foot_length - b.ball_forward, 0.5 * b.foot_length - b.ball_forward
    track.lift[m] = 0.0
    level = is_level(b, w, track, n, m)
    samples = LEVEL_SAMPLES if level else SAMPLES
    for k in range(1, samples):
        s = k / samples
        ball, heading, normal, pitch, flex = swing.sole_at(b, track, n, m, s)
        rise = swing.bump(s)
        for forward, bend in ((back, pitch), (0.0, 0.0), (ahead, pitch - flex)):
            p = swing.point_of_foot(b, ball, heading, normal, forward, 0.0, bend)
            ground = 0.0 if level else queries.ground_height(w, p[0], p[1])
            lack = ground + b.clearance * rise - p[2]
            lift = max(lift, min(lack / rise, 3 * b.max_rise))
    return lift
