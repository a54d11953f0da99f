"""How the window of stepping stones is begun."""

import numpy as np

from motion.track.curve import Curve
from sim.rows.stone_windows import Expected, retime
from worlds.compiled.tables import empty


def test_a_curve_is_told_at_the_times_of_other_contacts():
    """A straight line in the share of the time between contacts stays one, with the velocity that belongs to it."""
    was, now = Expected(1.0, 2.0, 2.5, 3.5), Expected(1.0, 1.8, 2.6, 3.2)
    window = empty(Curve, 6)
    window.time[:] = [0.5, 1.0, 1.5, 2.0, 2.25, 3.0]
    window.control[:, 3] = 1.0
    before = window.control.copy()
    retime(window, 5, was, now)
    np.testing.assert_allclose(window.time, [0.5, 1.0, 1.4, 1.8, 2.2, 3.0])
    np.testing.assert_allclose(window.control[:, 3], [1.0, 1.0, 1.25, 1.25, 0.625, 1.0])
    assert np.array_equal(window.control[:, :3], before[:, :3])
