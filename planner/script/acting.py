"""An act: what one character of a scene does, from its track to its motion, and again after an edit of the track."""

from typing import NamedTuple

from motion.characters.character import Character
from motion.com import newton, window
from motion.editing.resolving import resolve
from motion.motion import Motion, Pull, solve
from planner.script import shaping
from planner.script.laying import Laid, lay
from planner.script.manners import Spell, spells_of
from planner.script.track import Placed, Track, placed
from planner.script.turned import BoneKey
from worlds.world import World


class Act(NamedTuple):
    """A track and what became of it."""

    track: Track
    character: Character
    placed: list[Placed]  # the track's footprints in order
    laid: Laid  # as they are walked
    pulls: tuple[Pull, ...]
    motion: Motion
    keys: tuple[BoneKey, ...]  # of bones turned by hand
    spells: tuple[Spell, ...]  # of manners that are not the character's own

    @property
    def end(self) -> float:
        """When the track ends [s]."""
        return self.motion.end


def act(
    track: Track, character: Character, world: World, name: str, effort: newton.Effort = newton.SCENE, last: Act | None = None
) -> Act:  # fmt: skip
    """The act of a track, solved as a whole; from the last one on, only where it differs. Raises InputError."""
    order = placed(track, character)
    given = [one.footprint for one in order]
    shaping.check_numbers(name, len(given), track.stretch, (*track.pull, *track.key))
    laid = lay(given, character, world.arrays, track.stand_before, track.stand_after, track.support, name)
    laid, layout = shaping.stretched(laid, track.stretch, track.style), window.LAYOUTS[track.segments]
    pulls, end = shaping.pulls_of(laid, track.pull), float(laid.footprints.contact_time[-1]) + track.stand_after
    if last is None or last.track.segments != track.segments or last.character is not character:
        motion = solve(laid.footprints, character, end, layout, effort, pulls)
    else:
        touched = _touched(last.pulls, pulls)
        motion = resolve(last.motion, laid.footprints, end, layout, pulls=pulls, touched=touched)
    return Act(track, character, order, laid, pulls, motion, shaping.keys_of(laid, track.key), spells_of(laid, track.stretch))


def _touched(before: tuple[Pull, ...], after: tuple[Pull, ...]) -> tuple[float, float] | None:
    """The times [s] between which pulls differ."""
    times = [one.time for one in set(before) ^ set(after)]
    return (min(times), max(times)) if times else None
