"""A figure of ours beside people's."""

from collections.abc import Callable
from typing import Any, NamedTuple


class Case(NamedTuple):
    """Something of which people's figure is known: simulations, by weights of what a step costs, and the figure of all."""

    name: str
    unit: str
    low: float
    high: float
    runs: list[Callable[[Any], Any]]  # Weights -> sim.reports.flows.Flow
    figure: Callable[[list[Any]], float]
    number: int = 0  # of the RiMEA guideline
    why: str = ""  # said where it does not fit
    shows: str = ""  # the picture that its figure, or where people went, is drawn in
    at: float = 0.0  # where it is drawn: density [1/m^2], or width [m]


class Row(NamedTuple):
    """A figure of ours, and the range (inclusive) in which people's lie."""

    what: str
    unit: str
    value: float
    low: float
    high: float
    why: str = ""  # where it does not fit

    @property
    def fits(self) -> bool:
        """Whether ours lies in the range."""
        return self.low <= self.value <= self.high

    @property
    def told(self) -> str:
        """The figure with its unit."""
        return f"{self.value:.3g} {self.unit}".rstrip()

    @property
    def verdict(self) -> str:
        """Whether it fits, in a word."""
        return "fits" if self.fits else "does NOT fit"
