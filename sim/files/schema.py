"""What a state or a recording must be like before anything reads it: types, shapes, ranges. Kernels index memory by it.

Faults are ValueErrors; whoever reads a file names it.
"""

from typing import Annotated, Any

import numpy as np
from pydantic import AfterValidator, BaseModel, ConfigDict, Field

from motion.pose.pose import Pose
from motion.track.footprints import Footprints
from planner.round.refusals import LONGEST, TURNED
from planner.round.weights import NUMBERS, Weights
from planner.script.shaping import Style
from planner.script.track import Track
from sim.files.archive import Arrays
from sim.rows.crowd import REAL, Crowd
from sim.stage.asked import MOST_CHARACTERS, MOST_SEED, RATES
from sim.stage.commands import from_plain
from worlds.compiled.tables import Column, columns_of
from worlds.limits import FAR

Count = Annotated[int, Field(ge=0, le=2**53)]
Plain = dict[str, Any]
SWINGING = ("point_of_support",)
"""Columns that may hold NaN."""
RUN_FROM = 1e9
"""No time of a run lies so far out [s]."""


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)


class _Change(_Strict):
    tick: Count
    command: Plain


class _Named(_Strict):
    name: str
    values: Plain


class _Kind(_Strict):
    dimensions: Plain
    look: Plain


def _all_weights(weights: dict[str, float | str]) -> dict[str, float | str]:
    """The weights of walking among others, none missing: it would be the usual one for all who go on."""
    missing = [name for name in Weights._fields if name not in weights]
    if missing:
        raise ValueError(f"lacks {', '.join(missing)}")
    words = [name for name in NUMBERS if isinstance(weights[name], str)]
    if words:
        raise ValueError(f"{', '.join(words)}: numbers are needed")
    return weights


class StateMeta(_Strict):
    """The meta of a saved state."""

    format: int
    program: str
    version: str
    digest: str
    ticks: Count
    tick_rate: Annotated[int, Field(ge=RATES[0], le=RATES[1])]
    seed: Annotated[int, Field(ge=0, le=MOST_SEED)]
    steps: Count
    recasts: list[Annotated[int, Field(ge=-1, le=2**53)]]
    distance: list[Annotated[float, Field(ge=0, allow_inf_nan=False)]]
    world: Plain
    first_world: Plain | None
    kinds: Annotated[list[_Kind], Field(min_length=1)]
    kind: Annotated[list[Annotated[int, Field(ge=0)]], Field(min_length=1, max_length=MOST_CHARACTERS)]
    weights: Annotated[dict[str, float | str], AfterValidator(_all_weights)]
    planner: _Named
    changes: list[_Change]


class _Key(_Strict):
    bone: str
    time: Annotated[float, Field(allow_inf_nan=False)]
    rotation: Annotated[list[Annotated[float, Field(allow_inf_nan=False)]], Field(min_length=3, max_length=3)]
    blend: Annotated[float, Field(gt=0, allow_inf_nan=False)]


class Visitor(_Strict):
    """One who came into a row of a run that people come into and go out of."""

    character: Count  # the row
    recasts: Count  # how many had been in it before
    begin: Annotated[float, Field(allow_inf_nan=False)]  # [s]
    kind: Count  # of the meta's kinds


class RunMeta(BaseModel):
    """The meta of a recording; what later versions add is theirs."""

    model_config = ConfigDict(strict=True)
    format: int
    level: str
    rate: Annotated[float, Field(ge=1, le=RATES[1], allow_inf_nan=False)]
    characters: Annotated[list[Plain], Field(min_length=1, max_length=MOST_CHARACTERS)]
    looks: list[Plain] | None = None
    hand_keys: list[list[_Key]] | None = None
    styles: list[Style] | None = None
    shapes: list[Track] | None = None
    world: Plain
    first_world: Plain | None = None
    changes: list[_Change] = []
    visitors: list[Visitor] | None = None
    kinds: list[_Kind] = []


