"""People who come in, wait and go out: rows are used again, runs go on to the bit, nobody is lost."""

import numpy as np
import pytest

from motion.characters.character import load_character
from planner.modes.people.visitors import Visiting
from planner.planners import PLANNERS
from sim.files.recording import Recorder, load_recording
from sim.files.saving import restore, save
from sim.files.schema import RunMeta, check_run
from sim.reports.measure import measure
from sim.stage.commands import PlantTree, apply
from sim.stage.simulation import Simulation
from worlds.contents.traffic import Exit, Population, Source, Traffic, Waiting
from worlds.errors import InputError
from worlds.world import Wall, World

HUMAN = load_character("human")
HALL = World("hall", (16.0, 8.0), walls=tuple(Wall(np.array([(8.0, y), (8.0, y + 3.0)]), 0.2) for y in (0.0, 5.0)))
EAST, WEST = Exit(name="east", area=[(15.0, 1.0), (16.0, 7.0)]), Exit(name="west", area=[(0.0, 1.0), (0.8, 7.0)])
ROOM = [(1.0, 1.0), (3.0, 7.0)]


def hall(rows=30, seed=1, **tables):
    values = {"source": [Source(area=ROOM, rate=1.0, to=["east"])], "exit": [EAST, WEST]} | tables
    return Simulation(HALL, [HUMAN] * rows, Visiting(Traffic(**values)), seed)


def until(sim, seconds, look=None):
    while sim.time < seconds:
        sim.tick()
        if look:
            look(sim)
    return sim


def counts(sim):
    return sim.planner.counts(sim.plans)


def test_people_come_at_their_rate_and_go_out_by_their_exit():
    sim = until(hall(), 40.0)
    told = counts(sim)
    assert 25 <= told["came"] <= 55 and told["exits"]["west"] == 0 and told["exits"]["east"] == told["went"] > 10
    assert told["came"] == told["went"] + told["there"] and sim.present().sum() == told["there"]


def test_rows_are_used_again_and_full_ones_keep_people_outside():
    sim = until(hall(rows=6), 60.0)
    told = counts(sim)
    assert told["went"] > 6 and told["there"] <= 6 and told["outside"] > 0
    assert sim.footprints.recasts.max() > 0


def test_nobody_comes_onto_somebody_else():
    def look(sim):
        rows = np.flatnonzero(sim.present())
        place = sim.com()[rows, :2]
        apart = np.linalg.norm(place[:, None] - place[None], axis=2) + 9.0 * np.eye(len(rows))
        assert len(rows) < 2 or apart.min() > 0.2

    until(hall(seed=4, source=[Source(area=[(1.0, 3.0), (2.0, 5.0)], rate=3.0, to=["east"])]), 15.0, look)


def test_nobody_comes_into_the_way_of_a_step_that_is_planned():
    """Where others stream by they came to stand within 9 cm of one who was about to pass there."""
    nearest = []

    def look(sim):
        place = sim.com()[np.flatnonzero(sim.present()), :2]
        apart = np.linalg.norm(place[:, None] - place[None], axis=2) + 9.0 * np.eye(len(place))
        nearest.append(apart.min(initial=9.0))

    by_the_way = Source(area=[(4.0, 2.5), (6.5, 5.5)], rate=2.0, to=["east"])
    for seed in range(1, 5):
        until(hall(seed=seed, source=[Source(area=ROOM, rate=2.0, to=["east"]), by_the_way]), 20.0, look)
    assert min(nearest) > 0.25


def test_who_comes_stands_on_legs_of_its_own_length():
    small = [Population(name="small", share=1.0, character="human", size=(0.8, 0.0))]

    def look(sim):
        rows, pose = np.flatnonzero(sim.present()), sim.snapshot()
        legs = np.linalg.norm(pose.hip[rows] - pose.ankle[rows], axis=2)
        assert (legs < 1.002 * np.array([[sim.characters[c].biped.leg.max_length] for c in rows])).all()
        assert (np.abs(pose.com_velocity[rows, 2]) < 1.0).all()  # who falls onto them is at 2 m/s

    until(hall(population=small, source=[Source(area=ROOM, at_first=3, rate=1.0, to=["east"])]), 6.0, look)


