"""Everything that changes a running simulation: commands, each applied whole at a tick, or not at all, and logged.

    apply(sim, PlantTree(3.0, 4.0, 0.3))

A command checks all that it needs before it changes anything, so one that is refused (InputError, NoWay) leaves no trace. What
was done stands in `sim.changes`, in recordings and in saved states; `replay` does it again, in another run, to the same bit.
"""

from collections.abc import Iterable
from dataclasses import MISSING, fields
from typing import Any

import numpy as np

from sim.stage.cast import Change
from sim.stage.casting import Give, Pause, Recast, Steer
from sim.stage.command import Command
from sim.stage.edits import PlantTree, PutRock, Remove, SetGoal
from sim.stage.simulation import Simulation
from worlds.errors import InputError
from worlds.errors.wording import nearest

_KINDS: list[type[Command]] = [
    PlantTree,
    PutRock,
    Remove,
    SetGoal,
    Pause,
    Recast,
    Give,
    Steer,
]
COMMANDS = {kind.name: kind for kind in _KINDS}
"""All of them by their names. A new one is a line above."""


def apply(sim: Simulation, command: Command) -> None:
    """Does a command now, between two ticks, and logs it. Raises InputError, NoWay; then nothing has changed."""
    command.apply(sim)
    sim.log(command.as_plain())


def steer(
    sim: Simulation, direction: Any, pace: Any, aside: Any = 0.0, leap: Any = False, characters: Any = None
) -> None:  # fmt: skip
    """Tells characters (by default all) where to go and how, as `Steer` does; made to be called at every tick.

    Each wish is one for all or an array of theirs. Only those who are told something new are logged. Raises InputError.
    """
    who = np.arange(len(sim.characters)) if characters is None else np.atleast_1d(np.asarray(characters))
    command, news = Steer.of(who, direction, pace, aside, leap), getattr(sim.planner, "news", None)
    if news is None or ((who < 0) | (who >= len(sim.characters))).any():
        apply(sim, command)  # which says why not
    elif (new := news(sim.plans, who, *command.wish)).any():
        apply(sim, Steer.of(who[new], *(np.broadcast_to(np.array(wish), (len(who),))[new] for wish in command.wish)))


def steer_by_chance(sim: Simulation) -> None:
    """Keys by chance for everyone who is driven, after a tick, as a person would press them; else nothing."""
    by_chance = getattr(sim.planner, "by_chance", None)
    wish = by_chance(sim.seed, sim.ticks, len(sim.characters)) if by_chance else None
    if wish is not None:
        steer(sim, *wish)


def from_plain(plain: dict) -> Command:
    """The command that `as_plain` described. Raises InputError."""
    values: dict[str, Any] = dict(plain)
    name = str(values.pop("command", None))
    kind = COMMANDS.get(name)
    if kind is None:
        raise InputError(f"{plain!r}: is no command{nearest(name, COMMANDS)}; there are {', '.join(COMMANDS)}")
    needed = {field.name for field in fields(kind) if field.default is MISSING}
    known = {field.name for field in fields(kind)}
    if set(values) - known or needed - set(values):
        raise InputError(f"{plain!r}: is no command: {kind.name} has {', '.join(known)}, and needs {', '.join(needed)}")
    return kind(**values)


def replay(sim: Simulation, changes: Iterable[Change], ticks: int) -> None:
    """Lets a run tick until so many ticks, changing it as another one was changed."""
    pending = list(changes)
    while True:
        while pending and pending[0].tick <= sim.ticks:
            apply(sim, from_plain(pending.pop(0).command))
        if sim.ticks >= ticks:
            return
        sim.tick()
