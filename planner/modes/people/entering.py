"""Those who come in: as many as are due, as there are free rows for, and as have room."""

import numpy as np

from motion.characters.character import Character
from planner.modes.people.areas import places_in
from planner.modes.people.crowding import Grid
from planner.modes.people.gates import MARGIN, PLACE, Gates, go_on
from planner.modes.visiting import Visits
from planner.planner import Coming, Moment, fault_of_place
from planner.round.reservations import STRAY, body_sizes
from planner.stepping.field import course_down

FREE_AGAIN = 0.5
"""A row is free so long [s] after somebody has gone."""
MOST_AT_ONCE = 200
"""So many come in at a moment, at most."""
AT_FIRST = 40
"""Those who are there at the beginning look for room so many times as often as others."""


def let_in(plans: Visits, gates: Gates, moment: Moment, grid: Grid) -> list[Coming]:
    """Those who come in now: as many as are due, have room, and for whom there are free rows."""
    gates.draw(plans, moment.seed, moment.time)
    come: list[Coming] = []
    there = np.flatnonzero(plans.there)
    ways = ((moment.place, moment.between), (moment.between, moment.rest))
    taken = [[*begin, *end] for starts, ends in ways for begin, end in zip(starts[there], ends[there], strict=True)]
    wide = 2 * [_reach(moment.characters[c]) for c in there]
    for s in range(len(gates.traffic.source)):
        while plans.let_in[s] < plans.drawn[s] and len(come) < MOST_AT_ONCE * (AT_FIRST if moment.time == 0 else 1):
            one = _next_of(plans, gates, moment, grid, s, (taken, wide))
            if one is None:
                break
            come.append(one)
    return come


def _reach(character: Character) -> float:
    """How far the body reaches, however it turns and strays [m]."""
    return 0.5 * float(body_sizes(character.biped).max()) + STRAY * float(character.biped.gait.step_width)


def _next_of(
    plans: Visits, gates: Gates, moment: Moment, grid: Grid, s: int, others: tuple[list[list[float]], list[float]]
) -> Coming | None:  # fmt: skip
    """The next of a source, where a row is free and there is room for it; others: their ways (x, y, x, y), and how far they
    reach."""
    serial = int(plans.let_in[s])
    head = gates.head(moment.seed, s, serial, int(plans.head[s]))
    person = gates.person(moment.seed, s, serial, head)
    row = _free_row(plans, moment, person.character)
    if row is None:
        return None
    place = _room_at(plans, gates, moment, (s, serial, head), person.character, others)
    if place is None:
        return None
    plans.head[s], plans.let_in[s] = head, serial + 1
    others[0].append([*place, *place])
    others[1].append(_reach(person.character))
    _enter(plans, row, moment, (s, serial, head), place)
    seen = moment._replace(characters=[person.character if c == row else one for c, one in enumerate(moment.characters)])
    if person.reaction > 0:
        plans.rest[row] = moment.time + person.reaction
        plans.area[row], plans.stops.field[row, 0], plans.stops.again[row] = gates.to[s][0], -1, False
    else:
        go_on(plans, gates, seen, grid, row)
    a = int(plans.area[row])
    x, y = place.tolist()
    heading = course_down(plans.stops.fields[a], grid.cell, x, y, 0.0)
    if fault_of_place(moment.world, person.character, (x, y, heading)) is not None:
        heading = 0.0
    return Coming(row, person.character, x, y, heading)


def _enter(plans: Visits, row: int, moment: Moment, who: tuple[int, int, int], place: np.ndarray) -> None:
    """Somebody (source, serial, first of its group) is in a row from now on."""
    s, serial, head = who
    plans.there[row], plans.since[row], plans.source[row], plans.serial[row] = True, moment.time, s, serial
    plans.stage[row], plans.rest[row], plans.group[row] = 0, 0.0, head
    stops = plans.stops
    stops.start[row] = stops.stops[row, 0] = place
    stops.reached[row], stops.pace[row], stops.draw[row] = 0, 1.0, 0.0
    moment.place[row] = moment.rest[row] = place


def _free_row(plans: Visits, moment: Moment, character: Character) -> int | None:
    """A row for somebody: one that was of its kind, where there is one; None: all are in use."""
    free = np.flatnonzero(~plans.there & ((plans.until == 0) | (plans.until < moment.time - FREE_AGAIN)))
    wanted = character.biped.tobytes()  # type: ignore[attr-defined]
    for row in free.tolist():
        if moment.characters[row].biped.tobytes() == wanted and moment.characters[row].name == character.name:  # type: ignore[attr-defined]
            return row
    return int(free[0]) if len(free) else None


def _room_at(
    plans: Visits, gates: Gates, moment: Moment, who: tuple[int, int, int], character: Character,
    others: tuple[list[list[float]], list[float]],
) -> np.ndarray | None:  # fmt: skip
    """(2,) a place of a source that is clear of the world and of others, near its group; None: there is none just now."""
    s, serial, head = who
    times = AT_FIRST if moment.time == 0 else 1
    for again in range(times):
        look = (s, serial * AT_FIRST + again if times > 1 else int(moment.time * 60) + 7919 * serial)
        places = places_in(gates.sources[s], moment.seed, look, PLACE, MARGIN)
        friends = np.flatnonzero(plans.there & (plans.source == s) & (plans.group == head))
        if serial > head and len(friends):
            places = places[np.hypot(*(places - moment.place[friends].mean(axis=0)).T).argsort(kind="stable")]
        for place in places:
            if _is_free(place, _reach(character), others) and fault_of_place(moment.world, character, (*place, 0.0)) is None:
                return place
    return None


def _is_free(place: np.ndarray, reach: float, others: tuple[list[list[float]], list[float]]) -> bool:
    if not others[0]:
        return True
    begin, end = np.split(np.array(others[0]), 2, axis=1)
    way, off = end - begin, place - begin
    share = np.clip((way * off).sum(axis=1) / np.maximum((way * way).sum(axis=1), 1e-12), 0, 1)
    apart = np.hypot(*(off - share[:, None] * way).T)
    return bool((apart > reach + np.array(others[1])).all())
