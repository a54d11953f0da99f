"""`crowd` and `wander --mixed`: people of a level's tables, and what is said where there are none."""

import json

import numpy as np
import pytest

import main
from sim.stage.making import make_mixed
from worlds.errors import InputError
from worlds.level import LEVELS, load_level, load_traffic, visited_names

LEVEL = (LEVELS / "concourse.toml").read_text("utf-8")


def test_the_level_that_ships_is_walked_through(tmp_path, capsys):
    state, arguments = str(tmp_path / "s.npz"), ["crowd", "--headless", "--json", "--characters", "60"]
    assert main.main([*arguments, "--seconds", "15", "--save", state]) == 0
    told = json.loads(capsys.readouterr().out)
    people = told["people"]
    assert people["came"] == people["went"] + people["there"] > 15 and set(people["exits"]) == {"street", "market", "platforms"}
    assert main.main(["crowd", "--headless", "--json", "--seconds", "20", "--restore", state]) == 0
    again = json.loads(capsys.readouterr().out)
    assert main.main([*arguments, "--seconds", "20"]) == 0
    assert json.loads(capsys.readouterr().out) == again
    assert main.main(["wander", "--headless", "--restore", state]) == 2
    assert "footfall crowd --restore" in capsys.readouterr().err


def test_levels_without_people_are_refused(capsys):
    assert visited_names() == ["concourse"]
    assert main.main(["crowd", "forest", "--headless"]) == 2 and "[[source]]" in capsys.readouterr().err
    assert main.main(["wander", "--mixed", "--character", "bird", "--headless"]) == 2
    assert "--mixed" in capsys.readouterr().err


def test_a_mix_is_drawn_from_the_level():
    sim = make_mixed("concourse", 40, 3)
    steps = np.array([float(one.biped.gait.preferred_step) for one in sim.characters])
    assert len(sim.characters) == 40 and steps.std() > 0.05
    assert load_traffic("forest").population == []


@pytest.mark.parametrize(
    "old, new, said",
    [
        (
            'to = ["platforms"]',
            'to = ["platform"]',
            "source.0.to: 'platform' is none of the [[exit]] tables",
        ),
        ("rate = 0.5", "rate = -1.0", "source.0.rate"),
        ("area = [[34.6, 7.2], [35.8, 14.8]]", "area = [[34.6, 7.2], [36.8, 14.8]]", "exit.2.area"),
        ("area = [[34.6, 7.2], [35.8, 14.8]]", "area = [[34.6, 7.2], [34.6, 14.8]]", "0.05 square metres"),
        ("speed = [1.45, 0.2]", "sped = [1.45, 0.2]", "population.0.sped: unknown key; did you mean speed?"),
        ("ages = [[65.0, 85.0, 1.0]]", "ages = [[85.0, 65.0, 1.0]]", "from the younger to the older"),
        ("seconds = [4.0, 15.0]", "seconds = [14.0, 5.0]", "the shorter time first"),
    ],
)
def test_what_a_level_gets_wrong_is_told(old, new, said, tmp_path):
    path = tmp_path / "level.toml"
    path.write_text(LEVEL.replace(old, new, 1))
    with pytest.raises(InputError) as told:
        load_level(path)
    assert said in str(told.value) and str(path) in str(told.value)
