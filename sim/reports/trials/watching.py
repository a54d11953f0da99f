"""What is looked at while somebody is driven: kinks and kicks of the joints, one after the other, from poses alone."""

from typing import NamedTuple

import numpy as np

from motion.measures.joints import angles
from motion.measures.kinks import APART, STEPS, kinks
from motion.pose.pose import empty_pose
from sim.stage.simulation import Simulation

POINTS = ("com", "neck", "head", "shoulder", "elbow", "hand", "tail", "hip", "knee", "hock", "ankle", "heel", "ball", "toe")
"""What of a pose moves smoothly, if anything does."""
LEGS = ("knee", "hock", "ankle", "heel", "ball", "toe")
_BENT = ("hip", "knee", "hock", "ankle", "heel", "ball", "body_rotation_wxyz")
KICK = 10
"""So many moments of each tick are compared."""


class Worst(NamedTuple):
    """The largest value so far: of what, and when."""

    value: float = 0.0
    joint: str = ""
    time: float = 0.0  # [s]

    def beside(self, value: float, joint: str, time: float) -> "Worst":
        """The larger one."""
        return Worst(value, joint, time) if value > self.value else self


class Watch:
    """The joints of the first character of a simulation, in the ticks that are done."""

    def __init__(self, sim: Simulation) -> None:
        self.sim, self._row = sim, np.zeros(1, np.int64)
        self._three = bool(sim.characters[0].biped.leg.metatarsus > 0)
        self._seen, self._last, self._pose = sim.time, np.zeros((0, len(LEGS), 2, 3)), empty_pose(1)
        self.jump, self.turn, self.kick = Worst(), Worst(), Worst()
        """Jumps of velocities where phases change [m/s, rad/s]; the most by which a leg's joint changes its own in 1/600 s."""

    def look(self) -> None:
        """After a tick. Of the one before it everything is known, up to its end and a little beyond."""
        until = self.sim.time - 1 / self.sim.tick_rate
        for time in self._changes(self._seen, until):
            self._kinks_at(time)
        self._kicks()
        self._seen = until

    def _changes(self, begin: float, end: float) -> list[float]:
        """When feet land or leave, after `begin` and up to `end` [s]."""
        prints = self.sim.track(0)
        leaves = prints.contact_time + prints.stance_time
        every = np.concatenate([prints.contact_time[~prints.stands], leaves])
        return [t for t in np.unique(every).tolist() if max(begin, 0.01) < t <= end]

    def _kinks_at(self, time: float) -> None:
        poses = [self.sim.snapshot(time + k * APART, self._row) for k in STEPS]
        for name in POINTS:
            jumps = np.linalg.norm(kinks(np.stack([getattr(pose, name)[0] for pose in poses])), axis=-1)
            self.jump = self.jump.beside(float(np.max(jumps)), name, time)
        bent = angles({name: np.concatenate([getattr(pose, name) for pose in poses]) for name in _BENT}, self._three)
        for name, angle in bent.items():
            self.turn = self.turn.beside(float(np.abs(kinks(angle)).max()), name, time)

    def _kicks(self) -> None:
        rate = self.sim.tick_rate * KICK
        path = np.empty((KICK, len(LEGS), 2, 3))
        for k in range(KICK):
            self.sim.pose_into(self._pose, self.sim.time - (KICK - 1 - k) / rate, self._row)
            for j, name in enumerate(LEGS):
                path[k, j] = getattr(self._pose, name)[0]
        path = np.concatenate([self._last, path])
        kicks = np.linalg.norm(np.diff(path, 2, axis=0), axis=-1).max(axis=2) * rate
        self._last = path[-2:]
        if len(kicks):
            when, which = np.unravel_index(int(kicks.argmax()), kicks.shape)
            moment = self.sim.time - (len(kicks) - 1 - int(when)) / rate
            self.kick = self.kick.beside(float(kicks.max()), LEGS[int(which)], moment)
