"""Figures by matplotlib (the extra `plots`): a recorded run over time, and the automatic timing over the step length."""

from pathlib import Path
from typing import Any

import matplotlib
import matplotlib.patches
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from PIL import Image

from motion.measures import gait, joints
from motion.track import phases
from motion.track.footprints import SIDES as SIDE_NAMES
from motion.track.footprints import Footprints
from sim.files import outputs
from sim.files.recording import Recording
from sim.reports.cycles import ANGLES, Cycle
from sim.reports.measure import frames_of
from worlds.errors import InputError

FRAMES = 30
"""Poses per simulated second in the figures of crowds."""
KINDS = (".png", ".svg", ".pdf")
SIDES = (phases.COLOURS[phases.LEFT_STANCE], phases.COLOURS[phases.RIGHT_STANCE])
INK, GRID = "0.25", "0.9"
STYLE: Any = {
    "font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": INK, "axes.labelcolor": INK,
    "xtick.color": INK, "ytick.color": INK, "text.color": INK, "axes.grid": True, "grid.color": GRID, "axes.axisbelow": True,
    "lines.linewidth": 1.3, "legend.frameon": False, "legend.fontsize": 8, "svg.hashsalt": "footfall",
}  # fmt: skip


def plot_run(recording: Recording, c: int, path: str | Path, between: tuple[float, float] | None = None) -> None:
    """Draws character c over time [s], or over the times `between`: com, costs, joint angles, who stands."""
    count = recording.arrays["com"].shape[1]
    if not 0 <= c < count:
        raise InputError(f"--character-index {c}: the recording has {count} character(s), 0 to {count - 1}")
    time, dimensions = recording.arrays["time"], recording.meta["characters"][c]
    shown = _shown(time, between)
    a, footprints = frames_of(recording, c), recording.footprints(c)
    angles = joints.angles(a, dimensions["metatarsus"] > 0)
    heights = (1.2, 1.2, 1.2, *(1.2 for _ in angles), 0.7)
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(11, 1.3 * sum(heights)), layout="constrained")
        axes = figure.subplots(len(heights), 1, sharex=True, height_ratios=heights)
        _com((axes[0], axes[1]), time, a["com"], footprints, dimensions["hip_height"], shown)
        _costs(axes[2], time[shown], a["physics_cost"][shown], a["comfort_cost"][shown])
        for axis, (name, angle) in zip(axes[3:-1], angles.items(), strict=True):
            _angle(axis, name, time[shown], angle[shown])
        _legend(axes[3])
        _stances(axes[-1], time[shown], a["contact"][shown], a["phase"][shown])
        axes[-1].set_xlim(time[shown][0], time[shown][-1])
        axes[-1].set_xlabel("time [s]")
        figure.align_ylabels(axes)
        figure.suptitle(f"{dimensions['name']}, {recording.meta['level']}", fontsize=11, x=0.01, ha="left")
        write(figure, path)


def _shown(time: np.ndarray, between: tuple[float, float] | None) -> slice:
    if between is None:
        return slice(0, len(time))
    first, last = np.searchsorted(time, between[0] - 1e-9), np.searchsorted(time, between[1] + 1e-9)
    if last - first < 3:
        raise InputError(
            f"--between {between[0]:g} {between[1]:g}: holds {max(last - first, 0)} frames; the recording goes "
            f"from {time[0]:g} to {time[-1]:g} s"
        )
    return slice(int(first), int(last))


def _com(
    axes: tuple[Axes, Axes], time: np.ndarray, com: np.ndarray, footprints: Footprints, hip_height: float, shown: slice
) -> None:
    """Height of the com, and how far it is to the left of the walked line."""
    height, aside = axes
    height.plot(time[shown], com[shown, 2], color=INK)
    height.set_ylabel("com height\n[m]")
    strides = gait.strides_of(footprints, float(time[0]), float(time[-1]), hip_height)
    if len(strides.begin):
        left = gait.off_line(time, com, float(np.median(strides.duration)))[:, 0]
        aside.plot(time[shown], 100 * left[shown], color=INK)
    else:
        aside.text(0.5, 0.5, "no strides: no walked line to sway about", transform=aside.transAxes, ha="center", va="center")
    aside.axhline(0, color="0.6", linewidth=0.8)
    aside.set_ylabel("com to the left\n[cm]")


