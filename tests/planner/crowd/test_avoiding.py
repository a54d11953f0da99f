"""Steps around others: whom one lets go first, what one sees of others, and what comes of it."""

import numpy as np
import pytest

from motion.characters.character import load_character
from motion.track.footprints import Feet, Foot, Footprints
from planner.crowd.neighbour import NEIGHBOUR, see
from planner.crowd.sides import MOST, keep_right
from planner.modes.walk_to import WalkTo, is_there
from planner.planner import Situation
from planner.round.reservations import Intents, empty_reservations, sort_into_cells
from planner.round.round import Me, Round
from planner.round.weights import PEOPLE, table_of_weights
from sim.reports import flows
from sim.reports.throngs import cases as throngs
from sim.reports.throngs import places
from sim.stage.cast import table_of
from sim.stage.simulation import Simulation
from tests.planner.crowd.test_terms import waiting
from worlds.compiled.tables import empty
from worlds.world import Wall, World

BIRD, HUMAN = load_character("bird"), load_character("human")
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
    count, weights = len(held.due), table_of_weights(PEOPLE, 1)
    return Round(np.zeros(count, np.int64), TABLE, world.arrays, plans, held, empty(Intents, count), 0, weights)


def there(x, y, stops, reached=0, again=False, trees=(), hindered=0, other=(1.0, 11.0)):
    """Whether a walker from 2, 5 that is at x, y has come to its stop, where another one stands elsewhere."""
    world = World("plain", (12.0, 12.0), trees=np.array(trees).reshape(-1, 3))
    situation = Situation(world, [BIRD] * 2, empty(Footprints, 2, 2), np.zeros(2), 1)
    plans, held = WalkTo([(2, 5, 0.0)] * 2, [stops] * 2, again=again).prepare(situation), nothing_held()
    held.path[0, :, :2], held.path[1, :, :2] = (x, y), other
    sort_into_cells(held)
    feet = Feet(Foot(0, 0.0, 0.0, 0.0, 0.0, 0.0), Foot(1, 0.0, 0.0, 0.0, 0.0, 0.0))
    return is_there(around(held, world, plans), Me(0, 3, True, hindered, feet), reached, (float(x), float(y)))


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


def test_content_with_a_place_near_its_stop_is_who_finds_it_taken():
    stride = float(BIRD.biped.gait.preferred_step)
    near = 6 - 1.2 * stride
    assert there(6 - 0.4 * stride, 5, [(6, 5)]) and not there(near, 5, [(6, 5)], other=(6.0, 5.0))
    assert not there(near, 5, [(6, 5)], hindered=8), "however long others kept it from getting on before"
    assert there(near, 5, [(6, 5)], hindered=8, other=(6.0, 5.0))
    assert there(near, 5, [(6, 5)], hindered=8, other=(6 - 0.6 * stride, 5.0)), "nor where another stands in the way to it"
    assert not there(near, 5, [(6, 5)], hindered=8, other=(6 - 1.8 * stride, 5.0)), "behind it nobody is in its way"


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


def facing(x, y, claim=(0.0, 0.0), rank=0.0, hindered=0, aim=(-1.0, 0.0), longer=-np.inf):
    """What one who stands at 5, 5, on its way to +x, sees of another who stands at x, y, and claims a place."""
    held = nothing_held()
    held.path[0, :, :2], held.path[1, :, :2] = (5, 5), (x, y)
    held.aim[1], held.claim[1], held.rank[1] = aim, claim, rank
    found = np.zeros(1, NEIGHBOUR)
    see(held, waiting(hindered), (1.0, 0.0), float(hindered), longer, np.array([1]), found)
    return held, found[0]


def test_only_a_claim_of_higher_rank_counts():
    assert facing(5.6, 5.0, (5.3, 5.0), 6.0, 5)[1]["claim_x"] == pytest.approx(0.3)
    assert np.isinf(facing(5.6, 5.0, (5.3, 5.0), 6.0, 7)[1]["claim_x"])
    assert np.isinf(facing(5.6, 5.0, (5.3, 5.0), 6.0, 6)[1]["claim_x"]), "of equal ones the lower number goes first"
    assert np.isinf(facing(5.6, 5.0)[1]["claim_x"]), "who does not wait claims nothing"


