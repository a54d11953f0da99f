"""A scripted scene: all footprints are known, so the whole curve is optimised at once, and time only shows it."""

import numpy as np

from motion.characters.biped import load_biped
from motion.com import newton, window
from planner import plan
from planner.script import script as scripts
from planner.script.scene import Scene
from sim.rows import row as rows
from sim.rows.crowd import above_feet, track_of
from sim.rows.steps import lay_way, set_timing, write
from sim.stage.cast import TICK_RATE, Cast
from worlds.compiled.jit import jit, jit_borrowing
from worlds.errors import InputError

SAMPLES = 10
SHORTEST_SWING = 0.05
"""A foot must have left for this long [s] before it lands again."""


@jit
def perform(crowd, bipeds, w, c, script, samples, by_step, effort):
    """Lets character c, which stands, do all of a planner.script.script.Script, and then stand; returns (E, iterations)."""
    for k in range(len(script.side)):
        n = crowd.real[c]
        write(crowd, bipeds, c, n, plan.scripted(bipeds[crowd.kind[c]], w, script, k, track_of(crowd, c, n)))
        _own_timing(crowd, bipeds, c, n, script, k)
        crowd.nominal_length[c, n] *= script.crouch[k]
        crowd.facing[c, n] = script.facing[k]
        crowd.real[c] = n + 1
    n = crowd.real[c]
    crowd.roll[c, n - 2 : n, 1] = 0.5
    if script.support != scripts.ROLL:
        crowd.roll[c, 2:n] = 0.5 if script.support == scripts.MIDDLE else 1.0
    end = crowd.contact_time[c, n - 1] + script.rest
    crowd.stance_time[c, n - 2 : n] = end + plan.STAND_TIME - crowd.contact_time[c, n - 2 : n]
    for k in range(2, n):
        lay_way(crowd, bipeds, w, c, k)
    finish = np.empty(6)
    above_feet(bipeds[crowd.kind[c]], track_of(crowd, c, n), finish)
    time, control, support, e, iterations = window.optimise_track(
        bipeds[crowd.kind[c]], track_of(crowd, c, n), crowd.curve_time[c, 0], end, crowd.control[c, 0], finish, samples,
        by_step, effort,
    )  # fmt: skip
    rows.commit(crowd, c, time, control, support, end)
    return e, iterations


@jit_borrowing
def _own_timing(crowd, bipeds, c, n, script, k):
    """Timing given by the script replaces the automatic one (NaN: none)."""
    step, stance = crowd.step_time[c, n - 1], crowd.stance_time[c, n - 1]
    if not np.isnan(script.stance_time[k]):
        stance = script.stance_time[k]
    elif not np.isnan(script.step_time[k]):
        stance *= script.step_time[k] / step
    if not np.isnan(script.step_time[k]):
        step = script.step_time[k]
    set_timing(crowd, bipeds[crowd.kind[c]], c, n, script.wait[k] > 0, step, stance)


class Performance(Cast):
    """One character that does what a scene says, and then stands."""

    def __init__(self, scene: Scene, tick_rate: int = TICK_RATE, effort: newton.Effort = newton.SCENE):
        biped = load_biped(scene.character)
        prints = scripts.prints_of(scene, biped)
        script = scripts.script_of(scene, prints)
        room = len(script.side) + 2
        super().__init__(scene.world, [biped], 0, tick_rate, rows=room, segments=2 * room + 2)
        self.scene = scene
        heading = np.unwrap(np.radians([p.heading_deg for p in prints[:2]]))
        places = np.array([(*p.position, h) for p, h in zip(prints[:2], heading, strict=True)])
        self.stand(0, int(prints[1].side == "right"), places)
        w = self.world.arrays
        by_step = scene.segments == "step"
        self.cost, self.iterations = perform(self.crowd, self.bipeds, w, 0, script, SAMPLES, by_step, effort)
        self.end = float(self.crowd.curve_time[0, self.crowd.curve_count[0]])
        self._check(scene)
        self.crowd.real[0] = 2
        self.footprints.keep(self.crowd)
        for n in range(3, room + 1):  # the log takes rows as if they had just been placed
            self.crowd.real[0] = n
            self.footprints.add(self.crowd, np.ones(1, np.int64))

    @property
    def over(self) -> bool:
        """Whether the script has ended."""
        return self.time >= self.end

    def moment(self, time: float | None) -> float:
        """The time [s] that is shown for `time`, by default now; before the beginning and after the end it stands."""
        return min(max(super().moment(time), 0.0), self.end - 1e-9)

    def _check(self, scene: Scene) -> None:
        """A foot must leave before it lands again."""
        track = self.track(0)
        last: dict[int, int] = {}
        for n, side in enumerate(track.side.tolist()):
            moved = side in last and np.abs(track.position[n] - track.position[last[side]]).max() > 1e-9
            left = track.contact_time[last[side]] + track.stance_time[last[side]] if moved else -np.inf
            if left > track.contact_time[n] - SHORTEST_SWING:
                x, y, _ = track.position[n]
                raise InputError(
                    f"{scene.name}: the {'right' if side else 'left'} foot lands on ({x:.2f}, {y:.2f}) at "
                    f"{track.contact_time[n]:.2f} s but has left its last footprint only at {left:.2f} s; "
                    "give that footprint a shorter stance_time, or the steps between longer step_times"
                )
            last[side] = n
