"""Planners of one's own and steps from outside: the seam, from both sides."""

import numpy as np
import pytest

from motion.characters.character import load_character
from motion.track.footprints import LEFT, RIGHT, Step
from planner.modes.acting import Acting
from planner.modes.custom import Custom
from planner.modes.external import External
from planner.modes.people.visitors import Visiting
from planner.modes.steer import Steered
from planner.modes.walk_to import WalkTo
from planner.modes.wander import Wander
from planner.planner import NoWay, checked_starts
from planner.planners import PLANNERS
from planner.river.rock_hop import RockHop
from planner.round.round import Wish, standing
from sim.stage.commands import Give, apply
from sim.stage.simulation import Simulation
from tests.examples.planner_in_python import in_a_circle
from worlds.contents.traffic import Exit, Source, Traffic
from worlds.errors import InputError
from worlds.level import load_level
from worlds.world import World

YARD = World("yard", (20.0, 20.0), start=(10.0, 10.0))
NAN = float("nan")
HUMAN, BIRD = load_character("human"), load_character("bird")


def run(planner, characters, ticks=600, world=YARD):
    sim = Simulation(world, characters, planner, 3)
    for _ in range(ticks):
        sim.tick()
    return sim


def test_a_planner_in_python_steps_to_the_bit_as_the_compiled_one():
    starts = [(10.0, 5.0, 0.0), (10.0, 14.0, 0.0), (4.0, 10.0, 1.0)]
    slow, fast = (run(Custom(in_a_circle, starts, compiled), [HUMAN, BIRD, BIRD]) for compiled in (False, True))
    for a, b in zip(slow.crowd.footprints, fast.crowd.footprints, strict=True):
        np.testing.assert_array_equal(a, b)
    np.testing.assert_array_equal(slow.com(), fast.com())
    assert slow.footprints.steps > 30


def test_what_a_planner_in_python_raises_is_raised_by_the_tick():
    def confused(round, me):
        raise ZeroDivisionError("of all things")

    with pytest.raises(ZeroDivisionError, match="of all things"):
        run(Custom(confused), [BIRD])


def test_an_answer_that_is_no_wish_is_told():
    with pytest.raises(TypeError, match="Wish is needed"):
        run(Custom(lambda round, me: 3), [BIRD])


BAD = {
    "no place": Step(0, NAN, 1.0, 0.0),
    "endless": Step(0, 5.0, float("inf"), 0.0),
    "far out": Step(0, 1e155, 5.0, 0.0),
    "no heading": Step(1, 5.0, 5.0, NAN),
    "no foot": Step(2, 5.0, 5.0, 0.0),
    "back in time": Step(0, 5.0, 5.0, 0.0, time=-1.0),
    "no leg": Step(0, 5.0, 5.0, 0.0, crouch=7.0),
    "stands for ever": Step(0, 5.0, 5.0, 0.0, stands=float("inf")),
}


@pytest.mark.parametrize("case", BAD)
def test_a_wish_that_no_body_can_do_is_refused(case):
    """Kernels index memory by it; the character stands, and the tick names planner, character and values."""
    made = Custom(lambda round, me: Wish(BAD[case], 0.0) if me.c == 1 else standing(me, 0.5), [(5, 5, 0), (9, 9, 0)])
    with pytest.raises(ValueError, match=r"planner Custom: character 1 cannot do Step\("):
        run(made, [BIRD, BIRD])


def whole_numbers(round, me):
    return Wish(Step(me.feet.older.side, 5, 5, 0, 1, 1, 0, 1, 0), 0, 2, False, False)


def raising(round, me):
    if me.number > 3:
        raise ValueError("of all things")
    return standing(me, 0.3)


def no_wish(round, me):
    return 3


def test_whole_numbers_are_numbers():
    assert run(Custom(whole_numbers, [(5, 5, 0)], compiled=True), [BIRD], 60).feet().position[0, 1, 0] == 5


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("next_step, error, said", [(raising, ValueError, "no answer"), (no_wish, TypeError, "must return")])
def test_a_compiled_planner_that_fails_is_told(next_step, error, said):
    with pytest.raises(error, match=said):
        run(Custom(next_step, [(5, 5, 0)], compiled=True), [BIRD], 120)


def test_a_planner_in_python_sees_the_round_and_itself():
    seen = []

    def watching(round, me):
        seen.append((me.c, me.number, me.real, round.world.bounds[2], round.bipeds[round.kind[me.c]].leg.thigh))
        return standing(me, 0.4)

    run(Custom(watching), [BIRD, HUMAN], 60)
    assert {c for c, *_ in seen} == {0, 1} and {real for _, _, real, *_ in seen} == {True, False}
    assert {(c, thigh) for c, _, _, _, thigh in seen} == {(0, BIRD.biped.leg.thigh), (1, HUMAN.biped.leg.thigh)}
    assert {size for *_, size, _ in seen} == {20.0}


def test_without_starts_everyone_starts_as_wanderers_do():
    custom, wander = Custom(in_a_circle).starts(YARD, [BIRD] * 5, 4), Wander().starts(YARD, [BIRD] * 5, 4)
    np.testing.assert_array_equal(custom, wander)


def steps(count, x=2.0, stride=0.6, **more):
    """Alternating steps along x, left first, from where one stands at 2, 5."""
    return tuple(
        Step(k % 2, x + stride * (k + 1), 5.06 if k % 2 == LEFT else 4.94, 0.0, **more) for k in range(count)
    )  # fmt: skip


def fed(count, ticks=1200, **more):
    sim = Simulation(YARD, [HUMAN], External([(2.0, 5.0, 0.0)]), 0)
    sim.keep_footprints()
    apply(sim, Give(0, steps(count, **more)))
    for _ in range(ticks):
        sim.tick()
    return sim


