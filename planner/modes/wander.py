"""Wandering (paper, section 4): keep a heading; when the way ahead comes too close to something, change it by chance.

The heading drifts slowly. Where the way ahead is not clear for the distance that the walker looks ahead, the nearest clear
heading is taken, right or left first by chance. No two steps are quite as long (`variation`). A goal that is set while they
wander is walked to by everyone, around walls and water (planner.stepping.field); then they wander on.
"""

from math import hypot
from typing import NamedTuple

import numpy as np

from motion.arithmetic.smooth import mix, smoothstep
from motion.characters.character import Character
from motion.characters.dimensions import Dimensions
from planner.planner import NoWay, Situation, fault_of_place
from planner.round.kernel import Compiled
from planner.round.round import Me, Round, Wish, biped_of
from planner.stepping import random
from planner.stepping.arriving import look_down, sees, walk_down, walk_on
from planner.stepping.beside import Place, middle_beside
from planner.stepping.field import BARS, fields_to, for_all, ways_from
from planner.stepping.finding import surely
from planner.stepping.steering import LOOK_STEPS, MARGIN, Onward, lengthened, longest_way, step_toward
from worlds.arrays import WorldArrays
from worlds.compiled.jit import jit_borrowing
from worlds.errors import InputError
from worlds.queries import clearance
from worlds.world import World

DRIFT_STEPS = 9
"""Steps over which the drift of the heading changes."""
DRIFT = 0.10
"""Largest drift [rad per step]."""
TRIES = 400
"""Places tried for each start."""
APART = 1.4
"""Distance between bodies at the start, in the sum of their radii."""
WAY = 5.0
"""Chance starts nobody where no way leads straight on for so many preferred steps."""
THERE = 1.0
"""Who walks to a goal is there within so many preferred steps."""
DETOURS, SPARE = 3.0, 20
"""Who walks to a goal gives up after so many times the straight way, and so many steps."""


class Errands(NamedTuple):
    """Where C wanderers walk before they wander on."""

    goal: np.ndarray  # (C, 2) [m]
    steps: np.ndarray  # (C,) they give up after so many more; 0: they wander
    fields: np.ndarray  # (G, rows, columns) the way to the goal that was set last, float32 (planner.stepping.field); or none
    cell: np.ndarray  # (1,) edge of its cells [m]

    @staticmethod
    def shared() -> tuple[str, ...]:
        """Columns of all characters together."""
        return "fields", "cell"


@jit_borrowing
def drift(seed: int, character: int, step: int) -> float:
    """Change of heading per step [rad] when nothing hinders: chance values every DRIFT_STEPS, blended smoothly."""
    block, part = step // DRIFT_STEPS, (step % DRIFT_STEPS) / DRIFT_STEPS
    a = random.uniform(seed, character, block, random.DRIFT)
    z = random.uniform(seed, character, block + 1, random.DRIFT)
    return DRIFT * (2 * mix(a, z, smoothstep(part)) - 1)


