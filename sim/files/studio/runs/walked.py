"""A run, live or recorded, as a document: the footprints that were walked, with their times, as single footprints of tracks.

What a planner has laid, `laid` lays again: footprint i of a track gets the step and stance times that it had. Where somebody
stood on both feet for a while, the log has one stance of each foot: the foot that steps next leaves a moment of START_OVERLAP
after the last shift of weight (planner.stepping.taking), so

    stand_i  = leave_i - overlap - contact_i
    step_i   = contact_{i+1} - contact_i - stand_i
    stance_i = end_i - contact_i - stand_i

with leave_i when that foot leaves, and end_i when the other one does. Before and after, all stand.
"""

from collections.abc import Sequence
from math import degrees
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from motion.characters.character import Character, load_character
from motion.characters.dimensions import Dimensions
from motion.track.footprints import SIDES, Footprints
from planner.script.footprint import Footprint
from planner.script.scene import Sheet
from planner.script.track import SHAPES, Track
from planner.stepping.taking import START_OVERLAP
from planner.stepping.timing import hip_pendulum, nominal_length
from sim.files.recording import Recording
from sim.files.studio.document import Document, document_of
from sim.files.studio.runs.grounds import tables_of
from sim.files.studio.runs.walkers import Walker, cut, leg_share
from sim.files.taking import opened
from sim.stage.cast import Cast
from sim.stage.scripted.performance import Performance
from worlds.compiled.tables import picked
from worlds.errors import InputError
from worlds.world import World

MOST_TRACKS, MOST_FOOTPRINTS = 64, 6000
"""So many characters, those nearest to one, and their latest footprints, become a scene."""
SAME = 1e-6
"""Times and shares that differ by no more are the same."""
LEAST, MOST = 1e-3, 60.0
"""Of times in a scene [s]."""
CROUCHES = (0.5, 1.05)
REST, SETTLE = 0.6, 0.1
"""One stands at least so long [s] at the end, and at a beginning in the middle of a run."""


class Run(NamedTuple):
    """What is known of a run."""

    world: World
    walkers: list[Walker]
    time: float  # when it was stopped [s]
    level: Path | None = None  # the file of its world
    kinds: Sequence[str] = ()  # names or files of characters that may have walked, beside those that ship


def document_of_cast(cast: Cast, focus: int = 0, level: str | Path | None = None, kinds: Sequence[str] = ()) -> Document:
    """The scene of a live run as it stands; of one that is played, that very scene. Raises InputError."""
    if not isinstance(cast, Performance):
        return document_from(run_of(cast, level, kinds), focus)
    head = Sheet(**tables_of(cast.scene.world))
    return Document(head, cast.scene.tracks)


def document_in(path: str | Path) -> Document:
    """The scene of a recording or of a saved state. Raises InputError."""
    found = opened(str(path))
    return document_from(run_in(found)) if isinstance(found, Recording) else document_of_cast(found)


def run_of(cast: Cast, level: str | Path | None = None, kinds: Sequence[str] = ()) -> Run:
    """A live run as it stands. level, kinds: names or files of its world and characters."""
    walked = cast.walked()
    walkers = [Walker(one, _latest(walked, c), Track(**cast.shapes(c))) for c, one in enumerate(cast.characters)]
    return Run(cast.world, walkers, cast.time, _file(level), kinds)


def _latest(walked: Any, c: int) -> Footprints:
    """The footprints of character c since it became who it is."""
    mine = walked.character == c
    mine &= walked.recasts == walked.recasts[mine].max(initial=0)
    return picked(walked.footprints, np.flatnonzero(mine))


def _file(level: str | Path | None) -> Path | None:
    """The file of a level, where it is none that ships."""
    return Path(level) if level is not None and Path(level).suffix else None


def run_in(recording: Recording) -> Run:
    """A recorded run. Raises InputError where it holds no footprints."""
    if "footprint_character" not in recording.arrays or "footprint_step_time" not in recording.arrays:
        raise InputError("the recording lacks its footprints' times; record the run again with this version")
    walkers = []
    for c in range(len(recording.meta["characters"])):
        for stay in recording.stays(c)[-1:]:
            walkers.append(Walker(stay.character, recording.footprints(c, stay.recasts), recording.shapes(c)))
    return Run(recording.world, walkers, float(recording.arrays["time"][-1]) if len(recording.arrays["time"]) else 0.0)


def document_from(run: Run, focus: int = 0) -> Document:
    """The scene of a run: the character `focus` first, and those who were nearest to it. Raises InputError."""
    chosen = _chosen(run.walkers, focus)
    if not chosen:
        raise InputError(f"{run.world.name}: nobody has walked yet; let it run for a few steps first")
    chosen = [cut(one, _since(chosen)) for one in chosen]
    begin = min(_begin(one) for one in chosen)
    tracks = [_track(one, begin, run) for one in chosen]
    first = {key: getattr(tracks[0], key) for key in Track.model_fields}
    sheet = Sheet(**{**tables_of(run.world, run.level), **first, "track": tuple(tracks[1:])})
    return document_of(sheet)


def _chosen(walkers: list[Walker], focus: int) -> list[Walker]:
    """Those who have taken a step, nearest to one of them first."""
    place = [one.footprints.position[-1] if len(one.footprints.side) else np.full(3, np.inf) for one in walkers]
    away = [float(np.linalg.norm(at - place[focus])) if np.isfinite(at).all() else np.inf for at in place]
    order = sorted(range(len(walkers)), key=lambda c: (c != focus, away[c]))
    return [walkers[c] for c in order if len(cut(walkers[c], -np.inf).footprints.side) > 2][:MOST_TRACKS]


