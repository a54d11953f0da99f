"""The report of `measure`: the quality of a recorded run, per character and the worst of all."""

from collections.abc import Callable, Iterable

import numpy as np

from motion.measures import gait, joints, quality
from sim.files.recording import Recording
from worlds import queries
from worlds.errors import InputError

_FRAMES = (
    "com", "com_acceleration", "body_rotation_wxyz", "hip", "knee", "hock", "ankle", "heel", "ball", "toe", "contact",
    "phase", "physics_cost", "comfort_cost", "point_of_support",
)  # fmt: skip
_PRINTS = ("side", "position", "heading", "normal", "contact_time", "stance_time", "rock")
_DIMENSIONS = ("nominal_length", "max_length", "metatarsus", "shank_radius", "hip_height", "foot_length", "ball_forward")
_LARGEST = (
    "stance_slide", "skate", "footprint_error", "contact_error", "penetration", "overreach", "flight_residual",
    "physics_cost_error",
)  # fmt: skip
_LEAST = ("swing_clearance", "clearance_share", "shank_gap", "tree_distance", "water_distance", "border_distance", "speed")
UNEVEN = 1e-6
"""Frames further than this [s] from even spacing have no central differences."""


def measure(recording: Recording) -> dict:
    """{"level", "seconds", "characters": [...], "worst": {...}}; lengths in metres, costs in m/s^2, angles in radians.

    Angular velocities and accelerations are central differences at the recording's own rate, "rate" [1/s].
    """
    _check(recording)
    world, time = recording.world.arrays, recording.arrays["time"]
    characters = [_character(recording, world, c) for c in range(recording.arrays["com"].shape[1])]
    seconds = float(time[-1] - time[0])
    return {
        "level": recording.meta["level"],
        "seconds": seconds,
        "rate": (len(time) - 1) / seconds if seconds > 0 else 0.0,
        "characters": characters,
        "worst": _worst(characters),
    }


def _check(recording: Recording) -> None:
    needed = (*_FRAMES, *(f"footprint_{name}" for name in (*_PRINTS, "character")))
    lacks = [name for name in needed if name not in recording.arrays]
    for c, dimensions in enumerate(recording.meta.get("characters", [])):
        lacks += [f"meta.characters.{c}.{name}" for name in _DIMENSIONS if name not in dimensions]
    if lacks:
        raise InputError(f"the recording lacks {', '.join(lacks)}; record the run again with this version")
    spacing = np.diff(recording.arrays["time"])
    if len(spacing) and np.ptp(spacing) > UNEVEN:
        raise InputError(
            f"the recording's frames are {spacing.min():.6f} to {spacing.max():.6f} s apart; measuring needs even spacing"
        )


def frames_of(recording: Recording, c: int) -> dict[str, np.ndarray]:
    """The arrays over frames of character c, (F, ...)."""
    return {name: np.ascontiguousarray(recording.arrays[name][:, c]) for name in _FRAMES}


def prints_of(recording: Recording, c: int) -> dict[str, np.ndarray]:
    """The footprints of character c by contact time, (K, ...)."""
    mine = recording.arrays["footprint_character"] == c
    return {name: recording.arrays[f"footprint_{name}"][mine] for name in _PRINTS}


def _character(recording: Recording, world, c: int) -> dict:
    a, prints = frames_of(recording, c), prints_of(recording, c)
    time, dimensions = recording.arrays["time"], recording.meta["characters"][c]
    again = quality.physics_cost(a["com"], a["com_acceleration"], a["point_of_support"], a["contact"])
    return {
        "name": dimensions["name"],
        **_feet(a, prints, time, dimensions, world),
        **_legs(a, time, dimensions),
        "physics_cost": quality.by_phase(a["physics_cost"], a["phase"]),
        "physics_cost_error": float(np.abs(again - a["physics_cost"]).max()),
        "comfort_cost": float(a["comfort_cost"].mean()),
        "flight_residual": quality.flight_residual(a["com_acceleration"], a["phase"]),
        "gait": gait.report(prints, time, a["com"], a["phase"], dimensions["hip_height"]),
        **_places(prints, world),
        **_going(prints, a, time),
    }


