"""Scene files: a character, a world, and a scripted track: footprints one by one, or a path to lay them along."""

from dataclasses import dataclass
from pathlib import Path as FilePath
from typing import Literal

from pydantic import model_validator

from motion.characters.character import Character, Scale
from planner.script.footprint import Footprint, Pause
from planner.script.path import Path, footprints_along
from worlds import ground, reading
from worlds.contents import checks
from worlds.errors import InputError
from worlds.ground import Ground
from worlds.world import World

SCENES = FilePath(__file__).parent / "scenes"


class _Scene(Ground):
    about: str = ""
    figure: str = ""
    character: str = "human"
    character_scale: Scale = 1.0  # how much larger it is than its file says
    stand_before: Pause = 0.4
    stand_after: Pause = 0.6
    support: Literal["roll", "middle", "toe"] = "roll"  # where a standing foot presses: heel to toe, or the paper's either-or
    segments: Literal["smooth", "phase", "step"] = "smooth"  # of the com's curve: with continuous forces, or one to each
    footprint: list[Footprint] = []
    path: Path | None = None

    @model_validator(mode="after")
    def _one_track(self) -> "_Scene":
        if bool(self.footprint) == bool(self.path):
            raise ValueError("give either [[footprint]] or [path]")
        if 0 < len(self.footprint) < 3:
            raise ValueError("footprint: at least three: two to stand on, and a step")
        if self.footprint and self.footprint[0].side == self.footprint[1].side:
            raise ValueError("footprint.1.side: the first two are stood on, one left and one right")
        return self


@dataclass(frozen=True)
class Scene:
    """A world and what is done in it. Times in seconds, angles in degrees as in the file."""

    name: str
    world: World
    footprints: tuple[Footprint, ...] = ()  # or a path
    path: Path | None = None
    character: str = "human"
    character_scale: float = 1.0
    stand_before: float = 0.4
    stand_after: float = 0.6
    support: str = "roll"
    segments: str = "smooth"
    about: str = ""
    figure: str = ""

    def footprints_of(self, character: Character) -> list[Footprint]:
        """Its footprints, those along a path laid out for a character; the first two are stood on."""
        return list(self.footprints) if self.path is None else footprints_along(self.path, character)


_PLAIN = ("name", "about", "figure", "character", "character_scale", "stand_before", "stand_after", "support", "segments")


def scene_names() -> list[str]:
    """Names of the scenes that ship."""
    return reading.names_in(SCENES)


def load_scene(name_or_path: str | FilePath) -> Scene:
    """A shipped scene by name, or any scene file by path. Raises InputError naming every fault."""
    path = reading.named_file(SCENES, name_or_path, "scene")
    file = reading.read_model(path, _Scene, "scene", "format, name, character, [world] and [[footprint]] or [path]")
    start = file.footprint[0].position if file.footprint else file.path.points[0]  # type: ignore[union-attr]
    world, faults = ground.build(path, file, start, 0.0)
    faults += checks.faults(world)
    if faults:
        raise InputError("\n".join(f"{path}: {fault}" for fault in faults))
    plain = {key: getattr(file, key) for key in _PLAIN}
    return Scene(world=world, footprints=tuple(file.footprint), path=file.path, **plain)
