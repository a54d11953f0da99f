"""Steering: the next footprint answers, nobody steps where no foot may, nothing slides; runs repeat to the bit."""

import numpy as np
import pytest

from motion.characters.character import character_names, load_character
from planner.modes.steer import Steered
from planner.modes.wander import Wander
from planner.stepping.footing import FINE, why_not_stand
from planner.stepping.placing import EDGE
from sim.files.archive import flat
from sim.files.recording import Recorder
from sim.files.saving import restore, save
from sim.reports.measure import measure
from sim.stage.commands import SetGoal, apply, replay, steer, steer_by_chance
from sim.stage.making import make_steered
from sim.stage.simulation import Simulation
from tests.worlds_by_chance import JUMP
from worlds.level import level_names
from worlds.queries import rock_under
from worlds.world import River, World

YARD = World("yard", (40.0, 30.0), start=(10.0, 15.0))
DITCH = World("ditch", (30.0, 12.0), rivers=(River(np.array([[12.0, -5.0], [12.0, 20.0]]), 0.5),), start=(8.0, 6.0))
STREAM = World("stream", (30.0, 12.0), rivers=(River(np.array([[12.0, -5.0], [12.0, 20.0]]), 6.0),), start=(6.0, 6.0))


def ticked(sim, ticks, hand=lambda sim: None):
    for _ in range(ticks):
        sim.tick()
        hand(sim)
    return sim


def in_yard(name="human", world=YARD, characters=1):
    sim = Simulation(world, [load_character(name)] * characters, Steered(), 0)
    sim.keep_footprints()
    return ticked(sim, 60)


def newest(sim):
    prints = sim.track(0)
    return prints.position[-1, :2], float(prints.heading[-1]), bool(prints.stands[-1])


def last_stride(sim):
    """How far the last step brought the foot that moved beyond the other one [m]."""
    return float(np.linalg.norm(np.diff(sim.feet().position[0, :, :2], axis=0)))


@pytest.mark.parametrize("name", character_names())
def test_the_next_footprint_answers(name):
    sim = in_yard(name)
    assert newest(sim)[2]
    steer(sim, 0.0, "walk")
    before = sim.steps_planned[0]
    while sim.steps_planned[0] == before:
        sim.tick()
    assert not newest(sim)[2]
    ticked(sim, 240)
    steer(sim, np.pi / 2, "walk")
    before, was = sim.steps_planned[0], newest(sim)[1]
    while sim.steps_planned[0] == before:
        sim.tick()
    assert newest(sim)[1] - was > 0.2


def test_paces_are_paces():
    speeds = {}
    for pace in ("creep", "walk", "run"):
        sim = in_yard()
        steer(sim, 0.0, pace)
        ticked(sim, 240)
        began = sim.com()[0].copy()
        ticked(sim, 120)
        speeds[pace] = np.linalg.norm(sim.com()[0] - began) / 2
    assert speeds["creep"] < 0.6 * speeds["walk"] and speeds["run"] > 1.6 * speeds["walk"]


def test_one_who_is_to_stand_stands_after_a_run():
    sim = in_yard()
    steer(sim, 0.0, "run")
    ticked(sim, 240)
    steer(sim, 0.0, "stand")
    ticked(sim, 240)
    feet = sim.feet().position[0, :, :2]
    assert sim.crowd.standing[0] and np.linalg.norm(np.diff(feet, axis=0)) < 0.25
    still = sim.snapshot().toe.copy()
    np.testing.assert_array_equal(ticked(sim, 120).snapshot().toe, still)


def test_it_turns_on_the_spot():
    sim = in_yard()
    steer(sim, np.pi, "turn")
    ticked(sim, 400)
    heading = sim.feet().heading[0]
    assert np.allclose(np.cos(heading), -1, atol=0.01)
    assert np.linalg.norm(sim.com()[0, :2] - (10.0, 15.0)) < 0.3 and sim.crowd.standing[0]


@pytest.mark.parametrize("aside", [np.pi / 2, -np.pi / 2, np.pi])
def test_it_goes_aside_and_back_as_it_looks(aside):
    sim = in_yard()
    steer(sim, aside, "walk", aside)
    ticked(sim, 400)
    gone = sim.com()[0, :2] - (10.0, 15.0)
    assert gone @ (np.cos(aside), np.sin(aside)) > 1.5 and abs(gone @ (-np.sin(aside), np.cos(aside))) < 0.4
    feet = sim.feet()
    assert np.abs(feet.heading[0] - feet.toe_out[0]).max() < 0.05
    prints = sim.walked().footprints
    left = prints.position[prints.side == 0, 1]
    assert len(left) > 4


def test_a_leap_is_one_leap():
    sim = in_yard()
    steer(sim, 0.0, "walk")
    ticked(sim, 200)
    steer(sim, 0.0, "walk", leap=True)
    strides = []
    for _ in range(240):
        before = sim.steps_planned[0]
        sim.tick()
        if sim.steps_planned[0] > before:
            strides.append(last_stride(sim))
    assert sum(stride > 1.15 for stride in strides) == 1 and max(strides) == strides[0]


