"""A motion after an edit: where nothing has changed it is the same to the bit, where something has, as if solved as a whole."""

import numpy as np
import pytest

from motion.characters.character import load_character
from motion.com.window import LAYOUTS, STEADY
from motion.motion import Pull, solve
from motion.resolving import changed, resolve
from motion.track.curve import evaluate
from planner.script.footprint import Footprint
from planner.script.laying import laid
from worlds.world import World

HUMAN = load_character("human")
COUNT, MIDDLE = 24, 12


def footprints(moved=(0.0, 0.0), **keys):
    """A straight walk, its middle footprint moved [m] and with other keys."""
    given = [
        Footprint(side=("left", "right")[i % 2], position=(1.5 + 0.6 * max(i - 1, 0), 2.0 + 0.06 * (1 - 2 * (i % 2))))
        for i in range(COUNT)
    ]
    x, y = given[MIDDLE].position
    given[MIDDLE] = given[MIDDLE].model_copy(update={"position": (x + moved[0], y + moved[1]), **keys})
    return laid(given, HUMAN, World("w", (30.0, 4.0)).arrays)


def end_of(footprints):
    return float(footprints.contact_time[-1]) + 0.6


def places(motion, times):
    out, rest = np.empty((len(times), 3)), np.empty((2, 3))
    for i, t in enumerate(times):
        evaluate(motion.curve, t, out[i], rest[0], rest[1])
    return out


def by_contacts(motion):
    """Places (900, 3) at the same shares of the times between contacts."""
    contact = motion.footprints.contact_time
    shares = np.linspace(1, len(contact) - 1.001, 900)
    return places(motion, np.interp(shares, np.arange(len(contact)), contact))


@pytest.mark.parametrize("layout", ["smooth", "steady", "phase"])
@pytest.mark.parametrize(
    "edit", [{"moved": (0.1, 0.06)}, {"step_time": 0.75}, {"stance_time": 0.45}], ids=lambda e: next(iter(e))
)
def test_an_edit_is_as_the_whole_would_be_and_the_rest_stays_to_the_bit(layout, edit):
    before, after = footprints(), footprints(**edit)
    first = solve(before, HUMAN, end_of(before), LAYOUTS[layout])
    new = resolve(first, after, end_of(after), LAYOUTS[layout])
    whole = solve(after, HUMAN, end_of(after), LAYOUTS[layout])
    assert np.abs(by_contacts(new) - by_contacts(whole)).max() < (0.005 if layout != "phase" else 0.02)
    old = first.curve
    same_head = int(np.argmin((new.curve.control[: len(old.time)] == old.control[: len(new.curve.time)]).all(axis=1)))
    assert old.time[same_head] > 0.2 * first.end
    tail = (new.curve.control[::-1][: len(old.time)] == old.control[::-1][: len(new.curve.time)]).all(axis=1)
    assert int(np.argmin(tail)) > 0.1 * len(old.time)
    assert (np.diff(new.curve.time) > 0).all()
    for i in np.flatnonzero(new.curve.support[:-1, 0] >= 0):
        assert after.side[new.curve.support[i, 0]] == 0


def test_the_curve_goes_on_where_the_window_ends():
    before, after = footprints(), footprints(moved=(0.1, 0.1))
    new = resolve(solve(before, HUMAN, end_of(before), STEADY), after, end_of(after), STEADY)
    for i in range(1, len(new.curve.time) - 1):
        near, rest = np.empty((2, 3)), np.empty((2, 3))
        for k, t in enumerate((new.curve.time[i] - 1e-7, new.curve.time[i] + 1e-7)):
            evaluate(new.curve, t, rest[0], rest[1], near[k])
        assert np.abs(near[1] - near[0]).max() < 2e-2  # the acceleration does not jump


def test_what_has_not_changed_is_the_same_motion():
    before = footprints()
    motion = solve(before, HUMAN, end_of(before), STEADY)
    assert changed(before, footprints()) is None
    assert resolve(motion, footprints(), end_of(before), STEADY) is motion


def test_timing_that_is_dragged_moves_the_curve_continuously_through_overlap_to_flight():
    last, motion, jumps = None, None, []
    for stance in np.arange(0.66, 0.40, -0.005):
        after = footprints(step_time=0.55, stance_time=float(stance))
        motion = solve(after, HUMAN, end_of(after), STEADY) if motion is None else resolve(motion, after, end_of(after), STEADY)
        now = by_contacts(motion)
        if last is not None:
            jumps.append(np.linalg.norm(now - last, axis=1).max())
        last = now
    assert max(jumps) < 0.01


def test_a_pull_draws_the_centre_of_mass_and_lets_go_elsewhere():
    before = footprints()
    plain = solve(before, HUMAN, end_of(before), STEADY)
    t = 0.5 * plain.end
    there = places(plain, [t])[0] + (0.0, 0.04, -0.03)
    far = [np.linalg.norm(places(plain, [t])[0] - there)]
    for stiffness in (30.0, 3000.0):
        pulled = solve(before, HUMAN, end_of(before), STEADY, pulls=(Pull(t, tuple(there), stiffness),))
        far.append(np.linalg.norm(places(pulled, [t])[0] - there))
        assert np.abs(places(pulled, [1.0]) - places(plain, [1.0])).max() < 1e-3
    assert far[0] > far[1] > far[2] and far[2] < 0.012
    local = resolve(plain, before, end_of(before), STEADY, pulls=(Pull(t, tuple(there), 3000.0),), touched=(t, t))
    assert np.linalg.norm(places(local, [t])[0] - there) == pytest.approx(far[2], abs=2e-3)


def test_less_gravity_floats():
    rises = []
    for share in (0.5, 0.75, 1.0):
        given = footprints(step_time=0.62, stance_time=0.32)
        given.gravity[:] = share
        motion = solve(given, HUMAN, end_of(given), STEADY)
        flight = int(np.flatnonzero((motion.curve.support[:-1] < 0).all(axis=1))[0])
        fall = np.empty((3, 3))
        evaluate(motion.curve, 0.5 * float(motion.curve.time[flight : flight + 2].sum()), fall[0], fall[1], fall[2])
        rises.append(-fall[2, 2])
    np.testing.assert_allclose(rises, 9.81 * np.array([0.5, 0.75, 1.0]), rtol=0.05)
