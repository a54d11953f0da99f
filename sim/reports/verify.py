"""`verify`: crowds beside people. Each case has a figure, the band in which people lie, and a verdict.

Bands: fundamental diagram between Weidmann's curve (1993) less 0.1 m/s and nine in ten of laboratory measurements; bottleneck
flow of laboratory experiments; cases named RiMEA follow the guideline 4.1.1 (RiMEA e.V. 2022) as far as geometry needs.
"""

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from string import ascii_lowercase

from planner.round.weights import PEOPLE, Weights
from sim.files.outputs import whole
from sim.reports import flows
from sim.reports.flows import Flow
from sim.reports.people import MANY, SEEDS, Case, Row, by_seeds, median_of, worst_of
from sim.reports.rimea import cases as rimea
from sim.reports.throngs import cases as throngs

Seen = Callable[[Case, list[Flow], Row], None]
RING_BANDS = {0.5: (1.20, 1.54), 1.0: (0.96, 1.47), 1.5: (0.71, 1.19), 2.0: (0.51, 1.01), 2.5: (0.35, 0.56), 3.0: (0.2, 0.4)}
"""Speeds [m/s] by density [1/m^2]."""
NECKS = (0.9, 1.2, 2.0, 3.0)
"""Widths of bottlenecks [m]."""
LONGEST = 200.0
"""No case takes longer [s]."""


def cases(quick: bool) -> list[Case]:
    """All, or a few that are soon done."""
    seconds, seeds, many = (20.0, SEEDS[:1], SEEDS[:1]) if quick else (40.0, SEEDS, MANY)
    corridor = Case("RiMEA 1: 40 m of corridor", "s", 26, 34, [_corridor], lambda all: float(all[0].time[-1]), 1)
    corner = Case("RiMEA 6: 20 around a corner, places in walls", "", 0, 0, [_corner], _first(flows.in_walls), 6)
    rings = [
        Case(
            f"RiMEA 4: speed at {density:g} per m^2",
            "m/s",
            *band,
            by_seeds(partial(_ring, density, seconds), seeds=seeds),
            median_of(_first(flows.ring_speed)),
            4,
            shows="speeds",
            at=density,
        )
        for density, band in RING_BANDS.items()
    ]
    necks = [
        Case(f"bottleneck {width:g} m wide: flow", "1/(m s)", 1.6, 2.1,
             by_seeds(partial(_neck, width, 50 if quick else 100), seeds=many),
             median_of(_first(partial(flows.specific_flow, width=width))), 0, "two shoulders hardly pass",
             "flows", width)
        for width in NECKS
    ]  # fmt: skip
    against = [
        Case(
            f"counterflow, {count} a side through 3 m: last through",
            "s",
            0,
            limit,
            by_seeds(partial(_against, count), seeds=seeds),
            worst_of(_first(flows.last_through)),
            16,
            "two streams jam before the gap",
            "lanes",
        )
        for count, limit in ((20, 30.0), (60, 60.0))
    ]
    everything = sorted([corridor, corner, *rings, *rimea.cases()], key=lambda case: case.number)
    return [corridor, rings[1], necks[2]] if quick else [*everything, *necks, *against, *throngs.cases()]


def _first(figure: Callable[[Flow], float]) -> Callable[[list[Flow]], float]:
    """The figure of the only simulation of a case."""
    return lambda all: float(figure(all[0]))


def _corridor(weights: Weights) -> Flow:
    return flows.watched(flows.corridor(), LONGEST, 42.0)


def _corner(weights: Weights) -> Flow:
    return flows.watched(flows.corner(), 40.0)


def _ring(density: float, seconds: float, weights: Weights, seed: int) -> Flow:
    return flows.watched(flows.ring(density, weights, seed), seconds)


def _neck(width: float, count: int, weights: Weights, seed: int) -> Flow:
    return flows.watched(flows.bottleneck(width, count, weights=weights, seed=seed), LONGEST, flows.DOOR[0] + 1.5)


def _against(count: int, weights: Weights, seed: int) -> Flow:
    sim = flows.counterflow(count, weights=weights, seed=seed)
    return flows.watched(sim, LONGEST, sim.world.size[0] / 2)


def numbers() -> list[int]:
    """The RiMEA tests that there are."""
    return sorted({case.number for case in cases(False)} - {0})


def verify(
    quick: bool = False, folder: Path | None = None, weights: Weights = PEOPLE, number: int | None = None,
    seen: Seen | None = None,
) -> Iterator[Row]:  # fmt: skip
    """Row by row, as they come; trajectories are written into the folder, if there is one.

    number: only that RiMEA test. seen: is shown every case, where its people went, and its row.
    """
    for k, case in enumerate(cases(quick)):
        if number in (None, case.number):
            found = [run(weights) for run in case.runs]
            for i, flow in enumerate(found if folder is not None else []):
                with whole(Path(str(folder)) / f"{k + 1:02d}{ascii_lowercase[i] if len(found) > 1 else ''}.txt") as path:
                    path.write_text(flows.trajectories(flow), encoding="utf-8")
            row = Row(case.name, case.unit, case.figure(found), case.low, case.high, case.why)
            if seen is not None:
                seen(case, found, row)
            yield row


def in_words(row: Row) -> str:
    """A line of the table."""
    why = f": {row.why}" if row.why and not row.fits else ""
    return f"{row.what:58} {row.told:>16}   people {row.low:g} to {row.high:g}   {row.verdict}{why}"


def as_dict(row: Row) -> dict:
    """A row for JSON."""
    return {
        "name": row.what,
        "figure": row.value,
        "unit": row.unit,
        "low": row.low,
        "high": row.high,
        "fits": row.fits,
        "why": "" if row.fits else row.why,
    }
