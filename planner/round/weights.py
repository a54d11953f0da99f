"""What a step among others costs: one table of weights, which is the same for all that are alike.

A candidate footprint costs the sum of the terms of planner.crowd.terms; each line below is the weight of one of them, or the
scale of what it measures. Lengths and times are in the character's own units, so that birds, people and dinosaurs do alike: a
stride is its preferred step [m], a swing the pendulum time sqrt(h / g) of its hips [s].
"""

from math import inf
from typing import Any, NamedTuple

import numpy as np


class Weights(NamedTuple):
    """Costs are counted in progress: 1 is to stand for the time of a step."""

    progress: float = 1.0
    """Of speed lost on the wished course; more of it presses on, and turns aside less."""
    turn: float = 0.15
    """Of a radian that the foot turns off the wished course, or the body goes off its heading: more of it walks straighter."""
    gap: float = 0.91
    """Time gap kept to who is ahead, in swings: more of it follows from further behind, and flows less."""
    ahead: float = 3.55
    """How far one looks at how dense it is ahead, in strides, to walk as slowly as that tells: more of it speeds up sooner
    where a throng ends ahead, and flows more; 0 does not look."""
    meet: float = 0.2
    """Share of the full speed that one gives up while anyone comes against it as near ahead as it looks for how dense it is:
    more of it passes others more slowly."""
    touch: float = 0.35
    """Of an early touch, per 1 / swings of time until then, at full speed: more of it swerves earlier and wider."""
    horizon: float = 6.0
    """Touches later than this, in swings, do not matter."""
    near: float = 0.2
    """Of having others near, each: more of it spreads out."""
    distance: float = 0.2
    """By which having others near fades, in strides: more of it feels further."""
    side: float = 1.5
    """Of leaving those who come against one on the right: streams part into lanes, each to its own right."""
    around: float = 0.8
    """Radians by which one goes to the right of a throng that comes in the open: more of it makes wider roundabouts; a quarter
    turn leads nowhere."""
    rank: float = 2.5
    """Of resting where one who has waited longer would go: more of it makes way, and backs off, sooner."""
    stand: float = 0.18
    """Of standing still: more of it shuffles on."""
    model: str = "steps"
    """Who reads the table, one of MODELS."""

    def of(self, name: str, value: float) -> "Weights":
        """The same, but for one of the numbers."""
        return self._replace(**{name: value})  # type: ignore[arg-type]


PEOPLE = Weights()
"""As measured (docs/crowds.md)."""
MODELS = ("steps", "orca")
"""How one chooses among others: the step that costs least (planner.crowd.choosing), or a velocity that avoids all for a while
(planner.velocities.orca), for which none of these weighs anything."""
NUMBERS = tuple(name for name in Weights._fields if name != "model")
WEIGHTS = np.dtype([(name, np.float64) for name in NUMBERS])


def table_of_weights(weights: Weights, kinds: int) -> Any:
    """(kinds,) records of WEIGHTS, for kernels. Raises ValueError for a weight below 0, since bounds of costs count
    on that, and for a model that there is not."""
    numbers = tuple(getattr(weights, name) for name in NUMBERS)
    for name, weight in zip(NUMBERS, numbers, strict=True):
        if not 0 <= weight < inf:
            raise ValueError(f"weights.{name}: {weight} is no weight of a step's cost; allowed are numbers from 0 on")
    if weights.model not in MODELS:
        raise ValueError(f"weights.model: {weights.model!r} is no model of walking among others; there are {', '.join(MODELS)}")
    return np.array([numbers] * kinds, WEIGHTS).view(np.recarray)
