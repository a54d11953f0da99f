"""Supporting forces: what each foot carries of the force that a motion needs (paper, section 2.4).

Unit mass: a force in N per kg of the body, w = a - g the one that is needed. A standing leg pushes along K = unit(com - s), s
its point of support, and never pulls; two share w by the non-negative combination of their pushes that is nearest to it, as in
the solver's cone (motion.com.cost, whose |w - F| is the physics cost):

    flight         F = 0
    single stance  F = max(0, w.K) K
    double stance  F = a1 K1 + a2 K2,  a1 = (w.K1 - k w.K2) / (1 - k^2),  k = K1.K2, where a1 and a2 are positive;
                   or else the leg that pushes more carries alone

Times a body's mass [kg] they are newtons; over 9.81 m/s^2, body weights.
"""

import numpy as np

from motion.arithmetic.gravity import GRAVITY

_NEARLY_PARALLEL = 1e-9
"""Legs whose 1 - k^2 is less than this are one leg."""
LEAST = 0.3
"""Upward forces below so many body weights slip over nothing that matters."""


def needed_force(acceleration: np.ndarray) -> np.ndarray:
    """w = a - g (F, 3) [N/kg] of accelerations (F, 3) of the centre of mass [m/s^2]."""
    return acceleration + np.array([0.0, 0.0, GRAVITY])


def friction(needed: np.ndarray) -> np.ndarray:
    """What forces (F, 3), of any unit of weight in which one is 1, need of the ground: level by upward, (F,); 0 where the
    upward one is below LEAST."""
    level, upward = np.hypot(needed[:, 0], needed[:, 1]), needed[:, 2]
    return np.where(upward < LEAST, 0.0, level / np.maximum(upward, LEAST))


def demands(acceleration: np.ndarray) -> dict[str, float]:
    """What a motion asks of its legs and the ground, of accelerations (F, 3) [m/s^2]: the largest force and its largest change
    from one frame to the next, in body weights, and the friction."""
    needed = needed_force(acceleration) / GRAVITY
    changes = np.linalg.norm(np.diff(needed, axis=0), axis=1)
    return {
        "force": float(np.linalg.norm(needed, axis=1).max()),
        "force_change": float(changes.max(initial=0.0)),
        "friction": float(friction(needed).max()),
    }


def supporting_forces(
    com: np.ndarray, acceleration: np.ndarray, point_of_support: np.ndarray, contact: np.ndarray
) -> np.ndarray:
    """Force of the ground on each foot (F, 2, 3) [N/kg], world frame, left first; zero for a foot that does not stand.

    com, acceleration: (F, 3) [m], [m/s^2]; point_of_support: (F, 2, 3) [m], NaN where a foot swings; contact: (F, 2) bool.
    """
    needed = needed_force(acceleration)
    leg = np.where(contact[..., None], com[:, None] - point_of_support, 0.0)
    leg /= np.maximum(np.linalg.norm(leg, axis=2, keepdims=True), 1e-300)
    push = np.einsum("fli,fi->fl", leg, needed)
    k = np.einsum("fi,fi->f", leg[:, 0], leg[:, 1])
    apart = 1 - k * k
    both = contact.all(axis=1) & (apart > _NEARLY_PARALLEL)
    both &= (push[:, 0] > k * push[:, 1]) & (push[:, 1] > k * push[:, 0])
    shared = (push - k[:, None] * push[:, ::-1]) / np.where(both, apart, 1.0)[:, None]
    alone = np.where(contact, push, -np.inf)
    carries = np.stack([alone[:, 0] >= alone[:, 1], alone[:, 0] < alone[:, 1]], axis=1)
    single = np.where(carries & contact, np.maximum(push, 0.0), 0.0)
    return np.where(both[:, None], shared, single)[..., None] * leg


def impulses(time: np.ndarray, force: np.ndarray, contact: np.ndarray) -> np.ndarray:
    """Impulse (F, 2, 3) [N s/kg] that each foot has received since it landed, by trapezoids; zero where it does not stand.

    time: (F,) [s]; force: (F, 2, 3) as `supporting_forces` has it; contact: (F, 2) bool.
    """
    gain = np.zeros_like(force)
    gain[1:] = 0.5 * (force[1:] + force[:-1]) * np.diff(time)[:, None, None]
    landed = contact & ~np.concatenate([np.zeros_like(contact[:1]), contact[:-1]])
    begin = np.maximum.accumulate(np.where(landed, np.arange(len(time))[:, None], 0), axis=0)
    total = np.cumsum(gain, axis=0)
    before = np.take_along_axis(total - gain, np.broadcast_to(begin[..., None], force.shape), axis=0)
    return np.where(contact[..., None], total - before, 0.0)
