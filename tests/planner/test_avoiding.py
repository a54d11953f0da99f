"""Steps around others: nothing changes for one alone, and what is placed is free of what others hold."""

import numpy as np
import pytest

from motion.characters.biped import load_biped
from planner import plan
from planner.crowd.candidates import ASIDE_AND_BACK, CANDIDATES, Walker, candidate, step_to
from planner.crowd.foresight import OTHER, danger, foresee, gives_way
from planner.crowd.reservations import empty_reservations
from planner.crowd.right_of_way import BELONGS, hindered_after, inherited, rank_of
from planner.crowd.way_around import keep_right, way_around, wrong_side
from planner.stepping import timing
from planner.walking import WalkTo
from sim.stage.simulation import Simulation
from worlds.world import World

BIRD = load_biped("bird")


def test_a_walker_goes_to_its_stops_and_stays():
    planner = WalkTo([(2, 5, 0.0)], [[(8, 5), (8, 9), (3, 9)]])
    sim, nearest = Simulation(World("plain", (12.0, 12.0)), [BIRD], planner), np.full(3, np.inf)
    for _ in range(60 * 40):
        sim.tick()
        nearest = np.minimum(nearest, np.linalg.norm(planner.stops[0] - sim.snapshot().com[0, :2], axis=1))
    assert nearest.max() < 0.6 and sim.crowd.reached[0] == 2 and sim.crowd.standing[0]
    assert np.linalg.norm(sim.snapshot().com[0, :2] - (3, 9)) < 0.5


def there(x, y, stops, reached=0, again=False, trees=(), hindered=0):
    """Whether a walker from 2, 5 that is at x, y has come to its stop."""
    world = World("plain", (12.0, 12.0), trees=np.array(trees).reshape(-1, 3))
    plans = WalkTo([(2, 5, 0.0)], [stops], again=again).prepare(world, [BIRD], np.zeros((1, 2, 5)), np.zeros(1), 1)
    return plan.is_there(BIRD.record, world.arrays, plans, 0, reached, hindered, x, y)


def test_a_stop_on_the_way_that_lies_behind_is_reached():
    on = [(6, 5), (10, 5)]
    assert there(6.3, 8, on) and not there(5.7, 8, on)
    assert not there(6.3, 8, on, trees=[(7.5, 7.0, 0.5)])  # the way on is not free: only the stop leads around
    assert not there(6.3, 8, on[:1]), "the last stop is not on the way"
    assert not there(6.0, 5.0, [(6, 5), (3, 5)], reached=1, again=True), "nor is where one turns back"
    assert there(2.9, 8, [(6, 5), (3, 5)], reached=1, again=True)


def test_a_stop_to_the_side_is_passed_by_whom_others_keep_off_it():
    on = [(6, 5), (10, 5)]
    assert there(5.0, 7, on, hindered=1) and not there(5.0, 7, on) and not there(3.0, 7, on, hindered=9)
    assert not there(5.0, 7, on, hindered=1, trees=[(7.5, 6.0, 0.5)])


def test_nobody_slows_down_for_a_stop_on_the_way():
    sim, x = Simulation(World("plain", (12.0, 10.0)), [BIRD], WalkTo([(2, 5, 0.0)], [[(6, 5), (10.5, 5)]])), [2.0]
    while x[-1] < 8:
        sim.tick()
        x.append(sim.com()[0, 0])
    speed = np.diff(x)[np.array(x[1:]) > 4]
    assert speed.min() > 0.8 * speed.mean()


def test_a_walker_may_begin_again():
    sim = Simulation(World("plain", (12.0, 12.0)), [BIRD], WalkTo([(3, 5, 0.0)], [[(7, 5), (3, 5)]], again=True))
    for _ in range(60 * 60):
        sim.tick()
    assert sim.crowd.reached[0] >= 8


def test_stops_of_another_shape_are_refused():
    with pytest.raises(ValueError, match="starts"):
        WalkTo([(2, 5, 0.0)], [(8, 5)])


def test_who_meet_head_on_pass_each_other():
    planner = WalkTo([(2, 5, 0.0), (10, 5, np.pi)], [[(10, 5)], [(2, 5)]])
    sim, nearest = Simulation(World("plain", (12.0, 10.0)), [BIRD, BIRD], planner), np.inf
    for _ in range(60 * 25):
        sim.tick()
        nearest = min(nearest, float(np.hypot(*np.diff(sim.snapshot().com[:, :2], axis=0)[0])))
    assert nearest > 0.39
    assert np.linalg.norm(sim.snapshot().com[:, :2] - planner.stops[:, 0], axis=1).max() < 0.6


def oncoming(x, y):
    """One at x, y who walks toward -x, as planner.crowd.avoiding.foresee tells: room to keep 0.5 m."""
    return np.array([[x, y, -0.5, 0.0, 0.5, -1.0, 0.0, -np.inf, 0.0]])