def _costs(axis: Axes, time: np.ndarray, physics: np.ndarray, comfort: np.ndarray) -> None:
    axis.fill_between(time, physics, color="#d95f02", alpha=0.25, linewidth=0)
    axis.plot(time, physics, color="#d95f02", label="physics")
    axis.plot(time, comfort, color="#1b7f79", label="comfort")
    axis.set_ylim(bottom=0)
    axis.set_ylabel("cost\n[m/s²]")
    _legend(axis)


def _legend(axis: Axes) -> None:
    """Above the axis, clear of its lines."""
    axis.legend(loc="lower right", bbox_to_anchor=(1.0, 0.94), ncols=2, borderaxespad=0)


def _angle(axis: Axes, name: str, time: np.ndarray, angle: np.ndarray) -> None:
    for side, label in enumerate(SIDE_NAMES):
        axis.plot(time, np.degrees(angle[:, side]), color=SIDES[side], label=label)
    axis.set_ylabel(f"{name}\n[deg]")


def _stances(axis: Axes, time: np.ndarray, contact: np.ndarray, phase: np.ndarray) -> None:
    """The timing diagram: a bar per foot where it stands, in the colour of the body's phase; flights behind both."""
    dt = (time[-1] - time[0]) / max(len(time) - 1, 1)
    edges = np.concatenate([[0], np.flatnonzero(np.diff(phase)) + 1, [len(phase)]])
    for begin, end in zip(edges[:-1], edges[1:], strict=True):
        code = int(phase[begin])
        span = (time[begin], (end - begin) * dt)
        if code == phases.FLIGHT:
            axis.broken_barh([span], (-0.5, 2), color=phases.COLOURS[code], linewidth=0)
        for side in range(2):
            if contact[begin, side]:
                axis.broken_barh([span], (0.65 - side, 0.7), color=phases.COLOURS[code], linewidth=0)
    axis.set_yticks([1, 0], list(SIDE_NAMES))
    axis.set_ylim(-0.5, 1.5)
    axis.grid(False, axis="y")
    axis.set_ylabel("stance")
    handles = [matplotlib.patches.Patch(color=phases.COLOURS[code], label=name) for code, name in enumerate(phases.NAMES)]
    axis.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, -0.45), ncols=4)


