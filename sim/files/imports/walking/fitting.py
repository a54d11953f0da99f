"""From a way to a motion: treads as steps of the one loop that lays footprints, standing between them where there is time, and
one curve over all (motion.motion.solve)."""

from typing import NamedTuple

import numpy as np

from motion.arithmetic.angles import unwrapped
from motion.characters.character import Character
from motion.motion import Motion, solve
from motion.track.curve import Curve, evaluate
from motion.track.footprints import LEFT, STEP, Footprints, Step, outward
from planner.script.laying import finish_steps, lay_steps
from sim.files.imports.trajectories.ways import Way
from sim.files.imports.walking.course import Course, course_of
from sim.files.imports.walking.pace import Pace
from sim.files.imports.walking.treading import Stood, Tread, own_treads, standing_at, treads
from worlds.arrays import WorldArrays
from worlds.compiled.tables import empty
from worlds.errors import InputError

STAND, REST = 0.5, 0.6
"""Seconds of standing before the first step begins, and after the last has landed."""
PAUSE = 1.6
"""Who takes so many step times for a step stands before it."""
CORRECTIONS, LEAST_MOVED, MOST_MOVED = 7, 0.001, 0.08
"""How often footsteps are moved so that the body goes where the way goes, and how far at least and at most each time [m]."""
SWING, LAP = 0.3, 0.04
"""A swing lasts so long [s] at least, where both feet then still stand together for so long."""


class Fitted(NamedTuple):
    """A motion along a way, and when it can be seen."""

    way: Way
    motion: Motion
    since: float  # [s]
    until: float


def fit(way: Way, character: Character, pace: Pace, world: WorldArrays) -> Fitted:
    """The character along a way. Raises InputError where it is too fast for its legs."""
    _check(way, pace, character)
    course = course_of(way)
    biped = character.biped
    taken = own_treads(way, course, biped, pace) if way.landed.any() else treads(course, biped, pace)
    toe_out = 0.0 if way.landed.any() else float(biped.gait.toe_out)  # footsteps that are given point where they do
    motion = _solved(_laid(taken, course, character, world, toe_out), character)
    for _ in range(CORRECTIONS if taken else 0):
        moved = _moved(taken, course, motion)
        if moved == taken:
            break
        taken = moved
        motion = _solved(_laid(taken, course, character, world, toe_out), character)
    return Fitted(way, motion, way.begin, way.end)


def _solved(footprints: Footprints, character: Character) -> Motion:
    return solve(footprints, character, float(footprints.contact_time[-1]) + REST)


def _moved(taken: list[Tread], course: Course, motion: Motion) -> list[Tread]:
    """The treads, each moved by what the body lacks of its way over it and its neighbours: whoever bends cuts corners.

    The mean with the neighbours leaves the sway from foot to foot as it is.
    """
    off, scratch, time = np.zeros((len(taken), 2)), np.empty((3, 3)), motion.curve.time
    for k, tread in enumerate(taken):
        if time[0] < tread.over < time[-1]:
            evaluate(motion.curve, tread.over, *scratch)
            off[k] = course.at(tread.over) - scratch[0, :2]
    around = np.pad(off, ((1, 1), (0, 0)), mode="edge")
    off = 0.25 * around[:-2] + 0.5 * off + 0.25 * around[2:]
    far = np.hypot(*off.T)
    off *= np.minimum(1.0, MOST_MOVED / np.maximum(far, 1e-9))[:, None]
    off[far < LEAST_MOVED] = 0.0
    return [
        tread if np.isnan(tread.over) or x == y == 0 else tread._replace(x=tread.x + x, y=tread.y + y)
        for tread, (x, y) in zip(taken, off.tolist(), strict=True)
    ]


def _check(way: Way, pace: Pace, character: Character) -> None:
    """Nobody is faster than the legs, over half a second."""
    if way.end - way.begin < 0.1:
        return
    time = np.arange(way.begin, way.end, 0.1)
    gone = np.hypot(*(way.at(time + 0.5) - way.at(time)).T)
    worst = int(np.argmax(gone > 0.999 * gone.max()))
    if gone[worst] > 0.5 * pace.fastest:
        fast, at = 2 * gone[worst], time[worst]
        raise InputError(
            f"id {way.name} goes at {fast:.1f} m/s at {at:.1f} s; the {character.name} runs at {pace.fastest:.1f} at most: "
            "are its units metres and seconds, is an identity used twice?"
        )