def test_those_who_are_there_at_first_and_no_more_than_most():
    sim = hall(source=[Source(area=ROOM, at_first=12, rate=5.0, most=15, to=["east"])])
    assert counts(sim)["came"] == 12 and sim.present().sum() == 12
    until(sim, 30.0)
    assert counts(sim)["came"] == 15 and counts(sim)["went"] == 15 and not sim.present().any()


def test_a_waiting_area_is_visited_on_the_way():
    board = Waiting(name="board", area=[(4.0, 1.0), (7.0, 3.0)], seconds=(5.0, 6.0))
    sim = hall(source=[Source(area=ROOM, at_first=4, via=["board"], to=["east"])], waiting=[board])
    stayed = np.zeros(30)

    def look(sim):
        place = sim.com()[:, :2]
        stayed[sim.present() & (place[:, 0] > 3.5) & (place[:, 0] < 7.5) & (place[:, 1] < 3.6)] += 1 / 60

    until(sim, 45.0, look)
    assert counts(sim)["went"] == 4 and (stayed > 5.0).sum() == 4


def test_who_reacts_late_sets_out_late():
    people = Population(name="late", reaction=(3.0, 8.0))
    sim = hall(source=[Source(area=ROOM, at_first=5, to=["east"])], population=[people])
    first = sim.com()[:, :2]
    until(sim, 3.0)
    assert np.linalg.norm(sim.com()[:, :2] - first, axis=1)[sim.present()].max() < 0.25
    until(sim, 30.0)
    assert counts(sim)["went"] == 5


def test_groups_stay_together():
    def spread(groups):
        people = Population(name="families", groups=groups, speed=(1.3, 0.25))
        sim = hall(source=[Source(area=ROOM, at_first=3, to=["east"])], population=[people], seed=8)
        until(sim, 6.0)
        return np.ptp(sim.com()[sim.present(), 0])

    assert spread([0.001, 0.001, 1.0]) < spread([1.0]) and spread([0.001, 0.001, 1.0]) < 1.5


def test_two_walk_abreast():
    pairs = Population(name="pairs", groups=[0.001, 1.0])
    yard = World("yard", (30.0, 8.0))
    out = Exit(name="out", area=[(28.0, 1.0), (30.0, 7.0)])
    tables = Traffic(population=[pairs], source=[Source(area=ROOM, at_first=2)], exit=[out])
    sim, aside, along = Simulation(yard, [HUMAN] * 2, Visiting(tables), 5), [], []

    def look(sim):
        if sim.time > 6.0 and sim.present().all():
            off = np.abs(np.diff(sim.com()[:, :2], axis=0)[0])
            along.append(off[0])
            aside.append(off[1])

    until(sim, 18.0, look)
    assert len(aside) > 200 and 0.6 < np.median(aside) < 0.95 and np.median(along) < 0.8


def test_a_run_goes_on_to_the_bit_where_it_was_saved(tmp_path):
    families = [Population(name="families", groups=[1.0, 1.0], size=(1.0, 0.05))]
    sim, other = (hall(rows=8, population=families) for _ in range(2))
    until(sim, 13.3)
    save(sim, tmp_path / "state.npz")
    again = until(restore(tmp_path / "state.npz"), 30.0)
    until(other, 30.0)
    np.testing.assert_array_equal(again.com(), other.com())
    np.testing.assert_array_equal(again.distance, other.distance)
    assert counts(again) == counts(other) and (again.present() == other.present()).all()


def test_a_recording_tells_who_was_there(tmp_path):
    sim = hall(rows=5, population=[Population(name="p", size=(1.0, 0.06))])
    recorder = Recorder(sim)
    until(sim, 40.0, lambda sim: recorder.capture() if sim.ticks % 4 == 0 else None)
    recorder.save(tmp_path / "run.npz")
    run = load_recording(tmp_path / "run.npz")
    assert run.present.shape == run.arrays["com"].shape[:2] and not run.present.all() and run.present.any()
    stays = [stay for c in range(5) for stay in run.stays(c)]
    assert len(stays) == counts(sim)["came"] > 5
    report = measure(run)
    assert len(report["characters"]) >= counts(sim)["went"] and report["worst"]["skate"] < 0.01
    assert all(one["speed"] > 0.5 for one in report["characters"] if one["steps"] > 12)


