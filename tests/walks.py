"""Walks with known footprints, for tests."""

import numpy as np

from motion.arithmetic.gravity import pendulum_time
from motion.com import laying, newton
from motion.com.guess import straight_guess
from motion.com.problem import Layout
from motion.track.curve import Curve
from motion.track.footprints import Footprints
from worlds.compiled.tables import empty


def straight_walk(biped, count=14, stride=1.0, turn=0.0):
    """Footprints of steady steps of `stride` preferred ones; `turn` [rad] per step bends the way into a circle."""
    side, yaw = np.arange(count) % 2, turn * np.arange(count)
    along = np.cumsum(np.stack([np.cos(yaw), np.sin(yaw)], axis=1) * stride * biped.gait.preferred_step, axis=0)
    across = np.stack([-np.sin(yaw), np.cos(yaw)], axis=1) * (biped.gait.step_width / 2 * (1 - 2 * side))[:, None]
    time = 0.5 * pendulum_time(biped.timing.hip_height) / pendulum_time(0.92)
    footprints = empty(Footprints, count)
    footprints.side[:], footprints.heading[:] = side, yaw
    footprints.position[:, :2] = along + across
    footprints.contact_time[:], footprints.stance_time[:], footprints.step_time[:] = time * np.arange(count), 1.2 * time, time
    footprints.roll[:] = 0.0, 1.0
    footprints.nominal_length[:] = biped.leg.nominal_length
    footprints.lift[:], footprints.hold[:] = 0.05, 0.1
    return footprints


def solved(biped, footprints):
    """The curve over them, from the second contact to the last."""
    contact = footprints.contact_time
    problem, support = laying.build_problem(biped, footprints, contact[1], contact[-1], Layout(5, False, False, False, 0.0))
    control = np.zeros((len(problem.time), 6))
    straight_guess(problem, control, 0)
    newton.minimise(problem, control, newton.SCENE)
    return Curve(problem.time, control, np.vstack([support, [[-1, -1]]]))
