"""The forces that are shown are those whose lack is the physics cost."""

import numpy as np
import pytest

from motion.measures.pushes import pushes_of
from tests.reference import GRAVITY, physics_cost


@pytest.mark.parametrize("seed", range(200))
def test_what_is_missing_is_as_large_as_the_cost(seed):
    chance = np.random.default_rng(seed)
    com, acceleration = chance.normal(size=3) + (0, 0, 1.0), chance.normal(size=3) * 6
    support, standing = chance.normal(size=(2, 3)) * 0.5, chance.random(2) < 0.7
    found = pushes_of(com, acceleration, support, standing)
    assert np.linalg.norm(found.missing) == pytest.approx(physics_cost(com, acceleration, list(support[standing])), abs=1e-9)
    np.testing.assert_allclose(found.legs.sum(axis=0) + found.missing, acceleration - GRAVITY, atol=1e-9)
    for leg in range(2):
        push = found.legs[leg] @ (com - support[leg])
        assert push >= -1e-9 and (standing[leg] or not found.legs[leg].any())
