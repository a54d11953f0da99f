"""What would heal the places where a motion borrows most: small edits, tried with the solver, the mildest first.

For the worst places of a track, candidates change a step there: more time in flight, more time on the foot, a footprint nearer
to the one before, a deeper leg. Each is solved around the place, and what it then owes is summed; a cure is offered where it
takes at least LEAST of that away. One candidate is tried in each frame, so the window stays alive.
"""

from dataclasses import dataclass, field

import numpy as np

from planner.script.acting import Act, act
from sim.files.studio.document import Spot, footprint_at
from sim.files.studio.edits import Edit, Move, Set
from sim.files.studio.history import tried
from sim.stage.scripted.rehearsal import Rehearsal
from sim.view.studio.desk.debts import COMFORT, PHYSICS, STEP, WORTH, Debts, debts_at
from sim.view.studio.desk.desk import Desk
from worlds.errors import InputError

LEAST = 0.3
"""Share of a place's debt that a cure takes away at least."""
AROUND = 0.5
"""Seconds to either side of a place that count to it."""
MOST_CURES = 2
WORDS = ("borrows from physics", "is uncomfortable", "a leg is out of reach")


@dataclass(frozen=True)
class Candidate:
    """An edit that may heal."""

    words: str
    edit: Edit
    effort: float  # how much it changes, in units that a person would call alike


@dataclass(frozen=True)
class Cure:
    """An edit that heals, and how much of the debt it takes away."""

    words: str
    edit: Edit
    share: float
    effort: float


@dataclass
class Place:
    """A place where the motion borrows."""

    time: float
    kind: int
    number: int
    words: str
    debt: float
    waiting: list[Candidate]
    cures: list[Cure] = field(default_factory=list)


class Healing:
    """Looks for cures of the present motion, a little in each frame."""

    def __init__(self) -> None:
        self.debts, self.places = Debts(), list[Place]()
        self._for: Act | None = None

    def look(self, desk: Desk) -> list[Place]:
        """The worst places with the cures that are known by now."""
        if desk.dragging:
            return self.places
        self.debts.look(desk.show, desk.track, desk.playing.time)
        now = desk.act(desk.track)
        if now is not self._for and not np.isnan(self.debts.values[0]).any():
            self._for, self.places = now, [_place(desk, self.debts, t, kind) for t, kind in self.debts.worst()]
        for place in self.places if now is self._for else ():
            if place.waiting:
                self._try(desk, place, place.waiting.pop(0))
                break
        return self.places

    def _try(self, desk: Desk, place: Place, candidate: Candidate) -> None:
        """Solves with a candidate, and keeps it where it helps."""
        after = debt_with(desk, place, candidate.edit)
        if after is not None and after <= (1 - LEAST) * place.debt:
            place.cures.append(Cure(candidate.words, candidate.edit, 1 - after / place.debt, candidate.effort))
            place.cures = sorted(place.cures, key=lambda cure: cure.effort)[:MOST_CURES]


def _place(desk: Desk, debts: Debts, t: float, kind: int) -> Place:
    laid = desk.act(desk.track).laid
    contact = laid.footprints.contact_time[laid.row]
    number = max(int((contact <= t + 1e-9).sum()) - 1, 0)
    words = f"at {t:.2f} s: {WORDS[kind]}"
    return Place(t, kind, number, words, debts.total(t - AROUND, t + AROUND), candidates(desk, number, kind))


def candidates(desk: Desk, number: int, kind: int) -> list[Candidate]:
    """What may heal a place at a footprint, the mildest first."""
    k, laid = desk.track, desk.act(desk.track).laid
    found = []
    for n in (number, number - 1, number + 1):
        if not 1 <= n < len(laid.row) - 1:
            continue
        row, spot = int(laid.row[n]), (Spot(k, n),)
        step, stance = float(laid.footprints.step_time[row]), float(laid.footprints.stance_time[row])
        for more in (0.04, 0.08, 0.16):
            longer = round(step + more, 4)
            found.append(
                Candidate(f"{more:.2f} s later after footprint {n}", Set(spot, "step_time", longer, "Heal: more time"), more)
            )
            found.append(
                Candidate(
                    f"stand {more:.2f} s longer on {n}",
                    Set(spot, "stance_time", round(stance + more, 4), "Heal: stand longer"),
                    more,
                )
            )
        if n >= 2:
            found += _nearer(desk, n)
        one = footprint_at(desk.document, spot[0])
        if kind in (PHYSICS, COMFORT) and one.crouch > 0.9:
            found.append(
                Candidate(f"bend the leg on {n}", Set(spot, "crouch", round(one.crouch - 0.05, 3), "Heal: bend the leg"), 0.1)
            )
    return sorted(found, key=lambda one: one.effort)


def _nearer(desk: Desk, n: int) -> list[Candidate]:
    """The footprint nearer to the one before the last, which is where its step comes from."""
    here, there = (np.array(footprint_at(desk.document, Spot(desk.track, i)).position) for i in (n, n - 1))
    way = there - here
    far = float(np.linalg.norm(way))
    made = []
    for by in (0.06, 0.12, 0.2):
        if far > by + 0.2:
            dx, dy = (by / far * way).tolist()
            edit = Move((Spot(desk.track, n),), (round(dx, 4), round(dy, 4)))
            made.append(Candidate(f"footprint {n} {100 * by:.0f} cm nearer", edit, by))
    return made


def debt_with(desk: Desk, place: Place, edit: Edit) -> float | None:
    """What a place owes after an edit; None where that cannot be walked."""
    made, k = tried(edit, desk.history.document), desk.track
    if isinstance(made, str):
        return None
    before = desk.act(k)
    try:
        after = act(made.tracks[k], before.character, desk.show.world, "the scene", last=before)
    except InputError:
        return None
    return _owed(desk.show, k, after, place, before)


def _owed(show: Rehearsal, k: int, after: Act, place: Place, before: Act) -> float:
    """The debt around a place, whose footprint may land at another time now."""
    row = [int(one.laid.row[place.number]) for one in (before, after)]
    later = float(after.laid.footprints.contact_time[row[1]] - before.laid.footprints.contact_time[row[0]])
    acts = list(show.acts)
    show.show([after if c == k else one for c, one in enumerate(acts)])
    try:
        begin = min(place.time, place.time + later) - AROUND
        end = max(place.time, place.time + later) + AROUND
        times = np.arange(int(max(begin, 0.0) / STEP), int(end / STEP) + 1) * STEP
        owed = np.array([debts_at(show, k, float(t)) for t in times])
        return float((owed / np.array(WORTH)).sum() * STEP)
    finally:
        show.show(acts)
