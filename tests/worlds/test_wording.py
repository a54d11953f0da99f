"""What is wrong with a file is told in words of ours, with the key, the value, what is needed and the nearest name."""

import random

import pytest

from motion.characters.character import CHARACTERS, load_character
from planner.script.scene import SCENES, load_scene
from tests.fuzz import changed_text
from worlds.errors import InputError
from worlds.level import LEVELS, load_level

LEVEL = """format = 1
name = "a level"
[world]
size = [20, 20]
terrain = "flat"
[start]
position = [5, 5]
"""
SCENE = """format = 1
name = "a scene"
character = "human"
[world]
size = [20, 20]
terrain = "flat"
[path]
points = [[2, 2], [10, 2]]
step_length = 0.7
"""
LEVELS_SAY = {
    ("size = [20, 20]", "size = [20]"): "world.size = [20]: 2 or more values are needed, not 1",
    ("size = [20, 20]", "size = [20, 20, 3]"): "world.size = [20, 20, 3]: 2 are allowed at most, not 3",
    ("size = [20, 20]", "size = 3"): "world.size = 3: a list in [...] is needed",
    ('"flat"', '"flatt"'): "world.terrain = 'flatt': 'flat', 'hills', 'stairs', 'spiral_stairs' or 'heightmap' is allowed; "
    "did you mean flat?",
    ("format = 1", "format = true"): "format = true: a whole number is needed",
    ('"a level"', "3"): 'name = 3: text in "..." is needed',
    ("[5, 5]", "[5, nan]"): "start.position.1 = nan: a finite number is needed",
    ("[start]", "[[tree]]\nposition = [2, 2]\nradius = -1\n[start]"): "tree.0.radius = -1: 0.0001 or more is needed",
    ("[start]", "[tree]\nposition = [2, 2]\n[start]"): "tree: there may be several: write [[tree]], not [tree]",
    ("[start]", "[strat]"): "start: is missing|strat: unknown key; did you mean start?",
}
SCENES_SAY = {
    ("0.7", '"a"'): "path.step_length = 'a': a number or a list in [...] is needed",
    ("0.7", '[0.5, "a"]'): "path.step_length.1 = 'a': a number is needed",
    ("0.7", "-1"): "path.step_length = -1: 0.01 or more is needed",
    ("0.7", "0.7\ntangents = [[1, 2]]"): "path.0: 1 tangents for 2 points; give one to each, or none",
    ("points", "pionts"): "path.points: is missing|path.pionts: unknown key; did you mean points?",
    ("[world]", 'support = "tow"\n[world]'): "support = 'tow': 'roll', 'middle' or 'toe' is allowed; did you mean toe?",
}
CASES = [(load_level, LEVEL, change, said) for change, said in LEVELS_SAY.items()]
CASES += [(load_scene, SCENE, change, said) for change, said in SCENES_SAY.items()]


@pytest.mark.parametrize(("load", "text", "change", "said"), CASES, ids=[case[2][1] for case in CASES])
def test_a_fault_is_told_in_our_words(load, text, change, said, tmp_path):
    path = tmp_path / "it.toml"
    path.write_text(text.replace(*change, 1))
    with pytest.raises(InputError) as told:
        load(path)
    assert str(told.value).splitlines() == [f"{path}: {line}" for line in said.split("|")]


@pytest.mark.parametrize(("load", "folder"), [(load_level, LEVELS), (load_scene, SCENES), (load_character, CHARACTERS)])
def test_no_word_of_the_checker_reaches_anyone(load, folder, tmp_path):
    """Files changed by chance: whatever is wrong with them is not told as pydantic tells it."""
    texts, told = [path.read_text() for path in sorted(folder.glob("*.toml"))], 0
    for k in range(300):
        chance = random.Random(k)
        path = tmp_path / "changed.toml"
        path.write_text(changed_text(chance.choice(texts), chance), encoding="utf-8")
        try:
            load(path)
        except InputError as error:
            told += 1
            for word in ("Input should", "Value error", "should have", "after validation", "a valid", "constrained", "Field "):
                assert word not in str(error)
    assert told > 50
