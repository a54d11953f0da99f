"""A planner in ten lines of plain Python: everyone walks in a circle. A step takes about a tenth of a millisecond."""

from math import cos, sin

from motion.characters.character import load_character
from planner.modes.custom import Custom
from planner.round.round import biped_of, stepping
from planner.stepping.beside import beside, middle_beside
from sim.stage.simulation import Simulation
from worlds.world import World

TURN = 0.15


def in_a_circle(round, me):
    """The next foot goes a step ahead, turned a little to the left."""
    biped, foot = biped_of(round, me), me.feet.newer
    x, y = middle_beside(biped, foot)
    heading = foot.heading + TURN
    stride = biped.gait.preferred_step
    place = beside(biped, 1 - foot.side, (x + stride * cos(heading), y + stride * sin(heading)), heading)
    return stepping(1 - foot.side, place, heading, heading, True)


if __name__ == "__main__":
    sim = Simulation(World("yard", (20.0, 20.0)), [load_character("human")], Custom(in_a_circle, starts=[(10.0, 6.0, 0.0)]))
    for _ in range(1200):
        sim.tick()
    print(f"{sim.footprints.steps} steps; now at {sim.com()[0].round(2).tolist()}")
