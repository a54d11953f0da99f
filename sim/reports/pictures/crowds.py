"""Pictures of crowds beside people, by matplotlib (the extra `plots`): speeds, flows, where it is dense, lanes, a circle."""

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

from sim.reports.flows import Flow
from sim.reports.plots import INK, STYLE, write
from worlds.world import World

FREE, STEEP, FULL = 1.34, 1.913, 5.4
"""Weidmann 1993: v = FREE (1 - exp(-STEEP (1 / d - 1 / FULL))) at d people per square metre."""
LABORATORY = {0.5: 1.54, 1.0: 1.47, 1.5: 1.19, 2.0: 1.01, 2.5: 0.56}
"""Nine in ten of laboratory measurements lie below these speeds [m/s]."""
PEOPLE = (1.6, 2.1)
"""Flow of people through bottlenecks, per metre and second."""
OURS, THEIRS, OTHER = "#b5432f", "0.6", "#3b6fa0"
DIM = 0.8
"""Of full colours, so that yellow is seen on white."""
NOBODY = 0.02
"""Less than so many per square metre are left white."""
CELL, SMOOTH = 0.1, 0.4
"""Of maps of density: edge of a cell, and how far one is felt [m]."""


class Spot(NamedTuple):
    """A figure at a density [1/m^2] or a width [m]."""

    at: float
    value: float


def weidmann(density: np.ndarray) -> np.ndarray:
    """Speed of people at a density [m/s]."""
    return FREE * (1 - np.exp(-STEEP * (1 / density - 1 / FULL)))


def plot_speeds(spots: Sequence[Spot], path: str | Path) -> None:
    """Speed over density, with Weidmann's curve and the laboratories'."""
    with matplotlib.rc_context(STYLE):
        figure, axis = _one(4.8, 3.6)
        density = np.linspace(0.3, 4.0, 200)
        top = np.interp(density, list(LABORATORY), list(LABORATORY.values()))
        shown = density <= max(LABORATORY)
        axis.fill_between(density[shown], weidmann(density[shown]) - 0.1, top[shown], color=THEIRS, alpha=0.25, lw=0)
        axis.plot(density, weidmann(density), color=THEIRS, label="people, Weidmann 1993")
        axis.plot(list(LABORATORY), list(LABORATORY.values()), "_", color=INK, ms=9, label="nine in ten of laboratories below")
        axis.plot(*np.array(spots).T, "o-", color=OURS, label="here")
        axis.set(xlabel="people per square metre", ylabel="speed [m/s]", xlim=(0, 4), ylim=(0, 1.7))
        axis.legend(loc="upper right")
        write(figure, path)


def plot_flows(spots: Sequence[Spot], path: str | Path) -> None:
    """People per second over the width of a bottleneck, and the band of people."""
    with matplotlib.rc_context(STYLE):
        figure, axis = _one(4.8, 3.6)
        width = np.array([0.0, 1.1 * max(spot.at for spot in spots)])
        axis.fill_between(width, PEOPLE[0] * width, PEOPLE[1] * width, color=THEIRS, alpha=0.3, lw=0, label="people")
        axis.plot([spot.at for spot in spots], [spot.at * spot.value for spot in spots], "o-", color=OURS, label="here")
        axis.set(xlabel="width of the bottleneck [m]", ylabel="people per second", xlim=(0, width[1]), ylim=(0, None))
        axis.legend(loc="upper left")
        write(figure, path)


def plot_density(flow: Flow, path: str | Path) -> None:
    """Mean density of the middle third of the time, from above."""
    frames = flow.place[len(flow.time) // 3 : 2 * len(flow.time) // 3 + 1]
    size = np.ceil(np.array(flow.world.size) / CELL).astype(int)
    there = frames[~np.isnan(frames[..., 0])]
    edges = [np.arange(count + 1) * CELL for count in size]
    count, *_ = np.histogram2d(there[:, 0], there[:, 1], bins=edges)
    reach = np.arange(-int(3 * SMOOTH / CELL), int(3 * SMOOTH / CELL) + 1) * CELL
    kernel = np.exp(-0.5 * (reach / SMOOTH) ** 2)
    kernel /= kernel.sum()
    for axis in (0, 1):
        count = np.apply_along_axis(np.convolve, axis, count, kernel, "same")
    with matplotlib.rc_context(STYLE):
        figure, plane = _one(7.2, 7.2 * flow.world.size[1] / flow.world.size[0] + 0.6)
        map_of = plane.imshow(
            np.ma.masked_less(count.T / len(frames) / CELL**2, NOBODY),
            origin="lower",
            extent=(0, size[0] * CELL, 0, size[1] * CELL),
            cmap="magma_r",
        )
        figure.colorbar(map_of, ax=plane, label="people per square metre", shrink=0.8)
        _ground(plane, flow.world, there)
        write(figure, path)


def plot_lanes(flow: Flow, path: str | Path) -> None:
    """Ways of everyone, from above, coloured by where they go: to the right, or to the left."""
    with matplotlib.rc_context(STYLE):
        figure, plane = _one(7.2, 3.4)
        went = flow.place[-1, :, 0] - flow.place[0, :, 0]
        for right, colour in ((True, OURS), (False, OTHER)):
            ways = [flow.place[:, c] for c in np.flatnonzero((went > 0) == right)]
            plane.add_collection(LineCollection(ways, colors=colour, linewidths=0.6, alpha=0.55))
            plane.plot([], [], color=colour, label="to the right" if right else "to the left")
        _ground(plane, flow.world, flow.place.reshape(-1, 2))
        plane.legend(loc="upper right", ncols=2)
        write(figure, path)


def plot_circle(flow: Flow, path: str | Path) -> None:
    """Ways of those who change places on a circle, from above, coloured by where they began, and where all are when they are
    nearest to its middle."""
    with matplotlib.rc_context(STYLE):
        figure, plane = _one(4.8, 4.8)
        middle = 0.5 * np.array(flow.world.size)
        off = flow.place[0] - middle
        colours = DIM * matplotlib.colormaps["hsv"]((np.arctan2(off[:, 1], off[:, 0]) / (2 * np.pi)) % 1)[:, :3]
        plane.add_collection(LineCollection(list(flow.place.transpose(1, 0, 2)), colors=colours, linewidths=0.6, alpha=0.7))
        nearest = np.hypot(*(flow.place - middle).transpose(2, 0, 1)).mean(axis=1).argmin()
        plane.scatter(
            flow.place[nearest, :, 0], flow.place[nearest, :, 1], s=16, c=colours, edgecolors=INK, linewidths=0.4, zorder=3
        )
        _ground(plane, flow.world, flow.place.reshape(-1, 2))
        write(figure, path)


def _one(width: float, height: float) -> tuple[Figure, Axes]:
    figure = Figure(figsize=(width, height), layout="constrained")
    return figure, figure.subplots()


def _ground(plane: Axes, world: World, places: np.ndarray) -> None:
    """Walls, and as much of the world as people are in."""
    for wall in world.walls:
        plane.plot(*wall.points.T, color=INK, lw=2, solid_capstyle="butt")
    low, high = np.nanpercentile(places, 1, axis=0) - 2.0, np.nanpercentile(places, 99, axis=0) + 2.0
    plane.set(xlim=(max(low[0], 0), min(high[0], world.size[0])), ylim=(max(low[1], 0), min(high[1], world.size[1])))
    plane.set(aspect="equal", xlabel="x [m]", ylabel="y [m]")
    plane.grid(False)
