"""Edits that need to know how a track is walked now: its times scaled, a walk made a run, prints snapped to what is there."""

from math import radians

import numpy as np

from planner.stepping.timing import RUNNING_DUTY, duty_factor, hip_pendulum, least_step_time
from sim.files.studio.document import Spot, footprint_at
from sim.files.studio.edits import Put, Retime
from sim.view.studio.desk.desk import Desk
from worlds.queries import terrain_height

WALK, RUN = "walk", "run"
ON_ROCK = 0.6
"""A rock this near [m] is snapped to."""
TREAD = 0.02
"""Places that differ less than this in height [m] are of one tread."""


def _times(desk: Desk, spot: Spot) -> tuple[float, float]:
    """Step and stance time [s] that a footprint now has."""
    laid = desk.act(spot.track).laid
    row = laid.row[spot.number]
    return float(laid.footprints.step_time[row]), float(laid.footprints.stance_time[row])


def scale_time(desk: Desk, factor: float) -> None:
    """What is chosen takes so many times as long."""
    times = [_times(desk, spot) for spot in desk.spots]
    if times:
        steps, stances = (tuple(round(factor * t[k], 4) for t in times) for k in (0, 1))
        desk.do(Retime(desk.spots, steps, stances, "Slow down" if factor > 1 else "Speed up"))


def make(desk: Desk, gait: str) -> None:
    """Gives what is chosen the times of a walk or a run: running feet stand a third of the stride, walking ones nearly two."""
    if not desk.selection:
        desk.say("Choose footprints first: click one, or draw a box around several")
        return
    steps, stances = [], []
    for spot in desk.spots:
        biped, step = desk.act(spot.track).character.biped, _times(desk, spot)[0]
        if gait == RUN:
            step = min(step, 1.25 * float(hip_pendulum(biped)))
            duty = RUNNING_DUTY
        else:
            step = max(step, 1.35 * float(least_step_time(biped, 0.0)))
            duty = float(duty_factor(0.2, 0.0, biped.timing.walking_duty))
        steps.append(round(step, 4))
        stances.append(round(2 * duty * step, 4))
    desk.do(Retime(desk.spots, tuple(steps), tuple(stances), f"Make it a {gait}"))


def snap(desk: Desk) -> None:
    """Puts what is chosen onto the rock that is near, or onto the middle of its tread."""
    spots, places = [], []
    for spot in desk.spots:
        one = footprint_at(desk.document, spot)
        place = _snapped(desk, one.position, radians(one.heading_deg))
        if place is not None:
            spots.append(spot)
            places.append(place)
    if spots:
        desk.do(Put(tuple(spots), tuple(places)))
    else:
        desk.say("Nothing to snap to: no rock within 0.6 m, no tread under these footprints")


def _snapped(desk: Desk, place: tuple[float, float], heading: float) -> tuple[float, float] | None:
    world = desk.show.world
    if len(world.rocks):
        away = np.hypot(world.rocks[:, 0] - place[0], world.rocks[:, 1] - place[1])
        k = int(away.argmin())
        if away[k] <= max(ON_ROCK, float(world.rocks[k, 2])):
            return float(world.rocks[k, 0]), float(world.rocks[k, 1])
    if world.terrain in ("stairs", "spiral_stairs"):
        ends = [_edge(desk, place, heading + turn) for turn in (0.0, np.pi)]
        if all(end is not None for end in ends):
            (a, b), (c, d) = ends  # type: ignore[misc]
            return 0.5 * (a + c), 0.5 * (b + d)
    return None


def _edge(desk: Desk, place: tuple[float, float], angle: float) -> tuple[float, float] | None:
    """Where the tread under a place ends in a direction; None where it does not within a metre."""
    arrays, (x, y) = desk.show.world.arrays, place
    level = terrain_height(arrays, x, y)
    for away in np.arange(0.0, 1.0, 0.01):
        u, v = x + away * np.cos(angle), y + away * np.sin(angle)
        if abs(terrain_height(arrays, float(u), float(v)) - level) > TREAD:
            return float(u), float(v)
    return None
