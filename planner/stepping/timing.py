"""Timing from the distance stepped (paper, section 4.1 and Fig. 12).

Dynamic similarity (Alexander 1976; coefficient for bipeds by Ruiz & Torices 2013): a stride S = 2s at hip height h goes at

    v = 0.226 sqrt(g) S^1.67 h^-1.17,   step time b = s / v,   Froude number Fr = v^2 / (g h)

Duty factor: walking_duty - 0.104 sqrt(Fr) while walking (walking_duty is near 0.65), 0.344 while running, which begins near
Fr = 0.5; stance time a = 2 beta b.
A step longer than the character's leap_length is a leap: its flight is ballistic, t = sqrt(2 d tan(alpha) / g).
"""

from math import exp, inf, sqrt, tan

from motion.arithmetic.gravity import GRAVITY, froude_number, pendulum_time
from motion.arithmetic.smooth import smoothstep
from motion.characters.dimensions import Dimensions
from planner.round.round import UNHURRIED
from worlds.compiled.jit import jit_borrowing

RUNS_FROM = 0.5
"""Froude number at which walking gives way to running."""
NARROWS = 0.2
"""Range of Froude numbers about that one in which the line of a runner's footprints becomes narrow."""
RUNNING_DUTY = 0.344
RUN_POWER = 1.265
"""Speed of a run grows with this power of the step."""
BREAKS_INTO, FAST_WALK = 0.72, 0.45
"""Share of its speed from which one breaks into a run; Froude number of the fastest walk till then."""
SLOWS_TO = 0.62
"""Share of its speed to which a run, or a leap, slows down within a step."""
BRISK_WALK = 0.3
"""Froude number of the fastest walk that slows down to any pace within a step; from there to the run it may the less."""
RUNNERS_LEAP = 1.45
"""Who runs leaps only beyond so many leap lengths."""
CLIMB, DESCENT, BRISK = 2.8, 2.8, 1.1
"""How many lengths [m] a metre up or down counts for; so reckoned, no step is longer than so many preferred ones."""
SHORTEST_STEP = 0.75
"""Step time of a walk in pendulum times of the hip's height: shorter is scurrying."""
LEAST_SWING = 0.9
"""Shortest time for a swing, in pendulum times."""
PUSH, LEAST_PUSH, COVER = 1.0, 0.5, 1.3
"""Stance before a leap: longest and shortest, in pendulum times, and in times that the leg's reach is crossed at its speed."""
GAIN, UPWARD = 0.4, 0.82
"""Speeds, in sqrt(g h): what the push before a leap adds (more needs more friction than dry soles give); with which one takes
off upward at most, as people who jump as high as they can (2.4 to 2.7 m/s: Bobbert & van Ingen Schenau 1988)."""
ALONE = 0.38
"""Shortest time, in pendulum times, for which a foot pushes alone before a flight: the other one, which is to land, is ahead by
then. From a stand one shifts the weight for long, and the leg that was left behind would be torn off the ground."""
CATCH = 2.6
"""Longest step after a flight, in pendulum times: on one foot alone a body that has come down bounces, and turns over."""
DESCENT_CROUCH = 0.25
"""Share by which the nominal leg is shorter for a step one hip height down: legs bend to take it."""
UPRIGHT = 0.25
"""Froude number up to which one walks on straight legs."""
SNAP = 0.02
"""Overlaps and flights shorter than this [s] become none: a sliver of a phase is not to be seen."""


@jit_borrowing
def hip_pendulum(biped: Dimensions) -> float:
    """The pendulum time of the hip's height [s]: the unit of time of a gait."""
    return pendulum_time(biped.timing.hip_height)


@jit_borrowing
def speed(length: float, hip_height: float) -> float:
    """Speed [m/s] of a gait with this step length [m]."""
    return 0.226 * sqrt(GRAVITY) * (2 * length) ** 1.67 * hip_height**-1.17


