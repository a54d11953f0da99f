"""What is shown of a motion whose timing is dragged: it follows no further than the hand goes, and comes to what is solved."""

import numpy as np
import pytest

from motion.com.window import SCENE
from motion.editing.gliding import PACE, glide, settle
from motion.editing.resolving import resolve
from motion.motion import solve
from tests.motion.editing.test_resolving import HUMAN, by_contacts, end_of, shipped

NAME, K, STANCES = "one_leg_hops", 1, np.arange(0.205, 0.174, -0.005)
"""A drag by which a step becomes a leap."""


def solved_in_turn(stances=STANCES):
    motion = None
    for stance in stances:
        after = shipped(NAME, K, stance_time=float(stance))
        motion = solve(after, HUMAN, end_of(after)) if motion is None else resolve(motion, after, end_of(after), SCENE)
        yield motion


def far(motion, other):
    return np.linalg.norm(by_contacts(motion) - by_contacts(other), axis=1).max()


def test_what_is_shown_goes_no_further_than_the_hand():
    shown, last, leapt = None, None, 0.0
    for solved in solved_in_turn():
        if shown is not None:
            now = glide(shown, solved)
            assert far(now, shown) < 0.01
            leapt, shown = max(leapt, far(solved, last)), now
        else:
            shown = solved
        last = solved
    assert leapt > 2 * PACE * 0.005  # the solved one goes further


def test_what_is_shown_comes_to_what_is_solved():
    first, *_, solved = solved_in_turn((0.205, 0.185))
    shown = glide(first, solved)
    before = far(shown, solved)
    assert before > 0.01
    for seconds in (0.05, 0.1):
        shown = settle(shown, solved, seconds)
        assert far(shown, solved) < before
        before = far(shown, solved)
    assert settle(shown, solved, 2.0) is solved


def test_who_holds_still_sees_no_jump_and_what_is_no_timing_is_shown_at_once():
    first, solved = solved_in_turn((0.205, 0.185))
    shown = glide(first, solved)
    assert far(glide(shown, solved), shown) < 1e-3
    moved = solve(shipped(NAME, K, stance_time=0.205, position=(2.0, 2.1)), HUMAN, end_of(first.footprints))
    assert glide(first, moved) is moved
    crouched = shipped(NAME, K, stance_time=0.205, crouch=0.9)
    low = solve(crouched, HUMAN, end_of(crouched))
    assert glide(first, low) is low


@pytest.mark.parametrize("end", [0, -1])
def test_who_stands_before_and_after_stands_while_it_glides(end):
    first, solved = solved_in_turn((0.205, 0.185))
    assert np.array_equal(glide(first, solved).curve.control[end], solved.curve.control[end])
