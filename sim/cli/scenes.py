"""`play`, `sheets` and `check`: what files say, played, drawn and checked."""

import os
import sys
from pathlib import Path
from typing import Any

from motion.characters.character import Character, character_names, load_character
from planner.planner import fault_of_goal, fault_of_place
from planner.script.scene import load_scene, scene_names
from sim.cli import agreeing
from sim.cli.show import show
from sim.cli.status import BAD_INPUT, DONE
from sim.stage.cast import Cast
from sim.stage.scripted.performance import Performance
from sim.view.window.choosing import maker
from worlds import reading
from worlds.compiled.telling import tell
from worlds.errors import InputError
from worlds.level import load_level
from worlds.world import World


def play(options: Any) -> int:
    """A scripted scene: solved as a whole, then shown, recorded or drawn like any run."""
    if options.list:
        for name in scene_names():
            print(f"{name:24}{load_scene(name).about}")
        return DONE

    agreeing.scene(options)

    def check() -> None:
        load_scene(options.level)
        if options.character:
            load_character(options.character)

    chosen = maker("play", 1)

    def make(level: str = options.level, character: str | None = options.character, seed: int = 0) -> Cast:
        return chosen(level, character, seed)

    return show(options, make, scene_names(), check)


def sheets(options: Any) -> int:
    """A contact sheet of every scene, or of those named."""
    from sim.view.graphics.gl import HINT, NoGL
    from sim.view.pictures.sheet import write_index, write_sheets

    folder = Path(options.window or options.folder)
    names = options.scenes or scene_names()
    scenes = {Path(name).stem: load_scene(name) for name in names}
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"{folder}: cannot be made: {error.strerror}") from None
    if options.window:
        return _window(folder)
    try:
        paths = write_sheets({name: Performance(scene) for name, scene in scenes.items()}, folder)
    except NoGL as error:
        raise InputError(f"contact sheets: {HINT} ({error})") from None
    if not options.scenes:
        paths.append(write_index(folder))
    print(f"wrote {len(paths)} file{'s' if len(paths) > 1 else ''} to {folder.resolve()}")
    return DONE


def _window(folder: Path) -> int:
    """Pictures of the window itself."""
    os.environ["SDL_VIDEODRIVER"] = "offscreen"
    from sim.view.graphics.gl import HINT, NoGL, prefer_egl_without_display

    prefer_egl_without_display()  # before anything of the panel asks for OpenGL
    from sim.view.window.pictures import write_pictures

    try:
        print(f"wrote {len(write_pictures(folder))} files to {folder.resolve()}")
    except NoGL as error:
        raise InputError(f"pictures of the window: {HINT} ({error})") from None
    return DONE


def check(options: Any) -> int:
    """Names every fault of the files."""
    faults = 0
    for name in options.files:
        try:
            what, ugly = _checked(name)
            print(f"{name}: {f'can be walked, but look at {ugly} warning(s)' if ugly else 'fine'} ({what})")
        except InputError as error:
            print(error, file=sys.stderr)
            faults += 1
    return BAD_INPUT if faults else DONE


def _checked(name: str) -> tuple[str, int]:
    """What a level, scene or character file holds, by its tables, and how much of it will be ugly. Raises InputError."""
    tables = reading.tables_of(name)
    if {"biped", "leg"} & tables:
        return f"character {load_character(name).name}", 0
    if {"footprint", "path", "track"} & tables:
        show = Performance(load_scene(name))
        return f"scene {show.scene.name}: {show.footprints.steps} steps, {show.end:.1f} s", len(show.warnings)
    world = load_level(name)
    return f"{world.name}: {len(world.trees)} trees, {len(world.rocks)} rocks, {len(world.walls)} walls", len(
        _told(name, world)
    )


def fault_of_start(world: World, character: Character) -> str | None:
    """Why a character cannot begin at a level's start, or None."""
    return fault_of_place(world, character, (*world.start, world.start_heading))


def _told(name: str, world: World) -> list[str]:
    """For whom of those who ship there is no room at a level's start or goal, told as warnings; InputError: for nobody."""
    found, cast = [], [load_character(one) for one in character_names()]
    for place, fault_of in (("start", fault_of_start), ("goal", fault_of_goal)):
        faults = [fault for one in cast if (fault := fault_of(world, one))]
        if len(faults) == len(cast):
            raise InputError(f"{name}: {place}.position: no character that ships can stand there: {faults[0]}")
        found += [f"{place}.position: {fault}" for fault in faults]
    for said in found:
        tell(f"{name}: warning: {said}")
    return found
