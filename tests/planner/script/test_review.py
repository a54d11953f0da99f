"""What of a scene cannot be walked is an error, what will be ugly a warning: by number, value and limit."""

import numpy as np
import pytest

from motion.characters.character import load_character
from planner.script.footprint import Footprint
from planner.script.review import review
from planner.script.scene import load_scene, scene_names
from sim.stage.scripted.performance import Performance
from worlds.errors import InputError
from worlds.world import River, World

HUMAN = load_character("human")
WORLD = World(
    "w", (20.0, 10.0), trees=np.array([[5.0, 5.0, 0.3]]), rivers=(River(np.array([[10.0, 0.0], [10.0, 10.0]]), 2.0),)
).arrays
STAIRS = World("s", (20.0, 10.0), "stairs", (5.0, 0.3, 0.6, 10)).arrays


def prints(*places, heading=0.0):
    """Left first, alternating."""
    return [Footprint(side=("left", "right")[k % 2], position=place, heading_deg=heading * max(k - 1, 0))
            for k, place in enumerate(places)]  # fmt: skip


STAND = ((2.0, 5.08), (2.0, 4.92))
WRONG = {
    "footprint.2 at .*in a tree": (prints(*STAND, (3.3, 5.08), (4.9, 4.92)), WORLD, 3),
    "footprint.2 at .*in water": (prints((8.0, 5.08), (8.0, 4.92), (9.5, 5.08)), WORLD, 2),
    "footprint.2 at .*outside the world": (prints((0.5, 5.08), (0.5, 4.92), (-0.5, 5.08)), WORLD, 2),
    "3.60 m from the one before; the human leaps 2.00 m": (prints(*STAND, (5.6, 4.92), (5.7, 4.0)), WORLD, 2),
    "on the other foot, 0.02 m": (prints(*STAND, (2.6, 5.08), (2.62, 5.08)), WORLD, 3),
    "a step up of 0.60 m; the human takes 0.45 m": (prints((4.5, 5.08), (4.5, 4.92), (5.9, 5.08)), STAIRS, 2),
}


@pytest.mark.parametrize("said", WRONG)
def test_what_cannot_be_walked_is_an_error(said):
    given, world, number = WRONG[said]
    with pytest.raises(InputError, match=said.replace("footprint.2", f"footprint.{number}")) as told:
        review(given, HUMAN, world, "scene")
    assert f"scene: footprint.{number} " in str(told.value)


UGLY = {
    "2.06 m from the one before": (prints(*STAND, (4.06, 4.92)), WORLD),
    "turns by 60 degrees": (prints(*STAND, (2.6, 5.08), heading=60.0), WORLD),
    "a step down of 0.60 m": (prints((7.0, 5.08), (7.0, 4.92), (5.9, 5.08)), STAIRS),
}


@pytest.mark.parametrize("said", UGLY)
def test_what_will_be_ugly_is_a_warning(said, caplog):
    given, world = UGLY[said]
    found = review(given, HUMAN, world, "scene")
    assert len(found) == 1 and said in found[0] and "footprint.2" in found[0]
    assert caplog.messages == [f"scene: warning: {found[0]}"]


def test_many_faults_are_told_in_short():
    given = prints(*STAND, *((2.0 + 3.0 * (k + 1), 5.0) for k in range(30)))
    with pytest.raises(InputError, match="and [0-9]+ more") as told:
        review(given, HUMAN, WORLD, "scene")
    assert len(str(told.value).splitlines()) == 9


@pytest.mark.parametrize("name", scene_names())
def test_scenes_that_ship_are_fine(name):
    scene = load_scene(name)
    who = load_character(scene.track.character)
    assert review(scene.footprints_of(who), who, scene.world.arrays, name) == []


def two_tracks(aside, later):
    """Two who walk the same way, the second `aside` [m] and `later` [s]."""
    head = 'format = 1\nname = "two"\ncharacter = "human"\n[world]\nsize = [20, 20]\nterrain = "flat"\n'
    path = "points = [[4, {0}], [12, {0}]]\nstep_length = 0.6\n"
    first, second = path.format(5), path.format(5 + aside)
    return f"{head}[path]\n{first}[[track]]\nstand_before = {1.0 + later}\n[[track.path]]\n{second}"


TREADS = [(0.0, 0.0, True), (0.2, 0.0, True), (0.6, 0.0, False), (0.1, 9.0, True)]


@pytest.mark.parametrize(("aside", "later", "treads"), TREADS)
def test_tracks_that_tread_on_each_other_are_told(aside, later, treads, tmp_path):
    path = tmp_path / "two.toml"
    path.write_text(two_tracks(aside, later))
    show = Performance(load_scene(path))
    said = [warning for warning in show.warnings if "treads on" in warning]
    soles = [one.motion.footprints for one in show.acts]
    assert len(said) == treads
    if treads:
        begin = float(said[0].rsplit(", ", 1)[1].split(" s")[0])
        firsts = [f.contact_time <= begin + 0.005 for f in soles]
        assert all(first.any() for first in firsts) and "footprint." in said[0] and "of track.0" in said[0]
