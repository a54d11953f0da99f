"""Gaits made up with known strides, bob and sway."""

import numpy as np
import pytest

from motion.measures import gait
from motion.track import phases
from motion.track.footprints import Footprints
from worlds.compiled.tables import empty

HIP = 0.92
TIME = np.arange(0, 14, 1 / 60)


def walk(step=0.7, step_time=0.5, duty=0.6, width=0.12, count=26, start=0.3, same_foot=False, turn=0.0):
    """Footprints of a steady gait; `turn` [rad] per step bends it into a circle."""
    k = np.arange(count)
    yaw = turn * k
    middle = np.cumsum(step * np.column_stack([np.cos(yaw), np.sin(yaw)]), axis=0)
    side = np.zeros(count, int) if same_foot else k % 2
    across = width * (0.5 - side)
    place = middle + across[:, None] * np.column_stack([-np.sin(yaw), np.cos(yaw)])
    stride = step_time if same_foot else 2 * step_time
    return empty(Footprints, count)._replace(
        side=side, position=np.column_stack([place, np.zeros(count)]), heading=yaw,
        contact_time=start + step_time * k, stance_time=np.full(count, duty * stride),
    )  # fmt: skip


def phase_of(footprints):
    on = np.zeros((len(TIME), 2), bool)
    for side, begin, stance in zip(footprints.side, footprints.contact_time, footprints.stance_time, strict=True):
        on[(begin <= TIME) & (begin + stance > TIME), side] = True
    codes = np.array([[phases.FLIGHT, phases.RIGHT_STANCE], [phases.LEFT_STANCE, phases.DOUBLE_STANCE]])
    return codes[on[:, 0].astype(int), on[:, 1].astype(int)]


def com(speed=1.4, bob=0.04, sway=0.05, rise=0.0, first=0.3, step_time=0.5):
    """Straight ahead; highest in the middle of each step, to the side twice as slowly."""
    t = (TIME - first) / step_time
    return np.column_stack(
        [speed * TIME, 0.5 * sway * np.sin(np.pi * t), 0.9 + rise * TIME - 0.5 * bob * np.cos(2 * np.pi * t)]
    )


def test_a_walk_in_figures():
    footprints = walk()
    found = gait.report(footprints, TIME, com(), phase_of(footprints), HIP)
    assert found["name"] == "walk" and found["shares"]["walk"] > 0.85
    assert found["bob"] == pytest.approx(0.04, abs=5e-4) and found["sway"] == pytest.approx(0.05, abs=5e-4)
    assert found["step_length"] == pytest.approx(0.7) and found["step_width"] == pytest.approx(0.12)
    assert found["cadence"] == pytest.approx(120) and found["duty_factor"] == pytest.approx(0.6)
    assert found["double_support"] == pytest.approx(0.2, abs=0.01) and found["flight"] == 0
    assert found["speed"] == pytest.approx(1.4) and found["froude"] == pytest.approx(1.4**2 / 9.81 / HIP)


def test_height_at_midstance_tells_a_pendulum_from_a_spring():
    footprints = walk(duty=0.5)  # its stances are as long as steps: mid-stance is mid-step
    for bob, height in ((0.04, 1), (-0.04, 0)):
        found = gait.report(footprints, TIME, com(bob=bob), phase_of(footprints), HIP)
        assert found["height_at_midstance"] == pytest.approx(height, abs=0.01)


def test_a_run_flies():
    footprints = walk(duty=0.36)
    found = gait.report(footprints, TIME, com(), phase_of(footprints), HIP)
    assert found["name"] == "run" and found["flight"] == pytest.approx(0.28, abs=0.02) and found["double_support"] == 0


def test_slopes_and_turns_neither_bob_nor_sway():
    footprints = walk()
    climbing = gait.report(footprints, TIME, com(rise=0.5), phase_of(footprints), HIP)
    assert climbing["bob"] == pytest.approx(0.04, abs=5e-4)
    radius = 5.0
    angle, level = TIME * 1.4 / radius, com(sway=0.0)
    round_about = np.column_stack([radius * np.cos(angle), radius * np.sin(angle), level[:, 2]])
    found = gait.report(footprints, TIME, round_about, phase_of(footprints), HIP)
    assert found["sway"] < 3e-4 and found["speed"] == pytest.approx(1.4, rel=0.01)


def test_hops_and_standing_are_told_apart():
    hops = walk(same_foot=True, duty=0.5)
    found = gait.report(hops, TIME, com(), phase_of(hops), HIP)
    assert found["name"] == "hop" and found["step_width"] is None and found["cadence"] == pytest.approx(120)
    still = walk(count=2)
    still.stance_time[:] = 20.0
    found = gait.report(still, TIME, com(speed=0), phase_of(still), HIP)
    assert found["name"] == "stand" and found["shares"]["stand"] == 1 and found["bob"] is None and found["strides"] == 0


def test_a_pause_is_no_stride():
    footprints = walk(count=22)
    footprints.contact_time[10:] += 2.0
    footprints.stance_time[8:10] += 2.0
    strides = gait.strides_of(footprints, 0.0, 14.0, HIP)
    assert len(strides.begin) == 22 - 2 - 2 and strides.duration == pytest.approx(1.0)
    assert gait.shares_of(strides, TIME)["stand"] == pytest.approx(1 - (10.0 - 1.0 + 0.5 - 0.5) / 14, abs=0.08)


def test_backward_steps_keep_their_width():
    footprints = walk(step=-0.4)
    length, width = gait.stepping(gait.strides_of(footprints, 0.0, 14.0, HIP), footprints)
    assert length == pytest.approx(0.4) and width == pytest.approx(0.12)
    crossing = walk(width=-0.06)
    assert gait.stepping(gait.strides_of(crossing, 0.0, 14.0, HIP), crossing)[1] == pytest.approx(-0.06)
