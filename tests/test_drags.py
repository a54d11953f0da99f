"""Daggers that are dragged move the shown body by no jump; a large run is `python -m tests.drags`."""

import pytest

from tests import drags


@pytest.mark.parametrize("scene", ["fig17_small_leap", "one_leg_hops"])
def test_no_dagger_moves_the_shown_body_by_more_than_a_centimetre_for_5_ms(scene, monkeypatch, tmp_path):
    monkeypatch.setenv("FOOTFALL_STATE", str(tmp_path))
    found = list(drags.drags(scene))
    assert len(found) > 10 and max(one.shown for one in found) < 0.01
    assert max(one.solved for one in found) > 0.01  # which is no wonder where that does not jump either
