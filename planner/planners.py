"""The planners that ship, by the names that saved states know them by."""

from collections.abc import Callable

from planner.modes.acting import Acting
from planner.modes.external import External
from planner.modes.people.visitors import Visiting
from planner.modes.steer import Steered
from planner.modes.walk_to import WalkTo
from planner.modes.wander import Wander
from planner.planner import Planner
from planner.river.rock_hop import RockHop

PLANNERS: dict[str, Callable[..., Planner]] = {
    kind.name: kind for kind in (Wander, RockHop, WalkTo, External, Steered, Visiting, Acting)
}
