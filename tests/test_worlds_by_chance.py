"""In sensible worlds made by chance every character stands well, whatever the planner; more of them by a command."""

from collections import Counter

import pytest

from tests import worlds_by_chance


@pytest.mark.parametrize("first", range(0, 48, 16))
def test_nobody_stands_where_no_foot_may(first):
    found = sum((worlds_by_chance.faults(k, 15.0) for k in range(first, first + 16)), Counter())
    assert found.pop("none", 0) < 10 and found == {}


@pytest.mark.parametrize("k", [69, 157, 332, 770])
def test_what_was_found_once_is_not_found_again(k):
    """A rock before a walker, a start on a rock, legs too long on a steep slope, a sole that fits on few places."""
    assert worlds_by_chance.faults(k, 24.0) == {}
