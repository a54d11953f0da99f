"""The report of `measure`: the quality of a recorded run, per character and the worst of all."""

from collections.abc import Callable, Iterable
from typing import NamedTuple

import numpy as np

from motion.measures import forces, gait, joints, quality
from motion.track.footprints import Footprints
from sim.files.recording import UNEVEN, Recording
from worlds import queries
from worlds.arrays import WorldArrays
from worlds.errors import InputError

_FRAMES = (
    "com", "com_acceleration", "body_rotation_wxyz", "hip", "knee", "hock", "ankle", "heel", "ball", "toe", "contact",
    "phase", "physics_cost", "comfort_cost", "point_of_support",
)  # fmt: skip
_PRINTS = ("side", "position", "heading", "normal", "contact_time", "stance_time", "rock")
"""Columns of footprints that are measured; others may be missing."""
_DIMENSIONS = (
    "nominal_length", "max_length", "metatarsus", "shank_radius", "hip_height", "foot_length", "ball_forward", "max_turn",
)  # fmt: skip
_LARGEST = (
    "stance_slide", "skate", "footprint_error", "contact_error", "penetration", "overreach", "flight_residual",
    "physics_cost_error", "force", "force_change", "friction",
)  # fmt: skip
_LEAST = ("swing_clearance", "clearance_share", "shank_gap", "tree_distance", "water_distance", "border_distance", "speed")


def measure(recording: Recording) -> dict:
    """{"level", "seconds", "characters": [...], "worst": {...}}; lengths in metres, costs in m/s^2, angles in radians.

    Angular velocities and accelerations are central differences at the recording's own rate, "rate" [1/s].
    """
    _check(recording)
    time = recording.arrays["time"]
    grounds, count = Grounds(recording), recording.arrays["com"].shape[1]
    characters = [_character(recording, part, grounds) for c in range(count) for part in _parts(recording, c)]
    if not characters:
        raise InputError("nobody is there at three frames or more: there is nothing to measure")
    seconds = float(time[-1] - time[0])
    return {
        "level": recording.meta["level"],
        "seconds": seconds,
        "rate": (len(time) - 1) / seconds if seconds > 0 else 0.0,
        "characters": characters,
        "worst": _worst(characters),
    }


class Part(NamedTuple):
    """A character for as long as it was the same one."""

    c: int
    recasts: int  # how often it had become another one before
    frames: np.ndarray  # (F,) bool
    dimensions: dict


def _parts(recording: Recording, c: int) -> list[Part]:
    """Character c in each of its casts; one that was too short to measure is left out."""
    parts = [Part(c, stay.recasts, frames, stay.dimensions) for stay, frames in recording.spans(c)]
    return [part for part in parts if part.frames.sum() > 2] or ([] if "present" in recording.arrays else parts[:1])


def _check(recording: Recording) -> None:
    needed = (*_FRAMES, *(f"footprint_{name}" for name in (*_PRINTS, "character")))
    lacks = [name for name in needed if name not in recording.arrays]
    for c, dimensions in enumerate(recording.meta.get("characters", [])):
        lacks += [f"meta.characters.{c}.{name}" for name in _DIMENSIONS if name not in dimensions]
    if lacks:
        raise InputError(f"the recording lacks {', '.join(lacks)}; record the run again with this version")
    if not len(recording.arrays["time"]):
        raise InputError("the recording has no frames: there is nothing to measure")
    spacing = np.diff(recording.arrays["time"])
    if len(spacing) and np.ptp(spacing) > UNEVEN:
        raise InputError(
            f"the recording's frames are {spacing.min():.6f} to {spacing.max():.6f} s apart; measuring needs even spacing"
        )


def frames_of(recording: Recording, c: int) -> dict[str, np.ndarray]:
    """The arrays over frames of character c, (F, ...)."""
    return {name: np.ascontiguousarray(recording.arrays[name][:, c]) for name in _FRAMES}


def _character(recording: Recording, part: Part, grounds: "Grounds") -> dict:
    c, recasts, inside, dimensions = part
    time, a = recording.arrays["time"][inside], {k: v[inside] for k, v in frames_of(recording, c).items()}
    footprints = recording.footprints(c, recasts)
    again = quality.physics_cost(a["com"], a["com_acceleration"], a["point_of_support"], a["contact"])
    return {
        "name": dimensions["name"],
        **_feet(a, footprints, time, dimensions, grounds),
        **_legs(a, time, dimensions),
        "physics_cost": quality.by_phase(a["physics_cost"], a["phase"]),
        "physics_cost_error": float(np.abs(again - a["physics_cost"]).max()),
        "comfort_cost": float(a["comfort_cost"].mean()),
        **forces.demands(a["com_acceleration"]),
        "flight_residual": quality.flight_residual(a["com_acceleration"], a["phase"]),
        "gait": gait.report(footprints, time, a["com"], a["phase"], dimensions["hip_height"]),
        **_places(footprints, grounds),
        **_going(footprints, a, time),
    }


