"""The human on the flat with automatic timing, beside what is known of people.

Ranges: speed, bob (vertical) and sway (lateral motion of the com, peak to peak), double support and flight of adults at these
steps; walking changes to running near Froude number 0.5 (Alexander); the com is highest at mid-stance in walking, an inverted
pendulum, and lowest in running, a spring (Cavagna).
"""

from functools import cache

from motion.characters.character import load_character
from motion.track.footprints import LEFT, RIGHT, SIDES
from planner.script.footprint import Footprint
from planner.script.scene import Scene, one_track
from planner.stepping import timing
from sim.files.recording import Recorder
from sim.reports.cycles import ANGLES, Cycle, at, compared, cycle
from sim.reports.measure import measure
from sim.reports.people import Row
from sim.reports.timings import run_from
from sim.stage.scripted.performance import Performance
from worlds.world import World

WALK, RUN = 0.7, 1.04
"""Steps [m] of the walk and of the run."""
STEADY, SETTLING = 24, 6
"""Steps of that length, and how many of them at either end are not looked at."""
RUNS = {0.93: 2.5, 1.23: 3.5, 1.48: 4.5}
"""Runners' steps [m] and speeds [m/s] (Fukuchi et al. 2017)."""
SPEED_UP = {WALK: (0.4, 0.6), RUN: (0.5, 0.8, 0.95), 0.93: (0.5, 0.8), 1.23: (0.5, 0.8, 1.0), 1.48: (0.5, 0.8, 1.0, 1.2)}


def straight(step: float, character: str = "human") -> Scene:
    """A character that walks straight on, from standing to steady steps of this length [m] and back to standing."""
    lengths = [*SPEED_UP[step], *[step] * STEADY, *SPEED_UP[step][::-1]]
    biped = load_character(character).biped
    width = float(biped.gait.step_width)
    x, footprints = 1.0, [_footprint(RIGHT, 1.0, width), _footprint(LEFT, 1.0, width)]
    for k, length in enumerate([*lengths, 0.0]):
        x += length
        footprints.append(_footprint((k + 1) % 2, x, timing.width_at(biped, timing.pace_of(biped, length))))
    world = World("flat", (x + 2, 4.0), start=(1.0, 2.0))
    return one_track(f"steps of {step} m", world, footprint=tuple(footprints), character=character)


def _footprint(side: int, x: float, width: float) -> Footprint:
    return Footprint(side=SIDES[side], position=(x, 2.0 + (0.5 - side) * width))  # type: ignore[arg-type]


def steady(step: float) -> dict:
    """The report of `measure` over the steady steps of that length alone."""
    show = Performance(straight(step))
    recorder = Recorder(show)
    begin, end = (show.walked().footprints.contact_time[k] for k in _looked_at(step))
    while show.time < end:
        show.tick()
        if show.time >= begin:
            recorder.capture()
    return measure(recorder.recording())["characters"][0]


def _looked_at(step: float) -> tuple[int, int]:
    first = 2 + len(SPEED_UP[step]) + SETTLING
    return first, first + STEADY - 2 * SETTLING


def compare() -> list[Row]:
    """Every figure with its range."""
    walk, run, change = steady(WALK)["gait"], steady(RUN)["gait"], run_from(load_character("human"))
    return [
        Row("walk, 0.7 m steps: speed", "m/s", walk["speed"], 1.33, 1.45),
        Row("walk: bob", "cm", 100 * walk["bob"], 2.5, 5.5),
        Row("walk: sway", "cm", 100 * walk["sway"], 3.0, 6.0),
        Row("walk: double support", "%", 100 * walk["double_support"], 20.0, 26.0),
        Row("walk: height at mid-stance, 1 highest", "", walk["height_at_midstance"], 0.8, 1.0),
        Row("run, 1.04 m steps: speed", "m/s", run["speed"], 2.5, 2.9),
        Row("run: flight", "%", 100 * run["flight"], 22.0, 32.0),
        Row("run: bob", "cm", 100 * run["bob"], 6.0, 11.0),
        Row("run: height at mid-stance, 0 lowest", "", run["height_at_midstance"], 0.0, 0.2),
        Row("Froude number where walking changes to running", "", change["froude"] if change else float("inf"), 0.4, 0.6),
        *curve_rows(),
    ]


def strides() -> dict[str, Cycle]:
    """A steady stride of the walk and of the run."""
    return {name: steady_stride(step) for name, step in (("walk", WALK), ("run", RUN))}


@cache
def steady_stride(step: float) -> Cycle:
    """A stride in the middle of steady steps of that length [m]."""
    show, (first, last) = Performance(straight(step)), _looked_at(step)
    n = (first + last) // 2
    return cycle(show, n + (show.motion.footprints.side[n] != LEFT))


def curve_rows() -> list[Row]:
    """Key figures of the strides, beside those of people (Fukuchi et al. 2018; Winter 1991; Nilsson and
    Thorstensson 1989; friction: Redfern et al. 2001)."""
    walk, run = strides().values()
    knee, ankle, percent = walk.angles["knee_flexion"], walk.angles["ankle_dorsiflexion"], walk.percent
    middle, leaving = (percent >= 20) & (percent <= 50), (percent >= 60) & (percent <= 66)
    peaks = [(f"run, {step} m steps: speed", steady_stride(step).speed, speed) for step, speed in RUNS.items()]
    return [
        Row("walk: knee, straightest in stance", "deg", float(knee[middle].min()), 0.0, 10.0),
        Row("walk: knee, peak in swing", "deg", float(knee.max()), 57.0, 68.0),
        Row("walk: when, of the stride", "%", float(percent[knee.argmax()]), 70.0, 75.0),
        Row("walk: ankle, push-off", "deg", float(ankle[leaving].min()), -30.0, -12.0),
        Row("walk: force at 14 % of the stride", "BW", at(walk, walk.force, 14), 1.0, 1.25),
        Row("walk: force at 29 %", "BW", at(walk, walk.force, 29), 0.65, 0.85),
        Row("walk: force at 47 %", "BW", at(walk, walk.force, 47), 1.0, 1.25),
        Row("walk: friction needed", "", float(walk.friction.max()), 0.15, 0.4),
        Row("run: peak force", "BW", float(run.force.max()), 2.0, 2.9),
        Row("run: friction needed", "", float(run.friction.max()), 0.15, 0.7),
        *(Row(what, "m/s", value, 0.9 * speed, 1.1 * speed) for what, value, speed in peaks),
    ]


def compare_with(people: dict) -> list[Row]:
    """Shapes of the strides' curves beside those of people (sim.reports.cycles.people_of)."""
    rows = []
    for gait, ours in strides().items():
        for quantity in ANGLES:
            if (gait, quantity) in people:
                apart, alike = compared(ours, quantity, people[gait, quantity])
                name = f"{gait}: {quantity.replace('_', ' ')}"
                rows.append(Row(f"{name}, rms difference", "deg", apart, 0.0, 6.0 if gait == "walk" else 8.0))
                rows.append(Row(f"{name}, correlation", "", alike, 0.9, 1.0))
    return rows


def as_dict(rows: list[Row]) -> dict:
    """The table for JSON."""
    return {"rows": [{**row._asdict(), "fits": row.fits} for row in rows], "fits": all(row.fits for row in rows)}


def in_words(rows: list[Row]) -> str:
    """The table for people, in Markdown."""
    lines = ["| human, automatic timing | here | people | |", "|---|---|---|---|"]
    for row in rows:
        lines.append(f"| {row.what} | {row.told} | {row.low:g} to {row.high:g} | {row.verdict} |")
    return "\n".join(lines)
