"""The report of `measure` for people."""

import numpy as np


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
