"""Scene files: a character, a world, and a scripted track: footprints one by one, or paths to lay them along."""

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

from pydantic import Field, model_validator

from worlds import checks, ground, reading
from worlds.errors import InputError
from worlds.ground import Finite, Ground, Length, Part, Point
from worlds.world import World

SCENES = Path(__file__).parent / "scenes"

Seconds = Annotated[float, Field(gt=0, le=60, allow_inf_nan=False)]
Pause = Annotated[float, Field(ge=0, le=60, allow_inf_nan=False)]
Crouch = Annotated[float, Field(ge=0.5, le=1.05, allow_inf_nan=False)]


class Print(Part):
    """A footprint. What is not given is automatic."""

    side: Literal["left", "right"]
    position: Point
    heading_deg: Finite = 0.0
    step_time: Seconds | None = None  # until the next footfall
    stance_time: Seconds | None = None
    stand: Pause = 0.0  # both feet stay this long, once this one has landed
    crouch: Crouch = 1.0  # share of the nominal leg length
    facing_deg: Finite = 0.0  # the body turns away from the feet


class Stretch(Part):
    """A way along a Hermite curve through points, walked with feet to either side."""

    points: Annotated[list[Point], Field(min_length=2)]
    step_length: Length | Annotated[list[Length], Field(min_length=2)]  # a list changes evenly along the way
    step_width: Annotated[float, Field(ge=0, le=5)] | None = None  # the character's own
    first: Literal["left", "right"] = "left"
    feet_deg: Finite = 0.0  # the feet point this far to the left of the way: 180 backward
    facing_deg: Finite = 0.0
    crouch: Crouch = 1.0
    step_time: Seconds | None = None
    stance_time: Seconds | None = None
    stand: Pause = 0.0  # at its end


class _Scene(Ground):
    about: str = ""
    figure: str = ""
    character: str = "human"
    stand_before: Pause = 0.4
    stand_after: Pause = 0.6
    support: Literal["roll", "middle", "toe"] = "roll"  # where a standing foot presses: heel to toe, or the paper's either-or
    segments: Literal["phase", "step"] = "phase"  # of the com's curve: one per phase of support, or the paper's per step
    footprint: list[Print] = []
    path: Stretch | None = None

    @model_validator(mode="after")
    def _one_track(self):
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
    about: str
    figure: str
    character: str
    world: World
    stand_before: float
    stand_after: float
    footprints: tuple[Print, ...]
    path: Stretch | None
    support: str = "roll"
    segments: str = "phase"


_PLAIN = ("name", "about", "figure", "character", "stand_before", "stand_after", "support", "segments")


def scene_names() -> list[str]:
    """Names of the scenes that ship."""
    return reading.names_in(SCENES)


def load_scene(name_or_path: str | Path) -> Scene:
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
