"""Steps for a speed: the stride law of the automatic timing (planner.stepping.timing), read the other way round."""

from dataclasses import dataclass

import numpy as np

from motion.characters.character import Character
from planner.stepping import timing

LENGTHS = 60
SHORTEST, LONGEST = 0.04, 1.4
"""Steps of the table, in leap lengths: runners stretch theirs beyond one."""


@dataclass(frozen=True)
class Pace:
    """What steps a character takes at a speed; tables of k steps, from short to long."""

    speeds: np.ndarray  # (k,) ascending [m/s]
    step_time: np.ndarray  # (k,) [s]
    stance_time: np.ndarray  # (k,) [s]

    def step(self, speed: float) -> float:
        """Seconds from contact to contact."""
        return float(np.interp(speed, self.speeds, self.step_time))

    def stance(self, speed: float) -> float:
        """Seconds that a foot stands."""
        return float(np.interp(speed, self.speeds, self.stance_time))

    @property
    def fastest(self) -> float:
        """No step is faster than this [m/s]."""
        return float(self.speeds[-1])


def pace_of(character: Character) -> Pace:
    """The table of a character, on the flat, straight on."""
    biped = character.biped
    lengths = np.linspace(SHORTEST, LONGEST, LENGTHS) * float(biped.reach.leap_length)
    times = np.array([timing.step_timing(biped, length, 0.0, 0.0, False, timing.UNHURRIED, True, np.inf) for length in lengths])
    return Pace(np.maximum.accumulate(lengths / times[:, 0]), times[:, 0], times[:, 1])