def test_who_comes_against_one_belongs_on_the_left():
    ahead, to_the_left, to_the_right = (wrong_side(oncoming(2.0, y), 0.0, 0.0, 4.0) for y in (0.0, 1.0, -1.0))
    assert to_the_left == 0 and ahead > 0 and to_the_right > 0
    assert wrong_side(oncoming(2.0, 0.0), 0.0, -np.pi / 6, 4.0) < ahead < wrong_side(oncoming(1.0, 0.0), 0.0, 0.0, 4.0)
    assert wrong_side(oncoming(-1.0, 0.0), 0.0, 0.0, 4.0) == 0 and wrong_side(oncoming(5.0, 0.0), 0.0, 0.0, 4.0) == 0


def test_who_goes_the_same_way_may_be_on_either_side():
    same = oncoming(2.0, -0.2)
    same[0, 5] = 1.0
    assert wrong_side(same, 0.0, 0.0, 4.0) == 0


def waiting(hindered):
    """One who stands at 5, 5 and wishes to go toward +x at 1 m/s."""
    return Walker(0, 0, 5.0, 4.9, 5.0, 5.0, 0.0, 5.0, 5.0, 0.0, 0.0, 0.0, 0.3, 1.0, hindered, 0.0, True)


def facing(x, y, claim=(0.0, 0.0, 0.0)):
    """Reservations of that one, and of another who stands at x, y, wishes to go toward -x, and claims a velocity."""
    r = empty_reservations(np.rec.array(BIRD.record.reshape(1)), np.zeros(2, np.int64), (12.0, 12.0))
    r.way[0, :, :2], r.way[1, :, :2] = (5, 5), (x, y)
    r.aim[1], r.claim[1] = (-1.0, 0.0), claim
    return r


def foreseen(r, rank):
    others = np.zeros((1, OTHER))
    foresee(r, waiting(0), np.array([1]), rank, others)
    return others


def test_who_has_waited_and_has_the_oncoming_on_its_left_ranks_higher():
    near = np.array([1])
    left, right = (rank_of(facing(5.0, 5 + y), waiting(3), near, 0.0) for y in (1.0, -1.0))
    assert left == pytest.approx(3 + BELONGS) and right == pytest.approx(3 - BELONGS)
    assert rank_of(facing(5.0, 6.0), waiting(3), near, np.pi) == 3, "who goes the same way may be anywhere"
    assert rank_of(facing(6.0, 5.0), waiting(9), near, 0.0) > rank_of(facing(6.0, 5.0), waiting(3), near, 0.0)


def test_only_a_claim_of_higher_rank_is_expected_to_come():
    claims = facing(5.6, 5.0, (-0.2, 0.2, 6.0))
    yielding, insisting = foreseen(claims, 5.0)[0], foreseen(claims, 7.0)[0]
    np.testing.assert_allclose(yielding[2:4], (-0.2, 0.2), atol=1e-12)
    np.testing.assert_allclose(insisting[2:4], (0.0, 0.0), atol=1e-12)


def lets_me_go(x, y, way, rank, theirs):
    """Whether one at x, y from me, who goes a way [rad], gives way to me, who goes toward +x."""
    r = facing(5 + x, 5 + y, (0.1, 0.0, theirs))
    return gives_way(r, waiting(0), rank, 1.0, 0.0, 1, np.array([x, y, 0.0, 0.0, 0.5, np.cos(way), np.sin(way), 0.0, 0.0]))


def test_those_behind_give_way_and_of_those_who_converge_the_lower_rank():
    assert lets_me_go(-0.6, 0.1, 0.0, 0.0, 9.0) and not lets_me_go(0.6, 0.1, 0.0, 9.0, 0.0), "a queue"
    assert lets_me_go(0.3, 0.6, -0.8, 5.0, 3.0) and not lets_me_go(0.3, 0.6, -0.8, 3.0, 5.0), "converging"
    assert not lets_me_go(-0.6, 0.1, np.pi, 9.0, 0.0), "who comes against one never does"


def test_one_queues_behind_who_is_held_up_and_goes_around_who_stands():
    def heading(claimed):
        ahead = np.array([[0.5, 0.0, 0.0, 0.0, 0.45, 1.0, 0.0, -np.inf, claimed]])
        w = World("plain", (12.0, 12.0)).arrays
        return way_around(BIRD.record, w, facing(5.5, 5.0), waiting(0), ahead)

    assert heading(0.3) == 0 and abs(heading(0.0)) > 0.2


