"""Steps around others: nothing changes for one alone, and what is placed is free of what others hold."""

import numpy as np
import pytest

from motion.characters.character import load_character
from motion.track.footprints import Feet, Foot, Footprints
from planner.crowd.candidates import ASIDE_AND_BACK, CANDIDATES, Walker, candidate, candidate_to
from planner.crowd.course_around import course_around, keep_right, wrong_side
from planner.crowd.foresight import danger, foresee, gives_way
from planner.crowd.neighbour import NEIGHBOUR
from planner.crowd.right_of_way import BELONGS, hindered_after, inherited, rank_of
from planner.modes.walk_to import WalkTo, is_there
from planner.planner import Situation
from planner.round.reservations import Intents, empty_reservations
from planner.round.round import Me, Round
from planner.stepping import timing
from sim.stage.cast import table_of
from sim.stage.simulation import Simulation
from worlds.compiled.tables import empty
from worlds.world import World

BIRD = load_character("bird")
TABLE = table_of([BIRD])


def test_a_walker_goes_to_its_stops_and_stays():
    planner = WalkTo([(2, 5, 0.0)], [[(8, 5), (8, 9), (3, 9)]])
    sim, nearest = Simulation(World("plain", (12.0, 12.0)), [BIRD], planner), np.full(3, np.inf)
    for _ in range(60 * 40):
        sim.tick()
        nearest = np.minimum(nearest, np.linalg.norm(planner.stops[0] - sim.snapshot().com[0, :2], axis=1))
    assert nearest.max() < 0.6 and sim.plans.reached[0] == 2 and sim.crowd.standing[0]
    assert np.linalg.norm(sim.snapshot().com[0, :2] - (3, 9)) < 0.5


def nothing_held(count=2):
    return empty_reservations(TABLE, np.zeros(count, np.int64), (12.0, 12.0))


def around(held, world, plans=0):
    """The round in which characters hold that."""
    count = len(held.due)
    return Round(np.zeros(count, np.int64), TABLE, world.arrays, plans, held, empty(Intents, count), 0)


def others(*rows):
    """Neighbours: x, y, vx, vy, room, aim_x, aim_y, rank, speed."""
    return np.array([tuple(row) for row in rows], NEIGHBOUR)


def there(x, y, stops, reached=0, again=False, trees=(), hindered=0):
    """Whether a walker from 2, 5 that is at x, y has come to its stop."""
    world = World("plain", (12.0, 12.0), trees=np.array(trees).reshape(-1, 3))
    situation = Situation(world, [BIRD], empty(Footprints, 1, 2), np.zeros(1), 1)
    plans = WalkTo([(2, 5, 0.0)], [stops], again=again).prepare(situation)
    feet = Feet(Foot(0, 0.0, 0.0, 0.0, 0.0, 0.0), Foot(1, 0.0, 0.0, 0.0, 0.0, 0.0))
    return is_there(around(nothing_held(1), world, plans), Me(0, 3, True, hindered, feet), reached, (float(x), float(y)))


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
    assert sim.plans.reached[0] >= 8


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
    """One at x, y who walks toward -x; 0.5 m are to be kept from it."""
    return others((x, y, -0.5, 0.0, 0.5, -1.0, 0.0, -np.inf, 0.0))


def test_who_comes_against_one_belongs_on_the_left():
    ahead, to_the_left, to_the_right = (wrong_side(oncoming(2.0, y), 0.0, 0.0, 4.0) for y in (0.0, 1.0, -1.0))
    assert to_the_left == 0 and ahead > 0 and to_the_right > 0
    assert wrong_side(oncoming(2.0, 0.0), 0.0, -np.pi / 6, 4.0) < ahead < wrong_side(oncoming(1.0, 0.0), 0.0, 0.0, 4.0)
    assert wrong_side(oncoming(-1.0, 0.0), 0.0, 0.0, 4.0) == 0 and wrong_side(oncoming(5.0, 0.0), 0.0, 0.0, 4.0) == 0


def test_who_goes_the_same_way_may_be_on_either_side():
    same = oncoming(2.0, -0.2)
    same["aim_x"] = 1.0
    assert wrong_side(same, 0.0, 0.0, 4.0) == 0


