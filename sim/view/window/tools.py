"""What a click does while a key is held: a goal, a tree, a rock, or away with one."""

from planner.planner import NoWay
from sim.stage.cast import Cast
from sim.stage.commands import apply
from sim.stage.simulation import Simulation
from sim.view.window import picking
from worlds.errors import InputError

THERE = {"Wander": "; they walk there, and wander on", "RockHop": "; they cross to it"}
"""What a goal means, by planners; others make for none."""


def used(sim: Cast, tool: str, x: float, y: float) -> str:
    """Uses a tool at a place [m]; what became of it, in words.

    g: goal, t: plant a tree, k: put a rock, x: remove the nearest tree or rock.
    """
    if not isinstance(sim, Simulation):
        return "a scene is played as it is written; Enter edits it"
    command = picking.command_for(sim.world, tool, x, y)
    if command is None:
        return "nothing to remove there"
    try:
        apply(sim, command)
    except (InputError, NoWay) as error:
        return str(error)
    meant = THERE.get(sim.planner.name, f"; but {sim.planner.name} makes for no goal") if tool == "g" else ""
    return f"{command.name}: done{meant}"