def _since(walkers: list[Walker]) -> float:
    """The time [s] from which on no more than MOST_FOOTPRINTS footprints were walked."""
    times = np.sort(np.concatenate([one.footprints.contact_time for one in walkers]))
    return float(times[-MOST_FOOTPRINTS]) if len(times) > MOST_FOOTPRINTS else -np.inf


class _Pause(NamedTuple):
    """How a footprint was left."""

    stand: float  # [s] since its contact, on both feet
    step: float  # then, until the next contact
    stance: float  # then, of the foot that stays


def _track(walker: Walker, begin: float, run: Run) -> Track:
    """The track of one who walked; begin: the time of the scene's beginning [s]."""
    f, biped = walker.footprints, walker.character.biped
    name, scale = _name_of(walker.character, run.kinds)
    pauses = [_pause(f, i, biped) for i in range(1, len(f.side) - 1)]
    first = pauses[0]._replace(stand=pauses[0].stand + float(f.contact_time[1]) - begin)
    legs = [leg_share(walker.shapes, i) for i in range(len(f.side))]
    prints = [_print(f, 0, None, 1.0), _print(f, 1, first._replace(stand=0.0), 1.0)]
    prints += [_print(f, i, pauses[i - 1], _crouch(f, i, pauses[i - 2], biped, legs[i])) for i in range(2, len(f.side) - 1)]
    prints.append(_print(f, len(f.side) - 1, None, _crouch(f, len(f.side) - 1, pauses[-1], biped, legs[-1])))
    rest = run.time - float(f.contact_time[-1])
    return Track(
        character=name, character_scale=scale, footprint=tuple(prints), stand_before=_within(first.stand, 0.0),
        stand_after=_within(rest, REST) if rest > REST else REST, **{name: getattr(walker.shapes, name) for name in SHAPES},
    )  # fmt: skip


def _begin(walker: Walker) -> float:
    """When a track begins in the run's time [s]: as the run did, or, in the middle of it, so that one can shift the weight."""
    f = walker.footprints
    if _stood(f, 1):
        return float(f.contact_time[1])
    return float(f.contact_time[1]) + _pause(f, 1, walker.character.biped).stand - SETTLE


def _stood(f: Footprints, i: int) -> bool:
    """Whether both feet stood for a while after the contact of footprint i."""
    return float(f.contact_time[i + 1] - f.contact_time[i] - f.step_time[i]) >= SAME


def _pause(f: Footprints, i: int, biped: Dimensions) -> _Pause:
    """How footprint i was left for the next one. One begins by standing on footprints 0 and 1, whatever was before."""
    contact, end, gap = f.contact_time, f.contact_time + f.stance_time, float(f.contact_time[i + 1] - f.contact_time[i])
    steps, stays = f.side == f.side[i + 1], f.side != f.side[i + 1]
    if i > 1 and not (_stood(f, i) and steps[: i + 1].any()):
        return _Pause(0.0, gap, float(f.stance_time[i]))
    leaves, other = (int(np.flatnonzero(one[: i + 1])[-1]) for one in (steps, stays))
    shifted = float(end[leaves]) - START_OVERLAP * float(hip_pendulum(biped)) - float(contact[i])
    shifted = min(max(shifted, 0.0 if i > 1 else -MOST), gap - LEAST)
    return _Pause(shifted, gap - shifted, float(end[other] - contact[i]) - shifted)


def _crouch(f: Footprints, i: int, before: _Pause, biped: Dimensions, leg: float) -> float:
    """The share of the usual leg over footprint i: what its step asks for beside its pace, and beside stretches, `leg`."""
    far, rise = np.hypot(*(f.position[i] - f.position[i - 1])[:2]), float(f.position[i, 2] - f.position[i - 1, 2])
    share = float(f.nominal_length[i]) / float(nominal_length(biped, float(far), before.step, rise)) / leg
    return 1.0 if abs(share - 1) < SAME else min(max(share, CROUCHES[0]), CROUCHES[1])


def _print(f: Footprints, i: int, left: _Pause | None, crouch: float) -> Footprint:
    """Footprint i as a file has it; left: how it was left, where that is to stay."""
    times: dict[str, Any] = (
        {} if left is None else {"step_time": _within(left.step, LEAST), "stance_time": _within(left.stance, LEAST)}
    )
    if left is not None and left.stand > SAME:
        times["stand"] = _within(left.stand, 0.0)
    x, y, _ = f.position[i].tolist()
    side: Any = SIDES[int(f.side[i])]
    heading, facing = degrees(f.heading[i]), degrees(f.facing[i])
    return Footprint(side=side, position=(x, y), heading_deg=heading, facing_deg=facing, crouch=crouch, **times)


def _within(seconds: float, least: float) -> float:
    return float(min(max(seconds, least), MOST))


def _name_of(character: Character, kinds: Sequence[str]) -> tuple[str, float]:
    """The name or file of a character, and how many times as large it is. Raises InputError where no file is known."""
    for name in (character.name, *kinds):
        try:
            same = load_character(name)
        except InputError:
            continue
        scale = float(character.biped.leg.nominal_length / same.biped.leg.nominal_length)
        if _is_same(character.biped, load_character(name, scale).biped):
            return name, 1.0 if abs(scale - 1) < SAME else scale
    raise InputError(f"{character.name}: is none of the characters that ship; its own file is needed: --character FILE")


def _is_same(one: Dimensions, other: Dimensions) -> bool:
    """Whether two bodies have the same bones."""
    return all(
        np.allclose(float(one[table][name]), float(other[table][name]), rtol=1e-6)  # type: ignore[index]
        for table in ("leg", "foot")
        for name in one[table].dtype.names  # type: ignore[index]
        if name not in ("loading", "push_off", "comfort_weight")
    )