def check_columns(kind: type, arrays: Arrays, prefix: str, shape: tuple[int, ...]) -> None:
    """The columns of a table that are there, of `shape` rows; a column may hold whole numbers for others."""
    for name, column in columns_of(kind).items():
        array = arrays.get(prefix + name)
        if array is not None:
            _check_column(prefix + name, array, column, shape, name in SWINGING)


def _check_column(said: str, array: np.ndarray, column: Column, shape: tuple[int, ...], gaps: bool) -> None:
    if array.shape != shape + column.shape:
        raise ValueError(f"{said} of shape {array.shape}: {shape + column.shape} is needed")
    if array.dtype.kind != np.dtype(column.dtype).kind:
        raise ValueError(f"{said} of {array.dtype}: {np.dtype(column.dtype)} is needed")
    if array.dtype.kind == "f" and not (np.isfinite(array) | (np.isnan(array) if gaps else False)).all():
        raise ValueError(f"{said}: finite numbers are needed")


def within(said: str, array: np.ndarray, low: float, high: float) -> None:
    """All of an array lies in a range."""
    if array.size and not (low <= array.min() and array.max() <= high):
        raise ValueError(f"{said}: from {array.min()} to {array.max()}; {low:g} to {high:g} is allowed")


def check_prints(footprints: Footprints, said: str) -> None:
    """Footprints that can be walked: sides, places, times that pass."""
    limits = {
        "side": (0, 1), "rock": (-1, 1e9), "position": (-FAR, FAR), "heading": (-TURNED, TURNED), "normal": (-1.001, 1.001),
        "contact_time": (-RUN_FROM, RUN_FROM), "stance_time": (0, 2 * LONGEST), "step_time": (0, LONGEST), "roll": (0, 1),
        "nominal_length": (1e-6, 1e4), "facing": (-TURNED, TURNED), "lift": (0, 1e4), "hold": (0, 0.49),
    }  # fmt: skip
    for name, (low, high) in limits.items():
        within(f"{said}{name}", getattr(footprints, name), low, high)
    if footprints.normal.size and np.abs(np.linalg.norm(footprints.normal, axis=-1) - 1).max() > 1e-6:
        raise ValueError(f"{said}normal: of length 1")


def check_crowd(crowd: Crowd, kind: np.ndarray, horizon: float, there: np.ndarray) -> None:
    """Rows that kernels can go on from; kind (C,): whom they are of; horizon [s]: all who are `there` (C,) are committed up to
    that."""
    if not np.array_equal(crowd.kind, kind):
        raise ValueError("crowd.kind: others than meta tells")
    rows, curve, window = crowd.footprints.side.shape[1], crowd.committed, crowd.window
    within("crowd.real", crowd.real, 2, REAL)
    within("crowd.number", crowd.number, 1, 2**53)
    within("crowd.segments", crowd.segments, 1, curve.time.shape[1] - 1)
    within("crowd.points", crowd.points, 0, window.time.shape[1])
    limits = {"hindered": (0, 2**53), "rank": (0, 2**53), "claim": (-2 * FAR, 2 * FAR), "aim": (-1.001, 1.001)}
    for name, (low, high) in (limits | {"ahead": limits["aim"], "stood": limits["hindered"], "about": limits["claim"]}).items():
        within(f"crowd.intents.{name}", getattr(crowd.intents, name), low, high)
    within("crowd.intents.since", crowd.intents.since, -RUN_FROM, RUN_FROM)
    for name, table in (("committed", curve), ("window", window)):
        within(f"crowd.{name}.support", table.support, -1, rows - 1)
        within(f"crowd.{name}.control", table.control, -FAR, FAR)
        within(f"crowd.{name}.time", table.time, -RUN_FROM, RUN_FROM)
    for c in range(len(kind)):
        _check_row(crowd, c, horizon if there[c] else None)


