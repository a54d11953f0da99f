"""The rows of `bench` for jams and beginnings."""

import numba

from sim.bench import jams
from sim.reports.flows import ring


def test_jams_and_beginnings_cost_something_and_are_told():
    threads = numba.get_num_threads()
    figures = jams.report(ring, 0.2, 20)
    assert numba.get_num_threads() == threads
    costs = figures["ms_per_character_second"]
    assert set(costs) == {"1", "2"} and min(costs.values()) > 0 and figures["begin_s"]["20"] > 0
    jam, beginning = jams.in_words(figures)
    assert "at 1," in jam and "at 2 per square metre" in jam and beginning.startswith("20 wanderers")