@jit_borrowing
def wander_on(
    biped: Dimensions, world: WorldArrays, middle: tuple[float, float], heading: float, seed: int, character: int, step: int
) -> Onward:
    """One step of wandering of the walker whose middle is there; it looks ahead, by chance, up to twice LOOK_STEPS."""
    wanted = heading + drift(seed, character, step)
    look = biped.gait.preferred_step * LOOK_STEPS * (1 + random.uniform(seed, character, step // 4, random.LOOK))
    right_first = random.uniform(seed, character, step // 12, random.SIDE) < 0.5
    on = step_toward(biped, world, middle, heading, wanted, look, right_first)
    return lengthened(on, middle, random.near_one(seed, character, step, biped.gait.variation))


@jit_borrowing
def _has_errand(round: Round, me: Me, middle: Place) -> bool:
    """Whether the walker is on its way to a goal; one that is there, or gives up, forgets it once a real step is planned."""
    errands, c = round.plans, me.c
    if errands.steps[c] <= 0:
        return False
    far = hypot(errands.goal[c, 0] - middle[0], errands.goal[c, 1] - middle[1])
    there = far < THERE * biped_of(round, me).gait.preferred_step
    if me.real:
        errands.steps[c] = 0 if there else errands.steps[c] - 1
    return not there


def _next_step(round: Round, me: Me) -> Wish:
    biped, foot, goal = biped_of(round, me), me.feet.newer, round.plans.goal
    middle = middle_beside(biped, foot)
    if _has_errand(round, me, middle):
        to = (goal[me.c, 0], goal[me.c, 1])
        if len(round.plans.fields) > 0 and not sees(round, me, middle, to):
            course = look_down(biped, round.world, middle, round.plans.fields[0], round.plans.cell[0], to).course
            on = walk_down(round, me, middle, course, (0.0, 0.0))
        else:
            on = walk_on(biped, round.world, middle, foot.heading, to, round.seed, (me.c, me.number))
        return surely(round, me, (on.x, on.y), on.heading, on.course, True)
    on = wander_on(biped, round.world, middle, foot.heading, round.seed, me.c, me.number)
    return surely(round, me, (on.x, on.y), on.heading, on.course, False)


def _no_errands(characters: int) -> Errands:
    return Errands(np.zeros((characters, 2)), np.zeros(characters, np.int64), np.zeros((0, 1, 1), np.float32), np.ones(1))


def _most_steps(situation: Situation, far: np.ndarray) -> np.ndarray:
    """(C,) after how many steps those give up who have so far to go (C,) [m]."""
    strides = np.array([float(one.biped.gait.preferred_step) for one in situation.characters])
    return (DETOURS * far / strides).astype(np.int64) + SPARE


_PLANNING = Compiled(_next_step, _no_errands(1))


class Wander:
    """The planner of wanderers. Raises InputError where a world has no room for so many to start apart."""

    name = "Wander"
    planning = _PLANNING

    def starts(self, world: World, characters: list[Character], seed: int) -> np.ndarray:
        """(C, 3) x, y, heading: the first at the world's start, the others where chance finds room."""
        radius = {each: float(one.biped.body.radius) for each, one in {id(one): one for one in characters}.items()}
        room, places = _Room(world, max(radius.values())), [(*world.start, world.start_heading)]
        for c, character in enumerate(characters):
            if c > 0:
                places.append(room.free_place(character, radius[id(character)], seed, c))
            room.take(*places[c][:2], radius[id(character)])
        return np.array(places, np.float64)

    def prepare(self, situation: Situation) -> Errands:
        """Nowhere to go at first, whatever goal the level has; to another goal, once that is set: those to whom a way leads.

        Raises NoWay where it leads to nobody.
        """
        world, errands, before = situation.world, _no_errands(len(situation.characters)), situation.before
        errands.goal[:] = world.goal or world.start
        if before is None:
            return errands
        same = (errands.goal == before.goal).all()
        if same and not before.steps.any():
            return errands
        fields, cell, _ = fields_to(world, for_all([one.biped for one in situation.characters]), errands.goal[:1])
        middles = situation.feet.position[:, :, :2].mean(axis=1)
        led = np.isfinite(ways_from(fields, cell, np.zeros(len(middles), np.int64), middles)) if len(fields) else np.True_
        if not same and not np.any(led):
            (x, y), names = errands.goal[0].tolist(), " or ".join(sorted({one.name for one in situation.characters}))
            raise NoWay(f"{world.name}: no way for the {names} leads to a goal at ({x:.2f}, {y:.2f}): {BARS}")
        most = before.steps if same else _most_steps(situation, np.hypot(*(errands.goal - middles).T))
        return errands._replace(fields=fields, cell=np.array([cell]), steps=np.where(led, most, 0))

    def check_plans(self, plans: Errands, characters: int) -> None:
        """Whether plans from a file are errands. Raises ValueError."""
        if plans.steps.shape != (characters,) or not 0 <= plans.steps.min() <= plans.steps.max() < 2**53:
            raise ValueError("plans: errands that never end")
        if not (np.abs(plans.goal) < 1e9).all():
            raise ValueError("plans: a goal that cannot be")
        if plans.fields.ndim != 3 or min(plans.fields.shape[1:]) < 1 or not plans.cell[0] > 0:
            raise ValueError("plans: a way that cannot be")

    def values(self) -> dict:
        """It is made of nothing."""
        return {}


class _Room:
    """Where bodies stand already, by cell of a grid as wide as two of the largest and the room between them."""

    def __init__(self, world: World, largest: float) -> None:
        self.world, self.cell = world, 2 * APART * largest
        self.even = world.terrain == "flat" and len(world.rocks) == 0
        self.taken: dict[tuple[int, int], list[tuple[float, float, float]]] = {}

    def take(self, x: float, y: float, radius: float) -> None:
        self.taken.setdefault((int(x / self.cell), int(y / self.cell)), []).append((x, y, radius))

    def free_place(self, character: Character, radius: float, seed: int, c: int) -> tuple[float, float, float]:
        """x, y, heading: the first of chance's places where one of this radius [m] is clear of the world and of those who
        stand."""
        size = self.world.size
        for k in range(TRIES):
            x, y = (size[i] * random.uniform(seed, c, 3 * k + i, random.PLACE) for i in (0, 1))
            if clearance(self.world.arrays, x, y) > radius + MARGIN and self._is_free(x, y, radius):
                place = (x, y, 2 * np.pi * random.uniform(seed, c, 3 * k + 2, random.PLACE))
                if self.even or self._is_fit(character, place):
                    return place
        raise InputError(
            f"{self.world.name}: no room for {character.name} number {c + 1} to start apart from the others; "
            "use fewer --characters or a level with more room"
        )

    def _is_fit(self, character: Character, place: tuple[float, float, float]) -> bool:
        """Whether it can stand there, and go on: from a high rock, or a hole, no step leads away."""
        far = WAY * float(character.biped.gait.preferred_step)
        on = longest_way(character.biped, self.world.arrays, place[0], place[1], far)
        return on >= far and fault_of_place(self.world, character, place) is None

    def _is_free(self, x: float, y: float, radius: float) -> bool:
        i, j = int(x / self.cell), int(y / self.cell)
        near = [body for a in range(i - 1, i + 2) for b in range(j - 1, j + 2) for body in self.taken.get((a, b), [])]
        return all(np.hypot(x - u, y - v) >= APART * (radius + r) for u, v, r in near)
