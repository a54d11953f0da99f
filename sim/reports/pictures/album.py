"""The album of `verify --pictures`: it takes cases as they come, and draws what they show."""

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from sim.reports.flows import Flow
from sim.reports.people import Case, Row, Weighed
from sim.reports.pictures.crowds import Spot, plot_circle, plot_density, plot_flows, plot_lanes, plot_speeds
from sim.reports.pictures.weights import plot_weights

DENSE = 2.0
"""The bottleneck of this width [m] is shown from above."""


class Album:
    """Takes cases of `verify` as they come, and draws what they show."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._spots: dict[str, list[Spot]] = {"speeds": [], "flows": []}
        self._flows: dict[str, Flow] = {}
        self._weighed: list[Weighed] = []

    def take(self, case: Case, found: list[Flow], row: Row) -> None:
        """Keeps what is to be drawn of a case."""
        if case.shows in self._spots:
            self._spots[case.shows].append(Spot(case.at, row.value))
        if case.shows in ("lanes", "circle") and case.shows not in self._flows:
            self._flows[case.shows] = found[0]
        if case.shows == "flows" and case.at == DENSE:
            self._flows["density"] = found[0]

    def weigh(self, rows: Iterable[Weighed]) -> None:
        """Keeps what weights do, to be drawn too."""
        self._weighed = list(rows)

    def draw(self) -> list[Path]:
        """The pictures that were written: those of which there is something to draw."""
        jobs: list[tuple[str, Callable[[Any, Path], None], Any]] = [
            ("speeds", plot_speeds, self._spots["speeds"]),
            ("flows", plot_flows, self._spots["flows"]),
            ("lanes", plot_lanes, self._flows.get("lanes")),
            ("density", plot_density, self._flows.get("density")),
            ("circle", plot_circle, self._flows.get("circle")),
            ("weights", plot_weights, self._weighed),
        ]
        done = []
        for name, plot, of in jobs:
            if of:
                done.append(self.folder / f"crowd_{name}.png")
                plot(of, done[-1])
        return done
