"""`export`: a recording, a saved state or a scene for other programs."""

import os
from pathlib import Path
from typing import Any

from sim.export.clip.asked import Asked
from sim.export.clip.clip import Clip
from sim.export.clip.cutting import clip_of
from sim.export.formats import exporter_of, format_of
from sim.export.tables.contacts import export_array
from sim.files import outputs
from sim.files.recording import Recording
from sim.files.taking import opened, span_of, taken
from sim.stage.cast import Cast
from sim.stage.run import Bar
from worlds.errors import InputError


def export(options: Any) -> None:
    """Writes one file, or one per character where a format holds one only."""
    begin, end = options.between or (None, None)
    asked = Asked(
        options.character_index, begin, end, options.fps, options.array, options.scenery, options.size
    ).check()  # fmt: skip
    form = format_of(options.out)
    outputs.check({"export": options.out})
    write = exporter_of(options.out)
    source = opened(options.source)
    if asked.array is not None:
        _export_array(source, options, asked)
        return
    clip = clip_of(_recording(source, asked), asked)
    for part, path in _parts(clip, options.out) if form.apart else [(clip, options.out)]:
        write(part, path, asked)
        print(f"wrote {os.path.abspath(path)}")
    _say(clip)


def _recording(source: Recording | Cast, asked: Asked) -> Recording:
    """What is there, or is taken now. Raises InputError."""
    if isinstance(source, Recording):
        return source
    bar = Bar()
    found = taken(source, span_of(source, asked.begin, asked.end), asked.rate or source.tick_rate, bar.show)
    bar.end()
    return found


def _export_array(source: Recording | Cast, options: Any, asked: Asked) -> None:
    """Raises InputError where that is none of a recording as .csv."""
    if not isinstance(source, Recording) or not options.out.lower().endswith(".csv"):
        raise InputError(f"--array {asked.array}: arrays are those of a recording (RUN.npz), and become .csv")
    export_array(source, options.out, asked)
    print(f"wrote {os.path.abspath(options.out)}")


def _parts(clip: Clip, out: str) -> list[tuple[Clip, str]]:
    """A clip of each character, and its file: OUT itself where there is one only. Raises InputError for those not writable."""
    if len(clip.actors) == 1:
        return [(clip, out)]
    path = Path(out)
    names = [str(path.with_name(f"{path.stem}_{actor.index}{path.suffix}")) for actor in clip.actors]
    outputs.check({f"export {name}": name for name in names})
    each = [Clip(clip.name, clip.world, clip.time, clip.rate, (actor,)) for actor in clip.actors]
    return list(zip(each, names, strict=True))


def _say(clip: Clip) -> None:
    count = len(clip.actors)
    print(f"{clip.name}: {count} character{'s' if count > 1 else ''}, {clip.seconds:.2f} s at {clip.rate:g} per second")
