"""Nobody starts in another, whatever the planner; nobody becomes so large that it reaches into one beside it."""

import numpy as np
import pytest

from motion.characters.character import CHARACTERS, load_character
from planner.crowd.apart import overlap_of, what_overlaps
from planner.modes.custom import Custom
from planner.modes.external import External
from planner.modes.steer import Steered
from planner.modes.walk_to import WalkTo
from planner.round.round import standing
from sim.stage.commands import Recast, apply
from sim.stage.simulation import Simulation
from worlds.errors import InputError
from worlds.world import World

YARD = World("yard", (20.0, 20.0), start=(10.0, 10.0))


def stay(round, me):
    """Everyone stands."""
    return standing(me, 0.5)


IN_EACH_OTHER = {
    "the very same place": [(5.0, 5.0, 0.0), (5.0, 5.0, 0.0)],
    "turned a little": [(5.0, 5.0, 0.0), (5.2, 5.1, 1.0)],
}


@pytest.mark.parametrize("starts", IN_EACH_OTHER.values(), ids=IN_EACH_OTHER)
@pytest.mark.parametrize("planner", [WalkTo, External, Steered, Custom], ids=lambda kind: kind.name)
def test_nobody_starts_in_another(starts, planner):
    more = {WalkTo: ([[(9.0, 9.0)]] * 3,), Custom: (), External: (), Steered: ()}[planner]
    crowd, starts = [load_character("human")] * 3, [(15.0, 15.0, 0.0), *starts]
    made = Custom(stay, starts) if planner is Custom else planner(starts, *more)
    with pytest.raises(InputError, match=r"starts\.2 at \(5.*starts\.1 at \(5.*overlap"):
        Simulation(YARD, crowd, made)


def test_soles_that_reach_beyond_bodies_are_kept_apart(tmp_path):
    thin = tmp_path / "thin.toml"
    thin.write_text((CHARACTERS / "human.toml").read_text().replace("depth = 0.27", "depth = 0.1"))
    one, place = load_character(thin).biped, np.array([5.0, 5.0, 0.0])
    assert what_overlaps(one, place, one, place + (0.2, 0.0, 0.0)) == "soles"
    assert what_overlaps(one, place, one, place + (0.27, 0.0, 0.0)) is None
    assert what_overlaps(load_character("human").biped, place, one, place + (0.15, 0.0, 0.0)) == "bodies"


def test_a_thousand_who_stand_apart_are_told_from_one_in_another():
    """The grid finds the pair that a look at all pairs finds."""
    rng, human = np.random.default_rng(3), load_character("human").biped
    spots = 0.55 * np.stack(np.meshgrid(np.arange(32.0), np.arange(32.0)), axis=2).reshape(-1, 2) + 1
    places = np.column_stack([spots, np.zeros(len(spots))])
    crowd = [human] * len(places)
    assert overlap_of(crowd, places) is None
    for _ in range(20):
        c, other = np.sort(rng.choice(len(places), 2, False))[::-1]
        moved = places.copy()
        moved[c, :2] = moved[other, :2] + (0.05, 0.0)
        found = overlap_of(crowd, moved)
        pairs = [(a, z) for a in range(c, c + 1) for z in range(a) if what_overlaps(human, moved[a], human, moved[z])]
        assert found is not None and (found.one, found.other) in [*pairs, (int(c), int(other))]


def test_nobody_becomes_larger_than_there_is_room():
    bird, dinosaur = load_character("bird"), load_character("dinosaur")
    sim = Simulation(YARD, [bird] * 3, External([(5.0, 5.0, 0.0), (5.6, 5.0, 0.0), (15.0, 5.0, 0.0)]))
    apply(sim, Recast.to(2, dinosaur))
    with pytest.raises(InputError, match="character 0 stands, beside character 1"):
        apply(sim, Recast.to(0, dinosaur))
    assert [one.name for one in sim.characters] == ["bird", "bird", "dinosaur"]
