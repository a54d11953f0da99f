"""Trials: a character is driven about a level by keys of chance, and everything that can go wrong is measured.

soles       footprints in water without a rock under them, in a tree, a wall, a rock's side, or outside of the world
body        least distance of the centre of mass from trees, walls and the border: below nothing it is in one
skate       of a point of the sole that is on the ground, over a whole stance
penetration of soles into the ground
jump, turn  largest difference of a joint's velocity, and of a leg's angle, before and after a phase change
kick        most by which a joint of a leg changes its velocity within 1/600 s
keys        how many changed a footprint, how many the very next one that was planned; the most steps that were ended
            before that was planned, and the longest wait for its contact
"""

from collections import Counter
from typing import NamedTuple
from zlib import crc32

import numpy as np

from planner.stepping.footing import FINE, WORDS, why_not_stand
from planner.stepping.placing import EDGE
from sim.files.recording import Recorder
from sim.reports.measure import measure
from sim.reports.trials.answers import Answer, answer
from sim.reports.trials.watching import Watch, Worst
from sim.stage.commands import steer_by_chance
from sim.stage.making import make_steered
from sim.stage.simulation import Simulation
from worlds import queries


class Trial(NamedTuple):
    """What came of it."""

    level: str
    character: str
    seed: int  # `steer LEVEL --character C --seed SEED --headless` is the same run
    seconds: float
    steps: int
    distance: float  # [m]
    soles: dict[str, int]  # how many are where none may be, by what they are in
    body: float  # [m]
    skate: float  # [m]
    penetration: float  # [m]
    jump: Worst  # [m/s]
    turn: Worst  # [rad/s]
    kick: Worst  # [m/s]
    keys: int  # that were pressed
    answered: int  # of them, by another footprint
    at_once: int  # of them, by the very next one that was planned
    ended: int  # most steps that ended before that was planned
    wait: float  # longest wait for its contact [s]


def seed_of(level: str, character: str, seed: int) -> int:
    """Another seed for each level and character, so that other keys are pressed there."""
    return seed + crc32(f"{level} {character}".encode())


def trial(level: str, character: str, seconds: float, seed: int) -> Trial:
    """Drives a character about by the keys of that seed. Raises InputError."""
    sim = make_steered(level, character, 1, seed)
    recorder, watch, answers, keys, body = Recorder(sim), Watch(sim), list[Answer](), 0, np.inf
    for _ in range(round(seconds * sim.tick_rate)):
        sim.tick()
        wish = sim.planner.by_chance(sim.seed, sim.ticks, 1)  # type: ignore[attr-defined]
        if wish is not None:
            keys += 1
            answers += [one for one in (answer(sim, wish),) if one]
        steer_by_chance(sim)
        recorder.capture()
        watch.look()
        body = min(body, _room(sim))
    worst, at_once = measure(recorder.recording())["worst"], [one for one in answers if one.later == 0]
    return Trial(
        level, character, seed, sim.time, sim.footprints.steps, float(sim.distance[0]), dict(misplaced(sim)), body,
        worst["skate"], worst["penetration"], watch.jump, watch.turn, watch.kick, keys, len(answers), len(at_once),
        max((one.contacts for one in at_once), default=0), max((one.seconds for one in at_once), default=0.0),
    )  # fmt: skip


def _room(sim: Simulation) -> float:
    """How far the centre of mass is from trees, walls and the border [m]."""
    (x, y, _), world = sim.com()[0].tolist(), sim.world.arrays
    solid = min(queries.tree_clearance(world, x, y), queries.wall_clearance(world, x, y))
    return min(solid, queries.border_clearance(world, x, y))


def misplaced(sim: Simulation) -> Counter:
    """How many footprints are where no sole may be, by what they are in; on a rock in water its middle must lie on that."""
    prints, world, found = sim.walked().footprints, sim.world.arrays, Counter[str]()
    for (x, y, _), heading, rock in zip(prints.position.tolist(), prints.heading.tolist(), prints.rock.tolist(), strict=True):
        on_rock = rock >= 0 and queries.rock_under(world, x, y, EDGE) == rock
        why = FINE if on_rock else why_not_stand(sim.characters[0].biped, world, x, y, heading)
        if why != FINE:
            found[WORDS[why]] += 1
    return found


def as_dict(one: Trial) -> dict:
    """A trial for JSON."""
    return {key: value._asdict() if isinstance(value, Worst) else value for key, value in one._asdict().items()}


def in_words(one: Trial) -> str:
    """A trial for people."""
    soles = ", ".join(f"{count} that {what}" for what, count in one.soles.items()) or "all well"
    return (
        f"{one.level}, {one.character}, seed {one.seed}: {one.seconds:.0f} s, {one.steps} steps, {one.distance:.0f} m; "
        f"soles {soles}; "
        f"the body keeps {one.body:.2f} m off; skate {1e3 * one.skate:.3f} mm, penetration {1e3 * one.penetration:.1f} mm; "
        f"where phases change, joints jump by {_said(one.jump, 'm/s')}, {_said(one.turn, 'rad/s')}; "
        f"within 1/600 s by {_said(one.kick, 'm/s')}; of {one.keys} keys {one.answered} changed something, {one.at_once} at "
        f"once: after {one.ended} step(s) at most, on the ground within {one.wait:.1f} s"
    )


def _said(worst: Worst, unit: str) -> str:
    return f"{worst.value:.3f} {unit} ({worst.joint}, at {worst.time:.2f} s)" if worst.joint else f"0 {unit}"
