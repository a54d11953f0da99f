"""Manners of stretches of steps over time: how a body is carried comes over the step before a stretch, and goes after it.

A stretch from footprint f to footprint l weighs w(t) = smoothstep of the share of the step that leads to f, 1 from the contact
of f to that after l, and falls in the same way over the step after. A body's dimension d is then d (1 + w (s - 1)) for a
share s.
What legs do is in the footprints (their columns comfort and bounce), so the solver knows of it.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from motion.arithmetic.smooth import smoothstep
from motion.characters.dimensions import Dimensions
from planner.script.laying import Laid
from planner.script.shaping import Manners, Stretch, carry

PLAIN = Manners()
LONG = 1e6
"""Seconds between footprints that are not there."""


class Spell(NamedTuple):
    """A stretch's manners by the scene's time [s]."""

    begin: float  # they begin to come
    whole: float  # they are there
    last: float  # they begin to go
    end: float
    manners: Manners

    def weight(self, t: float) -> float:
        """How far they hold at a time [s], 0 to 1."""
        if not self.begin < t < self.end:
            return 0.0
        comes = (t - self.begin) / max(self.whole - self.begin, 1e-9)
        goes = (self.end - t) / max(self.end - self.last, 1e-9)
        return float(smoothstep(min(comes, goes, 1.0)))


def spells_of(laid: Laid, stretches: Sequence[Stretch]) -> tuple[Spell, ...]:
    """The manners of stretches that have any; those of footprints that are not there hold nowhere."""
    contact, found = laid.footprints.contact_time[laid.row], []
    for one in stretches:
        manners = Manners(**{name: getattr(one, name) for name in Manners.model_fields})
        if manners != PLAIN and one.first < len(contact):
            begin, whole, last, end = (_contact(contact, k) for k in (one.first - 1, one.first, one.last + 1, one.last + 2))
            found.append(Spell(begin, whole, last, end, manners))
    return tuple(found)


def _contact(contact: np.ndarray, k: int) -> float:
    """When footprint k lands [s]; those before the first and after the last, long before and after."""
    return float(contact[k]) if 0 <= k < len(contact) else k * LONG


def carried(biped: Dimensions, spells: Sequence[Spell], t: float) -> Dimensions | None:
    """The dimensions with the manners of a time [s]; None where none hold."""
    held = [(spell.manners, weight) for spell in spells if (weight := spell.weight(t)) > 0]
    if not held:
        return None
    changed: Dimensions = biped.copy()  # type: ignore[attr-defined]
    for manners, weight in held:
        carry(changed, manners, weight)
    return changed
