"""Wandering (paper, section 4): keep a heading; when the way ahead comes too close to something, change it by chance.

The walker's middle goes in front of it, its feet half a step width to either side. The heading drifts slowly. Where the way
ahead is not clear for the distance that the walker looks ahead, the nearest clear heading is taken, right or left first by
chance. A heading too far away is reached by short steps that turn: the place where the walker is is always clear, so it
can always turn round, and is never trapped.
"""

from math import atan2, cos, hypot, pi, sin

from planner.stepping import random
from worlds import queries
from worlds.compiled.jit import jit_borrowing

DRIFT_STEPS = 9
"""Steps over which the drift of the heading changes."""
DRIFT = 0.10
"""Largest drift [rad per step]."""
LOOK_STEPS = 3.0
"""Look-ahead in preferred steps; by chance up to twice that."""
FAN = 15
"""Headings tried to either side, spread over half a turn."""
MARGIN = 0.08
"""Tolerance kept beyond the body's radius [m]."""


@jit_borrowing
def free_way(w, x, y, heading, margin, far):
    """Distance [m] that one can go straight on with at least `margin` around, at most `far`."""
    c, s, done = cos(heading), sin(heading), 0.0
    while done < far:
        room = queries.clearance(w, x + done * c, y + done * s) - margin
        if room < 0:
            return done - 0.05 if done > 0.05 else 0.0
        done += max(room, 0.05)
    return far


@jit_borrowing
def drift(seed, character, step):
    """Change of heading per step [rad] when nothing hinders: chance values every DRIFT_STEPS, blended smoothly."""
    block, part = step // DRIFT_STEPS, (step % DRIFT_STEPS) / DRIFT_STEPS
    a = random.uniform(seed, character, block, random.DRIFT)
    z = random.uniform(seed, character, block + 1, random.DRIFT)
    part = part * part * (3 - 2 * part)
    return DRIFT * (2 * (a + part * (z - a)) - 1)


@jit_borrowing
def clear_heading(w, x, y, wanted, margin, look, right_first):
    """(offset, free way): the nearest offset from the wanted heading with a way as long as `look`, else the freest."""
    best, best_free = 0.0, -1.0
    for k in range(FAN + 1):
        for turn in range(2 if k else 1):
            sign = 1.0 if (turn == 0) != right_first else -1.0
            offset = sign * k * pi / FAN
            free = free_way(w, x, y, wanted + offset, margin, look)
            if free >= look:
                return offset, free
            if free > best_free:
                best, best_free = offset, free
    return best, best_free


@jit_borrowing
def step_toward(b, w, x, y, heading, wanted, look, right_first):
    """Next middle (x, y), heading and way: a step toward the nearest clear heading, shorter where it turns."""
    margin = min(b.body_radius + MARGIN, queries.clearance(w, x, y) - 0.01)
    offset, _ = clear_heading(w, x, y, wanted, margin, look, right_first)
    turn = min(max(wanted + offset - heading, -b.max_turn), b.max_turn)
    free = free_way(w, x, y, heading + turn, margin, b.preferred_step)
    length = min(b.preferred_step * max(1 - 0.5 * abs(turn) / b.max_turn, 0.3), free)
    return x + length * cos(heading + turn), y + length * sin(heading + turn), heading + turn, wanted + offset


@jit_borrowing
def wander_step(b, w, x, y, heading, seed, character, step):
    """Next middle (x, y), heading and way of the walker whose middle is at x, y: one step of wandering."""
    wanted = heading + drift(seed, character, step)
    look = b.preferred_step * LOOK_STEPS * (1 + random.uniform(seed, character, step // 4, random.LOOK))
    right_first = random.uniform(seed, character, step // 12, random.SIDE) < 0.5
    return step_toward(b, w, x, y, heading, wanted, look, right_first)


@jit_borrowing
def walk_step(b, w, x, y, heading, stop, seed, character):
    """Next middle (x, y), heading and way of the walker whose middle is at x, y, on its way to stop (2,), not beyond it."""
    dx, dy = stop[0] - x, stop[1] - y
    far = hypot(dx, dy)
    wanted = heading + (atan2(dy, dx) - heading + pi) % (2 * pi) - pi
    right_first = random.uniform(seed, character, 0, random.SIDE) < 0.5
    look = min(b.preferred_step * LOOK_STEPS, far)
    nx, ny, ahead, way = step_toward(b, w, x, y, heading, wanted, look, right_first)
    share = min(far / max(hypot(nx - x, ny - y), 1e-9), 1.0)
    return x + share * (nx - x), y + share * (ny - y), ahead, way