def test_given_steps_are_taken_to_the_letter():
    sim = fed(10)
    laid = sim.walked().footprints
    wanted = np.array([(step.x, step.y) for step in steps(10)])
    np.testing.assert_array_equal(laid.position[2:, :2], wanted)
    assert laid.side[2:].tolist() == [step.side for step in steps(10)]
    assert sim.planner.left(sim.plans, sim.steps_planned)[0] == 0 and sim.crowd.standing[0]


def test_given_times_are_kept():
    laid = fed(8, time=0.9).walked().footprints
    np.testing.assert_allclose(np.diff(laid.contact_time[2:]), 0.9, atol=1e-12)


def test_who_is_given_no_more_goes_on_in_its_window_as_it_went_and_then_stands():
    sim = fed(6)
    still = sim.snapshot().toe.copy()
    for _ in range(120):
        sim.tick()
    np.testing.assert_array_equal(sim.snapshot().toe, still)
    apply(sim, Give(0, steps(3, x=sim.feet().position[0, 1, 0])))
    for _ in range(300):
        sim.tick()
    assert np.abs(sim.snapshot().toe - still).max() > 0.5


def test_steps_behind_steps_wait_for_their_turn():
    sim = Simulation(YARD, [HUMAN], External([(2.0, 5.0, 0.0)]), 0)
    for step in steps(5):
        apply(sim, Give(0, (step,)))
    assert sim.planner.left(sim.plans, sim.steps_planned)[0] == 5
    for _ in range(900):
        sim.tick()
    assert sim.feet().position[0, :, 0].max() == steps(5)[-1].x


def test_stands_crouch_and_facing_are_asked_for_too():
    sim = Simulation(YARD, [HUMAN], External([(2.0, 5.0, 0.0)]), 0)
    sim.keep_footprints()
    low = [step._replace(crouch=0.9, facing=0.4) for step in steps(4)]
    apply(sim, Give(0, tuple(low)))
    for _ in range(600):
        sim.tick()
    laid = sim.walked().footprints
    assert (laid.facing[2:6] == 0.4).all() and (laid.nominal_length[2:6] < 0.91 * HUMAN.biped.leg.nominal_length).all()


@pytest.mark.parametrize("planner", [WalkTo, External])
def test_starts_must_be_as_many_as_characters(planner):
    made = planner([(2, 5, 0.0)], [[(8, 5)]]) if planner is WalkTo else planner([(2, 5, 0.0)])
    with pytest.raises(ValueError, match="one for each"):
        Simulation(YARD, [BIRD] * 2, made)


@pytest.mark.parametrize("world", [load_level("stairs"), World("spiral", (14.0, 14.0), "spiral_stairs",
    (7.0, 7.0, 0.6, 5.5, 0.16, 24), start=(12.0, 7.5))], ids=lambda world: world.name)  # fmt: skip
@pytest.mark.parametrize("name", ["human", "bird"])
def test_wanderers_start_where_their_feet_may_stand(world, name):
    crowd = [load_character(name)] * 12
    checked_starts(Wander().starts(world, crowd, 0), world, crowd)  # raises for a foot in a riser


def test_bad_starts_are_refused():
    for starts in ([(1.0, 2.0)], [(1.0, 2.0, NAN)]):
        with pytest.raises(InputError, match="finite numbers"):
            External(starts)
        with pytest.raises(InputError, match="needed"):
            WalkTo(starts, [[(5.0, 5.0)]])
    for starts, said in (([(30.0, 1.0, 0.0)], "outside"), ([(1.0, NAN, 0.0)], "finite"), ("x", "array"), ([(1, 1)], "C, 3")):
        with pytest.raises(InputError, match=said):
            Simulation(YARD, [BIRD], Custom(in_a_circle, starts))
    with pytest.raises(InputError, match="finite"):
        WalkTo([(5, 5, 0.0)], [[(NAN, 5.0)]])


def test_an_impossible_task_says_so_before_anything_begins():
    with pytest.raises(NoWay):
        Simulation(load_level("river_impossible"), [BIRD], RockHop())


def test_every_planner_that_ships_is_made_again_from_its_values():
    traffic = Traffic(source=[Source(area=[(0, 0), (1, 1)], rate=1.0)], exit=[Exit(name="out", area=[(8, 8), (9, 9)])])
    made = (Wander(), RockHop(), WalkTo([(2, 5, 0.0)], [[(8, 5)]]), External([(2.0, 5.0, 0.0)]), Steered(), Visiting(traffic))
    made += (Acting([(2.0, 5.0, 0.0)]),)
    assert {planner.name for planner in made} == set(PLANNERS)
    for planner in made:
        assert PLANNERS[planner.name](**planner.values()).values() == planner.values()


def test_a_wish_may_hop():
    """The same foot twice: nothing in a crowd says that feet alternate."""

    def hops(round, me):
        foot = me.feet.newer
        return Wish(Step(foot.side, foot.x + 0.5, foot.y, foot.heading), foot.heading) if me.number > 6 else standing(me, 0.3)

    sim = run(Custom(hops, [(3.0, 10.0, 0.0)]), [HUMAN], 300)
    assert len(set(sim.feet().side[0].tolist())) == 1
    assert sim.feet().side[0, 0] in (LEFT, RIGHT)


@pytest.mark.parametrize("name", ["bird", "human"])
def test_ten_thousand_find_room_on_a_level_that_ships(name):
    starts = Wander().starts(load_level("meadow"), [load_character(name)] * 10_000, 0)
    assert starts.shape == (10_000, 3) and len(np.unique(starts[:, :2].round(1), axis=0)) == 10_000
