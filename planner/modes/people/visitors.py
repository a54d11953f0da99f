"""The planner of a level that people come into and go out of: sources, waiting areas, exits (worlds.contents.traffic)."""

from functools import cached_property
from typing import Any

import numpy as np

from motion.characters.character import Character
from planner.modes.people import entering, gates, groups
from planner.modes.people.areas import places_in
from planner.modes.people.crowding import Grid, grid_of, weigh
from planner.modes.people.gates import PLACE, Gates
from planner.modes.people.mix import Mix
from planner.modes.visiting import PLANNING, Visits, empty_visits
from planner.planner import Moment, Situation, Turnover, fault_of_place
from planner.stepping.field import for_all
from worlds.contents.traffic import Traffic, corners
from worlds.errors import InputError
from worlds.level import faults_of
from worlds.reading import checked
from worlds.world import World

RETHINK = 2.0
"""Seconds between two looks at the crowd: ways and exits are weighed anew."""
NEAR = 0.2
"""A stop on the way is reached within this distance [m]."""
ROOM = 0.3
"""Everyone starts so far [m] from the border of its source, where that is wide enough."""


class Visiting:
    """People who come in at sources, by populations, wait, and go out by exits; C rows hold those who are there.

    traffic: the tables, as data or as plain values. weighs: whether ways and exits take account of how crowded they are.
    Raises InputError.
    """

    name = "Visiting"
    planning = PLANNING

    def __init__(self, traffic: Traffic | dict, weighs: bool = True) -> None:
        self.traffic = traffic if isinstance(traffic, Traffic) else checked("traffic", traffic, Traffic)
        if faults := faults_of(self.traffic):
            raise InputError("\n".join(faults))
        if not self.traffic.source:
            raise InputError("source: nobody comes in; give a [[source]] with area and rate, or at_first")
        self.weighs, self.mix = bool(weighs), Mix(self.traffic.population)
        self._grid: tuple[World, Grid] | None = None

    @cached_property
    def gates(self) -> Gates:
        """What the tables say, by numbers."""
        return Gates(self.traffic, self.mix)

    def starts(self, world: World, characters: list[Character], seed: int) -> np.ndarray:
        """(C, 3) x, y, heading: everyone is away at first, and kept where the first source has room for one."""
        polygon = corners(self.traffic.source[0].area)
        for x, y in places_in(polygon, seed, (0, 0), PLACE, ROOM).tolist():
            if all(fault_of_place(world, one, (x, y, 0.0)) is None for one in {c.name: c for c in characters}.values()):
                return np.tile([x, y, 0.0], (len(characters), 1))
        raise InputError(
            f"{world.name}: source.0.area: nobody of the {characters[0].name}'s size has room there; make it larger"
        )

    def grid(self, world: World) -> Grid:
        """The cells of a world, for its areas and those who come."""
        if self._grid is None or self._grid[0] is not world:
            self._grid = (world, grid_of(world, for_all([one.biped for one in self.mix.characters]), self.gates.polygons))
        return self._grid[1]

    def prepare(self, situation: Situation) -> Visits:
        """Nobody is there at first; whoever was stays."""
        grid, before, count = self.grid(situation.world), situation.before, len(situation.characters)
        plans = before or empty_visits(count, len(self.traffic.source), len(self.gates.polygons))
        stops = plans.stops
        fields = np.empty((len(grid.area), *grid.slowness.shape), np.float32)
        weigh(grid, np.zeros((0, 2)), fields)
        if before is None:
            stops.near[:] = NEAR
            stops.stops[:] = situation.feet.position[:, :, :2].mean(axis=1)[:, None]
            stops.start[:] = stops.stops[:, 0]
            plans.due[:] = [self.gates.first(situation.seed, s) for s in range(len(plans.due))]
        return plans._replace(stops=stops._replace(fields=fields, cell=np.array([grid.cell])))

    def come_and_go(self, plans: Visits, moment: Moment) -> Turnover:
        """Who goes and who comes now; sets where those go who are there."""
        grid, stops = self.grid(moment.world), plans.stops
        gone = gates.let_out(plans, self.gates, moment)
        there = np.flatnonzero(plans.there)
        thinks = round(1000 * moment.time) % round(1000 * RETHINK) == 0
        if thinks and self.weighs and len(there):
            weigh(grid, moment.place[there], stops.fields)
        gates.lead(plans, self.gates, moment, grid, thinks)
        groups.keep_together(plans, moment)
        return Turnover(gone, entering.let_in(plans, self.gates, moment, grid))

    def there(self, plans: Visits, time: float) -> np.ndarray:
        """(C,) bool: in whose row somebody is at a time [s]; of former times only those of the last one are known."""
        return (plans.since <= time + 1e-9) & (plans.there | (time < plans.until - 1e-9))

    def counts(self, plans: Visits) -> dict[str, Any]:
        """How many came, went, by which exit, are there and wait outside."""
        first = len(self.traffic.waiting)
        exits = {one.name: int(plans.gone[first + k]) for k, one in enumerate(self.traffic.exit)}
        came = int(plans.let_in.sum())
        outside = int(plans.drawn.sum()) - came
        return {
            "came": came,
            "went": int(plans.gone.sum()),
            "exits": exits,
            "there": int(plans.there.sum()),
            "outside": outside,
        }

    def check_plans(self, plans: Visits, characters: int) -> None:
        """Whether plans from a file are of these tables. Raises ValueError."""
        areas, sources, stops = len(self.gates.polygons), len(self.traffic.source), plans.stops
        same = len(plans.there) == characters and stops.stops.shape == (characters, 1, 2) and stops.fields.ndim == 3
        same &= stops.field.shape == (characters, 1) and stops.draw.shape == (characters, 2) and min(stops.fields.shape) > 0
        same &= len(stops.fields) == areas == len(plans.gone) == len(plans.last) and stops.cell.shape == (1,)
        same &= all(len(column) == sources for column in (plans.due, plans.drawn, plans.let_in))
        if not same or not stops.cell[0] > 0 or not np.abs(stops.stops).max() < 1e9:
            raise ValueError("plans: of other sources, areas or rows than the planner's")
        for column, low, high in ((stops.field, -1, areas), (plans.area, 0, areas), (plans.source, 0, sources)):
            if not low <= column.min() <= column.max() < high:
                raise ValueError("plans: an area or a source that there is not")

    def values(self) -> dict:
        """What it was made with."""
        return {"traffic": self.traffic.model_dump(mode="json"), "weighs": self.weighs}
