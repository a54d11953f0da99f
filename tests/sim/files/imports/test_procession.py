"""People on their ways: near them, in their time, on feet that stand."""

import numpy as np
import pytest

import main
from motion.characters.character import load_character
from sim.files.imports.trajectories.ways import Way
from sim.files.imports.walking.crowding import procession
from sim.files.recording import Recorder, load_recording
from sim.reports.measure import measure

HUMAN = load_character("human")


def way(name, time, x, y, landed=None):
    return Way(name, time, np.column_stack([x, y]), np.zeros(len(time), bool) if landed is None else landed)


def relaxed(time, begin, speed, tau=0.5):
    """How far one has gone who starts at `begin` as the social force model's people do."""
    since = np.maximum(time - begin, 0)
    return speed * (since - tau * (1 - np.exp(-since / tau)))


def ways():
    """Straight, bent, starting from standing, stopping and going on, creeping, coming late."""
    t = np.arange(0, 12, 0.1)
    zero = np.zeros(len(t))
    stops = relaxed(t, 0.5, 1.3) - relaxed(t, 4.0, 1.3) + relaxed(t, 8.0, 1.3)
    angle = 0.3 * t
    return [
        way("straight", t, 1.36 * t, zero),
        way("bent", t, 4 * np.sin(angle), 10 - 4 * np.cos(angle)),
        way("starts", t, relaxed(t, 2.0, 1.2), zero + 3),
        way("stops", t, stops, zero + 18),
        way("creeps", t, 0.15 * t, zero + 21),
        way("late", t[60:], 1.1 * (t[60:] - 6), zero[60:] + 24),
        way("runs", t, 3.0 * t, zero + 27),
        way("stands", t, zero, zero + 30),
    ]


@pytest.fixture(scope="module")
def crowd():
    return procession("ways", ways(), HUMAN)


def hips(fitted, times):
    return np.array([fitted.motion.pose(t).hip[0, :, :2].mean(axis=0) for t in times])


def test_hips_stay_on_their_way(crowd):
    """95 of 100 moments of all within 15 cm, of each, who may stop as no body can, within 17."""
    every = []
    for fitted in crowd.fitted:
        times = np.arange(fitted.since, fitted.until, 0.05)
        away = np.hypot(*(hips(fitted, times) - fitted.way.at(times)).T)
        assert np.quantile(away, 0.95) < 0.17, fitted.way.name
        every.append(away)
    assert np.quantile(np.concatenate(every), 0.95) < 0.12


def test_they_arrive_in_time(crowd):
    """Over the last metre of the way, and where it stops, nobody is early or late by .3 s."""
    for fitted in crowd.fitted:
        times = np.arange(fitted.since, fitted.until, 0.02)
        course, gone = fitted.way.at(times), hips(fitted, times)
        end = fitted.way.place[-1]
        for radius in (0.3, 0.6):
            near = [np.hypot(*(places - end).T) < radius for places in (course, gone)]
            if near[0].any() and not near[0][0]:
                assert abs(times[near[0].argmax()] - times[near[1].argmax()]) < 0.3, fitted.way.name


def test_feet_stand(crowd):
    recorder = Recorder(crowd)
    for time in np.arange(0, 12, 1 / 60):
        recorder.capture(time)
    worst = measure(recorder.recording())["worst"]
    assert worst["skate"] < 1e-3 and worst["footprint_error"] < 1e-3 and worst["penetration"] < 1e-3


def test_who_stands_takes_no_step_and_who_walks_does(crowd):
    steps = {fitted.way.name: int((~fitted.motion.footprints.stands).sum()) - 2 for fitted in crowd.fitted}
    assert steps["stands"] == 0 and 20 < steps["straight"] < 34 and steps["late"] < steps["straight"]


def test_people_are_there_while_the_file_knows_them(crowd):
    names = [fitted.way.name for fitted in crowd.fitted]
    assert crowd.present(0.0).tolist() == [name != "late" for name in names]
    assert crowd.present(7.0).all() and crowd.end == pytest.approx(11.9)


def test_prints_come_as_time_goes_on():
    crowd = procession("ways", ways()[:3], HUMAN)
    seen, found = crowd.steps_planned, len(crowd.walked().character)
    for _ in range(600):
        crowd.tick()
    new = crowd.placed_since(seen)
    assert len(new.character) > 20 and (new.footprints.contact_time <= crowd.time).all()
    assert len(crowd.walked().character) == found + len(new.character)
    crowd.ticks = 0
    assert crowd.placed_since(crowd.steps_planned + 1) is None


def test_footsteps_of_a_file_are_taken_as_they_are():
    """Of one who comes walking, waits for two seconds in the middle, and goes on walking."""
    time = np.concatenate([np.arange(0, 10.25, 0.5), 12 + np.arange(0, 10.25, 0.5)])
    x = 0.6 * np.concatenate([np.arange(21), 20 + np.arange(21)])
    landed = ~np.isin(np.arange(42), (0, 21))
    crowd = procession("steps", [way("1", time, x, 0.1 * np.sin(x), landed)], HUMAN)
    (fitted,) = crowd.fitted
    footprints = fitted.motion.footprints
    half = 0.5 * HUMAN.biped.gait.step_width * (1 - 2 * footprints.side)
    middle = footprints.position[:, :2] + half[:, None] * np.column_stack(
        [np.sin(footprints.heading), -np.cos(footprints.heading)]
    )
    for place in fitted.way.place[landed]:
        assert np.hypot(*(middle - place).T).min() < 0.01
    times = np.arange(0, 22, 0.05)
    away = np.hypot(*(hips(fitted, times) - fitted.way.at(times)).T)
    assert np.quantile(away, 0.95) < 0.15


def test_a_file_is_walked_and_recorded(tmp_path, capsys):
    path, run = tmp_path / "people.csv", str(tmp_path / "run.npz")
    path.write_text("id,t,x,y\n" + "".join(f"{c},{k / 10},{0.12 * k},{c}\n" for k in range(40) for c in range(3)), "utf-8")
    assert main.main(["import-trajectories", str(path), "--headless", "--record", run, "--json"]) == 0
    recording = load_recording(run)
    assert recording.arrays["com"].shape[1] == 3 and recording.arrays["time"][-1] == pytest.approx(3.9, abs=0.1)
    assert main.main(["import-trajectories", str(path), "--headless", "--character", "bird", "--seconds", "1", "--json"]) == 0


def test_who_is_too_fast_is_named(tmp_path, capsys):
    path = tmp_path / "people.csv"
    path.write_text("id,t,x,y\n" + "".join(f"{c},{k},{(1 + 30 * c) * k},{c}\n" for k in range(5) for c in range(2)), "utf-8")
    assert main.main(["import-trajectories", str(path), "--headless"]) == 2
    assert "id 1 goes at 31.0 m/s at 0.0 s; the human runs at" in capsys.readouterr().err
