"""What of a run is to be exported, and as what; checked before anything is done."""

from typing import NamedTuple

from worlds.errors import InputError

MOST_RATE = 240.0
"""Moments per second."""


class Asked(NamedTuple):
    """The options of `export`. None: what the source has."""

    character: int | None = None  # only this one
    begin: float | None = None  # [s] of the run
    end: float | None = None
    rate: float | None = None  # moments per second
    array: str | None = None  # .csv: this array of a recording
    scenery: bool = False  # terrain, trees, rocks and water too, where a format can hold them
    size: tuple[int, int] = (960, 540)  # of films [pixels]

    def check(self) -> "Asked":
        """Raises InputError where that is none of what can be asked for."""
        begin, end = self.begin, self.end
        if begin is not None and end is not None and not 0 <= begin < end <= 1e6:
            raise InputError(f"--between {begin:g} {end:g}: two times, the first the earlier, 0 to 1000000 s, are needed")
        if self.rate is not None and not 1 <= self.rate <= MOST_RATE:
            raise InputError(f"--fps {self.rate:g}: 1 to {MOST_RATE:g} is allowed")
        return self
