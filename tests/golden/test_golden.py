"""The golden runs are what they were, to the bit; on other libraries than they were made with, to a micrometre."""

import numpy as np
import pytest

from tests.golden import runs

NEAR = 1e-6
"""How far [m, s] a run may be from the kept one where libraries round otherwise."""


@pytest.mark.parametrize("name", runs.RUNS)
def test_run_is_what_it_was(name):
    hashes, libraries = runs.kept()
    run = runs.made(name)
    if runs.digest(run) == hashes[name]:
        return
    for key, array in runs.thinned(run).items():
        before = runs.kept_values(name)[key]
        assert array.shape == before.shape, f"{key}: {array.shape}, was {before.shape}"
        assert np.abs(array - before).max(initial=0.0) <= NEAR, f"{key} is elsewhere"
    if libraries == runs.libraries():
        pytest.fail("other bits than were kept, though no value is more than a micrometre off")
    pytest.skip(f"within {NEAR} m of the run made with {libraries}; these are {runs.libraries()}")


def test_every_run_is_kept():
    assert set(runs.kept()[0]) == set(runs.RUNS)