@jit_borrowing
def pace_of(biped: Dimensions, length: float) -> float:
    """Speed [m/s] of a character's steps of this length: by Alexander's law, and running by its own, if it has one.

    People run at v / sqrt(g h) = run_speed (s / h)^1.265: 2.5, 3.5 and 4.5 m/s at 0.93, 1.23 and 1.48 m (Fukuchi et al. 2017).
    """
    law = biped.timing
    walking, unit = speed(length, law.hip_height), sqrt(GRAVITY * law.hip_height)
    if law.run_speed == 0:
        return walking
    share = _running(walking * walking / (unit * unit), law.gait_smoothness)
    return walking + share * (law.run_speed * (length / law.hip_height) ** RUN_POWER * unit - walking)


@jit_borrowing
def level_length(biped: Dimensions, length: float, rise: float) -> float:
    """Length [m] of the step on the level that takes as long as one of this length and rise [m].

    A tread makes a step short, not slow: people climb stairs of 17 / 29 cm with the cadence of their walk, at 0.5 to 0.8 m/s
    (Fruin 1971), and go down them a little faster. A step that is long anyway is none the longer.
    """
    most = max(BRISK * biped.gait.preferred_step, length)
    return min(length + (CLIMB * rise if rise > 0 else -DESCENT * rise), most)


@jit_borrowing
def _running(froude: float, smoothness: float) -> float:
    """0 walking, 1 running; smoothness 0 changes abruptly, 1 over a wide range."""
    width = 0.02 + 0.25 * smoothness
    return 1 / (1 + exp(-min(max((froude - RUNS_FROM) / width * 4, -50.0), 50.0)))


@jit_borrowing
def width_at(biped: Dimensions, speed: float) -> float:
    """Distance [m] between the lines of left and right footprints at that speed [m/s]: runners tread nearly in one line."""
    froude = speed * speed / (GRAVITY * biped.timing.hip_height)
    return biped.gait.step_width * (1 - biped.gait.run_narrower * smoothstep((froude - RUNS_FROM) / NARROWS + 0.5))


@jit_borrowing
def is_running(biped: Dimensions, length: float, time: float) -> bool:
    """Whether a step of this length [m] in this time [s] was one of a run: not a walk, and not a leap, which is slower."""
    froude = froude_number(2 * length, 2 * time, biped.timing.hip_height)
    return froude > RUNS_FROM and length > 0.85 * time * pace_of(biped, length)


@jit_borrowing
def duty_factor(froude: float, smoothness: float, slowest: float) -> float:
    """Share of the stride that a foot stands; smoothness 0 changes to the run abruptly, 1 over a wide range; slowest: the
    share at the slowest walk."""
    walking = max(slowest - 0.104 * sqrt(froude), RUNNING_DUTY)
    return walking + _running(froude, smoothness) * (RUNNING_DUTY - walking)


@jit_borrowing
def nominal_length(biped: Dimensions, length: float, step_time: float, rise: float) -> float:
    """Comfortable virtual leg [m] at a step of this length and rise [m] in this time [s]: shorter the faster, and downhill."""
    height = biped.timing.hip_height
    froude = froude_number(length, step_time, height)
    faster = min(max((froude - UPRIGHT) / (1 - UPRIGHT), 0.0), 1.0)
    bent = 1 - biped.gait.run_crouch * faster - DESCENT_CROUCH * max(-rise, 0.0) / height
    return biped.leg.nominal_length * bent


@jit_borrowing
def least_step_time(biped: Dimensions, overlap: float) -> float:
    """Shortest step time after an overlap [s] of double stance, so that the leg has time to swing."""
    return max(overlap, 0.0) + LEAST_SWING * hip_pendulum(biped)


@jit_borrowing
def least_push(biped: Dimensions) -> float:
    """Shortest time for which a foot stands alone before a flight [s]."""
    return ALONE * hip_pendulum(biped)


@jit_borrowing
def after_flight(biped: Dimensions, step: float, stance: float) -> tuple[float, float]:
    """(step time, stance time) [s] of a step after a flight, of these by itself: the other foot comes down soon."""
    share = min(CATCH * hip_pendulum(biped) / step, 1.0)
    return share * step, share * stance


@jit_borrowing
def _snap(step: float, stance: float) -> float:
    if abs(stance - step) < SNAP:
        return step
    return stance


