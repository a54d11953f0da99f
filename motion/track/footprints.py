"""Timed footprints: what motion consumes (paper, section 2.1)."""

from typing import NamedTuple

import numpy as np


class Track(NamedTuple):
    """n footprints in the order of their contacts, world frame, SI units.

    Footprint i stands over [contact, contact + stance]; contact[i + 1] = contact[i] + step_time[i]. Standing still is a
    footprint coincident with the same foot's last one, whose stance ends exactly at the new contact.
    """

    side: np.ndarray  # (n,) int64, 0 left, 1 right
    position: np.ndarray  # (n, 3) middle of the sole [m]
    heading: np.ndarray  # (n,) [rad], counter-clockwise from +x, unwrapped: neighbours differ by the turn
    normal: np.ndarray  # (n, 3) unit normal of the sole
    contact_time: np.ndarray  # (n,) [s]
    stance_time: np.ndarray  # (n,) [s]
    step_time: np.ndarray  # (n,) [s] until the next footfall
    roll: np.ndarray  # (n, 2) where on the sole the support begins and ends: 0 heel, 1 toe, 0.5 the middle
    nominal_length: np.ndarray  # (n,) comfortable virtual leg over this footprint [m]: less is crouched
    facing: np.ndarray  # (n,) how far the body turns away from the feet over this footprint [rad]
    lift: np.ndarray  # (n,) [m] height of the swing that arrives here above the line between its ends
    hold: np.ndarray  # (n,) share of that swing, at either end, in which the foot goes only up or down
