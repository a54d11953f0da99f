"""The commands of the command line, by name: where each is, so that a command loads what it needs and no more."""

import sys
from importlib import import_module
from typing import Any

from planner.planner import NoWay
from sim.cli.status import BAD_INPUT, DONE, IMPOSSIBLE
from worlds.errors import InputError

COMMANDS = {
    "wander": "walks.walk",
    "steer": "walks.walk",
    "river": "walks.walk",
    "crowd": "walks.walk",
    "play": "scenes.play",
    "edit": "show.edit",
    "sheets": "scenes.sheets",
    "check": "scenes.check",
    "export": "exporting.export",
    "measure": "reporting.measured_run",
    "timing": "reporting.timing",
    "literature": "reporting.people",
    "bench": "reporting.bench",
    "batch": "batching.batch",
    "import-plan": "plans.plan",
    "import-trackway": "imports.trackway",
    "import-trajectories": "imports.trajectories",
    "verify": "reporting.verified",
    "trials": "trying.trials",
}


def run(options: Any) -> int:
    """Runs the command of `options`; returns its status, DONE where it tells none. Errors of people become one message."""
    module, _, name = COMMANDS[options.command].partition(".")
    try:
        status = getattr(import_module(f"sim.cli.{module}"), name)(options)
        return DONE if status is None else status
    except InputError as error:
        print(f"footfall: {error}", file=sys.stderr)
        return BAD_INPUT
    except NoWay as error:
        print(f"footfall: {error}", file=sys.stderr)
        return IMPOSSIBLE