def waiting(hindered):
    """One who stands at 5, 5 and wishes to go toward +x at 1 m/s."""
    return Walker(0, 3, 0, 5.0, 4.9, 5.0, 5.0, 0.0, 5.0, 5.0, 0.0, 0.0, 0.0, 0.3, 1.0, hindered, 0.0, True)


def facing(x, y, claim=(0.0, 0.0, 0.0)):
    """Reservations of that one, and of another who stands at x, y, wishes to go toward -x, and claims a velocity."""
    held = nothing_held()
    held.path[0, :, :2], held.path[1, :, :2] = (5, 5), (x, y)
    held.aim[1], held.claim[1] = (-1.0, 0.0), claim
    return held


def foreseen(held, rank):
    found = np.zeros(1, NEIGHBOUR)
    foresee(held, waiting(0), np.array([1]), rank, found)
    return found


def test_who_has_waited_and_has_the_oncoming_on_its_left_ranks_higher():
    near = np.array([1])
    left, right = (rank_of(facing(5.0, 5 + y), waiting(3), near) for y in (1.0, -1.0))
    assert left == pytest.approx(3 + BELONGS) and right == pytest.approx(3 - BELONGS)
    assert rank_of(facing(5.0, 6.0), waiting(3)._replace(course=np.pi), near) == 3, "who goes the same way may be anywhere"
    assert rank_of(facing(6.0, 5.0), waiting(9), near) > rank_of(facing(6.0, 5.0), waiting(3), near)


def test_only_a_claim_of_higher_rank_is_expected_to_come():
    claims = facing(5.6, 5.0, (-0.2, 0.2, 6.0))
    yielding, insisting = foreseen(claims, 5.0)[0], foreseen(claims, 7.0)[0]
    np.testing.assert_allclose((yielding["vx"], yielding["vy"]), (-0.2, 0.2), atol=1e-12)
    np.testing.assert_allclose((insisting["vx"], insisting["vy"]), (0.0, 0.0), atol=1e-12)


def lets_me_go(x, y, course, rank, theirs):
    """Whether one at x, y from me, who goes on a course [rad], gives way to me, who goes toward +x."""
    held = facing(5 + x, 5 + y, (0.1, 0.0, theirs))
    other = others((x, y, 0.0, 0.0, 0.5, np.cos(course), np.sin(course), 0.0, 0.0))[0]
    return gives_way(held, waiting(0), rank, (1.0, 0.0), 1, other)


def test_those_behind_give_way_and_of_those_who_converge_the_lower_rank():
    assert lets_me_go(-0.6, 0.1, 0.0, 0.0, 9.0) and not lets_me_go(0.6, 0.1, 0.0, 9.0, 0.0), "a queue"
    assert lets_me_go(0.3, 0.6, -0.8, 5.0, 3.0) and not lets_me_go(0.3, 0.6, -0.8, 3.0, 5.0), "converging"
    assert not lets_me_go(-0.6, 0.1, np.pi, 9.0, 0.0), "who comes against one never does"


def test_one_queues_behind_who_is_held_up_and_goes_around_who_stands():
    def heading(claimed):
        ahead = others((0.5, 0.0, 0.0, 0.0, 0.45, 1.0, 0.0, -np.inf, claimed))
        return course_around(around(facing(5.5, 5.0), World("plain", (12.0, 12.0))), waiting(0), ahead)

    assert heading(0.3) == 0 and abs(heading(0.0)) > 0.2


def lane(y, comes=True):
    """The course of a bird at 4, y past the middle of a gap of 2 m at 5, 6, wished toward +x, where another may come."""
    trees = np.array([(5.0, 6 + side * k, 0.3) for side in (-1, 1) for k in np.arange(1.3, 5.8, 0.4)])
    held = facing(7.0, 6.0)
    held.aim[1] = (-1.0 if comes else 1.0, 0.0)
    return keep_right(around(held, World("gap", (12.0, 12.0), trees=trees)), 0, np.array([1]), (4.0, y), 0.0)


def test_a_narrow_place_is_passed_on_the_right_where_anyone_comes():
    assert lane(6.4) < lane(6.0) < -0.1 and lane(5.5) == 0 and lane(6.0, comes=False) == 0


