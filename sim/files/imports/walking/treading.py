"""Treads: when a body passes over which foot, along a course.

A foot is set down so that the body is over it half a stance later. So a tread is a moment t of the course and a foot beside
the place there; its contact is half a stance earlier. The next tread is a step time of the present speed later
(`pace`), on the other foot, unless neither foot has anywhere to go: then the walker stands until one has. A file's
own footsteps are treads as they are.
"""

from typing import NamedTuple

import numpy as np

from motion.arithmetic.angles import wrapped
from motion.characters.dimensions import Dimensions
from motion.track.footprints import LEFT, RIGHT
from planner.stepping.beside import beside, middle_of
from sim.files.imports.trajectories.ways import Way
from sim.files.imports.walking.course import GRAIN, Course
from sim.files.imports.walking.pace import Pace

WORTH = 0.14
"""A foot moves for no less than this share of the preferred step, or this share of the sharpest turn."""
STARTS = 0.45
"""Who stands takes a first step once the way has gone on by this share of a step at its speed."""
GATHERS = 1.0
"""Who waits for longer than this many slow steps brings its feet together meanwhile."""
QUICKEST = 0.6
"""A step takes no less than this share of the one before."""


class Tread(NamedTuple):
    """A foot that is set down."""

    side: int
    x: float
    y: float
    heading: float
    contact: float  # [s]
    after: float  # step time that its speed asks for [s]
    over: float = np.nan  # when the body is to be over it [s], where it may be moved for that


class Stood(NamedTuple):
    """Where a foot is."""

    x: float
    y: float
    heading: float


def standing_at(course: Course, biped: Dimensions, time: float) -> list[Stood]:
    """Both feet beside the place of a time."""
    heading = course.heading_at(time)
    return [Stood(*beside(biped, side, course.at(time), heading), heading) for side in (LEFT, RIGHT)]


def own_treads(way: Way, course: Course, biped: Dimensions, pace: Pace) -> list[Tread]:
    """The footsteps that a way has itself, left and right in turn: the body over each when it ends.

    Before and behind them one walks as the course is led on; the feet meet where one waits, and at the end.
    """
    at = np.flatnonzero(way.landed).tolist()
    taken, last, side = _led(course, biped, pace, RIGHT, way.begin, -1.0), np.inf, RIGHT
    for k in at:
        since = float(way.time[k] - way.time[k - 1])
        if float(way.time[k - 1]) - last > GATHERS * pace.step(0.0):
            taken.append(_beside(taken[-1], biped, pace))
            side = taken[-1].side
        side, last = 1 - side, float(way.time[k])
        speed = float(np.hypot(*(way.place[k] - way.place[k - 1]))) / max(since, 1e-9)
        heading = course.heading_at(last)
        x, y = beside(biped, side, (float(way.place[k, 0]), float(way.place[k, 1])), heading)
        taken.append(Tread(side, x, y, heading, last - 0.5 * pace.stance(speed), min(pace.step(speed), since)))
    taken += _led(course, biped, pace, 1 - side, last, 1.0)
    return [*taken, _beside(taken[-1], biped, pace)]


def _led(course: Course, biped: Dimensions, pace: Pace, side: int, at: float, sign: float) -> list[Tread]:
    """Treads from foot `side` on along what a course is led on by: before its begin (sign -1), in their order, or behind it."""
    found, least = list[Tread](), WORTH * float(biped.gait.preferred_step)
    speed = course.speed(at - 0.4, at) if sign > 0 else course.speed(at, at + 0.4)
    if not (course.leaves if sign > 0 else course.enters):
        return found
    time = pace.step(speed)
    at += time if sign > 0 else 0.0
    while course.time[0] + time < at < course.time[-1] and time * course.speed(at - time, at) > least:
        heading = course.heading_at(at)
        x, y = beside(biped, side, course.at(at), heading)
        found.append(Tread(side, x, y, heading, at - 0.5 * pace.stance(course.speed(at - time, at)), time))
        side, at = 1 - side, at + sign * time
    return found if sign > 0 else found[::-1]