class Grounds:
    """The ground of a run, as it was at each time: it may have been edited."""

    def __init__(self, recording: Recording) -> None:
        self.begins = np.array([begin for begin, _ in recording.worlds])
        self.worlds: list[WorldArrays] = [world.arrays for _, world in recording.worlds]

    def at(self, times: np.ndarray) -> list[tuple[np.ndarray, WorldArrays]]:
        """(indices of the times, world) of each world that holds at some of these times."""
        which = np.searchsorted(self.begins, times, side="left") - 1
        return [(np.flatnonzero(which == k), self.worlds[k]) for k in np.unique(which)]

    def heights(self, times: np.ndarray, points: np.ndarray) -> np.ndarray:
        """Height of the ground (F, ...) below points (F, ..., 3) at times (F,)."""
        out = np.empty(points.shape[:-1])
        for rows, world in self.at(times):
            part = np.ascontiguousarray(points[rows])
            out[rows] = queries.ground_heights(world, part.reshape(-1, 3)).reshape(part.shape[:-1])
        return out


def _feet(a: dict, footprints: Footprints, time: np.ndarray, dimensions: dict, grounds: Grounds) -> dict:
    """How exactly the feet stand, and what they clear."""
    sole = np.stack([a["heel"], a["ball"], a["toe"]], axis=2)
    ground = grounds.heights(time, sole)
    height = sole[..., 2] - ground
    stands = quality.footing(time, a["contact"], footprints)
    pivoting = quality.pivots(dimensions["max_turn"], footprints)
    down = quality.on_ground(sole, stands, footprints, pivoting)
    places = quality.marks(footprints, dimensions["foot_length"], dimensions["ball_forward"])
    horizontal, total = quality.skate(sole, down, stands)
    lowest = quality.swing_clearance(height.min(axis=2), a["contact"])
    return {
        "stance_slide": quality.stance_slide(sole, down),
        "skate_horizontal": horizontal,
        "skate": total,
        "footprint_error": quality.footprint_error(sole, down, stands, places),
        "contact_error": quality.contact_error(time, a["contact"], footprints),
        "penetration": quality.penetration(sole, ground),
        "swing_clearance": quality.swing_clearance(height[..., quality.TOE], a["contact"]),
        "clearance_share": None if lowest is None else lowest / dimensions["nominal_length"],
    }


def _legs(a: dict, time: np.ndarray, dimensions: dict) -> dict:
    angles = joints.angles(a, dimensions["metatarsus"] > 0)
    apart = float(joints.shank_distance(a["knee"], a["hock"], a["ankle"]).min())
    return {
        "overreach": quality.overreach(a["hip"], a["ankle"], dimensions["max_length"]),
        "joints": {name: joints.peaks(angle, time) for name, angle in angles.items()},
        "shank_distance": apart,
        "shank_gap": apart - 2 * dimensions["shank_radius"],
    }


def _places(footprints: Footprints, grounds: Grounds) -> dict:
    """Least distances of the footprints' middles; water counts only where no rock carries the foot."""
    trees, walls, waters, borders = [], [], [], []
    for rows, world in grounds.at(footprints.contact_time):
        for n in rows:
            x, y, _ = footprints.position[n]
            trees.append(queries.tree_clearance(world, x, y))
            walls.append(queries.wall_clearance(world, x, y))
            borders.append(queries.border_clearance(world, x, y))
            if footprints.rock[n] < 0:
                waters.append(queries.water_clearance(world, x, y))
    return {
        "tree_distance": min(trees),
        "wall_distance": min(walls),
        "water_distance": min(waters, default=queries.REACH),
        "border_distance": min(borders),
    }


def _going(footprints: Footprints, a: dict, time: np.ndarray) -> dict:
    way = float(np.linalg.norm(np.diff(a["com"][:, :2], axis=0), axis=1).sum())
    seconds = float(time[-1] - time[0])
    return {"steps": len(footprints.side) - 2, "distance": way, "speed": way / seconds if seconds > 0 else 0.0}


def _worst(characters: list[dict]) -> dict:
    """The worst of each figure over all characters; of the joints, the acceleration's peak over its percentile."""
    worst = {key: _most(max, (one[key] for one in characters)) for key in _LARGEST}
    worst |= {key: _most(min, (one[key] for one in characters)) for key in _LEAST}
    worst["mean_physics_cost"] = max(one["physics_cost"]["all"]["mean"] for one in characters)
    for name in ("hip", "knee", "hock", "ankle"):
        pops = [one["joints"][name]["acceleration_ratio"] for one in characters if name in one["joints"]]
        worst[f"{name}_acceleration_ratio"] = _most(max, pops)
    return worst


def _most(which: Callable, values: Iterable) -> float | None:
    return which((value for value in values if value is not None), default=None)