def lane(y, comes=True):
    """The way of a bird at 4, y past the middle of a gap of 2 m at 5, 6, wished toward +x, where another may come."""
    trees = np.array([(5.0, 6 + side * k, 0.3) for side in (-1, 1) for k in np.arange(1.3, 5.8, 0.4)])
    r = facing(7.0, 6.0)
    r.aim[1] = (-1.0 if comes else 1.0, 0.0)
    return keep_right(BIRD.record, World("gap", (12.0, 12.0), trees=trees).arrays, r, 0, np.array([1]), 4.0, y, 0.0)


def test_a_narrow_place_is_passed_on_the_right_where_anyone_comes():
    assert lane(6.4) < lane(6.0) < -0.1 and lane(5.5) == 0 and lane(6.0, comes=False) == 0


def test_a_gap_is_seen_from_a_way_that_leads_through_it_at_an_angle():
    trees = np.array([(5.0, 6 + side * k, 0.3) for side in (-1, 1) for k in np.arange(1.3, 5.8, 0.4)])
    world, r = World("gap", (12.0, 12.0), trees=trees).arrays, facing(7.0, 6.0)
    straight = np.arctan2(1.2, 2.0)  # from the right half to the left one
    way = keep_right(BIRD.record, world, r, 0, np.array([1]), 4.0, 5.4, straight)
    assert 5.4 + np.tan(way) < 6 - 0.7 * r.room[0] < 5.4 + np.tan(straight)


def test_no_way_around_leads_into_a_wall():
    world = World("wall", (12.0, 12.0), trees=np.array([(x, 4.47, 0.3) for x in np.arange(1.0, 11.0, 0.4)])).arrays
    ahead = np.array([[0.42, 0.05, -1.0, 0.0, 0.42, -1.0, 0.0, -np.inf, 0.0]])  # comes head-on: the right would be free of it
    assert way_around(BIRD.record, world, facing(5.5, 5.0), waiting(0), ahead) >= 0


def staggered(hindered=0):
    """One who stands with its last foot, the right, ahead of the other."""
    return waiting(hindered)._replace(side=1, foot_x=5.1, foot_y=4.955, x=5.1, rest_x=5.0, rest_y=5.0)


def test_a_step_back_brings_the_body_back_from_any_stance():
    b = BIRD.record
    for me in (waiting(0), staggered()):
        wish = step_to(b, me, me.x + 0.3, 5.0, 0.0)
        for k, (ahead, _) in enumerate(ASIDE_AND_BACK[:-1]):
            step = candidate(b, me, wish, CANDIDATES - len(ASIDE_AND_BACK) + 1 + k)
            if ahead < 0:
                assert 0.5 * (me.foot_x + step.foot_x) < me.rest_x - 0.02


def test_a_foot_set_down_where_it_was_gets_nobody_on():
    b, me = BIRD.record, staggered(3)
    wish = step_to(b, me, 5.4, 5.0, 0.0)
    in_place = step_to(b, me, 4.9, 5.0, 0.0)
    on, back = step_to(b, me, 5.3, 5.0, 0.0), step_to(b, me, 4.6, 5.0, 0.0)
    assert [hindered_after(b, me, wish, step) for step in (wish, on, in_place, back)] == [2, 2, 4, 5]


def test_among_those_who_touch_backing_off_is_less_dangerous():
    r = facing(5 + 2 * facing(6.0, 5.0).room[0], 5.0, (-0.5, 0.0, 6.0))
    others = foreseen(r, 2.0)
    costs = [danger(others, v, 0.0) for v in (-0.6, -0.4, -0.2, 0.0)]
    assert costs[0] == 0 and (np.diff(costs) > 0).all()


def test_a_leader_is_expected_to_go_as_it_claims():
    r = facing(5.6, 5.0, (0.4, 0.0, 1.0))
    r.aim[1] = (1.0, 0.0)
    assert foreseen(r, 9.0)[0, 2] == 0.4, "whatever its rank"


def test_short_steps_of_the_hindered_are_quick():
    calm, hurried = (step_to(BIRD.record, waiting(hindered), 5.05, 5.0, 0.0).time for hindered in (0, 1))
    assert hurried < calm and hurried >= timing.least_step_time(BIRD.record, 0.0) - 1e-12


def test_who_is_in_the_way_of_a_claim_inherits_its_rank():
    assert inherited(foreseen(facing(5.6, 5.0, (-0.2, 0.0, 6.0)), 2.0), 2.0) == 5
    assert inherited(foreseen(facing(5.6, 5.0, (0.2, 0.0, 6.0)), 2.0), 2.0) == 2, "it goes away"
    assert inherited(foreseen(facing(7.5, 5.0, (-0.2, 0.0, 6.0)), 2.0), 2.0) == 2, "it is far"
    assert inherited(foreseen(facing(5.6, 5.0, (-0.2, 0.0, 6.0)), 7.0), 7.0) == 7, "it ranks lower"
