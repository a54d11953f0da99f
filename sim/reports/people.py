"""A figure of ours beside people's."""

from typing import NamedTuple


class Row(NamedTuple):
    """A figure of ours, and the range (inclusive) in which people's lie."""

    what: str
    unit: str
    value: float
    low: float
    high: float

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
