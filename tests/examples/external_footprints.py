"""Footprints from outside: a program says where each foot goes, while time goes on; the body follows."""

from motion.characters.character import load_character
from motion.track.footprints import LEFT, RIGHT, Step
from planner.modes.external import External
from sim.stage.commands import Give, apply
from sim.stage.simulation import Simulation
from worlds.world import World

program = External(starts=[(2.0, 5.0, 0.0)])
sim = Simulation(World("yard", (20.0, 10.0)), [load_character("human")], program)
side, x = LEFT, 2.0
while sim.time < 20:
    sim.tick()
    if program.left(sim.plans, sim.steps_planned)[0] < 2 and x < 15:  # it is running out: decide where the next foot goes
        x += 0.6
        apply(sim, Give(0, (Step(side, x, 5.06 if side == LEFT else 4.94, 0.0),)))
        side = RIGHT if side == LEFT else LEFT
feet = sim.feet()
print(f"{sim.footprints.steps} steps; the feet stand at {feet.position[0, :, :2].round(2).tolist()}")
