"""`import-plan`: a floor plan in, a level with its walls out."""

from pathlib import Path
from typing import Any

from sim.files import outputs
from sim.files.imports.plans.dxf import read_dxf
from sim.files.imports.plans.level import moved_by, text_of, world_of
from sim.files.imports.plans.lines import Plan
from sim.files.imports.plans.wkt import read_wkt
from worlds.compiled.telling import tell
from worlds.errors import InputError


def plan(options: Any) -> None:
    """A level of a plan: well-known text, or a drawing."""
    if Path(options.out).suffix != ".toml":
        raise InputError(f"--out {options.out}: levels are .toml files")
    outputs.check({"--out": options.out})
    found = _read(options)
    try:
        world = world_of(found, Path(options.file).stem, options.thickness)
    except InputError as error:
        raise InputError(f"{options.file}: {error}; is --scale right?") from None
    with outputs.whole(options.out) as part:
        part.write_text(text_of(world, Path(options.file).name, moved_by(found)), "utf-8")
    pieces = sum(len(wall.points) - 1 for wall in world.walls)
    print(f"{world.name}: {world.size[0]:.1f} by {world.size[1]:.1f} m, {len(world.walls)} walls of {pieces} pieces")
    tell(f"wrote {Path(options.out).resolve()}: footfall wander {options.out}")


def _read(options: Any) -> Plan:
    if Path(options.file).suffix.lower() == ".dxf":
        return read_dxf(options.file, options.scale, options.layers)
    if options.layers:
        raise InputError("--layers: only drawings (.dxf) have them")
    return read_wkt(options.file).scaled(options.scale or 1.0)