def test_nobody_in_a_queue_has_the_right_of_way():
    claims = [facing(5.6, 5.0, (5.3, 5.0), 6.0, 0, (np.cos(a), np.sin(a)))[1]["claim_x"] for a in (0.0, 1.0, 1.1, 2.0, 3.0)]
    np.testing.assert_allclose(claims, [np.inf, np.inf, 0.3, 0.3, 0.3], atol=1e-12)


def test_others_are_expected_to_keep_the_pace_of_their_last_step():
    held, _ = facing(6.0, 5.0)
    held.path[1, :3] = [(5.6, 5.0, -1.0), (5.8, 5.0, -0.5), (6.0, 5.0, 0.0)]
    me, found = waiting()._replace(there=0.5), np.zeros(1, NEIGHBOUR)
    see(held, me, (1.0, 0.0), 0.0, -np.inf, np.array([1]), found)
    assert found[0]["vx"] == pytest.approx(0.4) and found[0]["x"] == pytest.approx(1.2)


def passed(held, trees, middle, course):
    """How a bird there, that wishes to go on a course, passes a gap between trees, where another may come."""
    held.path[0, :, :2] = middle
    sort_into_cells(held)
    round = around(held, World("gap", (12.0, 12.0), trees=trees))
    round.intents.aim[0] = np.cos(course), np.sin(course)
    return keep_right(round, 0, middle, course)


def lane(y, comes=True, at=7.0):
    """How a bird at 4, y passes the middle of a gap of 2 m at 5, 6, wished toward +x, where another may come from `at`."""
    trees = np.array([(5.0, 6 + side * k, 0.3) for side in (-1, 1) for k in np.arange(1.3, 5.8, 0.4)])
    held = facing(at, 6.0)[0]
    held.aim[1] = (-1.0 if comes else 1.0, 0.0)
    return passed(held, trees, (4.0, y), 0.0)


def test_a_narrow_place_is_passed_on_the_right_where_anyone_comes():
    assert lane(6.4).course < lane(6.0).course < -0.1 and lane(5.5).course == 0 and lane(6.0, comes=False).course == 0
    assert lane(6.4).left > lane(6.0).left > 0 == lane(5.5).left, "it does not wait where they come out"
    assert lane(6.0, at=4.5).course == 0, "who is on this side of the gap does not come through it"


def door(mine, theirs, fellow=None):
    """How a bird at so far before a gap of 0.9 m at 5, 6 passes it, where another comes from so far behind it, and a fellow."""
    trees = np.array([(5.0, 6 + side * k, 0.3) for side in (-1, 1) for k in np.arange(0.75, 5.8, 0.4)])
    held = nothing_held(3)
    held.path[:, :, 1], held.aim[:] = 6.0, (1.0, 0.0)
    held.path[1, :, 0], held.aim[1] = 5.0 + theirs, (-1.0, 0.0)
    held.path[2, :, 0] = 5.0 - (mine if fellow is None else fellow)
    return passed(held, trees, (5.0 - mine, 6.0), 0.0)


def test_through_a_door_that_is_too_narrow_for_two_ways_those_who_are_nearest_go_first():
    assert door(0.8, 1.2).left == 0 == door(0.8, 1.2).course, "the others wait"
    assert door(1.2, 0.8).left == MOST and door(1.2, 0.8, fellow=0.5).left == 0, "or I do, unless I follow one of mine"
    assert door(2.0, 0.8).left < MOST and door(3.5, 0.8).left == 0, "out of the way of those who come out, and no further"


@pytest.mark.parametrize(("count", "width"), [(20, 0.9), (20, 1.2), (12, 0.9), (10, 0.8)])
def test_those_who_meet_in_a_narrow_door_come_through_it_in_bursts(count, width):
    for seed in (3, 4):
        sim = flows.counterflow(count, width, seed=seed)
        assert flows.last_through(flows.watched(sim, 90.0, sim.world.size[0] / 2)) < 75


def in_the_open(count, comes=True, trees=(), weights=PEOPLE):
    """The course of a bird at 4, 6, wished toward +x, where so many come against it, a metre or two ahead of it."""
    held = nothing_held(count + 1)
    held.path[1:, :, 0], held.path[1:, :, 1] = 5.0 + np.arange(count)[:, None] * 0.1, 6.0
    held.aim[1:] = -1.0 if comes else 1.0, 0.0
    held.path[0, :, :2] = 4.0, 6.0
    sort_into_cells(held)
    world = World("open", (12.0, 12.0), trees=np.array(trees).reshape(-1, 3))
    round = around(held, world)._replace(weights=table_of_weights(weights, 1))
    round.intents.aim[0] = 1.0, 0.0
    return keep_right(round, 0, (4.0, 6.0), 0.0).course


