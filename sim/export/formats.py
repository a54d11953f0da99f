"""Which exporter writes a file, by the ending of its name."""

from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Protocol, cast

from sim.export.clip.asked import Asked
from sim.export.clip.clip import Clip
from sim.export.endings import FORMATS, Format
from worlds.errors import InputError
from worlds.errors.wording import nearest


class Exporter(Protocol):
    """Writes a clip to a file, whole or not at all. Raises InputError."""

    def __call__(self, clip: Clip, path: str, asked: Asked) -> None: ...


def exporter_of(path: str) -> Exporter:
    """What writes a file of this name; nothing else is loaded. Raises InputError where it is none, or a library is missing."""
    form = format_of(path)
    if form.needs and find_spec(form.needs[0]) is None:
        raise InputError(f"{path}: needs {form.needs[1]}: pip install {form.needs[1]}")
    module, _, name = form.where.rpartition(".")
    return cast(Exporter, getattr(import_module(f"sim.export.{module}"), name))


def format_of(path: str) -> Format:
    """The format that a name asks for. Raises InputError, with all that there are and the nearest."""
    ending = Path(path).suffix.lower()
    if ending in FORMATS:
        return FORMATS[ending]
    hint = "; Blender makes an .fbx of a .glb (File, Export)" if ending == ".fbx" else nearest(ending, FORMATS)
    raise InputError(f"{path}: its name must end in {', '.join(FORMATS)}{hint}")