@jit_borrowing
def step_timing(
    biped: Dimensions,
    length: float,
    rise: float,
    turn: float,
    same_side: bool,
    longest: float = UNHURRIED,
    running: bool = False,
    before: float = inf,
) -> tuple[float, float]:
    """(step time, stance time) [s] of the footprint that a step leaves.

    length [m] horizontal, rise [m], turn [rad] >= 0; a hop on the same side is a leap of any length. longest: step time of a
    walk, in pendulum times. running: who runs goes on running, and leaps only from further on. before: speed of the step
    before [m/s]: nobody breaks from a walk into a run at once, nor out of one.
    """
    law = biped.timing
    slower = 1 + law.turn_slowdown * turn + law.rise_slowdown * max(rise, 0.0) / law.hip_height
    if length > (RUNNERS_LEAP if running else 1.0) * biped.reach.leap_length or same_side:
        return _leap(biped, length, rise, slower, before)
    step = _time(biped, length, rise, longest, before) * slower
    froude = froude_number(length, step, law.hip_height)
    return step, _snap(step, 2 * duty_factor(froude, law.gait_smoothness, law.walking_duty) * step)


@jit_borrowing
def level_time(biped: Dimensions, length: float, turn: float, longest: float) -> float:
    """The step time [s] of `step_timing` on level ground, alone."""
    slower = 1 + biped.timing.turn_slowdown * turn
    if length > biped.reach.leap_length:
        return _leap(biped, length, 0.0, slower, inf)[0]
    return _time(biped, length, 0.0, longest, inf) * slower


@jit_borrowing
def _time(biped: Dimensions, length: float, rise: float, longest: float, before: float) -> float:
    """Step time [s] of a walk or a run straight on."""
    law, unit = biped.timing, hip_pendulum(biped)
    level = level_length(biped, max(length, 1e-3), rise)
    v = pace_of(biped, level)
    if before < BREAKS_INTO * v:  # too slow to break into a run: a fast walk
        v = min(v, max(sqrt(FAST_WALK * GRAVITY * law.hip_height), before / BREAKS_INTO))
    step = level / v
    brisk, run = sqrt(BRISK_WALK * GRAVITY * law.hip_height), sqrt(RUNS_FROM * GRAVITY * law.hip_height)
    if brisk < before < inf:  # too fast to walk at once
        step -= min((before - brisk) / (run - brisk), 1.0) * max(step - level / (SLOWS_TO * before), 0.0)
    return min(max(step, SHORTEST_STEP * unit), longest * unit)


@jit_borrowing
def _leap(biped: Dimensions, length: float, rise: float, slower: float, before: float) -> tuple[float, float]:
    """Part of the way is covered while standing, at the mean of the flight's speed and that of the step before [m/s], at most
    the flight's: so who comes slowly pushes for longer, as well as off more steeply."""
    from_length, unit = biped.reach.leap_length, hip_pendulum(biped)
    distance = max(length - 0.5 * from_length, 0.3 * length)
    flight = _flight(biped, distance, rise, before)
    speed = distance / flight
    crossing = from_length / (speed + min(before, speed))
    stance = min(max(COVER * crossing, LEAST_PUSH * unit) * slower, PUSH * unit)
    return stance + flight, stance


@jit_borrowing
def _flight(biped: Dimensions, distance: float, rise: float, before: float) -> float:
    """Time [s] of a flight over that distance [m]. Ballistic: d = v^2 sin(2 alpha) / g gives t^2 = 2 (d tan(alpha) - rise) / g.

    alpha is the character's take-off angle; whoever comes at a speed before [m/s] to which the push cannot add enough takes off
    as much more steeply, within what the legs can do: g t / 2 + rise / t upward.
    """
    law, unit = biped.timing, sqrt(GRAVITY * biped.timing.hip_height)
    usual = sqrt(2 * max(distance * tan(law.takeoff_angle) - rise, 0.04 * law.hip_height) / GRAVITY)
    highest = UPWARD * unit + sqrt(max(UPWARD * unit * UPWARD * unit - 2 * GRAVITY * rise, 0.0))
    return max(usual, min(distance / (before + GAIN * unit), highest / GRAVITY))
