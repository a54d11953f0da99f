"""Wandering (paper, section 4): keep a heading; when the way ahead comes too close to something, change it by chance.

The heading drifts slowly. Where the way ahead is not clear for the distance that the walker looks ahead, the nearest clear
heading is taken, right or left first by chance. No two steps are quite as long (`variation`).
"""

import numpy as np

from motion.arithmetic.smooth import smoothstep
from motion.characters.character import Character
from motion.characters.dimensions import Dimensions
from planner.planner import Situation, fault_of_place
from planner.round.kernel import Compiled
from planner.round.round import Me, Round, Wish, biped_of
from planner.stepping import random
from planner.stepping.beside import middle_beside
from planner.stepping.footing import surely
from planner.stepping.steering import LOOK_STEPS, MARGIN, Onward, lengthened, step_toward
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


@jit_borrowing
def drift(seed: int, character: int, step: int) -> float:
    """Change of heading per step [rad] when nothing hinders: chance values every DRIFT_STEPS, blended smoothly."""
    block, part = step // DRIFT_STEPS, (step % DRIFT_STEPS) / DRIFT_STEPS
    a = random.uniform(seed, character, block, random.DRIFT)
    z = random.uniform(seed, character, block + 1, random.DRIFT)
    part = smoothstep(part)
    return DRIFT * (2 * (a + part * (z - a)) - 1)


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


def _next_step(round: Round, me: Me) -> Wish:
    biped, foot = biped_of(round, me), me.feet.newer
    on = wander_on(biped, round.world, middle_beside(biped, foot), foot.heading, round.seed, me.c, me.number)
    return surely(round, me, (on.x, on.y), on.heading, on.course, False)


_PLANNING = Compiled(_next_step)


class Wander:
    """The planner of wanderers. Raises InputError where a world has no room for so many to start apart."""

    name = "Wander"
    planning = _PLANNING

    def starts(self, world: World, characters: list[Character], seed: int) -> np.ndarray:
        """(C, 3) x, y, heading: the first at the world's start, the others where chance finds room."""
        room = _Room(world, max(float(character.biped.body.radius) for character in characters))
        places = [(*world.start, world.start_heading)]
        for c, character in enumerate(characters):
            if c > 0:
                places.append(room.free_place(character, seed, c))
            room.take(*places[c][:2], float(character.biped.body.radius))
        return np.array(places, np.float64)

    def prepare(self, situation: Situation) -> None:
        """Nothing to look up beforehand."""

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

    def free_place(self, character: Character, seed: int, c: int) -> tuple[float, float, float]:
        """x, y, heading: the first of chance's places that is clear of the world and of those who stand."""
        radius, size = float(character.biped.body.radius), self.world.size
        for k in range(TRIES):
            x, y = (size[i] * random.uniform(seed, c, 3 * k + i, random.PLACE) for i in (0, 1))
            if clearance(self.world.arrays, x, y) > radius + MARGIN and self._is_free(x, y, radius):
                place = (x, y, 2 * np.pi * random.uniform(seed, c, 3 * k + 2, random.PLACE))
                if self.even or fault_of_place(self.world, character, place) is None:
                    return place
        raise InputError(
            f"{self.world.name}: no room for {character.name} number {c + 1} to start apart from the others; "
            "use fewer --characters or a level with more room"
        )

    def _is_free(self, x: float, y: float, radius: float) -> bool:
        i, j = int(x / self.cell), int(y / self.cell)
        near = [body for a in range(i - 1, i + 2) for b in range(j - 1, j + 2) for body in self.taken.get((a, b), [])]
        return all(np.hypot(x - u, y - v) >= APART * (radius + r) for u, v, r in near)