def _check_row(crowd: Crowd, c: int, horizon: float | None) -> None:
    real, m = int(crowd.real[c]), int(crowd.segments[c])
    prints = Footprints(*(column[c, :real] for column in crowd.footprints))
    check_prints(prints, f"crowd.footprints.{c}: ")
    time, points = crowd.committed.time[c, : m + 1], crowd.window.time[c, : int(crowd.points[c])]
    if (np.diff(prints.contact_time) < 0).any() or (np.diff(time) <= 0).any() or (np.diff(points) <= 0).any():
        raise ValueError(f"crowd: times of character {c} must ascend")
    in_time = horizon is None or horizon <= time[-1] <= horizon + LONGEST
    if not in_time or crowd.committed.support[c, :m].max(initial=-1) >= real:
        raise ValueError(f"crowd: character {c} is committed up to {time[-1]} s, on footprints that it has; it is {horizon} s")


def check_log(arrays: Arrays, recasts: list[int]) -> None:
    """The footprint_* arrays of a state or a recording, where there are any."""
    character = arrays.get("footprint_character")
    if character is None:
        return
    if character.ndim != 1 or character.dtype.kind != "i":
        raise ValueError("footprint_character: a row of whole numbers is needed")
    within("footprint_character", character, 0, len(recasts) - 1)
    check_columns(Footprints, arrays, "footprint_", character.shape)
    cast = arrays.get("footprint_recasts", np.zeros_like(character))
    if cast.shape != character.shape or cast.dtype.kind != "i" or (cast < 0).any():
        raise ValueError("footprint_recasts: a whole number for each footprint is needed")
    if (cast > np.array(recasts)[character]).any():
        raise ValueError("footprint_recasts: more than characters became others")
    within("footprint_side", arrays.get("footprint_side", np.zeros(0)), 0, 1)


def check_run(arrays: Arrays, meta: RunMeta) -> None:
    """The arrays of a recording."""
    count = len(meta.characters)
    if arrays["time"].ndim != 1 or arrays["time"].dtype.kind != "f" or not np.isfinite(arrays["time"]).all():
        raise ValueError("time: a row of finite times is needed")
    if (np.diff(arrays["time"]) < 0).any():
        raise ValueError("time: must ascend")
    if meta.looks is not None and len(meta.looks) != count:
        raise ValueError(f"meta.looks: {len(meta.looks)} for {count} characters")
    for name in ("styles", "shapes", "hand_keys"):
        each = getattr(meta, name)
        if each and len(each) != count:
            raise ValueError(f"meta.{name}: {len(each)} for {count} characters")
    for c, dimensions in enumerate(meta.characters):
        numbers = [value for name, value in dimensions.items() if name != "name"]
        if not isinstance(dimensions.get("name"), str) or not all(type(v) in (int, float) and np.isfinite(v) for v in numbers):
            raise ValueError(f"meta.characters.{c}: a name and finite numbers are needed")
    if len(arrays["time"]):
        check_columns(Pose, arrays, "", (len(arrays["time"]), count))
    within("phase", arrays.get("phase", np.zeros(0)), 0, 3)
    _check_visitors(arrays, meta)
    check_log(arrays, [sum(_recasts(change, c) for change in meta.changes) + _visits(meta, c) for c in range(count)])


def _check_visitors(arrays: Arrays, meta: RunMeta) -> None:
    """Who is there in which frames, and who that is."""
    present, count = arrays.get("present"), len(meta.characters)
    if (present is None) != (meta.visitors is None):
        raise ValueError("present and meta.visitors: both are needed, or none")
    if present is None or meta.visitors is None:
        return
    if present.shape != (len(arrays["time"]), count) or present.dtype != np.bool_:
        raise ValueError(f"present: truth of shape {(len(arrays['time']), count)} is needed")
    if any(one.character >= count or one.kind >= len(meta.kinds) for one in meta.visitors):
        raise ValueError("meta.visitors: a character or a kind that there is not")


def _visits(meta: RunMeta, c: int) -> int:
    return max((one.recasts for one in meta.visitors or () if one.character == c), default=0)


def _recasts(change: _Change, c: int) -> bool:
    return from_plain(change.command).name == "recast" and change.command["character"] == c
