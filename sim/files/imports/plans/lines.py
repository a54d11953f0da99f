"""Lines of a plan: polylines in metres, which become walls, and the polygons in which people may walk, if it has any."""

from dataclasses import dataclass

import numpy as np

from worlds.errors import InputError

MOST_POINTS = 100_000
"""Of a plan."""
SAME = 1e-9
"""Points nearer than this [m] are one."""


@dataclass(frozen=True)
class Plan:
    """Polylines, each (P, 2) [m] in the plan's own frame; rings are polylines that end where they begin.

    walkable: which of them are the outer border of where people walk.
    """

    lines: tuple[np.ndarray, ...]
    walkable: tuple[int, ...] = ()

    def scaled(self, scale: float) -> "Plan":
        """The plan in other units: so many metres in one of its own."""
        return Plan(tuple(scale * line for line in self.lines), self.walkable)


def checked(path: str, plan: Plan) -> Plan:
    """The plan without points that are there twice. Raises InputError where it has nothing, or too much."""
    lines, walkable = list[np.ndarray](), list[int]()
    for k, line in enumerate(plan.lines):
        apart = np.hypot(*np.diff(line, axis=0).T) > SAME
        kept = line[np.concatenate([[True], apart])]
        if len(kept) > 1:
            walkable += [len(lines)] if k in plan.walkable else []
            lines.append(kept)
    count = sum(len(line) for line in lines)
    if not lines:
        raise InputError(f"{path}: holds no lines and no polygons, so there is nothing to make walls of")
    if count > MOST_POINTS:
        raise InputError(f"{path}: {count:,} points; {MOST_POINTS:,} at most: leave layers out, or simplify the plan")
    return Plan(tuple(lines), tuple(walkable))