def test_in_the_open_one_turns_to_the_right_of_a_throng_the_more_the_more_come():
    assert in_the_open(20) == pytest.approx(-PEOPLE.around) and -0.2 < in_the_open(1) < 0 and in_the_open(4) < in_the_open(2)
    assert in_the_open(20, comes=False) == 0 == in_the_open(20, weights=PEOPLE._replace(around=0.0))
    assert in_the_open(20, trees=[(5.5, 6.0, 0.3)]) == 0, "a way that ends is not open"
    assert in_the_open(20, trees=[(4.7, 5.3, 0.1)]) == 0, "nor is there room to turn where something stands on the right"


def test_those_who_change_places_on_a_circle_make_a_roundabout():
    """Forty: all arrive soon without standing, and go around the middle the same way, each with it on its left."""
    flow = flows.watched(places.circle(40, 0.9, PEOPLE), 22.0)
    assert throngs.still_before(flow) < 2 and throngs.last_across(flow) < 20
    off = flow.place - flow.world.size[0] / 2
    turned = np.unwrap(np.arctan2(off[..., 1], off[..., 0]), axis=0)
    assert (turned[-1] - turned[0] > 0).mean() > 0.9


def test_a_gap_is_seen_from_a_course_that_leads_through_it_at_an_angle():
    trees = np.array([(5.0, 6 + side * k, 0.3) for side in (-1, 1) for k in np.arange(1.3, 5.8, 0.4)])
    held = facing(7.0, 6.0)[0]
    straight = np.arctan2(1.2, 2.0)  # from the right half to the left one
    course = passed(held, trees, (4.0, 5.4), straight).course
    assert 5.4 + np.tan(course) < 6 - 0.9 * held.half[0, 1] < 5.4 + np.tan(straight)


def test_whom_a_field_leads_tells_where_its_way_goes_on():
    """Who goes along a wall to a door in it is not against one who comes along it from the other side of the door."""
    wall = Wall(np.array([(5.0, 0.0), (5.0, 5.2), (7.0, 5.2)]), 0.1), Wall(np.array([(5.0, 12.0), (5.0, 6.8), (7.0, 6.8)]), 0.1)
    starts = [(4.5, 4.4, np.pi / 2), (4.5, 7.6, -np.pi / 2)]
    sim = Simulation(World("door", (12.0, 12.0), walls=wall), [HUMAN, HUMAN], WalkTo(starts, [[(11, 6)], [(11, 6)]]))
    for _ in range(60):
        sim.tick()
    aim = sim.reservations.aim
    assert (aim[:, 0] > 0.2).all() and aim[0] @ aim[1] > -0.5


def test_two_streams_part_before_a_gap():
    """Twelve a side through a gap of 1.6 m: all are through, and neither waits for the other to be done."""
    sim = flows.counterflow(12, 1.6)
    flow = flows.watched(sim, 60.0, sim.world.size[0] / 2)
    x = sim.world.size[0] / 2
    through = np.where((flow.place[..., 0] - x) * (flow.place[0, :, 0] - x) < 0, flow.time[:, None], np.inf).min(axis=0)
    assert np.isfinite(through).all()
    assert through[:12].min() < np.median(through[12:]) and through[12:].min() < np.median(through[:12])


def test_who_has_arrived_lets_others_by():
    """In a corridor too narrow for two who keep to its middle."""
    walls = tuple(Wall(np.array([(1.0, y), (13.0, y)]), 0.2) for y in (1.8, 3.2))
    stops = [[(7.0, 2.5)], [(11.5, 2.5)]]
    sim = Simulation(World("corridor", (14.0, 5.0), walls=walls), [HUMAN, HUMAN], WalkTo([(6, 2.5, 0), (2.5, 2.5, 0)], stops))
    aside, before = 0.0, sim.com()[:, 0]
    for _ in range(60 * 30):
        sim.tick()
        now = sim.com()
        if before[0] > 6.5 and not sim.crowd.standing[1]:
            aside = max(aside, abs(now[0, 1] - 2.5))
        before = now[:, 0]
    assert aside > 0.1 and np.hypot(*(sim.com()[1, :2] - stops[1][0])) < 0.5, "however hindered it was on its way"
    assert sim.crowd.standing.all() and np.hypot(*(sim.com()[0, :2] - stops[0][0])) < 1.0