def plot_timings(tables: dict[str, dict], path: str | Path) -> None:
    """Draws tables of sim.reports.timings over the step length, a column per character (paper, Fig. 12)."""
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(1 + 3.6 * len(tables), 7.5), layout="constrained")
        axes = figure.subplots(3, len(tables), squeeze=False, sharex="col", sharey="row", height_ratios=(1.6, 1, 1))
        for column, (name, table) in zip(axes.T, tables.items(), strict=True):
            _timing(column, name, table)
        for axis, label in zip(axes[:, 0], ("time [s]", "speed [m/s]", "duty factor"), strict=True):
            axis.set_ylabel(label)
            axis.set_ylim(bottom=0)
        figure.legend(*axes[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=4)
        figure.align_ylabels(axes[:, 0])
        write(figure, path)


def plot_strides(strides: dict[str, Cycle], people: dict, path: str | Path) -> None:
    """Draws hip, knee, ankle [deg] and force over a stride, a row per gait, beside curves of people where there are some."""
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(13, 3 * len(strides)), layout="constrained")
        axes = figure.subplots(len(strides), len(ANGLES) + 1, squeeze=False, sharex=True)
        for row, (gait_name, ours) in zip(axes, strides.items(), strict=True):
            for axis, quantity in zip(row, ANGLES, strict=False):
                _stride(axis, ours.percent, ours.angles[quantity], people.get((gait_name, quantity)))
                axis.set_title(f"{gait_name}: {quantity.replace('_', ' ')} [deg]", fontsize=9, loc="left")
            _stride(row[-1], ours.percent, ours.force, None)
            row[-1].set_title(f"{gait_name}: force [body weights]", fontsize=9, loc="left")
        for axis in axes[-1]:
            axis.set_xlabel("stride [%]")
        figure.legend(*axes[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
        write(figure, path)


def _stride(axis: Axes, percent: np.ndarray, values: np.ndarray, theirs: np.ndarray | None) -> None:
    axis.plot(percent, values, color=SIDES[0], label="here")
    if theirs is not None:
        offset = float(np.mean(np.interp(theirs[:, 0], percent, values) - theirs[:, 1]))
        axis.plot(theirs[:, 0], theirs[:, 1] + offset, "--", color=INK, label="people, at our mean")


def _timing(axes: np.ndarray, name: str, table: dict) -> None:
    length, kinds = np.array(table["step_length"]), np.array(table["gait"])
    parts = (("step_time", INK, "-"), ("stance_time", "#c0182a", "-"), ("swing_time", "#1b7f79", "-"))
    for column, colour, style in (*parts, ("flight_time", "#3b8fd0", "--")):
        axes[0].plot(length, _broken(table[column], kinds), style, color=colour, label=column.removesuffix("_time"))
    axes[1].plot(length, _broken(table["speed"], kinds), color=INK)
    axes[2].plot(length, _broken(table["duty_factor"], kinds), color=INK)
    axes[2].axhline(0.5, color="0.6", linewidth=0.8)
    axes[2].set_xlabel("step length [m]")
    for axis in axes:
        for kind, shade in (("run", 0.10), ("leap", 0.22)):
            there = length[kinds == kind]
            if len(there):
                axis.axvspan(there[0], there[-1], color=phases.COLOURS[phases.FLIGHT], alpha=shade * 2, linewidth=0)
    for kind in ("walk", "run", "leap"):
        there = length[kinds == kind]
        if len(there):
            axes[0].text(there.mean(), 1.0, kind, transform=axes[0].get_xaxis_transform(), ha="center", va="bottom", fontsize=8)
    change = table["run_from"]
    told = f"runs from Froude {change['froude']:.2f}" if change else "never runs"
    axes[0].set_title(f"{name}: {told}", pad=16, fontsize=10)


def _broken(values: list[float], kinds: np.ndarray) -> np.ndarray:
    """The values with a gap where a leap begins: the law jumps there."""
    out = np.array(values)
    out[1:][(kinds[1:] == "leap") & (kinds[:-1] != "leap")] = np.nan
    return out


def plot_crowds(crowds: dict[str, dict], path: str | Path) -> None:
    """Draws what `bench` tells of crowds (sim.bench.crowds.measure, by their counts): real time kept, and the costs' parts."""
    count, rows = [int(n) for n in crowds], list(crowds.values())
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(8, 3.4), layout="constrained")
        left, right = figure.subplots(1, 2)
        for key, style, label in (
            ("realtime_ratio_with_poses", "-o", f"{rows[0]['threads']} thread(s)"),
            ("realtime_ratio_with_poses_1_thread", "--o", "1 thread"),
        ):
            left.loglog(count, [row[key] for row in rows], style, color=INK, label=label, markersize=4)
        left.axhline(1.0, color=SIDES[1], linewidth=0.8)
        left.set(xlabel="characters", ylabel="simulated s / wall s, poses included")
        left.legend()
        bottom = np.zeros(len(rows))
        parts = (("planning_us_per_step", "#1b7f79"), ("optimising_us_per_step", "#c0182a"), ("posing_us", "#3b8fd0"))
        for key, colour in parts:
            each = FRAMES if key == "posing_us" else np.array([row["steps_per_second"] for row in rows])
            cost = 1e-3 * each * np.array([row[key] for row in rows])
            right.bar(range(len(rows)), cost, bottom=bottom, color=colour, label=key.split("_")[0], width=0.6)
            bottom += cost
        right.set_xticks(range(len(rows)), [f"{n:,}" for n in count])
        right.set(xlabel="characters", ylabel="core ms / character and simulated s")
        right.legend()
        write(figure, path)


def writable_kind(path: str | Path) -> None:
    """Raises InputError where the figure's name does not end in a known kind of file."""
    if Path(path).suffix.lower() not in KINDS:
        raise InputError(f"{path}: the figure's name must end in {', '.join(KINDS)}")


def write(figure: Figure, path: str | Path, colours: int | None = None) -> None:
    """Writes the figure whole or not at all; the kind of file is that of its name. A .png of so many colours is small."""
    writable_kind(path)
    kind = Path(path).suffix[1:].lower()
    with outputs.whole(path) as temporary:
        figure.savefig(temporary, format=kind, dpi=120)
        if colours is not None and kind == "png":
            with Image.open(temporary) as image:
                few = image.convert("RGB").quantize(colours, dither=Image.Dither.NONE)
            few.save(temporary, format="PNG", optimize=True)
