"""Trees: a few shapes, each drawn many times, sized, turned and coloured by where they stand; culled, coarser afar."""

import moderngl
import numpy as np

from sim.view.graphics import detail
from sim.view.graphics.mesh import Mesh
from sim.view.scenery.trees import VARIANTS, planted, tree
from worlds.world import World

COARSE_PIXELS = 130.0
"""A tree less tall than this on screen is drawn coarser."""
LAYOUT = ("3f 3f 3f", "in_offset", "in_normal", "in_part")
ROW_LAYOUT = ("4f 4f 4f/i", "place", "form", "leaf")
SHADE = 0.75
"""A shadow reaches this far, as a share of the tree's height."""


class Forest:
    """The trees of a world."""

    def __init__(self, ctx: moderngl.Context) -> None:
        self._meshes = [
            [Mesh(ctx, LAYOUT, shape := tree(v, fine), np.arange(len(shape)), ROW_LAYOUT) for fine in (True, False)]
            for v in range(VARIANTS)
        ]
        self.rows = np.zeros((0, 12), "f4")

    def plant(self, world: World) -> None:
        """Takes the trees of a world."""
        self.rows, self._variant = planted(world)

    def cull(self, view: np.ndarray, height: int) -> None:
        """Chooses what is drawn into a view (4, 4) of `height` pixels: each tree that it or its shadow may show."""
        if not len(self.rows):
            return
        tall = self.rows[:, 4].astype(float)
        middle = self.rows[:, :3] + np.outer(0.6 * tall, (0.0, 0.0, 1.0))
        seen = detail.in_view(view, middle, tall * (0.75 + SHADE))
        fine = detail.pixels(view, middle, tall, height) >= COARSE_PIXELS
        for variant, pair in enumerate(self._meshes):
            for mesh, near in zip(pair, (True, False), strict=True):
                mesh.write(self.rows[seen & (fine == near) & (self._variant == variant)])

    def draw(self, program: moderngl.Program) -> None:
        """Draws the trees chosen last."""
        if len(self.rows):
            for pair in self._meshes:
                for mesh in pair:
                    mesh.draw(program)
