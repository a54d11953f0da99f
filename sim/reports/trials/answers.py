"""How soon a key changes a footprint: the run is gone on with twice, with the key and without it, and both are compared.

Footprint n is planned when n - 2 lands, and the motion up to the contact of n - 1 is settled then: the body's heading looks
half a step ahead. So a key waits for the end of the step that is under way, and the footprint that is planned there answers.
"""

from typing import NamedTuple

import numpy as np

from sim.stage.commands import steer
from sim.stage.simulation import Simulation, State
from worlds.compiled.tables import copied

AHEAD = 3
"""So many footprints are compared from the next one on: one that changes later is no answer."""
SAME = 1e-9
"""Places, headings and times that differ by less [m, rad, s] are the same."""


class Answer(NamedTuple):
    """When a key took effect."""

    contacts: int  # that lay between the key and the planning of the first footprint that is another one
    later: int  # how many were planned before it that are the same with the key as without it
    seconds: float  # from the key to the contact of that footprint


class _Placed(NamedTuple):
    """A footprint that was placed."""

    what: np.ndarray  # (5,) x, y [m], heading [rad], whether the foot stands on, contact time [s]
    contacts: int  # since the beginning, when it was planned


def twin(sim: Simulation) -> Simulation:
    """A simulation that goes on from here as this one would, and changes nothing of it."""
    state = State(sim.ticks, copied(sim.crowd), copied(sim.plans))
    return Simulation(sim.world, sim.characters, sim.planner, sim.seed, sim.tick_rate, state)


def answer(sim: Simulation, wish: tuple) -> Answer | None:
    """What becomes of a wish (direction, pace, aside, leap) for the first character, told now; None: nothing else is done."""
    with_key, without = twin(sim), twin(sim)
    steer(with_key, *wish)
    changed, unchanged = _placed(with_key), _placed(without)
    for later, (one, other) in enumerate(zip(changed, unchanged, strict=True)):
        if not np.allclose(one.what, other.what, rtol=0, atol=SAME):
            return Answer(one.contacts, later, float(one.what[4]) - sim.time)
    return None


def _placed(sim: Simulation) -> list[_Placed]:
    """The next footprints that are placed."""
    found: list[_Placed] = []
    seen, begin = int(sim.crowd.number[0]), sim.time
    while len(found) < AHEAD:
        sim.tick()
        prints, now = sim.track(0), int(sim.crowd.number[0])
        for row in range(len(prints.side) - (now - seen), len(prints.side)):
            what = [*prints.position[row, :2], prints.heading[row], prints.stands[row], prints.contact_time[row]]
            landed = (prints.contact_time > begin) & (prints.contact_time <= sim.time)
            found.append(_Placed(np.array(what), int((landed & ~prints.stands).sum())))
        seen = now
    return found[:AHEAD]
