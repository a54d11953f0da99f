"""The kernels that a person waits for, by plain names, with the types that they are called with: for the first start."""

from typing import Any

import numpy as np

from motion import motion
from motion.characters.character import load_character
from motion.characters.dimensions import Dimensions
from motion.com import newton, window
from motion.pose import turning
from motion.pose.bones import Bones, Placed
from motion.pose.pose import empty_pose
from motion.pose.posing import pose_some
from motion.track import curve, phases
from motion.track.curve import Curve
from motion.track.footprints import STEP, Footprints
from planner.modes import visiting
from planner.modes.people.visitors import Visiting
from planner.modes.steer import Steered
from planner.modes.wander import Wander
from planner.river import grid, moves, search
from planner.river.rock_hop import RockHop
from planner.round.weights import PEOPLE
from planner.script import laying
from planner.stepping import beside, field, timing
from sim.rows import crowd as crowds
from sim.rows import posing, rounds
from sim.stage.cast import TICK_RATE, Cast
from worlds import queries
from worlds.arrays import WorldArrays
from worlds.compiled.tables import empty
from worlds.world import World

PLANNERS: dict[str, Any] = {"wandering": Wander, "steering": Steered, "visiting": Visiting, "crossing": RockHop}


def steps() -> dict[str, list[tuple[Any, tuple]]]:
    """Kernels by plain names, with arguments of the types that they are called with."""
    world = World("warm-up", (10.0, 10.0), start=(5.0, 5.0))
    cast = Cast(world, [load_character("bird")], 0, TICK_RATE)
    crowd, bipeds, w, biped = cast.crowd, cast.bipeds, world.arrays, cast.bipeds[0]
    one, matrix = np.zeros(2, np.int64), np.zeros((2, 3))
    span, nothing = window.Span(0.0, 0.0, matrix, matrix, matrix), empty(Curve, 1)
    spots, land = moves.Spots(matrix, one, np.zeros((2, 2), np.int64)), grid.empty_grid(1, 1)
    return {
        "window solve": [(rounds.optimise_step, ())],
        "placing footprints": [(rounds.plan_step, ())],
        "going around others": [(rounds.go_around[PEOPLE.model], ())],
        **{name: [(planner.planning.part, ())] for name, planner in PLANNERS.items()},
        "ways": [(field.lay_out, (biped, w, 0.0, matrix)), (field.sweep, (matrix, 0.0, matrix.astype(np.float32)))],
        "tick of the crowd": [(rounds.advance_all, (rounds.Parts(0, 0), 0, 0.0, one, 0))],
        "poses": [
            (pose_some, ()),
            (posing.pose_rows, (0, 0, 0.0, one, empty_pose(1))),
            (posing.com_all, (0, 0.0, matrix)),
        ],
        "bones": [
            (turning.fill_all_bones, (biped, empty_pose(1), empty(Bones, 1))),
            (curve.evaluate, (empty(Curve, 2), 0.0, *np.zeros((3, 3)))),
            (phases.phase_of, (0, 0)),
            (turning.lay_bones, (empty(Bones, 1), one, matrix, matrix, Placed(matrix[None], matrix[None], matrix[None]))),
        ],
        "standing": [
            (crowds.stand, (crowd, bipeds, w, 0, 0, matrix, 0.0, False)),
            (rounds.publish_all, (0, one)),
            (beside.beside, (biped, 0, (0.0, 0.0), 0.0)),
        ],
        "ground": _ground(w),
        "speeds of people": [(visiting.speeds_of, (bipeds, np.zeros(1), np.zeros(1)))],
        "stride law": [(timing.step_timing, (biped, 0.0, 0.0, 0.0, False, 0.0, True, 0.0))],
        "route search": [(search.find, (biped, spots, land, 0, 0))],
        "laying footprints": _laying(biped, w, matrix),
        "edited curves": [
            (window.optimise_track, (biped, empty(Footprints, 1), span, nothing, window.SCENE, newton.SCENE)),
        ],
        "whole curves": [(motion.solve_track, (biped, empty(Footprints, 1), 0.0, matrix, window.SCENE, newton.SCENE))],
    }


def _laying(biped: Dimensions, world: WorldArrays, matrix: np.ndarray) -> list[tuple[Any, tuple]]:
    """Laying the footprints of a scene."""
    footprints, steps = empty(Footprints, 1), np.zeros(1, STEP)
    return [
        (laying.lay_steps, (biped, world, footprints, 0, matrix, steps, np.zeros(1))),
        (laying.by_themselves, (biped, world, footprints, 0, matrix, steps)),
        (laying.finish_steps, (biped, world, footprints, 0.0, 0.0)),
    ]


def _ground(world: WorldArrays) -> list[tuple[Any, tuple]]:
    """What is asked of the world by all that draw and place."""
    at_a_place = (
        queries.clearance, queries.terrain_height, queries.in_water, queries.tree_clearance, queries.wall_clearance,
        queries.border_clearance,
    )  # fmt: skip
    return [
        (queries.rock_under, (world, 0.0, 0.0, 0.0)),
        (queries.survey, (world, np.zeros((2, 2)), np.zeros((2, 3)))),
        *((kernel, (world, 0.0, 0.0)) for kernel in at_a_place),
    ]
