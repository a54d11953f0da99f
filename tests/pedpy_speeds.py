"""PedPy's speeds of people, and of the same people walked: `python -m tests.pedpy_speeds [FILE]` (needs PedPy).

Without a file JuPedSim lets thirty people push through a door (needs jupedsim).
"""

import sys
import tempfile
from pathlib import Path

import numpy as np
import pedpy

from motion.characters.character import load_character
from sim.export.clip.asked import Asked
from sim.export.tables.trajectories import export_text
from sim.files.imports.trajectories.people import read_ways
from sim.files.imports.trajectories.ways import Way, between
from sim.files.imports.walking.crowding import procession, ticks_of
from sim.files.recording import Recorder
from tests.sim.export.readers import clip

RATE = 25
"""Moments per second at which both are compared."""


def pushing(path: Path) -> None:
    """Thirty people and a door 1.2 m wide."""
    import jupedsim
    import shapely

    room = [(0, 0), (12, 0), (12, 2.4), (13, 2.4), (13, 0), (22, 0), (22, 6), (13, 6), (13, 3.6), (12, 3.6), (12, 6), (0, 6)]
    writer = jupedsim.SqliteTrajectoryWriter(output_file=path, every_nth_frame=4)
    model = jupedsim.CollisionFreeSpeedModel()
    sim = jupedsim.Simulation(model=model, geometry=shapely.Polygon(room), trajectory_writer=writer)
    out = sim.add_exit_stage([(20, 0), (22, 0), (22, 6), (20, 6)])
    journey, chance = sim.add_journey(jupedsim.JourneyDescription([out])), np.random.default_rng(1)
    places = jupedsim.distribute_by_number(
        polygon=shapely.box(1, 0.5, 9, 5.5), number_of_agents=30, distance_to_agents=0.6, distance_to_polygon=0.3, seed=3
    )
    for place in places:
        speed = float(np.clip(chance.normal(1.3, 0.2), 0.8, 1.8))
        sim.add_agent(
            jupedsim.CollisionFreeSpeedModelAgentParameters(
                position=place, journey_id=journey, stage_id=out, desired_speed=speed, radius=0.2
            )
        )
    while sim.agent_count() > 0 and sim.elapsed_time() < 90:
        sim.iterate()


def speeds(path: Path) -> np.ndarray:
    """The mean of each person's speed [m/s], as PedPy finds it over half a second to either side."""
    data = pedpy.load_trajectory(trajectory_file=path)
    found = pedpy.compute_individual_speed(traj_data=data, frame_step=RATE // 2)
    return found.groupby("id").speed.mean().to_numpy()


def written(ways: list[Way], path: Path) -> None:
    """The ways at RATE, as PedPy reads them."""
    rows = []
    for k, way in enumerate(ways):
        frames = np.arange(np.ceil(way.begin * RATE - 1e-6), np.floor(way.end * RATE + 1e-6) + 1)
        rows += [(k, int(f), *xy) for f, xy in zip(frames, way.at(frames / RATE), strict=True)]
    text = "".join("{} {} {:.6f} {:.6f}\n".format(*row) for row in rows)
    path.write_text(f"# framerate: {RATE}\n# id frame x/m y/m\n{text}", "utf-8")


def main(source: Path, folder: Path) -> None:
    """Prints how the speeds differ."""
    ways = between(read_ways(source), None)
    written(ways, folder / "given.txt")
    crowd = procession(source.name, ways, load_character("human"))
    recorder = Recorder(crowd)
    for k in range(int(crowd.end * RATE) + 1):
        recorder.capture(k / RATE)
    export_text(clip(recorder.recording(), rate=float(RATE)), str(folder / "walked.txt"), Asked())
    given, walked = speeds(folder / "given.txt"), speeds(folder / "walked.txt")
    off = walked / given - 1
    print(
        f"{len(ways)} people, {ticks_of(ways)} ticks a second: mean speed {given.mean():.3f} m/s, {walked.mean():.3f} walked "
        f"({walked.mean() / given.mean() - 1:+.2%}); each within {np.abs(off).max():.2%}"
    )


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as made:
        file = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(made) / "door.sqlite"
        if len(sys.argv) < 2:
            pushing(file)
        main(file, Path(made))
