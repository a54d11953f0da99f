"""One renderer for the window, pictures and films."""

import moderngl
import numpy as np

from motion.pose import Pose
from sim.cast import Cast
from sim.view import bodies, meshes, shaders
from sim.view.camera import Camera, look_at, orthographic
from sim.view.clay import Clay
from sim.view.overlays import overlays
from sim.view.quality import Quality
from worlds.world import World

SUN = np.array([0.48, 0.34, 0.81]) / np.linalg.norm([0.48, 0.34, 0.81])
MOST_PRINTS = 600
"""Footprints drawn, the latest."""
MESH = ("3f 3f 3f", "in_position", "in_normal", "in_colour")


class Renderer:
    """Draws a simulation into a framebuffer."""

    def __init__(self, ctx: moderngl.Context, quality: Quality | None = None) -> None:
        self.ctx, self.quality = ctx, quality or Quality()
        ctx.enable(moderngl.DEPTH_TEST)
        self.mesh = ctx.program(vertex_shader=shaders.MESH_VERTEX, fragment_shader=shaders.MESH_FRAGMENT)
        self.clay = ctx.program(vertex_shader=shaders.CAPSULE_VERTEX, fragment_shader=shaders.CAPSULE_FRAGMENT)
        self.wet = ctx.program(vertex_shader=shaders.MESH_VERTEX, fragment_shader=shaders.WATER_FRAGMENT)
        self.sky = ctx.program(vertex_shader=shaders.SKY_VERTEX, fragment_shader=shaders.SKY_FRAGMENT)
        self.mesh_depth = ctx.program(vertex_shader=shaders.MESH_VERTEX, fragment_shader=shaders.DEPTH_FRAGMENT)
        self.clay_depth = ctx.program(vertex_shader=shaders.CAPSULE_VERTEX, fragment_shader=shaders.DEPTH_FRAGMENT)
        self.capsule = ctx.buffer(meshes.capsule().tobytes())
        self.corners = ctx.buffer(np.array([-1, -1, 3, -1, -1, 3], "f4").tobytes())
        self.instances = ctx.buffer(reserve=48 * 4096, dynamic=True)
        self.shadow: moderngl.Texture | None = None
        self._world: World | None = None
        self._static: dict[str, tuple[moderngl.Buffer, int]] = {}
        self._outlines: dict[str, np.ndarray] = {}
        self.show_overlays = True

    def _upload(self, name: str, triangles: np.ndarray | None) -> None:
        if name in self._static:
            self._static.pop(name)[0].release()
        if triangles is not None and len(triangles):
            self._static[name] = (self.ctx.buffer(np.ascontiguousarray(triangles, "f4").tobytes()), len(triangles))

    def set_world(self, world: World) -> None:
        """Builds the world's geometry, where it differs from the one shown; edits rebuild only what they touch."""
        old, self._world = self._world, world
        if old is None or old.name != world.name or len(old.trees) != len(world.trees):
            self._upload("ground", meshes.ground(world) if world.terrain != "stairs" else meshes.stairs(world))
            self._upload("trees", meshes.trees(world))
        self._upload("rocks", meshes.rocks(world))
        self._upload("water", meshes.water(world))

    def draw(self, target: moderngl.Framebuffer, sim: Cast, pose: Pose, camera: Camera, time: float, focus: int) -> None:
        """Draws everything at simulated `time` [s] into target; focus is the character with overlays."""
        if self._world is not sim.world:
            self.set_world(sim.world)
        count = self._instances(sim, pose, focus)
        self._footprints(sim, time)
        aspect = target.width / target.height
        sun = self._sun_matrix(camera)
        if self.quality.shadow_size:
            self._shadow_pass(sun, count)
        target.use()
        self.ctx.viewport = (0, 0, target.width, target.height)
        target.clear(0.7, 0.8, 0.9)
        view = camera.matrix(aspect)
        for program in (self.mesh, self.clay, self.wet, self.sky):
            self._uniforms(program, view, sun, camera.eye, time)
        self._draw_static("ground", self.mesh)
        self._draw_static("rocks", self.mesh)
        self._draw_static("prints", self.mesh)
        unit = float(sim.bipeds["nominal_length"][sim.crowd.kind[focus]])
        _set(self.mesh, "focus", np.array([*pose.com[focus], 1.3 * unit], "f4").tobytes())
        self._draw_static("trees", self.mesh)
        _set(self.mesh, "focus", np.zeros(4, "f4").tobytes())
        self._draw_clay(self.clay, count)
        self._draw_static("water", self.wet)
        self.ctx.simple_vertex_array(self.sky, self.corners, "in_corner").render()

    def _instances(self, sim: Cast, pose: Pose, focus: int) -> int:
        clay = Clay()
        names = np.array([character.name for character in sim.characters])
        for name in np.unique(names):
            rows = np.flatnonzero(names == name)
            bodies.model(clay, sim.characters[rows[0]], pose, rows)
        if self.show_overlays:
            overlays(clay, sim, focus)
        rows = clay.rows()
        if rows.nbytes > self.instances.size:
            self.instances.orphan(2 * rows.nbytes)
        self.instances.write(np.ascontiguousarray(rows).tobytes())
        return len(rows)

    def _footprints(self, sim: Cast, time: float) -> None:
        log = sim.footprints.arrays(sim.crowd, last=MOST_PRINTS)
        down = log["footprint_contact_time"] <= time
        parts = []
        for c in np.unique(log["footprint_character"]):
            biped = sim.characters[c]
            outline = self._outlines.setdefault(biped.name, bodies.outline(biped))
            mine = down & (log["footprint_character"] == c)
            position, heading, normal = (log[f"footprint_{key}"][mine] for key in ("position", "heading", "normal"))
            parts.append(meshes.prints(position, heading, normal, outline, (0.27, 0.24, 0.16)))
        self._upload("prints", np.vstack(parts))

    def _sun_matrix(self, camera: Camera) -> np.ndarray:
        half = float(np.clip(1.4 * camera.distance, 7.0, 40.0))
        texel = 2 * half / max(self.quality.shadow_size, 1)
        centre = np.round(camera.target / texel) * texel  # so that shadows do not crawl
        return orthographic(half, 120.0) @ look_at(centre + 60 * SUN, centre)

    def _shadow_pass(self, sun: np.ndarray, count: int) -> None:
        size = self.quality.shadow_size
        if self.shadow is None or self.shadow.size != (size, size):
            self.shadow = self.ctx.depth_texture((size, size))
            self.shadow.compare_func = ""
            self.shadow_target = self.ctx.framebuffer(depth_attachment=self.shadow)
        self.shadow_target.use()
        self.ctx.viewport = (0, 0, size, size)
        self.shadow_target.clear()
        for program in (self.mesh_depth, self.clay_depth):
            _set(program, "view_projection", sun.T.astype("f4").tobytes())
        self._draw_static("rocks", self.mesh_depth)
        self._draw_static("trees", self.mesh_depth)
        self._draw_clay(self.clay_depth, count)

    def _uniforms(self, program, view, sun, eye, time: float) -> None:
        _set(program, "view_projection", view.T.astype("f4").tobytes())
        _set(program, "sun_projection", sun.T.astype("f4").tobytes())
        _set(program, "back_projection", np.linalg.inv(view).T.astype("f4").tobytes())
        _set(program, "eye", np.asarray(eye, "f4").tobytes())
        _set(program, "sun", SUN.astype("f4").tobytes())
        _set(program, "time", np.float32(time).tobytes())
        _set(program, "shadows", np.float32(bool(self.quality.shadow_size)).tobytes())
        if self.shadow:
            self.shadow.use(0)

    def _draw_static(self, name: str, program) -> None:
        if name in self._static:
            buffer, count = self._static[name]
            content = [(buffer, *_used(program, MESH))]
            self.ctx.vertex_array(program, content).render(vertices=count)

    def _draw_clay(self, program, count: int) -> None:
        shape = (self.capsule, "4f", "in_shape")
        content = [shape, (self.instances, *_used(program, ("4f 4f 4f/i", "a", "b", "paint")))]
        self.ctx.vertex_array(program, content).render(instances=count)


def _used(program, layout: tuple) -> tuple:
    """The layout with what the program's compiler dropped left as padding."""
    formats, names = layout[0].removesuffix("/i").split(), layout[1:]
    kept = [name for name in names if name in program]
    padded = [one if name in program else f"{4 * int(one[0])}x" for one, name in zip(formats, names, strict=True)]
    return (" ".join(padded) + ("/i" if layout[0].endswith("/i") else ""), *kept)


def _set(program, name: str, value: bytes) -> None:
    if name in program:
        program[name].write(value)