def test_a_gap_is_seen_from_a_course_that_leads_through_it_at_an_angle():
    trees = np.array([(5.0, 6 + side * k, 0.3) for side in (-1, 1) for k in np.arange(1.3, 5.8, 0.4)])
    held = facing(7.0, 6.0)
    straight = np.arctan2(1.2, 2.0)  # from the right half to the left one
    course = keep_right(around(held, World("gap", (12.0, 12.0), trees=trees)), 0, np.array([1]), (4.0, 5.4), straight)
    assert 5.4 + np.tan(course) < 6 - 0.7 * held.room[0] < 5.4 + np.tan(straight)


def test_no_course_around_leads_into_a_wall():
    world = World("wall", (12.0, 12.0), trees=np.array([(x, 4.47, 0.3) for x in np.arange(1.0, 11.0, 0.4)]))
    ahead = others((0.42, 0.05, -1.0, 0.0, 0.42, -1.0, 0.0, -np.inf, 0.0))  # comes head-on: the right would be free of it
    assert course_around(around(facing(5.5, 5.0), world), waiting(0), ahead) >= 0


def staggered(hindered=0):
    """One who stands with its last foot, the right, ahead of the other."""
    return waiting(hindered)._replace(side=1, foot_x=5.1, foot_y=4.955, x=5.1, rest_x=5.0, rest_y=5.0)


def test_a_step_back_brings_the_body_back_from_any_stance():
    b = BIRD.biped
    for me in (waiting(0), staggered()):
        wish = candidate_to(b, me, me.x + 0.3, 5.0, 0.0)
        for k, (ahead, _) in enumerate(ASIDE_AND_BACK[:-1]):
            step = candidate(b, me, wish, CANDIDATES - len(ASIDE_AND_BACK) + 1 + k)
            if ahead < 0:
                assert 0.5 * (me.foot_x + step.foot_x) < me.rest_x - 0.02


def test_a_foot_set_down_where_it_was_gets_nobody_on():
    b, me = BIRD.biped, staggered(3)
    wish = candidate_to(b, me, 5.4, 5.0, 0.0)
    in_place = candidate_to(b, me, 4.9, 5.0, 0.0)
    on, back = candidate_to(b, me, 5.3, 5.0, 0.0), candidate_to(b, me, 4.6, 5.0, 0.0)
    assert [hindered_after(b, me, wish, step) for step in (wish, on, in_place, back)] == [2, 2, 4, 5]


def test_among_those_who_touch_backing_off_is_less_dangerous():
    near = foreseen(facing(5 + 2 * facing(6.0, 5.0).room[0], 5.0, (-0.5, 0.0, 6.0)), 2.0)
    costs = [danger(near, v, 0.0) for v in (-0.6, -0.4, -0.2, 0.0)]
    assert costs[0] == 0 and (np.diff(costs) > 0).all()


def test_a_leader_is_expected_to_go_as_it_claims():
    held = facing(5.6, 5.0, (0.4, 0.0, 1.0))
    held.aim[1] = (1.0, 0.0)
    assert foreseen(held, 9.0)["vx"] == 0.4, "whatever its rank"


def test_short_steps_of_the_hindered_are_quick():
    calm, hurried = (candidate_to(BIRD.biped, waiting(hindered), 5.05, 5.0, 0.0).time for hindered in (0, 1))
    assert hurried < calm and hurried >= timing.least_step_time(BIRD.biped, 0.0) - 1e-12


def test_who_is_in_the_way_of_a_claim_inherits_its_rank():
    assert inherited(foreseen(facing(5.6, 5.0, (-0.2, 0.0, 6.0)), 2.0), 2.0) == 5
    assert inherited(foreseen(facing(5.6, 5.0, (0.2, 0.0, 6.0)), 2.0), 2.0) == 2, "it goes away"
    assert inherited(foreseen(facing(7.5, 5.0, (-0.2, 0.0, 6.0)), 2.0), 2.0) == 2, "it is far"
    assert inherited(foreseen(facing(5.6, 5.0, (-0.2, 0.0, 6.0)), 7.0), 7.0) == 7, "it ranks lower"
