"""Who comes into a level and goes out of it: the tables [[population]], [[source]], [[waiting]] and [[exit]], as checked data.

An area is a polygon of three or more corners, or a rectangle of two opposite ones [m].
"""

from typing import Annotated, Any, Self

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, model_validator

MOST_TABLES = 100
"""Of each kind."""
Coordinate = Annotated[float, Field(ge=-1e5, le=1e5, allow_inf_nan=False, strict=True)]
Corner = tuple[Coordinate, Coordinate]
Area = Annotated[list[Corner], Field(min_length=2, max_length=200)]
Name = Annotated[str, Field(min_length=1, max_length=100)]
Names = Annotated[list[Name], Field(max_length=MOST_TABLES)]
Seconds = Annotated[float, Field(ge=0, le=1e6, allow_inf_nan=False, strict=True)]
Share = Annotated[float, Field(gt=0, le=1e6, allow_inf_nan=False, strict=True)]
Speed = Annotated[float, Field(gt=0.05, le=20, allow_inf_nan=False, strict=True)]
Spread = Annotated[float, Field(ge=0, le=10, allow_inf_nan=False, strict=True)]
Scale = Annotated[float, Field(ge=0.05, le=20, allow_inf_nan=False, strict=True)]
Years = Annotated[float, Field(ge=5, le=100, allow_inf_nan=False, strict=True)]
Rate = Annotated[float, Field(ge=0, le=100, allow_inf_nan=False, strict=True)]
Count = Annotated[int, Field(ge=0, le=200_000, strict=True)]
GROUPS = Annotated[list[Share], Field(min_length=1, max_length=6)]


class _Part(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=False, frozen=True)


class Population(_Part):
    """[[population]]: people that are alike but for chance."""

    name: Name
    share: Share = 1.0  # of all populations that a source, or a run, draws from
    character: Name = "human"
    speed: tuple[Speed, Spread] | None = None  # mean and standard deviation of what they prefer [m/s]
    ages: Annotated[list[tuple[Years, Years, Share]], Field(min_length=1, max_length=20)] | None = None
    size: tuple[Scale, Spread] = (1.0, 0.0)  # mean and standard deviation, of the character's
    reaction: tuple[Seconds, Seconds] = (0.0, 0.0)  # they set out so long after they have come: from, to [s]
    groups: GROUPS | None = None  # shares of those who come alone, by two, by three, ...

    @model_validator(mode="after")
    def _one_law_of_speed(self) -> Self:
        if self.speed is not None and self.ages is not None:
            raise ValueError("speed and ages: either one tells how fast they walk; leave one out")
        for begin, end, _ in self.ages or ():
            if begin >= end:
                raise ValueError(f"ages = [{begin:g}, {end:g}, ...]: from the younger to the older")
        if self.reaction[0] > self.reaction[1]:
            raise ValueError(f"reaction = {list(self.reaction)}: the shorter time first")
        return self


class Exit(_Part):
    """[[exit]]: who comes there is gone."""

    name: Name
    area: Area


class Waiting(_Part):
    """[[waiting]]: people who come by stay there for a while."""

    name: Name
    area: Area
    seconds: tuple[Seconds, Seconds]  # from, to

    @model_validator(mode="after")
    def _in_order(self) -> Self:
        if self.seconds[0] > self.seconds[1]:
            raise ValueError(f"seconds = {list(self.seconds)}: the shorter time first")
        return self


class Source(_Part):
    """[[source]]: people come in there, as a Poisson process."""

    area: Area
    rate: Rate = 0.0  # people per second
    at_first: Count = 0  # so many are there at the beginning
    most: Count | None = None  # no more than so many in all
    after: Seconds = 0.0  # the first comes later than this [s]
    population: Names = []  # which of them; none: all
    via: Names = []  # waiting areas, one after the other
    to: Names = []  # exits, of which each takes the one where it is soonest; none: all


class Traffic(_Part):
    """All of it."""

    population: Annotated[list[Population], Field(max_length=MOST_TABLES)] = []
    source: Annotated[list[Source], Field(max_length=MOST_TABLES)] = []
    waiting: Annotated[list[Waiting], Field(max_length=MOST_TABLES)] = []
    exit: Annotated[list[Exit], Field(max_length=MOST_TABLES)] = []

    def areas(self) -> dict[str, list[Corner]]:
        """Every area by its key in the file."""
        kinds: dict[str, list[Any]] = {"source": self.source, "waiting": self.waiting, "exit": self.exit}
        return {f"{key}.{k}.area": one.area for key, tables in kinds.items() for k, one in enumerate(tables)}


def corners(area: list[Corner]) -> np.ndarray:
    """(P, 2) corners of an area as a polygon [m]: two are opposite ones of a rectangle."""
    points = np.array(area, np.float64)
    if len(points) > 2:
        return points
    (x0, y0), (x1, y1) = points.tolist()
    return np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])
