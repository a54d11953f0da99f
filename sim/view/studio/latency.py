"""How long a drag takes from the mouse's move to the picture: in the real window, offscreen, on scenes of several lengths."""

import time as clock
from typing import NamedTuple

import numpy as np

from planner.script.footprint import Footprint
from sim.files.studio.document import Document, Spot, new_document
from sim.files.studio.keeping import Opened
from sim.view.studio.desk.desk import Desk
from sim.view.studio.pictures import window
from sim.view.studio.studio import Studio

MOVES, WARM = 120, 60
"""Moves that are measured, and frames before."""
STEP = 0.6


class Latency(NamedTuple):
    """Of one scene [ms]."""

    footprints: int
    median_ms: float
    p95_ms: float
    solve_ms: float  # of it, the edit and its solution, median
    within_33_ms: float  # share of the moves


def walk_of(count: int) -> Document:
    """A straight walk of so many footprints."""
    plain = new_document()
    side = ("left", "right")
    prints = tuple(
        Footprint(side=side[i % 2], position=(1.5 + STEP * max(i - 1, 0), 4.0 + 0.06 * (1 - 2 * (i % 2))))  # type: ignore[arg-type]
        for i in range(count)
    )
    world = plain.head.world.model_copy(update={"size": (STEP * count + 6.0, 8.0)})
    return Document(plain.head.model_copy(update={"world": world}), (plain.tracks[0].model_copy(update={"footprint": prints}),))


def latencies(counts: tuple[int, ...] = (40, 400)) -> list[Latency]:
    """Drags a footprint in the middle of walks of so many. Raises NoGL."""
    studio, found = window(Desk(), (960, 540), 1.0), []
    studio.screen.steady = False
    for count in counts:
        studio.desk.take(Opened(walk_of(count), None))
        found.append(_dragged(studio, count))
    studio.screen.close()
    return found


def _dragged(studio: Studio, count: int) -> Latency:
    """A footprint is dragged in circles; each move is handled and drawn."""
    desk, views, spot = studio.desk, studio.views, Spot(0, count // 2)
    views.look(desk)
    place = views.prints[0].place[spot.number]
    desk.playing.time = float(desk.act(0).laid.footprints.contact_time[desk.act(0).laid.row[spot.number]])
    views.plan.centre, views.plan.zoom = place[:2].copy(), 80.0
    views.space.camera.target = place + np.array([0.0, 0.0, 0.6])
    for _ in range(WARM):
        studio.frame(1 / 60)
    at = views.plan.project(place[None])[0]
    pg = studio.pygame
    _event(studio, pg.MOUSEMOTION, at, rel=(0, 0), buttons=(0, 0, 0))
    _event(studio, pg.MOUSEBUTTONDOWN, at, button=1)
    whole, solving = [], []
    for k in range(MOVES):
        to = at + 12 * np.array([np.cos(k / 9), np.sin(k / 9)])
        begin = clock.perf_counter()
        _event(studio, pg.MOUSEMOTION, to, rel=(1, 1), buttons=(1, 0, 0))
        solved = clock.perf_counter()
        studio.frame(1 / 60)
        whole.append(1e3 * (clock.perf_counter() - begin))
        solving.append(1e3 * (solved - begin))
    _event(studio, pg.MOUSEBUTTONUP, at, button=1)
    times = np.array(whole)
    median, most, solve = (float(np.round(v, 1)) for v in (np.median(times), np.percentile(times, 95), np.median(solving)))
    return Latency(count, median, most, solve, float(np.round((times <= 33).mean(), 3)))


def _event(studio: Studio, kind: int, at: np.ndarray, **rest: object) -> None:
    studio.handle(studio.pygame.event.Event(kind, pos=(int(at[0]), int(at[1])), **rest))