def test_memory_is_flat():
    sim = until(hall(rows=6), 5.0)
    before = {name: getattr(sim.crowd, name) for name in sim.crowd._fields}
    until(sim, 40.0)
    assert all(getattr(sim.crowd, name) is array for name, array in before.items())
    assert sim.footprints._chunks is None and not sim.changes and len(sim.planner.gates.people) <= 1


@pytest.mark.parametrize(
    "tables,said",
    [
        ({"source": []}, "nobody comes in"),
        ({"exit": []}, "give an [[exit]]"),
        ({"source": [Source(area=ROOM, to=["eastt"])]}, "'eastt' is none of the [[exit]] tables; did you mean east?"),
        ({"exit": [EAST, EAST]}, "'east': is there twice"),
        ({"source": [Source(area=ROOM, population=["x"])]}, "none of the [[population]] tables"),
    ],
)
def test_what_tables_get_wrong_is_told(tables, said):
    with pytest.raises(InputError) as told:
        hall(**tables)
    assert said in str(told.value)


def test_saved_plans_of_other_tables_are_refused():
    sim = hall(rows=3)
    with pytest.raises(ValueError, match="other sources"):
        sim.planner.check_plans(sim.plans, 4)
    assert PLANNERS["Visiting"](**sim.planner.values()).values() == sim.planner.values()


def planted(sim, x, y, radius):
    """Whether a tree has been planted there: nobody stands, or is about to, where it is to be."""
    try:
        apply(sim, PlantTree(x, y, radius))
    except InputError as error:
        assert "too near to a" in str(error)
        return False
    return True


def test_a_tree_that_is_planted_is_walked_around():
    sim, nearest = until(hall(), 6.0), []

    def look(sim):
        place = sim.com()[sim.present(), :2]
        nearest.append(np.hypot(*(place - (11.0, 4.0)).T).min(initial=9.0))

    while not planted(sim, 11.0, 4.0, 0.6):
        sim.tick()
    there = counts(sim)["there"]
    until(sim, 30.0, look)
    assert counts(sim)["went"] > there and 0.75 < min(nearest) < 2.5


def test_a_source_without_room_is_told():
    walls = tuple(Wall(np.array([(1.0, y), (3.0, y)]), 0.3) for y in np.arange(1.0, 7.2, 0.4))
    tables = Traffic(source=[Source(area=ROOM, rate=1.0)], exit=[EAST])
    with pytest.raises(InputError, match="source.0.area: nobody of the human's size has room"):
        Simulation(World("full", (16.0, 8.0), walls=walls), [HUMAN] * 3, Visiting(tables))


def test_too_many_areas_for_a_world_are_told():
    exits = [Exit(name=str(k), area=[(1.0 + k, 1.0), (1.5 + k, 2.0)]) for k in range(60)]
    tables = Traffic(source=[Source(area=ROOM, rate=1.0)], exit=exits)
    with pytest.raises(InputError, match="60 areas in a world so large"):
        Simulation(World("plain", (1000.0, 1000.0)), [HUMAN], Visiting(tables))


def test_damaged_recordings_of_visits_are_refused():
    sim = hall(rows=3)
    recorder = Recorder(sim)
    until(sim, 4.0, lambda sim: recorder.capture() if sim.ticks % 12 == 0 else None)
    run = recorder.recording()
    check_run(run.arrays, RunMeta.model_validate(run.meta))
    for change in ({"visitors": [{"character": 7, "recasts": 0, "begin": 0.0, "kind": 0}]}, {"kinds": []}, {"visitors": None}):
        with pytest.raises(ValueError, match="visitors"):
            check_run(run.arrays, RunMeta.model_validate(run.meta | change))
    with pytest.raises(ValueError, match="present"):
        check_run(run.arrays | {"present": run.arrays["present"][:-1]}, RunMeta.model_validate(run.meta))
