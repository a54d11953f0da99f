"""`import-trackway`: prints in, a scene out; `import-trajectories`: ways in, a crowd that walks them."""

import json
from pathlib import Path
from typing import Any

from motion.characters.character import load_character
from planner.script.review import review
from planner.script.scene import Scene
from sim.cli.show import show
from sim.cli.status import DONE
from sim.files import outputs
from sim.files.imports.trackways.prints import Prints, read_prints
from sim.files.imports.trackways.scenes import scene_of, site, text_of, walker
from sim.files.imports.trackways.trackway import completed, in_words, report
from sim.files.imports.trajectories.database import geometry_of
from sim.files.imports.trajectories.people import read_ways
from sim.files.imports.trajectories.ways import between
from sim.files.imports.walking.crowding import procession
from sim.files.imports.walking.procession import Procession
from worlds.compiled.telling import tell
from worlds.errors import InputError


def trackway(options: Any) -> int:
    """A scene of a trackway, or of each in the file and of all together, in one world; the report says what they tell."""
    found, load = read_prints(options.file), load_character(options.character)
    chosen = _chosen(found, options.trackway)
    heights = _each(options.hip_height, len(chosen), "--hip-height")
    sides = _each(options.first_side, len(chosen), "--first-side")
    ways = [
        completed(found[k], _scale(options, found[k]), height, side)
        for k, height, side in zip(chosen, heights, sides, strict=True)
    ]
    outs = _outs(options.out, len(chosen))
    every = [*outs, options.out] if len(outs) > 1 else outs
    outputs.check({f"--out {path}" if len(outs) > 1 else "--out": path for path in every})
    origin, size = site(ways)
    scenes = [scene_of(way, origin, size, options.character, options.speed) for way in ways]
    for scene, path in zip(scenes, outs, strict=True):
        _review(scene, path)
    for some, path in zip([*([scene] for scene in scenes), scenes], every, strict=False):
        with outputs.whole(path) as part:
            part.write_text(text_of(some, origin, options.speed), "utf-8")
    figures = [{**report(way, options.speed), "scene": path} for way, path in zip(ways, outs, strict=True)]
    print(json.dumps(figures) if options.json else "\n".join(in_words(one) for one in figures))
    for path in every:
        tell(f"wrote {Path(path).resolve()}, for the {load.name}: footfall play {path}")
    return DONE


def _review(scene: Scene, path: str) -> None:
    """Says what will be ugly. Raises InputError for what cannot be walked."""
    review(list(scene.track.footprint), walker(scene), scene.world.arrays, path)


def _chosen(found: list[Prints], trackway: int | None) -> list[int]:
    if trackway is None:
        return list(range(len(found)))
    if not 1 <= trackway <= len(found):
        raise InputError(f"--trackway {trackway}: there are {len(found)} in the file, counted from 1")
    return [trackway - 1]


def _each(values: list, count: int, option: str) -> list:
    """A value for each trackway: one for all of them, or one each."""
    if len(values) not in (1, count):
        raise InputError(f"{option} {' '.join(map(str, values))}: one, or one for each of the {count} trackways, is needed")
    return values * count if len(values) == 1 else values


def _scale(options: Any, prints: Prints) -> float:
    """Metres in a unit of the file: a table's are metres, where nothing else is said."""
    if options.scale is not None:
        return options.scale
    if prints.scale is not None:
        return prints.scale
    if Path(options.file).suffix.lower() == ".csv":
        return 1.0
    raise InputError(f"{options.file}: says no SCALE=; give --scale, the metres in a pixel")


def _outs(out: str, count: int) -> list[str]:
    """Where each scene goes: OUT.toml, or OUT.1.toml, OUT.2.toml ... where there are several; OUT.toml then has all of them."""
    path = Path(out)
    if path.suffix != ".toml":
        raise InputError(f"--out {out}: scenes are .toml files")
    return [out] if count == 1 else [str(path.with_name(f"{path.stem}.{k}.toml")) for k in range(1, count + 1)]


def trajectories(options: Any) -> int:
    """People's ways, walked: in a window, or headless, leaving what was asked for."""
    character = options.character
    load_character(character)
    ways = between(read_ways(options.file, options.format, options.fps, options.homography), options.between)
    borders = geometry_of(options.file)
    options.level, options.given = Path(options.file).name, set()

    def make(level: str = options.level, character: str = character, seed: int = 0) -> Procession:
        return procession(options.level, ways, load_character(character), borders)

    return show(options, make, [options.level], lambda: None)
