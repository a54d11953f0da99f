"""What each term of the cost of a step pays: a ring, a bottleneck, a counterflow and a circle without it, as a table."""

from collections.abc import Iterator

from planner.round.weights import NUMBERS, PEOPLE, Weights
from sim.reports import flows
from sim.reports.flows import Flow
from sim.reports.throngs import cases, figures

SCALES = {"horizon": "touch", "distance": "near"}
"""Weights that are no terms, but scales of one."""
SECONDS, LONGEST = 20.0, 120.0
"""For which the ring is looked at, and at most the others [s]."""


def table() -> Iterator[str]:
    """Line by line, in Markdown."""
    yield f"| without | ring at 2 per square metre | bottleneck 1.2 m | counterflow, 60 a side | {cases.EACH} on a circle |"
    yield "|---|---|---|---|---|"
    yield _row("nothing", PEOPLE)
    for name in NUMBERS:
        if name not in SCALES:
            yield _row(name, PEOPLE.of(name, 0.0))


def _row(name: str, weights: Weights) -> str:
    """Flows of one table of weights."""
    ring = flows.watched(flows.ring(2.0, weights), SECONDS, bodies=True)
    neck = flows.watched(flows.bottleneck(1.2, weights=weights), LONGEST, flows.DOOR[0] + 1.5, True)
    sim = flows.counterflow(60, weights=weights)
    middle = sim.world.size[0] / 2
    against = flows.watched(sim, LONGEST, middle, True)
    circle = cases.swap(weights)
    last, still = flows.last_through(against), figures.still_longest(against, middle)
    return (
        f"| {name} | {flows.ring_speed(ring):.2f} m/s{_touches(ring)} | {flows.specific_flow(neck, 1.2):.2f}{_touches(neck)} | "
        f"{last:.0f} s, longest standstill {still:.0f} s{_touches(against)} | "
        f"{cases.last_across(circle):.0f} s, longest standstill {cases.still_before(circle):.0f} s |"
    )


def _touches(flow: Flow) -> str:
    """How long bodies overlap, where they do for long."""
    longest = figures.longest_overlap(flow)
    return f", bodies overlap for {longest:.1f} s" if longest > 0.5 else ""
