"""Changes of a running simulation: whole or not at all, logged, and done again to the same bit."""

import json

import numpy as np
import pytest

from motion.characters.character import load_character
from motion.track.footprints import LEFT, RIGHT, Step
from planner.modes.external import ROOM, External
from planner.modes.steer import Steered
from planner.planner import NoWay
from sim.files.archive import flat
from sim.files.recording import Recorder, load_recording
from sim.files.saving import restore, save
from sim.stage.commands import (
    COMMANDS,
    Give,
    Pause,
    PlantTree,
    PutRock,
    Recast,
    Remove,
    SetGoal,
    Steer,
    apply,
    from_plain,
    replay,
)
from sim.stage.making import make_simulation
from sim.stage.simulation import Simulation
from worlds.errors import InputError
from worlds.world import World

NAN = float("nan")


def ticked(sim, ticks):
    for _ in range(ticks):
        sim.tick()
    return sim


def crossing():
    return make_simulation("river_easy", "human", 1, 0, True)


def wandering():
    return make_simulation("forest", "bird", 3, 2, False)


def fed():
    return Simulation(World("yard", (20.0, 10.0)), [load_character("human")], External([(2.0, 5.0, 0.0)]))


def driven():
    return Simulation(World("yard", (20.0, 10.0), start=(5.0, 5.0)), [load_character("human")] * 2, Steered())


def state(sim):
    """All that could differ, in bytes."""
    rows = flat("crowd", sim.crowd) | ({} if sim.plans is None else flat("plans", sim.plans)) | flat("held", sim.reservations)
    plain = [sim.world.to_dict(), sim.ticks, sim.changes, [character.name for character in sim.characters]]
    return json.dumps(plain, sort_keys=True), {name: np.asarray(array).tobytes() for name, array in rows.items()}


REFUSED = {
    "tree on a foot": (wandering, lambda sim: PlantTree(*sim.feet().position[0, 0, :2].tolist()), "too near to a foot"),
    "tree outside": (wandering, lambda sim: PlantTree(-1.0, 5.0), "outside the world"),
    "tree of no size": (wandering, lambda sim: PlantTree(5.0, 5.0, NAN), "radius"),
    "rock of no height": (wandering, lambda sim: PutRock(5.0, 5.0, 0.5, -1.0), "height"),
    "no such tree": (wandering, lambda sim: Remove("tree", 10_000), "counted from 0"),
    "no such thing": (wandering, lambda sim: Remove("tre", 0), "did you mean tree"),
    "goal in a tree": (wandering, lambda sim: SetGoal(*sim.world.trees[0, :2].tolist()), "needs dry ground"),
    "no such character": (wandering, lambda sim: Pause(7), "there are 3"),
    "a body too large": (wandering, lambda sim: Recast.to(0, sized("dinosaur", 30)), "no room"),
    "fed by nobody": (wandering, lambda sim: Give(0, (Step(LEFT, 5.0, 5.0, 0.0),)), "takes no footprints"),
    "steps from nowhere": (fed, lambda sim: Give(0, (Step(LEFT, 5.0, 5.1, 0.0), Step(RIGHT, NAN, 5.0, 0.0))), "steps.1"),
    "too many steps": (fed, lambda sim: Give(0, (Step(LEFT, 5.0, 5.0, 0.0),) * (ROOM + 1)), f"{ROOM} in all"),
    "no foot": (fed, lambda sim: Give(0, (Step(2, 5.0, 5.0, 0.0),)), "steps.0.side"),
    "longer than a minute": (fed, lambda sim: Give(0, (Step(LEFT, 5.0, 5.0, 0.0, time=90.0),)), "steps.0.time"),
    "steered by nobody": (wandering, lambda sim: Steer.of(0, 0.0, "walk"), "decides for itself"),
    "no pace": (driven, lambda sim: Steer.of(0, 0.0, "wlak"), "did you mean walk"),
    "nowhere": (driven, lambda sim: Steer.of(0, NAN, "walk"), "finite angles"),
    "nobody to steer": (driven, lambda sim: Steer.of([0, 2], 0.0, "walk"), "there are 2"),
    "a wish too many": (driven, lambda sim: Steer.of([0, 1], [0.0, 1.0, 2.0], "walk"), "3 values of direction"),
}


MISTYPED = {
    "text for a number": (lambda: PlantTree("3", 3.0), "plant tree: x"),
    "truth for a number": (lambda: PutRock(True, 3.0), "put rock: x"),
    "half a character": (lambda: Pause(0.5), "whole number"),
    "half a tree": (lambda: Remove("tree", 1.0), "whole number"),
    "a goal of text": (lambda: SetGoal(1.0, "b"), "set goal: y"),
    "a direction of text": (lambda: Steer.of(0, ["x"], "walk"), "steer: direction.0"),
    "a pace of numbers": (lambda: Steer.of(0, 0.0, 3), "steer: pace.0"),
    "steps that are none": (lambda: Give(0, (1,)), "steps.0"),
    "a body of nothing": (lambda: Recast(0, [], {}), "dimensions"),
}
BODIES = {
    "no number": ({"thigh": "long"}, "thigh"),
    "no leg": ({"thigh": 1e9}, "thigh"),
    "nothing of a body": ({"wheels": 4.0}, "wheels"),
    "links that do not fit": ({"thigh": 0.1, "shank": 0.1}, "must not be more"),
}