def _feet(a: dict, prints: dict, time: np.ndarray, dimensions: dict, world) -> dict:
    """How exactly the feet stand, and what they clear."""
    sole = np.stack([a["heel"], a["ball"], a["toe"]], axis=2)
    ground = queries.ground_heights(world, sole.reshape(-1, 3)).reshape(sole.shape[:-1])
    height = sole[..., 2] - ground
    stands = quality.footing(time, a["contact"], prints)
    down = quality.on_ground(sole, stands, prints)
    places = quality.marks(prints, dimensions["foot_length"], dimensions["ball_forward"])
    horizontal, total = quality.skate(sole, down, stands)
    lowest = quality.swing_clearance(height.min(axis=2), a["contact"])
    return {
        "stance_slide": quality.stance_slide(a["toe"], a["contact"]),
        "skate_horizontal": horizontal,
        "skate": total,
        "footprint_error": quality.footprint_error(sole, down, stands, places),
        "contact_error": quality.contact_error(time, a["contact"], prints),
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


def _places(prints: dict, world) -> dict:
    """Least distances of the footprints' middles; water counts only where no rock carries the foot."""
    places, on_land = prints["position"], prints["rock"] < 0
    dry = [queries.water_clearance(world, x, y) for x, y, _ in places[on_land]]
    return {
        "tree_distance": min(queries.tree_clearance(world, x, y) for x, y, _ in places),
        "water_distance": min(dry, default=queries.REACH),
        "border_distance": min(queries.border_clearance(world, x, y) for x, y, _ in places),
    }


def _going(prints: dict, a: dict, time: np.ndarray) -> dict:
    way = float(np.linalg.norm(np.diff(a["com"][:, :2], axis=0), axis=1).sum())
    seconds = float(time[-1] - time[0])
    return {"steps": len(prints["side"]) - 2, "distance": way, "speed": way / seconds if seconds > 0 else 0.0}


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


def in_words(report: dict) -> str:
    """The report for people."""
    lines = [f"{report['level']}: {report['seconds']:.1f} s, {len(report['characters'])} character(s)"]
    for one in report["characters"][:10]:
        lines += _character_in_words(one)
    if len(report["characters"]) > 10:
        lines.append(f"  ... and {len(report['characters']) - 10} more (all of them with --json)")
    known = {key: value for key, value in report["worst"].items() if value is not None}
    lines.append("  worst: " + ", ".join(f"{key} {value:.4g}" for key, value in known.items()))
    return "\n".join(lines)


def _character_in_words(one: dict) -> list[str]:
    costs, went = one["physics_cost"], one["gait"]
    shares = ", ".join(f"{name} {part['share']:.0%}" for name, part in costs.items() if name != "all")
    ordered = sorted(went["shares"].items(), key=lambda item: -item[1])
    gaits = ", ".join(f"{name} {share:.0%}" for name, share in ordered if share > 0)
    return [
        f"  {one['name']}: {one['steps']} steps, {one['distance']:.1f} m at {one['speed']:.2f} m/s ({shares})",
        f"    gait {gaits} of the time; in {went['strides']} strides: speed {_said(went['speed'], 1, 'm/s')}, "
        f"Froude {_said(went['froude'])}, cadence {_said(went['cadence'], 1, '/min')}, duty {_said(went['duty_factor'])}, "
        f"double support {_said(went['double_support'], 100, '%')}, flight {_said(went['flight'], 100, '%')}",
        f"    step length {_said(went['step_length'], 100, 'cm')}, width {_said(went['step_width'], 100, 'cm')}; "
        f"com bob {_said(went['bob'], 100, 'cm')}, sway {_said(went['sway'], 100, 'cm')}, "
        f"height at mid-stance {_said(went['height_at_midstance'])} (0 lowest, 1 highest)",
        f"    slide {1e3 * one['stance_slide']:.3f} mm a frame, skate {1e3 * one['skate']:.3f} mm a stance "
        f"({1e3 * one['skate_horizontal']:.3f} mm level), off its footprint {1e3 * one['footprint_error']:.3f} mm, "
        f"contacts {one['contact_error']} ticks off",
        f"    penetration {1e3 * one['penetration']:.2f} mm, mid-swing clearance of the toe "
        f"{_said(one['swing_clearance'], 1e3, 'mm')}, of the sole {_said(one['clearance_share'], 100, '% of the leg')}; "
        f"overreach {1e3 * one['overreach']:.1f} mm, shanks {1e3 * one['shank_gap']:.0f} mm apart beyond their radii",
        *(_joint_in_words(name, joint) for name, joint in one["joints"].items()),
        f"    physics cost {costs['all']['mean']:.3f} mean, {costs['all']['peak']:.2f} peak m/s^2; "
        f"flight |a - g| {one['flight_residual']:.3f} m/s^2",
        f"    nearest tree {one['tree_distance']:.2f} m, water {one['water_distance']:.2f} m, "
        f"border {one['border_distance']:.2f} m",
    ]


def _joint_in_words(name: str, joint: dict) -> str:
    least, most = np.degrees(joint["least"]), np.degrees(joint["most"])
    return (
        f"    {name:5} {least:4.0f} to {most:.0f} deg, {joint['velocity']:.1f} rad/s, {joint['acceleration']:.0f} rad/s^2 at "
        f"{joint['acceleration_time']:.2f} s, {joint['acceleration_ratio']:.2f} times the 99th percentile"
    )


def _said(value: float | None, scale: float = 1.0, unit: str = "") -> str:
    return "none" if value is None else f"{scale * value:.3g} {unit}".rstrip()
