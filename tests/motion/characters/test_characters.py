"""Character files: what ships loads, sizes scale by similarity, and every fault is told with its key."""

import re

import numpy as np
import pytest

from motion.characters.character import CHARACTERS, character_names, load_character
from motion.characters.dimensions import TABLES
from motion.characters.former import keys_now
from motion.characters.quantities import quantities_of
from planner.stepping.timing import step_timing
from worlds.errors import InputError

HUMAN = (CHARACTERS / "human.toml").read_text("utf-8")


def told(tmp_path, text):
    """What is said of a character file."""
    path = tmp_path / "x.toml"
    path.write_text(text)
    with pytest.raises(InputError) as refused:
        load_character(path)
    assert all(line.startswith(str(path)) for line in str(refused.value).splitlines())
    return str(refused.value)


def changed(key, value):
    """The human's file with another value of a key."""
    found = re.sub(rf"(?m)^{key} = [^#\n]*", f"{key} = {value} ", HUMAN, count=1)
    assert found != HUMAN
    return found


@pytest.mark.parametrize("name", character_names())
def test_what_ships_loads_and_returns_from_plain_numbers(name):
    character = load_character(name)
    again = type(character).from_dict(character.to_dict(), character.look.model_dump())
    assert again.biped.tobytes() == character.biped.tobytes() and again.look == character.look and again.name == name


def test_an_unknown_name_is_met_with_the_nearest():
    with pytest.raises(InputError, match="did you mean human") as refused:
        load_character("humann")
    assert "there are bird" in str(refused.value)


def test_every_line_of_the_tables_says_what_it_means():
    for table in TABLES.values():
        for name, quantity in quantities_of(table).items():
            assert quantity.meaning and quantity.low < quantity.high and quantity.unit in ("m", "rad", "", "1/s^2/m"), name


def test_faults_are_told_with_table_and_key(tmp_path):
    said = told(tmp_path, changed("thigh", -1.0).replace("[foot]", "[foot]\nfoo = 2"))
    assert "leg.thigh" in said and "foot.foo" in said
    assert "leg.shank" in told(tmp_path, re.sub(r"(?m)^shank = .*\n", "", HUMAN))
    assert "leg.thigh" in told(tmp_path, changed("thigh", '"0.45"'))


@pytest.mark.parametrize(
    ("key", "value", "said"),
    [
        ("thigh", 0.1, "links of the leg"),
        ("nominal_length", 0.99, "leg.nominal_length = 0.99 m must not be more than leg.max_length"),
        ("max_step", 9.0, "reach.max_leap"),
        ("ankle_forward", -0.9, "half of foot.length"),
    ],
)
def test_numbers_that_cannot_be_together_are_refused(tmp_path, key, value, said):
    assert said in told(tmp_path, changed(key, value))


def test_a_plan_is_one_of_those_there_are(tmp_path):
    said = told(tmp_path, changed("plan", '"humann"'))
    assert "look.plan" in said and "human" in said


def test_files_of_former_versions_are_told_what_each_key_is_now(tmp_path):
    said = told(tmp_path, 'format = 1\nname = "x"\n[biped]\nthigh = 0.45\nfoot_length = 0.26\n[body]\nplan = "human"\n')
    assert "biped.thigh: is now leg.thigh" in said and "biped.foot_length: is now foot.length" in said
    assert "format = 2" in said and "[look]" in said
    assert len(keys_now()) == sum(len(quantities_of(table)) for table in TABLES.values())


@pytest.mark.parametrize("scale", [0.55, 1.8])
def test_scale_makes_another_size_of_the_same_kind(tmp_path, scale):
    """Lengths grow with it, times with its root, and so a Froude number at the same relative step is the same."""
    path = tmp_path / "x.toml"
    path.write_text(HUMAN.replace('name = "human"', f'name = "human"\nscale = {scale}'))
    small, usual = load_character(path).biped, load_character("human").biped
    for table, kind in TABLES.items():
        for name, quantity in quantities_of(kind).items():
            growth = {"m": scale, "1/s^2/m": scale**-2}.get(quantity.unit, 1.0)
            assert small[table][name] == pytest.approx(growth * usual[table][name]), name
    for share in (0.3, 0.7, 1.04, 1.9):
        times = step_timing(small, share * scale, 0.0, 0.2, False), step_timing(usual, share, 0.0, 0.2, False)
        assert np.divide(*times) == pytest.approx(np.sqrt(scale), rel=0.02)


def test_two_of_one_name_do_not_share_a_body(tmp_path):
    from planner.modes.wander import Wander
    from sim.stage.simulation import Simulation
    from worlds.world import World

    path = tmp_path / "x.toml"
    path.write_text(HUMAN.replace('name = "human"', 'name = "human"\nscale = 0.5'))
    both = [load_character("human"), load_character(path)]
    sim = Simulation(World("yard", (20.0, 20.0), start=(10, 10)), both, Wander())
    assert sim.leg(1) == pytest.approx(0.5 * sim.leg(0)) and len(sim.kinds) == 2
