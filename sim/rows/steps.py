"""A step in a character's row: footprint n, the timing of the one that it leaves, and the way of the foot to it."""

from planner import plan
from planner.stepping import placing, timing
from sim.rows.crowd import track_of
from worlds.compiled.jit import jit_borrowing


@jit_borrowing
def write(crowd, bipeds, c, n, f):
    """Puts planned footprint f (a planner.plan.Placed) at row n, times the one it leaves, and lays the way to it."""
    b = bipeds[crowd.kind[c]]
    crowd.side[c, n] = f.side
    crowd.position[c, n, 0], crowd.position[c, n, 1], crowd.position[c, n, 2] = f.x, f.y, f.z
    crowd.heading[c, n] = f.heading
    crowd.normal[c, n, 0], crowd.normal[c, n, 1], crowd.normal[c, n, 2] = f.nx, f.ny, f.nz
    crowd.rock[c, n] = f.rock
    crowd.stands[c, n] = f.stands
    crowd.facing[c, n] = 0.0
    _roll(crowd, c, n, f.stands)
    step, stance = _timing(crowd, b, c, n, f)
    set_timing(crowd, b, c, n, f.stands, step, stance)


@jit_borrowing
def _roll(crowd, c, n, stands):
    """Where the support begins on footprint n and ends on n - 1: heel to toe forward, toe to heel backward, else between."""
    ahead = 0.0 if stands else placing.forwardness(crowd.position[c, n - 1], crowd.position[c, n], crowd.heading[c, n])
    if not stands:
        left = placing.forwardness(crowd.position[c, n - 1], crowd.position[c, n], crowd.heading[c, n - 1])
        crowd.roll[c, n - 1, 1] = 0.5 + 0.5 * left
    crowd.roll[c, n, 0] = 0.5 - 0.5 * ahead
    crowd.roll[c, n, 1] = 0.5 + 0.5 * ahead


@jit_borrowing
def _length(crowd, c, n):
    """Horizontal length of the step to footprint n [m]."""
    p, q = crowd.position[c, n - 1], crowd.position[c, n]
    return ((q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2) ** 0.5


@jit_borrowing
def _timing(crowd, b, c, n, f):
    """(step time, stance time) of footprint n - 1 from the step to footprint n (paper, section 4.1)."""
    if f.stands:
        return f.wait, f.wait + plan.START_OVERLAP * timing.pendulum_time(b)
    rise = crowd.position[c, n, 2] - crowd.position[c, n - 1, 2]
    turn = abs(crowd.heading[c, n] - crowd.heading[c, n - 1])
    step, stance = timing.step_timing(b, _length(crowd, c, n), rise, turn, f.side == crowd.side[c, n - 1], f.longest)
    overlap = crowd.contact_time[c, n - 2] + crowd.stance_time[c, n - 2] - crowd.contact_time[c, n - 1]
    longer = max(timing.least_step_time(b, overlap) - step, 0.0)
    return step + longer, stance + longer


@jit_borrowing
def set_timing(crowd, b, c, n, stands, step, stance):
    """Sets the timing of footprint n - 1, the same as a first guess for n's own, and the leg that the pace asks for."""
    if stands:
        crowd.stance_time[c, n - 2] = crowd.contact_time[c, n - 1] + step - crowd.contact_time[c, n - 2]
        crowd.roll[c, n - 2, 1] = 0.5
    crowd.step_time[c, n - 1] = step
    crowd.stance_time[c, n - 1] = stance
    crowd.contact_time[c, n] = crowd.contact_time[c, n - 1] + step
    crowd.step_time[c, n] = step
    crowd.stance_time[c, n] = stance
    rise = crowd.position[c, n, 2] - crowd.position[c, n - 1, 2]
    crowd.nominal_length[c, n] = b.nominal_length if stands else timing.nominal_length(b, _length(crowd, c, n), step, rise)


@jit_borrowing
def lay_way(crowd, bipeds, w, c, n):
    """Lift and hold of the swing that arrives at footprint n."""
    before = n - 1
    while before > 0 and crowd.side[c, before] != crowd.side[c, n]:
        before -= 1
    b = bipeds[crowd.kind[c]]
    placing.lay_swing(b, w, track_of(crowd, c, n + 1), before, n)
