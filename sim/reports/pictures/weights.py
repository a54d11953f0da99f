"""A picture of what each weight of a step's cost does: a row for each, a little scene at none of it, as it is, and double."""

import textwrap
from collections.abc import Sequence
from pathlib import Path

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection, LineCollection
from matplotlib.figure import Figure

from sim.reports.flows import Flow
from sim.reports.people import STANDING, WAYS, Weighed
from sim.reports.pictures.crowds import OTHER, OURS
from sim.reports.plots import INK, STYLE, write

WIDE, LABEL, TITLE, AIR = 2.1, 1.15, 0.2, 0.1
"""Width of a scene, of the weights' names, height of a scene's words, and room below it [inches]."""
HEADS = ("none of it", "as it is", "double")
COLOURS = 128
"""Of the picture, which is small so."""
SOON = 20
"""Looks after which one sees where somebody sets out for."""
SLOW = 0.1
"""Who is slower stands [m/s]."""


def plot_weights(rows: Sequence[Weighed], path: str | Path) -> None:
    """Small multiples: a row for each weight."""
    tall = [TITLE + AIR + WIDE * (row.box[3] - row.box[2]) / (row.box[1] - row.box[0]) for row in rows]
    width, height = LABEL + 3 * WIDE + 0.3, sum(tall) + 0.3
    with matplotlib.rc_context(STYLE):
        figure, top = Figure(figsize=(width, height)), height - 0.3
        for k, head in enumerate(HEADS):
            figure.text((LABEL + k * (WIDE + 0.1)) / width, 1 - 0.16 / height, head, fontsize=9, weight="bold")
        for row, high in zip(rows, tall, strict=True):
            at = (top - TITLE) / height
            figure.text(0.1 / width, at, row.weight, fontsize=9, weight="bold", va="bottom")
            figure.text(0.1 / width, at, textwrap.fill("more: " + row.more, 18), fontsize=7, va="top")
            for k in range(len(row.values)):
                left, low = LABEL + k * (WIDE + 0.1), top - high + AIR
                plane = figure.add_axes((left / width, low / height, WIDE / width, (high - TITLE - AIR) / height))
                plane.text(0, 1.02, f"{row.values[k]:g}: {row.words[k]}", transform=plane.transAxes, fontsize=7, va="bottom")
                _scene(plane, row, row.flows[k])
            top -= high
        write(figure, path, COLOURS)


def _scene(plane: Axes, row: Weighed, flow: Flow) -> None:
    """Ways of everyone, or their bodies at a moment, from above."""
    for wall in flow.world.walls:
        plane.plot(*wall.points.T, color=INK, lw=1.5, solid_capstyle="butt")
    begin = flow.place[min(SOON, len(flow.time) - 1)] - flow.place[0]
    stays = np.hypot(*(flow.place[-1] - flow.place[0]).T) < 0.5
    colours = np.where(stays, INK, np.where(begin[:, 0] > 1.2 * np.abs(begin[:, 1]), OURS, OTHER))
    if row.drawn == WAYS:
        plane.add_collection(LineCollection(list(flow.place.swapaxes(0, 1)), colors=colours, linewidths=0.6, alpha=0.75))
        x, y = flow.place[0, stays].T
        plane.scatter(x, y, s=8, color=INK, linewidths=0, zorder=3)
    else:
        _bodies(plane, row, flow, colours)
    plane.set(xlim=row.box[:2], ylim=row.box[2:], xticks=[], yticks=[])
    plane.spines[:].set_visible(False)
    plane.set_facecolor("0.965")


def _bodies(plane: Axes, row: Weighed, flow: Flow, colours: np.ndarray) -> None:
    """Bodies at a moment, as they face; or those who stand then, among the others."""
    assert flow.heading is not None and flow.half is not None
    k = min(int(np.searchsorted(flow.time, row.moment)), len(flow.time) - 1)
    if row.drawn == STANDING:
        gone = np.hypot(*(flow.place[k] - flow.place[k - 1]).T) / (flow.time[k] - flow.time[k - 1])
        colours = np.where(gone < SLOW, OURS, "0.8")
    deep, wide = 2 * flow.half.T
    plane.add_collection(
        EllipseCollection(
            deep, wide, np.degrees(flow.heading[k]), units="xy", offsets=flow.place[k], transOffset=plane.transData,
            facecolors=colours, edgecolors="none", alpha=0.85,
        )
    )  # fmt: skip
