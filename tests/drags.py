"""Every dagger of every scene dragged, as the studio does it: how far the body jumps at most for 5 ms of timing.

A large run: python -m tests.drags [SCENE ...]
"""

import os
import sys
import tempfile
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from motion.motion import Motion
from motion.track.curve import states_at
from planner.script.scene import SCENES, scene_names
from sim.files.studio.document import Spot, footprints_in
from sim.view.studio.bars.timeline import Held, Timeline
from sim.view.studio.desk.desk import Desk

STEP, FAR = 0.005, 0.3
"""How far the mouse goes from move to move, and in all [s]."""


class Drag(NamedTuple):
    """What came of one dagger that was dragged."""

    dagger: str  # scene, track, footprint, what of it, which way
    shown: float  # how far the shown body jumped at most from move to move [m]
    solved: float  # the same of what is solved
    paced: float  # and that as a multiple of the larger of a centimetre and what the body goes in STEP


def places(motion: Motion) -> tuple[np.ndarray, np.ndarray]:
    """Where the body is (n, 3) and how fast (n,) at the contacts and midway between them, where a drag is compared."""
    contact = motion.footprints.contact_time
    times = np.clip(np.concatenate([contact, 0.5 * (contact[1:] + contact[:-1])]), motion.begin, motion.end - 1e-9)
    state = states_at(motion.curve, times)
    return state[:, :3], np.linalg.norm(state[:, 3:], axis=1)


def dragged(desk: Desk, spot: Spot, what: str, way: int) -> Drag:
    """Drags one dagger of an open scene, and undoes that. Raises ValueError where not all is as it was then."""
    desk.track, document, kept = spot.track, desk.document, [one.motion.curve.control for one in desk.show.acts]
    worst = np.max(list(_jumps(desk, spot, what, way)) or [(0.0, 0.0, 0.0)], axis=0)
    desk.drop()
    if desk.document is not document:
        desk.undo()
    same = [np.array_equal(then, now.motion.curve.control) for then, now in zip(kept, desk.show.acts, strict=True)]
    if desk.document is not document or not all(same):
        raise ValueError(f"{spot} {what}: not as it was")
    return Drag(f"{spot.track} {spot.number} {what} {'+' if way > 0 else '-'}", *map(float, worst))


def _jumps(desk: Desk, spot: Spot, what: str, way: int) -> Iterator[tuple[float, float, float]]:
    """What a Drag tells, from move to move, as far as feet can follow."""
    timeline, laid = Timeline(), desk.act(spot.track).laid
    row, last = laid.row[spot.number], None
    begin = float(laid.footprints.contact_time[row] + (laid.footprints.stance_time[row] if what == "leave" else 0.0))
    timeline.held = Held(what, spot)
    for offset in np.arange(0, FAR, STEP) * way:
        desk.preview(timeline.edit(desk, begin + offset, False))
        if desk.fault:
            return
        shown, (solved, speed) = places(desk.act(spot.track).motion)[0], places(desk.show.solved[spot.track].motion)
        if last is not None:
            shift, jump = (np.linalg.norm(now - then, axis=1) for now, then in zip((shown, solved), last, strict=True))
            yield shift.max(), jump.max(), (jump / np.maximum(0.01, STEP * speed)).max()
        last = shown, solved


def drags(scene: str, seed: int = 1) -> Iterator[Drag]:
    """Of a scene's daggers, each dragged one way by chance."""
    desk, rng = Desk(), np.random.default_rng(seed)
    desk.open(f"{SCENES}/{scene}.toml")
    for track in range(len(desk.document.tracks)):
        for number in range(len(footprints_in(desk.document.tracks[track]))):
            for what in ("contact", "leave") if number > 1 else ("leave",):
                found = dragged(desk, Spot(track, number), what, int(rng.choice([-1, 1])))
                yield found._replace(dagger=f"{scene} {found.dagger}")


def main(scenes: list[str]) -> None:
    """Of these scenes, or of all."""
    os.environ["FOOTFALL_STATE"] = tempfile.mkdtemp()  # what the studio keeps of its user stays as it is
    found = list[Drag]()
    for scene in scenes or scene_names():
        found += drags(scene)
        print(f"{scene}: {len(found)} daggers so far, the worst {1e3 * max(one.shown for one in found):.1f} mm", flush=True)
    for name, limit in (("shown", 0.01), ("solved", 0.01), ("paced", 1.0)):
        values = np.array([getattr(one, name) for one in found])
        print(
            f"{name}: median {np.median(values):.4f}, nine in ten below {np.quantile(values, 0.9):.4f}, "
            f"at most {values.max():.4f} ({found[int(values.argmax())].dagger}); up to {limit}: {(values <= limit).mean():.1%}"
        )


if __name__ == "__main__":
    main(sys.argv[1:])
