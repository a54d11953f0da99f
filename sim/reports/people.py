"""A figure of ours beside people's."""

from collections.abc import Callable, Iterator
from functools import partial
from statistics import median
from typing import Any, NamedTuple

SEEDS, MANY = (1, 2, 3), tuple(range(1, 10))
"""Figures that chance changes are medians over these seeds, of MANY where it changes them most; where nothing may last longer
than a bound, maxima."""


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
        """The figure with its unit, in three digits, or as many as it takes to see whether it fits."""
        for digits in range(3, 10):
            figure = f"{self.value:.{digits}g}"
            if (self.low <= float(figure) <= self.high) == self.fits:
                break
        return f"{figure} {self.unit}".rstrip()

    @property
    def verdict(self) -> str:
        """Whether it fits, in a word."""
        return "fits" if self.fits else "does NOT fit"


WAYS, BODIES, STANDING = "ways", "bodies", "standing"
"""What is drawn of people: where they went, their bodies at a moment, or who of them stands then."""


class Weighed(NamedTuple):
    """A little scene at several values of a weight of what a step costs."""

    weight: str
    more: str  # what more of it does
    values: list[float]
    flows: list[Any]  # sim.reports.flows.Flow, of each value
    figures: list[float]
    words: list[str]  # what each figure tells
    box: tuple[float, float, float, float]  # what is shown: least and largest x, least and largest y [m]
    drawn: str  # WAYS, BODIES or STANDING
    moment: float  # at which bodies are shown [s]


Figure = Callable[[list[Any]], float]
"""Of all simulations of a case."""


def by_seeds(*runs: Callable[..., Any], seeds: tuple[int, ...] = SEEDS) -> list[Callable[[Any], Any]]:
    """The same simulations with one seed after the other."""
    return [partial(run, seed=seed) for seed in seeds for run in runs]


def median_of(figure: Figure, runs: int = 1) -> Figure:
    """The median of the figures of so many `runs` of each seed."""
    return lambda all: float(median(figure(some) for some in _in_parts(all, runs)))


def worst_of(figure: Figure, runs: int = 1) -> Figure:
    """The largest of the figures of so many `runs` of each seed."""
    return lambda all: max(figure(some) for some in _in_parts(all, runs))


def _in_parts(all: list[Any], size: int) -> Iterator[list[Any]]:
    return (all[k : k + size] for k in range(0, len(all), size))
