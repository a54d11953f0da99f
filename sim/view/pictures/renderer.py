"""One renderer for the window, pictures and films."""

import moderngl
import numpy as np

from motion.characters.character import Character
from sim.stage.cast import Cast
from sim.view.bodies import bodies
from sim.view.bodies.clay import Clay
from sim.view.graphics import shaders
from sim.view.graphics.camera import Camera, look_at, orthographic
from sim.view.graphics.mesh import Mesh
from sim.view.graphics.quality import Quality
from sim.view.pictures.overlays import OVERLAYS, goal, overlays
from sim.view.scenery import meshes
from sim.view.scenery.forest import Forest
from sim.view.scenery.ground import Ground
from sim.view.scenery.trail import Trail
from worlds.world import World

SUN = np.array([0.48, 0.34, 0.81]) / np.linalg.norm([0.48, 0.34, 0.81])
SUN_FAR = 1e4
MESH = ("3f 3f 3f", "in_position", "in_normal", "in_colour")
CLAY = ("4f 4f 4f/i", "a", "b", "paint")
LIT = {
    "mesh": (shaders.MESH_VERTEX, shaders.MESH_FRAGMENT),
    "tree": (shaders.TREE_VERTEX, shaders.TREE_FRAGMENT),
    "print": (shaders.PRINT_VERTEX, shaders.MESH_FRAGMENT),
    "clay": (shaders.CAPSULE_VERTEX, shaders.CAPSULE_FRAGMENT),
    "water": (shaders.MESH_VERTEX, shaders.WATER_FRAGMENT),
}
"""Vertex and fragment shaders of what the sun lights."""
PRINT = ("4f 4f/i", "place", "lie")
HAZE = 75.0
"""Distance [m] over which things fade; from far away they fade later, so that an overview stays clear."""
WIDEST_SHADOWS = 80.0
"""Shadows are drawn no farther than this [m] from what the camera looks at."""


