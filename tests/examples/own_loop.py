"""A loop of one's own: a crowd that wanders, ticked without a window, looked at and changed between two ticks."""

from motion.characters.character import load_character
from planner.modes.wander import Wander
from sim.stage.commands import PlantTree, apply
from sim.stage.simulation import Simulation
from worlds.level import load_level

characters = [load_character("bird")] * 10 + [load_character("human")] * 2
sim = Simulation(load_level("forest"), characters, Wander(), seed=1)
for tick in range(600):
    sim.tick()
    if tick == 300:
        apply(sim, PlantTree(20.0, 20.0, radius=0.4))
pose = sim.snapshot()
print(f"{sim.time:.0f} s, {sim.footprints.steps} steps; the first one's feet are at {pose.toe[0].round(2).tolist()}")
