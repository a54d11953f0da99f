"""The report of `measure` for people."""

import numpy as np

_WORST = {
    "stance_slide": ("slide", 1e3, "mm a frame"), "skate": ("skate", 1e3, "mm a stance"),
    "footprint_error": ("off the footprint", 1e3, "mm"), "contact_error": ("contacts off", 1.0, "ticks"),
    "penetration": ("penetration", 1e3, "mm"), "overreach": ("overreach", 1e3, "mm"),
    "flight_residual": ("flight |a - g|", 1.0, "m/s^2"), "physics_cost_error": ("physics cost off", 1.0, "m/s^2"),
    "swing_clearance": ("clearance of the toe", 1e3, "mm"), "clearance_share": ("of the sole", 100.0, "% of the leg"),
    "shank_gap": ("shanks apart", 1e3, "mm"), "tree_distance": ("nearest tree", 1.0, "m"),
    "water_distance": ("water", 1.0, "m"), "border_distance": ("border", 1.0, "m"), "speed": ("slowest", 1.0, "m/s"),
    "force": ("force", 1.0, "body weights"), "force_change": ("its change", 1.0, "a frame"), "friction": ("friction", 1.0, ""),
    "mean_physics_cost": ("mean physics cost", 1.0, "m/s^2"),
    **{f"{name}_acceleration_ratio": (f"{name} peak", 1.0, "times its 99th percentile")
       for name in ("hip", "knee", "hock", "ankle")},
}  # fmt: skip
"""The words of the figures of which the worst is told, and how they are counted."""


def in_words(report: dict) -> str:
    """The report for people."""
    lines = [f"{report['level']}: {report['seconds']:.1f} s, {len(report['characters'])} character(s)"]
    for one in report["characters"][:10]:
        lines += _character_in_words(one)
    if len(report["characters"]) > 10:
        lines.append(f"  ... and {len(report['characters']) - 10} more (all of them with --json)")
    known = {key: value for key, value in report["worst"].items() if value is not None}
    lines.append("  worst of all: " + ", ".join(_worst_in_words(key, value) for key, value in known.items()))
    return "\n".join(lines)


def _worst_in_words(key: str, value: float) -> str:
    """A figure of the worst with its words and unit."""
    words, scale, unit = _WORST.get(key, (key.replace("_", " "), 1.0, ""))
    return f"{words} {_said(value, scale, unit)}"


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
        f"flight |a - g| {one['flight_residual']:.3f} m/s^2; force {one['force']:.2f} body weights at most, changes by "
        f"{one['force_change']:.3f} a frame, needs friction {one['friction']:.2f}",
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
