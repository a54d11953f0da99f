"""`verify`: crowds beside people. Each case has a figure, the band in which people lie, and a verdict.

Bands: fundamental diagram between Weidmann's curve (1993) less 0.1 m/s and nine in ten of laboratory measurements; bottleneck
flow of laboratory experiments; cases named RiMEA follow the guideline 4.1.1 (RiMEA e.V. 2022) as far as geometry needs.
"""

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import NamedTuple

from planner.round.weights import PEOPLE, Weights
from sim.files.outputs import whole
from sim.reports import flows
from sim.reports.flows import Flow
from sim.reports.people import Row

RING_BANDS = {0.5: (1.20, 1.54), 1.0: (0.96, 1.47), 1.5: (0.71, 1.19), 2.0: (0.51, 1.01), 2.5: (0.35, 0.56), 3.0: (0.2, 0.4)}
"""Speeds [m/s] by density [1/m^2]."""
NECKS = (0.9, 1.2, 2.0, 3.0)
"""Widths of bottlenecks [m]."""
LONGEST = 200.0
"""No case takes longer [s]."""


class Case(NamedTuple):
    """Something of which people's figure is known."""

    name: str
    unit: str
    low: float
    high: float
    run: Callable[[Weights], Flow]
    figure: Callable[[Flow], float]


def cases(quick: bool) -> list[Case]:
    """All, or a few that are soon done."""
    seconds = 20.0 if quick else 40.0
    corridor = Case("RiMEA 1: 40 m of corridor", "s", 26, 34, _corridor, lambda flow: float(flow.time[-1]))
    corner = Case("RiMEA 6: 20 around a corner, places in walls", "", 0, 0, _corner, lambda flow: float(flows.in_walls(flow)))
    rings = [
        Case(f"RiMEA 4: speed at {density:g} per m^2", "m/s", *band, partial(_ring, density, seconds), flows.ring_speed)
        for density, band in RING_BANDS.items()
    ]
    necks = [
        Case(f"bottleneck {width:g} m wide: flow", "1/(m s)", 1.6, 2.1, partial(_neck, width, 50 if quick else 100),
             partial(flows.specific_flow, width=width))
        for width in NECKS
    ]  # fmt: skip
    against = [
        Case(
            f"counterflow, {count} a side through 3 m: last through",
            "s",
            0,
            limit,
            partial(_against, count),
            flows.last_through,
        )
        for count, limit in ((20, 30.0), (60, 60.0))
    ]
    return [corridor, rings[1], necks[2]] if quick else [corridor, corner, *rings, *necks, *against]


def _corridor(weights: Weights) -> Flow:
    return flows.watched(flows.corridor(), LONGEST, 42.0)


def _corner(weights: Weights) -> Flow:
    return flows.watched(flows.corner(), 40.0)


def _ring(density: float, seconds: float, weights: Weights) -> Flow:
    return flows.watched(flows.ring(density, weights), seconds)


def _neck(width: float, count: int, weights: Weights) -> Flow:
    return flows.watched(flows.bottleneck(width, count, weights=weights), LONGEST, flows.DOOR[0] + 1.5)


def _against(count: int, weights: Weights) -> Flow:
    sim = flows.counterflow(count, weights=weights)
    return flows.watched(sim, LONGEST, sim.world.size[0] / 2)


def verify(quick: bool = False, folder: Path | None = None, weights: Weights = PEOPLE) -> Iterator[Row]:
    """Row by row, as they come; trajectories are written into the folder, if there is one."""
    for k, case in enumerate(cases(quick)):
        flow = case.run(weights)
        if folder is not None:
            with whole(folder / f"{k + 1:02d}.txt") as path:
                path.write_text(flows.trajectories(flow), encoding="utf-8")
        yield Row(case.name, case.unit, case.figure(flow), case.low, case.high)


def in_words(row: Row) -> str:
    """A line of the table."""
    return f"{row.what:50} {row.told:>16}   people {row.low:g} to {row.high:g}   {row.verdict}"


def as_dict(row: Row) -> dict:
    """A row for JSON."""
    return {"name": row.what, "figure": row.value, "unit": row.unit, "low": row.low, "high": row.high, "fits": row.fits}