def _beside(last: Tread, biped: Dimensions, pace: Pace) -> Tread:
    """The other foot comes beside the one that was set down last."""
    side, middle = 1 - last.side, middle_of(biped, last.side, (last.x, last.y), last.heading)
    x, y = beside(biped, side, middle, last.heading)
    return Tread(side, x, y, last.heading, last.contact + pace.step(0.0), pace.step(0.0))


def treads(course: Course, biped: Dimensions, pace: Pace) -> list[Tread]:
    """All footsteps along a course, from standing where it begins to standing where it ends."""
    walker = _Walker(course, biped, pace)
    while walker.step():
        pass
    return walker.taken


class _Walker:
    """Goes along the course, tread by tread."""

    def __init__(self, course: Course, biped: Dimensions, pace: Pace) -> None:
        self.course, self.biped, self.pace = course, biped, pace
        self.now = float(course.time[0])
        self.feet = standing_at(course, biped, self.now)
        self.taken: list[Tread] = []
        self.stands, self.last, self.before = True, RIGHT, pace.step(0.0)

    def step(self) -> bool:
        """The next tread; False where there is none until the course ends."""
        at = self._next_moment()
        last = float(self.course.time[-1])
        while at <= last:
            side = self._side_to_move(at)
            if side is not None and not (self.stands and self._has_hardly_begun(at)):
                self._take(side, at)
                return True
            if not self.stands:
                self.stands = True
            at += GRAIN
        return False

    def _next_moment(self) -> float:
        """When the body is to be over the next foot."""
        speed = self.course.speed(self.now, self.now + self.before)
        time = max(self.pace.step(speed), QUICKEST * self.before)
        return self.now + time

    def _wanted(self, side: int, at: float) -> Stood:
        heading = self.course.heading_at(at)
        held = self.feet[1 - side].heading
        most = float(self.biped.reach.max_turn)
        heading = held + float(np.clip(wrapped(heading - held), -most, most))
        return Stood(*beside(self.biped, side, self.course.at(at), heading), heading)

    def _lacks(self, side: int, at: float) -> float:
        """How far a foot is from where it is wanted, 1 where that is worth a step."""
        foot, wanted = self.feet[side], self._wanted(side, at)
        far = np.hypot(wanted.x - foot.x, wanted.y - foot.y) / float(self.biped.gait.preferred_step)
        turned = abs(wanted.heading - foot.heading) / float(self.biped.reach.max_turn)
        return float(max(far, turned)) / WORTH

    def _side_to_move(self, at: float) -> int | None:
        """The other foot than the last, where it has somewhere to go; of one who stands the one that lags, else none."""
        other = 1 - self.last
        lack = [self._lacks(side, at) for side in (LEFT, RIGHT)]
        if not self.stands:
            return other if max(lack) >= 1 else None
        if max(lack) < 1:
            return None
        return other if lack[other] >= 0.9 * lack[self.last] else self.last

    def _has_hardly_begun(self, at: float) -> bool:
        """Whether who stands had better wait: its first step is about half a step of the speed to come."""
        (x, y), (u, v) = self.course.at(at), self.course.at(self.now)
        time = self.pace.step(self.course.speed(at, at + self.before))
        ahead = self.course.speed(at, at + time) * time
        return float(np.hypot(x - u, y - v)) < STARTS * ahead

    def _take(self, side: int, at: float) -> None:
        foot, speed = self._wanted(side, at), self.course.speed(self.now, at)
        if self.stands:
            speed = self.course.speed(at - 0.5 * self.before, at + 0.5 * self.before)
        time = self.pace.step(speed)
        contact = at - 0.5 * self.pace.stance(speed)
        if self.taken:
            contact = max(contact, self.taken[-1].contact + 0.5 * self.taken[-1].after)
        self.taken.append(Tread(side, *foot, contact, time, at))
        self.feet[side] = foot
        self.now, self.last, self.before, self.stands = at, side, time, False