@pytest.mark.parametrize("case", MISTYPED)
def test_values_of_another_type_are_refused_when_a_command_is_made(case):
    with pytest.raises(InputError, match=MISTYPED[case][1]):
        MISTYPED[case][0]()


@pytest.mark.parametrize("case", BODIES)
def test_a_body_that_cannot_be_is_no_recast(case):
    changed, said = BODIES[case]
    sim, human = wandering(), load_character("human")
    with pytest.raises(InputError, match=said):
        apply(sim, Recast(0, human.to_dict() | changed, human.look.model_dump(mode="json")))


def test_every_command_is_tried():
    """Each one is refused somewhere, mistyped somewhere and replayed somewhere in this file."""
    refused = {command(make()).name for make, command, _ in REFUSED.values()}
    assert refused == set(COMMANDS)
    assert {change.command["command"] for _, run in RUNS.values() for change in run().changes} == set(COMMANDS)


def test_numbers_of_any_kind_are_plain_once_logged(tmp_path):
    sim = wandering()
    apply(sim, PlantTree(np.float32(2.0), 3, np.float64(0.25)))
    apply(sim, Pause(np.int64(0), np.bool_(True)))
    assert [type(value) for value in sim.changes[0].command.values()] == [str, float, float, float]
    save(sim, tmp_path / "s.npz")
    assert restore(tmp_path / "s.npz").changes == sim.changes


def sized(name, scale):
    character = load_character(name)
    plain = character.to_dict()
    plain["body_radius"] *= scale
    return type(character).from_dict(plain, character.look.model_dump())


@pytest.mark.parametrize("case", REFUSED)
def test_a_refused_command_leaves_no_trace(case):
    make, command, said = REFUSED[case]
    sim = ticked(make(), 120)
    before = state(sim)
    with pytest.raises(InputError, match=said):
        apply(sim, command(sim))
    assert state(sim) == before
    ticked(sim, 60)


def test_a_change_that_leaves_no_way_leaves_no_trace():
    sim = ticked(make_simulation("river_leaps", "human", 1, 0, True), 100)
    before, done = state(sim), 0
    with pytest.raises(NoWay):
        for index in reversed(range(len(sim.world.rocks))):
            apply(sim, Remove("rock", index))
            before, done = state(sim), done + 1
    assert state(sim) == before and len(sim.changes) == done
    for _ in range(90 * 60):
        sim.tick()
        if sim.reached_goal.all():
            return
    pytest.fail("it does not go on to its goal")


def changed_river():
    sim = ticked(crossing(), 90)
    apply(sim, PutRock(6.0, 5.0, 0.5, 0.2))
    apply(sim, SetGoal(22.0, 5.0))
    ticked(sim, 130)
    apply(sim, Pause(0))
    ticked(sim, 100)
    apply(sim, Pause(0, False))
    return ticked(sim, 200)


def changed_wander():
    sim = ticked(wandering(), 150)
    apply(sim, PlantTree(30.0, 30.0, 0.4))
    apply(sim, Recast.to(1, load_character("human")))
    ticked(sim, 200)
    apply(sim, Remove("tree", 3))
    apply(sim, Recast.to(0, load_character("dinosaur")))
    return ticked(sim, 250)


def changed_feet():
    sim, side, x = ticked(fed(), 60), LEFT, 2.0
    for k in range(12):
        x += 0.5
        apply(sim, Give(0, (Step(side, x, 5.06 if side == LEFT else 4.94, 0.0, time=0.6 if k == 5 else NAN),)))
        side = 1 - side
        ticked(sim, 30)
    return ticked(sim, 120)


def changed_course():
    sim = ticked(driven(), 60)
    apply(sim, Steer.of([0, 1], np.array([0.3, 2.0]), ["run", "walk"]))
    ticked(sim, 150)
    apply(sim, Steer.of(0, 1.5, "walk", leap=True))
    apply(sim, Steer.of(1, 1.5, "creep", aside=-1.5))
    return ticked(sim, 200)


RUNS = {
    "driven": (driven, changed_course),
    "river": (crossing, changed_river),
    "wander": (wandering, changed_wander),
    "fed": (fed, changed_feet),
}


@pytest.mark.parametrize("name", RUNS)
def test_a_replay_is_the_same_to_the_bit(name):
    make, run = RUNS[name]
    sim = run()
    again = make()
    replay(again, sim.changes, sim.ticks)
    assert state(again) == state(sim)


@pytest.mark.parametrize("name", RUNS)
def test_commands_outlive_files(name, tmp_path):
    """A saved state knows what was done before it, and goes on as the run did; a recording can be replayed."""
    make, run = RUNS[name]
    sim = run()
    save(sim, tmp_path / "s.npz")
    restored = restore(tmp_path / "s.npz")
    assert restored.changes == sim.changes
    assert state(ticked(restored, 150)) == state(ticked(sim, 150))
    Recorder(sim).save(tmp_path / "r.npz")
    again = make()
    replay(again, load_recording(tmp_path / "r.npz").changes, sim.ticks)
    assert state(again) == state(sim)


@pytest.mark.parametrize("name", RUNS)
def test_a_command_is_plain_json_and_back(name):
    for change in RUNS[name][1]().changes:
        plain = json.loads(json.dumps(change.command))
        assert from_plain(plain).as_plain() == change.command and plain["command"] in COMMANDS


def test_what_is_no_command_is_refused():
    for plain in ({"command": "fly"}, {}, {"command": "pause", "characters": 1}):
        with pytest.raises(InputError, match="is no command"):
            from_plain(plain)
