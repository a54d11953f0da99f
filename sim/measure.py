"""The report of `measure`: the quality of a recorded run, per character and the worst of all."""

import numpy as np

from motion import quality
from sim.recording import Recording
from worlds import queries


def measure(recording: Recording) -> dict:
    """{"level", "seconds", "characters": [...], "worst": {...}}; lengths in metres, costs in m/s^2."""
    world = recording.world.arrays
    count = recording.arrays["com"].shape[1]
    characters = [_character(recording, world, c) for c in range(count)]
    return {
        "level": recording.meta["level"],
        "seconds": float(recording.arrays["time"][-1] - recording.arrays["time"][0]),
        "characters": characters,
        "worst": _worst(characters),
    }


def _heights(world, points: np.ndarray) -> np.ndarray:
    flat = points.reshape(-1, 3)
    return np.array([queries.ground_height(world, x, y) for x, y, _ in flat]).reshape(points.shape[:-1])


def _character(recording: Recording, world, c: int) -> dict:
    a = {name: value[:, c] for name, value in recording.arrays.items() if name in _PER_FRAME}
    dimensions = recording.meta["characters"][c]
    toe_ground, heel_ground = _heights(world, a["toe"]), _heights(world, a["heel"])
    again = quality.physics_cost(a["com"], a["com_acceleration"], a["point_of_support"], a["contact"])
    toe_depth = quality.penetration(a["toe"], toe_ground)
    return {
        "name": dimensions["name"],
        "stance_slide": quality.stance_slide(a["toe"], a["contact"]),
        "penetration": max(toe_depth, quality.penetration(a["heel"], heel_ground)),
        "swing_clearance": quality.swing_clearance(a["toe"], toe_ground, a["contact"]),
        "overreach": quality.overreach(a["hip"], a["ankle"], dimensions["max_length"]),
        "physics_cost": quality.by_phase(a["physics_cost"], a["phase"]),
        "physics_cost_error": float(np.abs(again - a["physics_cost"]).max()),
        "comfort_cost": float(a["comfort_cost"].mean()),
        "flight_residual": quality.flight_residual(a["com_acceleration"], a["phase"]),
        **_places(recording, world, c),
        **_going(recording, a, c),
    }


_PER_FRAME = {"com", "com_acceleration", "hip", "ankle", "heel", "toe", "contact", "phase", "physics_cost"}
_PER_FRAME |= {"comfort_cost", "point_of_support"}


def _places(recording: Recording, world, c: int) -> dict:
    """Least distances of the footprints' middles; water counts only where no rock carries the foot."""
    mine = recording.arrays["footprint_character"] == c
    places = recording.arrays["footprint_position"][mine]
    on_land = recording.arrays["footprint_rock"][mine] < 0
    dry = [queries.water_clearance(world, x, y) for x, y, _ in places[on_land]]
    return {
        "tree_distance": min(queries.tree_clearance(world, x, y) for x, y, _ in places),
        "water_distance": min(dry, default=queries.REACH),
        "border_distance": min(queries.border_clearance(world, x, y) for x, y, _ in places),
    }


def _going(recording: Recording, a: dict, c: int) -> dict:
    way = float(np.linalg.norm(np.diff(a["com"][:, :2], axis=0), axis=1).sum())
    seconds = float(recording.arrays["time"][-1] - recording.arrays["time"][0])
    steps = int((recording.arrays["footprint_character"] == c).sum()) - 2
    return {"steps": steps, "distance": way, "speed": way / seconds if seconds > 0 else 0.0}


def _worst(characters: list[dict]) -> dict:
    largest = ("stance_slide", "penetration", "overreach", "flight_residual", "physics_cost_error")
    least = ("swing_clearance", "tree_distance", "water_distance", "border_distance", "speed")
    worst = {key: max(one[key] for one in characters) for key in largest}
    worst |= {key: min(one[key] for one in characters) for key in least}
    worst["mean_physics_cost"] = max(one["physics_cost"]["all"]["mean"] for one in characters)
    return worst


def in_words(report: dict) -> str:
    """The report for people."""
    lines = [f"{report['level']}: {report['seconds']:.1f} s, {len(report['characters'])} character(s)"]
    for one in report["characters"][:10]:
        costs = one["physics_cost"]
        shares = ", ".join(f"{name} {part['share']:.0%}" for name, part in costs.items() if name != "all")
        lines += [
            f"  {one['name']}: {one['steps']} steps, {one['distance']:.1f} m at {one['speed']:.2f} m/s ({shares})",
            f"    slide {1e3 * one['stance_slide']:.3f} mm, penetration {1e3 * one['penetration']:.2f} mm, "
            f"mid-swing clearance {1e3 * one['swing_clearance']:.0f} mm, overreach {1e3 * one['overreach']:.1f} mm",
            f"    physics cost {costs['all']['mean']:.3f} mean, {costs['all']['peak']:.2f} peak m/s^2; "
            f"flight |a - g| {one['flight_residual']:.3f} m/s^2",
            f"    nearest tree {one['tree_distance']:.2f} m, water {one['water_distance']:.2f} m, "
            f"border {one['border_distance']:.2f} m",
        ]
    if len(report["characters"]) > 10:
        lines.append(f"  ... and {len(report['characters']) - 10} more (all of them with --json)")
    lines.append("  worst: " + ", ".join(f"{key} {value:.4g}" for key, value in report["worst"].items()))
    return "\n".join(lines)