class Renderer:
    """Draws a simulation into a framebuffer."""

    def __init__(self, ctx: moderngl.Context, quality: Quality | None = None) -> None:
        self.ctx, self.quality = ctx, quality or Quality()
        self._lit: dict[int, dict[str, moderngl.Program]] = {}
        self._depth = {name: self._program(LIT[name][0], shaders.DEPTH_FRAGMENT) for name in ("mesh", "tree", "clay")}
        self.sky = self._program(shaders.SKY_VERTEX, shaders.SKY_FRAGMENT)
        self.corners = ctx.buffer(np.array([-1, -1, 3, -1, -1, 3], "f4"))
        self._sky = ctx.vertex_array(self.sky, self.corners, "in_corner")
        self.bodies, self._marks = bodies.Bodies(), Clay()
        self._clay = {
            name: Mesh(ctx, ("4f", "in_shape"), *shape, CLAY)
            for name, shape in (("fine", meshes.capsule(5, 10)), ("coarse", meshes.capsule(3, 6)), ("flat", meshes.lozenge()))
        }
        self._overlays = Mesh(ctx, ("4f", "in_shape"), *meshes.capsule(3, 6), CLAY)
        self._forest = Forest(ctx)
        self._ground: Ground | None = None
        self._trail, self._prints = Trail(), list[Mesh]()
        self.shadow: moderngl.Texture | None = None
        self._shadow_target: moderngl.Framebuffer | None = None
        self._world: World | None = None
        self._kinds: list[Character] = []
        self._static: dict[str, Mesh] = {}
        self.show_overlays, self.shown = True, OVERLAYS
        self.alone = False
        """Whether only bodies are drawn, on nothing: the picture is transparent around them."""

    def _program(self, vertex: str, fragment: str, shadows: int = 0) -> moderngl.Program:
        head = f"{shaders.VERSION}#define SHADOWS {shadows}\n"
        return self.ctx.program(vertex_shader=head + vertex, fragment_shader=head + fragment)

    def _lit_programs(self) -> dict[str, moderngl.Program]:
        """Programs for the quality's shadows, made when they are first needed."""
        samples = self.quality.shadow_samples if self.quality.shadow_size else 0
        if samples not in self._lit:
            self._lit[samples] = {name: self._program(*pair, samples) for name, pair in LIT.items()}
        return self._lit[samples]

    def _upload(self, name: str, vertices: np.ndarray, indices: np.ndarray | None = None) -> None:
        if name in self._static:
            self._static.pop(name).release()
        if len(vertices):
            indices = np.arange(len(vertices)) if indices is None else indices
            self._static[name] = Mesh(self.ctx, MESH, vertices, indices)

    def set_world(self, world: World) -> None:
        """Builds the world's geometry, where it differs from the one shown; edits rebuild only what they touch."""
        old, self._world = self._world, world
        if old is None or old.name != world.name or len(old.trees) != len(world.trees):
            self._lay_ground(world)
            self._forest.plant(world)
        self._upload("rocks", meshes.rocks(world))
        self._upload("walls", meshes.walls(world))
        self._upload("water", meshes.water(world))

    def _lay_ground(self, world: World) -> None:
        """Smooth terrain in tiles, stairs as they are."""
        if self._ground:
            self._ground.release()
            self._ground = None
        if world.terrain in meshes.GROUNDS:
            self._upload("ground", *meshes.GROUNDS[world.terrain](world))
        else:
            self._upload("ground", np.zeros((0, 9)))
            self._ground = Ground(self.ctx, MESH, meshes.ground_grid(world))

    def draw(self, target: moderngl.Framebuffer, sim: Cast, camera: Camera, time: float, focus: int) -> None:
        """Draws everything at simulated `time` [s] into target; focus is the character with overlays.

        What hides other things is drawn first, so that hidden pixels cost nothing.
        """
        view, sun = camera.matrix(target.width / target.height), self._sun_matrix(camera)
        self._prepare(sim, time, view, camera.eye, target.height, focus)
        self.ctx.enable_only(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
        if self.quality.shadow_size:
            self._shadow_pass(sun)
        target.use()
        self.ctx.viewport = (0, 0, target.width, target.height)
        target.clear(*(0.0, 0.0, 0.0) if self.alone else (0.7, 0.8, 0.9))
        lit = self._lit_programs()
        for program in (*lit.values(), self.sky):
            self._uniforms(program, view, sun, camera, time)
        unit = sim.leg(focus)
        _set(lit["tree"], "focus", np.array([*self._focus_com, 1.3 * unit], "f4").tobytes())
        for mesh in self._clay.values():
            self._draw_clay(lit["clay"], mesh, mesh)
        self._draw_clay(lit["clay"], self._overlays, self._overlays)
        if not self.alone:
            self._draw_around(lit)

    def _draw_around(self, lit: dict[str, moderngl.Program]) -> None:
        """The world and the sky."""
        self._forest.draw(lit["tree"])
        self._draw_static("rocks", lit["mesh"])
        self._draw_static("walls", lit["mesh"])
        for prints in self._prints:
            prints.draw(lit["print"])
        self._draw_static("ground", lit["mesh"])
        if self._ground:
            self._ground.draw(lit["mesh"])
        self.ctx.disable(moderngl.CULL_FACE)
        self._draw_static("water", lit["water"])
        self._sky.render()

    def _prepare(self, sim: Cast, time: float, view: np.ndarray, eye: np.ndarray, height: int, focus: int) -> None:
        """Uploads what has changed since the last frame."""
        if self._world is not sim.world:
            self.set_world(sim.world)
        self.bodies.model(sim, time, view, height)
        self._focus_com = self.bodies.com[focus]
        self._marks.clear()
        if not self.alone:
            goal(self._marks, sim.world)
        if self.show_overlays and not self.alone:
            overlays(self._marks, sim, focus, self.shown)
        self._overlays.write(self._marks.rows())
        for name, mesh in self._clay.items():
            mesh.write(getattr(self.bodies, name).rows())
        self._forest.cull(view, height)
        if self._ground:
            self._ground.cull(view, eye, height)
        self._footprints(sim)

    def _footprints(self, sim: Cast) -> None:
        if self._kinds is not sim.kinds:
            self._kinds = sim.kinds
            for mesh in self._prints:
                mesh.release()
            shapes = [np.unique(bodies.outline(kind).reshape(-1, 2), axis=0, return_inverse=True) for kind in sim.kinds]
            self._prints = [Mesh(self.ctx, ("2f", "in_outline"), *shape, PRINT) for shape in shapes]
        for kind, at, rows in self._trail.look(sim):
            self._prints[kind].write(rows, at, keep=self._prints[kind].count)

    def _sun_matrix(self, camera: Camera) -> np.ndarray:
        half = float(np.clip(1.4 * camera.distance, 7.0, WIDEST_SHADOWS))
        texel = 2 * half / max(self.quality.shadow_size, 1)
        centre = np.round(camera.target / texel) * texel  # so that shadows do not crawl
        return orthographic(half, 2 * half + 60.0) @ look_at(centre + (half + 30.0) * SUN, centre)

    def _shadow_pass(self, sun: np.ndarray) -> None:
        size = self.quality.shadow_size
        if self.shadow is None or self.shadow.size != (size, size):
            for one in (self._shadow_target, self.shadow):
                if one:
                    one.release()
            self.shadow = self.ctx.depth_texture((size, size))
            self.shadow.compare_func = "<="
            self.shadow.filter = moderngl.LINEAR, moderngl.LINEAR
            self._shadow_target = self.ctx.framebuffer(depth_attachment=self.shadow)
        assert self._shadow_target is not None
        self._shadow_target.use()
        self.ctx.viewport = (0, 0, size, size)
        self._shadow_target.clear()
        for program in self._depth.values():
            _set(program, "view_projection", sun.T.astype("f4").tobytes())
            _set(program, "eye", (SUN_FAR * SUN).astype("f4").tobytes())
        if not self.alone:
            self._draw_static("rocks", self._depth["mesh"])
            self._draw_static("walls", self._depth["mesh"])
            self._forest.draw(self._depth["tree"])
        for mesh in (self._clay["coarse"], self._clay["flat"]):
            self._draw_clay(self._depth["clay"], mesh, self._clay["flat"])
        self._draw_clay(self._depth["clay"], self._clay["fine"], self._clay["coarse"])

    def _uniforms(self, program: moderngl.Program, view: np.ndarray, sun: np.ndarray, camera: Camera, time: float) -> None:
        _set(program, "view_projection", view.T.astype("f4").tobytes())
        _set(program, "sun_projection", sun.T.astype("f4").tobytes())
        _set(program, "back_projection", np.linalg.inv(view).T.astype("f4").tobytes())
        _set(program, "eye", np.asarray(camera.eye, "f4").tobytes())
        _set(program, "sun", SUN.astype("f4").tobytes())
        _set(program, "time", np.float32(time).tobytes())
        _set(program, "haze", np.float32(max(HAZE, 3.0 * camera.away)).tobytes())
        if self.shadow:
            self.shadow.use(0)

    def _draw_static(self, name: str, program: moderngl.Program) -> None:
        if name in self._static:
            self._static[name].draw(program)

    def _draw_clay(self, program: moderngl.Program, mesh: Mesh, shape: Mesh) -> None:
        """Draws a mesh's rows as that shape."""
        _set(program, "flat_shapes", np.float32(shape is self._clay["flat"]).tobytes())
        mesh.draw(program, shape)


def _set(program: moderngl.Program, name: str, value: bytes) -> None:
    uniform = program.get(name, None)
    if isinstance(uniform, moderngl.Uniform):
        uniform.write(value)
