"""Sensible worlds made by chance: nobody stands where no foot may, skates, is stretched or stuck; no knee jumps.

A large run: python -m tests.worlds_by_chance N [FIRST]
"""

import sys
from collections import Counter

import numpy as np

from motion.characters.character import Character, load_character
from motion.pose.pose import Pose
from planner.modes.walk_to import WalkTo
from planner.modes.wander import Wander
from planner.planner import NoWay
from planner.river.rock_hop import RockHop
from planner.stepping.footing import FINE, WORDS, why_not_stand
from sim.stage.simulation import Simulation
from worlds.contents.scatter import Scatter, scattered
from worlds.errors import InputError
from worlds.world import River, World

CHARACTERS = ("human", "bird", "dinosaur", "ostrich")
PLANNERS = ("wander", "walk", "river", "crowd")
JUMP = 0.25
"""No knee moves further against the body within a tick, in nominal legs."""
SKATES, STRETCHED = 1e-5, 1.01
"""No ball that lies on the ground moves so far [m] within a tick, no standing leg is longer than so many full ones."""
STUCK = 10.0
"""Nobody who has somewhere to go stays within a step for so long [s] at the end."""
GOAL, AT_GOAL = (21.0, 9.0), 1.2
"""Where walks and crossings go, and how near [m] one is there."""
TERRAINS = ("flat", "flat", "hills", "stairs", "heightmap")


def a_world(rng: np.random.Generator) -> World:
    """Trees, rocks, a river, hills, stairs or bumps, by chance; start and goal at either side."""
    size, terrain, heights, parameters = (24.0, 18.0), TERRAINS[rng.integers(len(TERRAINS))], np.zeros((1, 1)), ()
    if terrain == "hills":
        parameters = (rng.uniform(0.2, 1.5), rng.uniform(8, 30), *rng.uniform(0, 6, 3))
    if terrain == "stairs":
        parameters = (rng.uniform(6, 12), rng.uniform(0.1, 0.22), rng.uniform(0.25, 0.5), int(rng.integers(3, 14)))
    if terrain == "heightmap":
        coarse = rng.uniform(0, rng.uniform(0.2, 4), (7, 9))
        rows, columns = np.linspace(0, 6, 37), np.linspace(0, 8, 49)
        along = np.array([np.interp(columns, np.arange(9), row) for row in coarse])
        heights, parameters = np.array([np.interp(rows, np.arange(7), column) for column in along.T]).T, (0.5,)
    x = rng.uniform(10, 14)
    rivers = (
        (River(np.array([[x, -5.0], [x + rng.uniform(-2, 2), 25.0]]), rng.uniform(0.6, 4.0)),) if rng.random() < 0.5 else ()
    )
    bare = World("chance", size, terrain, tuple(parameters), heights, rivers=rivers, start=(3.0, 9.0), goal=GOAL)
    return scattered(bare, Scatter(
        seed=int(rng.integers(1 << 30)), trees=int(rng.integers(40)), rocks=int(rng.integers(50)), clear=1.2,
        tree_spacing=rng.uniform(0.3, 2.5), rock_radius=(0.25, rng.uniform(0.3, 1.0)),
        rock_height=(0.05, rng.uniform(0.1, 0.6)), rock_spacing=rng.uniform(0.05, 1.2)))  # fmt: skip


def faults(k: int, seconds: float = 30.0) -> Counter:
    """What footprints of run k are where they may not be, by its words; empty where the world has no room or no way."""
    rng = np.random.default_rng(k)
    world, who, kind = a_world(rng), load_character(CHARACTERS[k % 4]), PLANNERS[k // 4 % 4]
    try:
        sim = Simulation(world, [who] * (8 if kind == "crowd" else 1), _planner(kind), k)
    except (InputError, NoWay):
        return Counter(none=1)
    sim.keep_footprints()
    found, watch = Counter(), Watch(who)
    for _ in range(int(60 * seconds)):
        sim.tick()
        found.update(f"{kind} {who.name} {world.terrain}: {what}" for what in watch.see(sim.snapshot()))
        if sim.time < seconds - STUCK:
            then, far = sim.snapshot().com[:, :2], np.zeros(len(sim.snapshot().com))
        far = np.maximum(far, np.linalg.norm(sim.snapshot().com[:, :2] - then, axis=1))
    at_goal = kind in ("walk", "river") and np.linalg.norm(sim.snapshot().com[:, :2] - GOAL, axis=1).max() < AT_GOAL
    if not at_goal and far.min() < who.biped.gait.preferred_step:
        found[f"{kind} {who.name} {world.terrain}: stuck"] += 1
    prints = sim.walked().footprints
    for n in range(len(prints.side)):
        (x, y), heading = prints.position[n, :2].tolist(), float(prints.heading[n])
        why = why_not_stand(who.biped, world.arrays, x, y, heading)
        if why != FINE and not (kind == "river" and prints.rock[n] >= 0):  # a long sole's corners on a small round rock
            found[f"{kind} {who.name} {world.terrain}: {WORDS[why]}"] += 1
    return found


class Watch:
    """What is wrong with a body, tick by tick."""

    def __init__(self, who: Character) -> None:
        self.leg, self.full = float(who.biped.leg.nominal_length), float(who.biped.leg.max_length)
        self.knees: np.ndarray | None = None
        self.balls: np.ndarray | None = None
        self.toes: np.ndarray | None = None

    def see(self, pose: Pose) -> list[str]:
        """In words, what happened since the pose before."""
        knees, wrong = pose.knee - pose.com[:, None], []
        if self.knees is not None and np.linalg.norm(knees - self.knees, axis=2).max() > JUMP * self.leg:
            wrong.append("a knee jumps")
        if np.linalg.norm(pose.hip - pose.ankle, axis=2)[pose.contact].max(initial=0.0) > STRETCHED * self.full:
            wrong.append("a leg is stretched")
        balls, toes = np.where(pose.contact[..., None], pose.ball, np.nan), pose.toe - pose.ball
        if self.balls is not None:
            flat = np.linalg.norm(toes - self.toes, axis=2) < 1e-9  # the sole is not coming down
            moved = np.linalg.norm(balls - self.balls, axis=2)[flat]
            if np.nanmax(moved, initial=0.0) > SKATES:
                wrong.append("a foot skates")
        self.knees, self.balls, self.toes = knees, balls, toes
        return wrong


def _planner(kind: str) -> object:
    walk = WalkTo([(3.0, 9.0, 0.0)], [[GOAL]])
    return {"wander": Wander(), "crowd": Wander(), "river": RockHop(), "walk": walk}[kind]


def main(arguments: list[str]) -> int:
    """N worlds from FIRST on; tells what is wrong in which."""
    first, total, bad = int(arguments[1]) if len(arguments) > 1 else 0, Counter(), 0
    for k in range(first, first + int(arguments[0])):
        found = faults(k)
        total += found
        if found and "none" not in found:
            bad += 1
            print(k, dict(found), flush=True)
    print(f"{bad} of {arguments[0]} worlds ({total.pop('none', 0)} had no room or no way): {dict(total)}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
