"""Visiting: people come in, walk to where they wait or go out, and are gone; the kernel, and what C rows remember.

A row is one who is there, or free for the next one; who decides that is planner.modes.people.
"""

from typing import Any, NamedTuple

import numpy as np

from planner.modes.walk_to import Stops, empty_stops, step_to_stop
from planner.round.kernel import Compiled
from planner.round.round import Me, Round, Wish
from planner.stepping.timing import step_timing
from worlds.compiled.jit import jit


class Visits(NamedTuple):
    """What C rows remember of those who are in them, and S sources and A areas of those who came and went."""

    stops: Stops  # (C, 1) where each goes just now
    there: np.ndarray  # (C,) bool: somebody is in the row
    since: np.ndarray  # (C,) when it came [s]
    until: np.ndarray  # (C,) when the last one went [s]
    source: np.ndarray  # (C,) where it came in
    serial: np.ndarray  # (C,) its number among those of its source
    stage: np.ndarray  # (C,) how many of its waiting areas it has left behind
    area: np.ndarray  # (C,) where it goes: a number of the traffic's areas, waiting areas first, then exits
    rest: np.ndarray  # (C,) it stands where it is till then [s]; 0: it goes
    group: np.ndarray  # (C,) the serial of the first of those with whom it walks, of the same source; -1: alone
    due: np.ndarray  # (S,) when the next comes [s]
    drawn: np.ndarray  # (S,) how many have come, or wait outside
    let_in: np.ndarray  # (S,) how many have come in
    head: np.ndarray  # (S,) the serial of the first of the group that comes in
    gone: np.ndarray  # (A,) how many went out there
    last: np.ndarray  # (A,) when the last went out there [s]

    @staticmethod
    def shared() -> tuple[str, ...]:
        """Columns of all together."""
        return "due", "drawn", "let_in", "head", "gone", "last"


def empty_visits(rows: int, sources: int, areas: int) -> Visits:
    """Nobody there."""
    c, whole = rows, np.int64
    drawn, let_in, head = np.zeros((3, sources), whole)
    return Visits(
        empty_stops(c, 1), np.zeros(c, np.bool_), np.zeros(c), np.zeros(c), np.zeros(c, whole), np.zeros(c, whole),
        np.zeros(c, whole), np.zeros(c, whole), np.zeros(c), np.full(c, -1, whole), np.zeros(sources),
        drawn, let_in, head, np.zeros(areas, whole), np.zeros(areas),
    )  # fmt: skip


@jit
def speeds_of(bipeds: Any, steps: np.ndarray, speeds: np.ndarray) -> None:
    """Fills speeds (K,) [m/s] at which the first of `bipeds` walks in steps (K,) [m], when nothing hinders."""
    for k in range(len(steps)):
        speeds[k] = steps[k] / step_timing(bipeds[0], steps[k], 0.0, 0.0, False)[0]


def _next_step(round: Round, me: Me) -> Wish:
    """As one walks to a stop."""
    stops = round.plans.stops
    return step_to_stop(
        Round(round.kind, round.bipeds, round.world, stops, round.reservations, round.intents, round.seed, round.weights),
        me,
    )


PLANNING = Compiled(_next_step, empty_visits(1, 1, 1))
