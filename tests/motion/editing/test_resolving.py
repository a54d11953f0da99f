"""A motion after an edit: where nothing has changed it is the same to the bit, where something has, as if solved as a whole."""

import numpy as np
import pytest

from motion.characters.character import load_character
from motion.com import newton
from motion.com.window import LAYOUTS, SCENE
from motion.editing.resolving import changed, resolve
from motion.motion import Pull, solve
from motion.track.curve import evaluate
from planner.script.footprint import Footprint
from planner.script.laying import laid
from planner.script.scene import load_scene
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


@pytest.mark.parametrize("layout", ["smooth", "phase"])
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
    new = resolve(solve(before, HUMAN, end_of(before), SCENE), after, end_of(after), SCENE)
    for i in range(1, len(new.curve.time) - 1):
        near, rest = np.empty((2, 3)), np.empty((2, 3))
        for k, t in enumerate((new.curve.time[i] - 1e-7, new.curve.time[i] + 1e-7)):
            evaluate(new.curve, t, rest[0], rest[1], near[k])
        assert np.abs(near[1] - near[0]).max() < 2e-2  # the acceleration does not jump


def test_what_has_not_changed_is_the_same_motion():
    before = footprints()
    motion = solve(before, HUMAN, end_of(before), SCENE)
    assert changed(before, footprints()) is None
    assert resolve(motion, footprints(), end_of(before), SCENE) is motion


def greatest_move(drag):
    """How far the com moves at most [m] from one of those footprints to the next, at the same shares of its steps."""
    last, motion, moves = None, None, []
    for after in drag:
        motion = solve(after, HUMAN, end_of(after), SCENE) if motion is None else resolve(motion, after, end_of(after), SCENE)
        now = by_contacts(motion)
        if last is not None:
            moves.append(np.linalg.norm(now - last, axis=1).max())
        last = now
    return max(moves)


def test_timing_that_is_dragged_moves_the_curve_continuously_through_overlap_to_flight():
    stances = np.arange(0.66, 0.30, -0.005)
    assert greatest_move(footprints(step_time=0.55, stance_time=float(stance)) for stance in stances) < 0.01
    assert greatest_move(footprints(step_time=float(time)) for time in np.arange(0.30, 1.0, 0.02)) < 0.02


def running(**keys):
    """A run with steps of 1.04 m, one footprint in its middle with other keys."""
    ends = [0.0, 0.5, 0.8, 0.95]
    x = 1.5 + np.cumsum([0.0, *ends, *[1.04] * 9, *ends[::-1]])
    given = [Footprint(side=("left", "right")[i % 2], position=(x[i], 2.0 + 0.03 * (1 - 2 * (i % 2)))) for i in range(len(x))]
    given[9] = given[9].model_copy(update=keys)
    return laid(given, HUMAN, World("w", (30.0, 4.0)).arrays)


def test_a_runners_flight_that_is_dragged_until_its_feet_overlap_moves_the_curve_no_further_than_it_runs():
    assert greatest_move(running(stance_time=float(stance)) for stance in np.arange(0.16, 0.335, 0.005)) < 0.0105
    assert greatest_move(running(stance_time=float(stance)) for stance in np.arange(0.335, 0.60, 0.005)) < 1.25 * 2.9 * 0.005


def shipped(name, k, **keys):
    """Footprints of a scene that ships, the k-th given one with other keys."""
    scene = load_scene(name)
    given = [one.model_copy(update=keys if i == k else {}) for i, one in enumerate(scene.track.footprint)]
    return laid(given, HUMAN, scene.world.arrays, scene.track.stand_before, scene.track.stand_after)


def test_an_edit_a_few_steps_from_a_leap_is_as_the_whole_would_be():
    """What is solved anew begins where a leap has landed: there legs are springs, as if the leap were solved with it."""
    before, after = (shipped("fig19_automatic_timing", 10, stance_time=stance) for stance in (0.515, 0.52))
    new = resolve(solve(before, HUMAN, end_of(before), SCENE), after, end_of(after), SCENE)
    assert np.abs(by_contacts(new) - by_contacts(solve(after, HUMAN, end_of(after), SCENE))).max() < 0.005


def test_a_phase_of_some_milliseconds_does_not_stop_the_solver():
    """One foot leaves 2 ms after the other, before a hop: in as many pieces as any phase it is too stiff to be solved."""
    after = shipped("one_leg_hops", 2, step_time=0.26)
    found, best = (solve(after, HUMAN, end_of(after), SCENE, effort).solved.cost for effort in (newton.SCENE, newton.TIGHT))
    assert found < 1.01 * best


def test_a_squeezed_step_of_a_sprint_is_solved_to_its_end():
    """Hard scenes take more iterations: cut short, they stay at several times the cost, and a drag jumps by half a metre."""
    after = shipped("sprint", 8, stance_time=0.46)
    found, best = (solve(after, HUMAN, end_of(after), SCENE, effort).solved.cost for effort in (newton.SCENE, newton.TIGHT))
    assert found < 1.01 * best


def test_a_foot_that_is_dragged_to_leave_after_the_other_one_before_a_leap_moves_the_curve_continuously():
    """Both leave at once, or one a millisecond later: each leg reaches as far as it does by itself, and both are springs."""
    stances = np.arange(0.184, 0.168, -0.001)
    assert greatest_move(shipped("fig01_steps_and_a_hop", 3, stance_time=float(stance)) for stance in stances) < 0.01


def test_a_pull_draws_the_centre_of_mass_and_lets_go_elsewhere():
    before = footprints()
    plain = solve(before, HUMAN, end_of(before), SCENE)
    t = 0.5 * plain.end
    there = places(plain, [t])[0] + (0.0, 0.04, -0.03)
    far = [np.linalg.norm(places(plain, [t])[0] - there)]
    for stiffness in (30.0, 3000.0):
        pulled = solve(before, HUMAN, end_of(before), SCENE, pulls=(Pull(t, tuple(there), stiffness),))
        far.append(np.linalg.norm(places(pulled, [t])[0] - there))
        assert np.abs(places(pulled, [1.0]) - places(plain, [1.0])).max() < 1e-3
    assert far[0] > far[1] > far[2] and far[2] < 0.012
    local = resolve(plain, before, end_of(before), SCENE, pulls=(Pull(t, tuple(there), 3000.0),), touched=(t, t))
    assert np.linalg.norm(places(local, [t])[0] - there) == pytest.approx(far[2], abs=2e-3)


def test_less_gravity_floats():
    rises = []
    for share in (0.5, 0.75, 1.0):
        given = footprints(step_time=0.62, stance_time=0.32)
        given.gravity[:] = share
        motion = solve(given, HUMAN, end_of(given), SCENE)
        flight = int(np.flatnonzero((motion.curve.support[:-1] < 0).all(axis=1))[0])
        fall = np.empty((3, 3))
        evaluate(motion.curve, 0.5 * float(motion.curve.time[flight : flight + 2].sum()), fall[0], fall[1], fall[2])
        rises.append(-fall[2, 2])
    np.testing.assert_allclose(rises, 9.81 * np.array([0.5, 0.75, 1.0]), rtol=0.05)
