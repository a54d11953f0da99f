"""The same planner, compiled: a microsecond a step. The function is the same; it must call nothing but kernels."""

from motion.characters.character import load_character
from planner.modes.custom import Custom
from sim.stage.simulation import Simulation
from tests.examples.planner_in_python import in_a_circle
from worlds.world import World

if __name__ == "__main__":
    fast = Custom(in_a_circle, starts=[(10.0, 6.0, 0.0)], compiled=True)
    sim = Simulation(World("yard", (20.0, 20.0)), [load_character("human")], fast)
    for _ in range(1200):
        sim.tick()
    print(f"{sim.footprints.steps} steps; now at {sim.com()[0].round(2).tolist()}")