def _laid(taken: list[Tread], course: Course, character: Character, world: WorldArrays, toe_out: float) -> Footprints:
    """The footprints of treads, in the time of the way."""
    biped, start = character.biped, float(course.time[0])
    feet = standing_at(course, biped, start)
    first = taken[0].side if taken else LEFT
    begin = min(start, taken[0].contact - taken[0].after - STAND) if taken else start
    places = np.array([_place(feet[side]) for side in (first, 1 - first)])
    steps = np.array(_steps(taken, feet, begin, first), STEP)
    places[:, 2] += [outward(side, toe_out) for side in (first, 1 - first)]
    steps["heading"] += np.where(steps["side"] == LEFT, toe_out, -toe_out)
    footprints = empty(Footprints, len(steps) + 2)
    lay_steps(biped, world, footprints, 1 - first, places, steps, np.full(len(steps), np.nan))
    finish_steps(biped, world, footprints, np.nan, REST)
    footprints.contact_time[:] += begin
    _let_go(footprints)
    return footprints


def _place(foot: Stood) -> tuple[float, float, float]:
    return foot.x, foot.y, foot.heading


def _steps(taken: list[Tread], feet: list[Stood], begin: float, first: int) -> list[Step]:
    """Treads as steps (their times from contact to contact), with standing before those that are long in coming."""
    where, steps, now, last = [*feet], list[Step](), begin, 1 - first
    for tread in taken:
        wait = tread.contact - now
        if wait > PAUSE * tread.after or tread.side == last:
            held = max(wait - tread.after, 0.05)
            order = [1 - last] if tread.side == last else [1 - last, last]
            steps += [_standing(where[side], side, held / len(order)) for side in order]
            wait -= held
        heading = unwrapped(tread.heading, where[1 - tread.side].heading)
        where[tread.side] = Stood(tread.x, tread.y, heading)
        steps.append(Step(tread.side, tread.x, tread.y, heading, max(wait, 0.05)))
        now, last = tread.contact, tread.side
    if len(steps) < 2:
        steps += [_standing(where[side], side, 0.5) for side in (1 - last, last)]
    return steps


def _standing(foot: Stood, side: int, seconds: float) -> Step:
    return Step(side, foot.x, foot.y, foot.heading, seconds, np.nan, seconds)


def _let_go(footprints: Footprints) -> None:
    """No foot stands so long that it cannot swing to its next place."""
    upcoming: dict[int, int] = {}
    for n in range(len(footprints.side) - 1, -1, -1):
        side = int(footprints.side[n])
        later = upcoming.get(side)
        upcoming[side] = n
        if later is None or footprints.stands[later]:
            continue
        contact = footprints.contact_time
        other = upcoming.get(1 - side, later)
        leaves = contact[n] + footprints.stance_time[n]
        latest = contact[later] - SWING
        if leaves > latest:
            earliest = contact[other] + LAP if other < later else contact[n]
            footprints.stance_time[n] = max(min(latest, leaves), min(earliest, contact[later] - 0.1)) - contact[n]


def extended(motion: Motion, begin: float, end: float) -> Motion:
    """The motion with standing before and behind it, from `begin` to `end` [s] at least."""
    footprints = Footprints(*(column.copy() for column in motion.footprints))
    curve = motion.curve
    if begin < curve.time[0]:
        early = curve.time[0] - begin + 1.0
        for n in (0, 1):
            footprints.contact_time[n] -= early
            footprints.stance_time[n] += early
        footprints.step_time[1] += early
        curve = _with_row(curve, 0, curve.time[0] - early)
    if end > curve.time[-1]:
        late = end - curve.time[-1] + 1.0
        footprints.stance_time[-2:] += late
        curve = _with_row(curve, len(curve.time), curve.time[-1] + late)
    return Motion(motion.character, footprints, curve, motion.solved)


def _with_row(curve: Curve, at: int, time: float) -> Curve:
    """The curve with a segment of standing still before its first control point or behind its last."""
    near = min(at, len(curve.time) - 1)
    control = curve.control[near].copy()
    control[3:] = 0.0
    support = curve.support[max(min(at, len(curve.time) - 1) - (1 if at else 0), 0)]
    times, controls = np.insert(curve.time, at, time), np.insert(curve.control, at, control, axis=0)
    if at:
        supports = np.vstack([curve.support[:-1], support, support])
    else:
        supports = np.insert(curve.support, 0, support, axis=0)
    return Curve(times, np.ascontiguousarray(controls), np.ascontiguousarray(supports))