def test_a_ditch_is_stepped_over_and_a_stream_is_not_stepped_into():
    sim = in_yard(world=DITCH)
    steer(sim, 0.0, "walk")
    assert ticked(sim, 700).com()[0, 0] > 14.0
    sim = in_yard(world=STREAM)
    steer(sim, 0.0, "run")
    ticked(sim, 700)
    assert 8.0 < sim.com()[0, 0] < 9.05 and sim.crowd.standing[0]


def test_rocks_carry_over_a_stream():
    stones = STREAM
    for x in np.arange(9.3, 15.2, 0.62):
        stones = stones.with_rock(float(x), 6.0 + 0.1 * np.sin(5 * x), 0.28, 0.1)
    sim = in_yard(world=stones)
    steer(sim, 0.0, "walk")
    ticked(sim, 1500)
    assert sim.com()[0, 0] > 15.5
    assert (sim.walked().footprints.rock >= 0).sum() >= 5


@pytest.mark.parametrize("level", level_names())
@pytest.mark.parametrize("name", character_names())
def test_keys_by_chance_bring_nobody_where_no_foot_may_be(level, name):
    """A simulated minute each: soles are dry, in no tree and inside; in water, on rocks; feet do not slide."""
    sim = make_steered(level, name, 1, 7)
    recorder = Recorder(sim)

    def hand(sim):
        steer_by_chance(sim)
        recorder.capture()

    assert largest_jump(sim, 3600, hand) < JUMP
    report = measure(recorder.recording())
    assert report["worst"]["skate"] < 1e-3
    for where in standing_where_none_may(sim):
        pytest.fail(f"a sole at {where}")
    assert sim.distance[0] > 5.0


def largest_jump(sim, ticks, hand=lambda sim: None):
    """How far a knee moves at most against the body within a tick, in legs."""
    worst, before = 0.0, None
    for _ in range(ticks):
        sim.tick()
        hand(sim)
        pose = sim.snapshot()
        knee = pose.knee - pose.com[:, None]
        worst = max(worst, 0.0 if before is None else float(np.linalg.norm(knee - before, axis=2).max()))
        before = knee
    return worst / sim.leg(0)


def standing_where_none_may(sim):
    """Places of soles that may not be there; on a rock in water the middle of the sole must lie on the rock."""
    prints, world, found = sim.walked().footprints, sim.world.arrays, []
    for (x, y, _), heading, rock in zip(prints.position.tolist(), prints.heading.tolist(), prints.rock.tolist(), strict=True):
        on_rock = rock >= 0 and rock_under(world, x, y, EDGE) == rock
        if not on_rock and why_not_stand(sim.characters[0].biped, world, x, y, heading) != FINE:
            found.append((x, y))
    return found


def driven_crowd():
    return Simulation(World("square", (14.0, 14.0), start=(7.0, 7.0)), [load_character("bird")] * 12, Steered(), 3)


def same(a, b):
    rows, others = ({**flat("crowd", sim.crowd), **flat("plans", sim.plans)} for sim in (a, b))
    return all(np.asarray(rows[name]).tobytes() == np.asarray(others[name]).tobytes() for name in rows)


def test_a_replay_and_a_restored_state_are_the_same_to_the_bit(tmp_path):
    sim = ticked(driven_crowd(), 400, steer_by_chance)
    save(sim, tmp_path / "s.npz")
    restored = restore(tmp_path / "s.npz")
    assert same(restored, sim)
    ticked(sim, 300, steer_by_chance), ticked(restored, 300, steer_by_chance)
    assert same(restored, sim)
    again = driven_crowd()
    replay(again, sim.changes, sim.ticks)
    assert same(again, sim)


def test_those_who_are_driven_keep_off_each_other():
    sim = driven_crowd()
    radius = float(sim.bipeds["body"]["radius"][0])
    for _ in range(900):
        sim.tick()
        steer_by_chance(sim)
        com = sim.com()[:, :2]
        apart = np.linalg.norm(com[:, None] - com[None], axis=2) + 9 * np.eye(len(com))
        assert apart.min() > 1.6 * radius


def test_only_what_is_new_is_logged_and_a_thousand_are_told_at_once():
    sim = Simulation(World("plain", (200.0, 200.0), start=(100.0, 100.0)), [load_character("bird")] * 1000, Steered(), 1)
    direction = np.linspace(-3, 3, 1000)
    for _ in range(5):
        steer(sim, direction, "walk")
        sim.tick()
    assert len(sim.changes) == 1
    direction[17] += 0.5
    steer(sim, direction, "walk")
    assert len(sim.changes) == 2 and sim.changes[1].command["characters"] == [17]
    began = sim.com().copy()
    ticked(sim, 240)
    gone = (sim.com() - began)[:, :2]
    assert np.median((gone * np.stack([np.cos(direction), np.sin(direction)], axis=1)).sum(axis=1)) > 0.8


def test_wanderers_walk_to_a_goal_that_is_set_and_wander_on():
    sim = Simulation(World("meadow", (40.0, 40.0), start=(10.0, 10.0)), [load_character("bird")], Wander(), 1)
    ticked(sim, 120)
    apply(sim, SetGoal(20.0, 14.0))
    near = np.inf
    for _ in range(60 * 40):
        sim.tick()
        near = min(near, float(np.linalg.norm(sim.com()[0, :2] - (20.0, 14.0))))
    assert near < 0.8 and sim.plans.steps[0] == 0
    assert np.linalg.norm(sim.com()[0, :2] - (20.0, 14.0)) > 1.0
