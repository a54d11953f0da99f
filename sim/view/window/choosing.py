"""What a window can show: any level, walked as its command says, and any scene, by its own character or another one."""

from collections.abc import Callable
from pathlib import Path

from motion.characters.character import load_character
from planner.script.scene import load_scene, scene_names
from sim.stage.cast import Cast
from sim.stage.making import make_mixed, make_simulation, make_steered, make_visited
from sim.stage.scripted.performance import Performance
from worlds import reading
from worlds.level import level_names, load_level

USUAL = {"wander": "bird", "river": "bird", "steer": "human", "play": "bird"}
"""Who walks on a level where nobody was chosen."""
OF_SCENES = {"footprint", "path", "track"}
Make = Callable[..., Cast]


def places() -> list[str]:
    """All levels and scenes that ship, by their names."""
    return [*level_names(), *scene_names()]


def is_scene(name: str) -> bool:
    """Whether a name or file is a scene's."""
    return name in scene_names() or (Path(name).suffix == ".toml" and bool(OF_SCENES & reading.tables_of(name)))


def maker(command: str, characters: int, mixed: bool = False) -> Make:
    """Makes what is chosen: (level or scene, character or None, seed). It raises InputError, NoWay.

    On levels one goes as the command says: `steer` is driven, `wander` wanders, in a `crowd` people come and go, `river`
    crosses, and `play` crosses where there is a goal. mixed: wanderers are drawn from the level's populations.
    """

    def make(level: str, character: str | None, seed: int) -> Cast:
        if is_scene(level):
            return Performance(load_scene(level), load_character(character) if character else None)
        if command == "crowd":
            return make_visited(level, characters, seed)
        if mixed:
            return make_mixed(level, characters, seed)
        who = character or USUAL[command]
        if command == "steer":
            return make_steered(level, who, characters, seed)
        crosses = command == "river" or (command == "play" and load_level(level).goal is not None)
        return make_simulation(level, who, characters, seed, crosses)

    return make
