"""A scripted scene: all footprints are known, so the whole curve is optimised at once, and time only shows it."""

import numpy as np

from motion.characters.character import Character, load_character
from motion.com import newton, window
from motion.motion import Motion, solve
from planner.script.laying import laid
from planner.script.review import review
from planner.script.scene import Scene
from sim.stage.cast import TICK_RATE, Cast


class Performance(Cast):
    """One character that does what a scene says, and then stands."""

    def __init__(
        self, scene: Scene, character: Character | None = None, tick_rate: int = TICK_RATE,
        effort: newton.Effort = newton.SCENE,
    ) -> None:  # fmt: skip
        """character: who does it, the scene's own by default. Raises InputError where feet cannot do that.

        `warnings` tells what will be ugly.
        """
        who = character or load_character(scene.character, scene.character_scale)
        given = scene.footprints_of(who)
        self.warnings = review(given, who, scene.world.arrays, scene.name)
        footprints = laid(given, who, scene.world.arrays, scene.stand_before, scene.stand_after, scene.support, scene.name)
        self.scene, self.room = scene, len(footprints.side)
        end = float(footprints.contact_time[-1]) + scene.stand_after
        layout = window.LAYOUTS[scene.segments]
        self.motion = solve(footprints, who, end, layout, effort)
        super().__init__(scene.world, [who], 0, tick_rate, rows=self.room, segments=len(self.motion.curve.time))
        self._show(self.motion)

    def _show(self, motion: Motion) -> None:
        """Puts a motion into the crowd's only row; the log takes its footprints as if they had just been placed."""
        row = self.crowd
        for column, values in zip(row.footprints, motion.footprints, strict=True):
            column[0] = values
        for column, values in zip(row.committed, motion.curve, strict=True):
            column[0, : len(values)] = values
        row.segments[0], row.number[0], row.real[0] = len(motion.curve.time) - 1, 1, 2
        row.standing[0] = True
        self.footprints.keep(row)
        for n in range(3, self.room + 1):
            row.real[0] = n
            self.footprints.add(row, np.ones(1, np.int64))

    @property
    def end(self) -> float:
        """When the script ends [s]."""
        return self.motion.end

    @property
    def over(self) -> bool:
        """Whether the script has ended."""
        return self.time >= self.end

    def moment(self, time: float | None) -> float:
        """The time [s] that is shown for `time`, by default now; before the beginning and after the end it stands."""
        return min(max(super().moment(time), 0.0), self.end - 1e-9)
