"""Who walked in a run, on what, and what a scene had said of it beside its footprints."""

from typing import NamedTuple

import numpy as np

from motion.characters.character import Character
from motion.track.footprints import Footprints
from planner.script.shaping import ComPull, Key, Stretch
from planner.script.track import Track
from worlds.compiled.tables import picked


class Walker(NamedTuple):
    """Who walked, on what."""

    character: Character
    footprints: Footprints  # (K,) by their contacts; a foot that stood on prolongs its footprint
    shapes: Track = Track()  # what a scene said of it beside them


def cut(walker: Walker, since: float) -> Walker:
    """The walker from a time [s] on, the first two footprints of two feet, so that it can begin to stand on them."""
    footprints = walker.footprints
    later = np.flatnonzero(footprints.contact_time >= since)
    first = int(later[0]) if len(later) > 2 else max(len(footprints.side) - 3, 0)
    while first + 1 < len(footprints.side) and footprints.side[first] == footprints.side[first + 1]:
        first += 1
    return walker._replace(
        footprints=picked(footprints, slice(first, len(footprints.side))), shapes=_shifted(walker.shapes, first)
    )


def _shifted(shapes: Track, gone: int) -> Track:
    """What shapes a track of which so many footprints, the first ones, are gone."""

    def back(one: ComPull | Key) -> ComPull | Key:
        return one.model_copy(update={"footprint": one.footprint - gone})

    def shortened(one: Stretch) -> Stretch:
        return one.model_copy(update={"first": max(one.first - gone, 0), "last": one.last - gone})

    if not gone:
        return shapes
    return shapes.model_copy(
        update={
            "stretch": tuple(shortened(one) for one in shapes.stretch if one.last >= gone),
            "pull": tuple(back(one) for one in shapes.pull if one.footprint >= gone),
            "key": tuple(back(one) for one in shapes.key if one.footprint >= gone),
        }
    )


def leg_share(shapes: Track, i: int) -> float:
    """The share of the comfortable leg over footprint i that stretches ask for."""
    return float(np.prod([one.leg for one in shapes.stretch if one.first <= i <= one.last]))
