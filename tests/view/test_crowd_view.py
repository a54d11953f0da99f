"""Crowds on screen: culling, levels of detail, footprints, and buffers that are kept."""

import numpy as np
import pytest

from motion.characters.character import load_character
from planner.modes.wander import Wander
from sim.stage.simulation import Simulation
from sim.view.bodies import bodies
from sim.view.bodies.clay import Clay
from sim.view.bodies.dress import COLOURS, colours_of
from sim.view.graphics import detail, shaders
from sim.view.graphics.camera import Camera
from sim.view.scenery.trail import Trail
from sim.view.window import picking
from tests import reference
from worlds.level import load_level

KINDS = ("bird", "dinosaur", "human")


@pytest.fixture(scope="module")
def sim():
    made = Simulation(load_level("forest"), [load_character(KINDS[c % 3]) for c in range(60)], Wander(), 3)
    for _ in range(200):
        made.tick()
    return made


@pytest.mark.parametrize("plan", [False, True])
def test_culling_against_points_of_spheres(plan):
    rng = np.random.default_rng(4)
    camera = Camera(target=np.array([3.0, -2.0, 0.5]), distance=9.0, plan=plan)
    view = camera.matrix(16 / 9)
    centres, radii = rng.uniform(-30, 30, (3000, 3)), rng.uniform(0.1, 3.0, 3000)
    seen = detail.in_view(view, centres, radii)
    directions = rng.normal(size=(200, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    points = centres[:, None] + radii[:, None, None] * np.concatenate([directions, np.zeros((1, 3))])
    clip = np.concatenate([points, np.ones((*points.shape[:2], 1))], axis=2) @ view.T
    inside = (np.abs(clip[..., :3]) <= clip[..., 3:]).all(axis=2).any(axis=1)
    assert seen[inside].all()
    assert inside.mean() > 0.01 and (seen & ~inside).mean() < 0.05


def test_detail_follows_the_size_on_screen():
    camera = Camera(target=np.zeros(3), distance=10.0, elevation=0.3)
    view = camera.matrix(16 / 9)
    away = camera.target - camera.eye
    centres = camera.eye + np.array([0.5, 1.0, 3.0, 9.0])[:, None] * away
    size = detail.pixels(view, centres, np.full(4, 1.7), 540)
    assert size[1] == pytest.approx(1.7 * 540 / (2 * 10.0 * np.tan(np.radians(21))), rel=1e-3)
    assert (np.diff(size) < 0).all()
    levels = detail.level_of(np.array([500.0, *detail.PIXELS, 3.0]))
    assert levels.tolist() == [detail.FULL, detail.FULL, detail.REDUCED, detail.FAR, detail.DISTANT]
    assert detail.level_of(np.array(detail.PIXELS) - 0.1).tolist() == [detail.REDUCED, detail.FAR, detail.DISTANT]


def test_only_who_is_seen_is_modelled(sim):
    com = sim.com()
    shown = bodies.Bodies()
    camera = Camera(target=com[0].copy(), distance=4.0)
    shown.model(sim, sim.time, camera.matrix(1.6), 540)
    seen = detail.in_view(camera.matrix(1.6), com, 0.0)
    assert seen.sum() <= shown.levels.sum() < len(com) and shown.levels[detail.FULL] >= 1


@pytest.mark.parametrize("kind", KINDS)
def test_every_level_shows_the_whole_body_in_fewer_shapes(kind):
    alone = Simulation(load_level("forest"), [load_character(kind)], Wander(), 3)
    for _ in range(200):
        alone.tick()
    shown, low, high, counts = bodies.Bodies(), [], [], []
    view = Camera(target=alone.com()[0].copy(), distance=8.0).matrix(1.6)
    for level, wanted in enumerate((200.0, 80.0, 30.0, 8.0)):
        at_one = detail.pixels(view, alone.com(), np.full(1, 1.9 * alone.leg(0)), 1)[0]
        shown.model(alone, alone.time, view, int(wanted / at_one))
        assert shown.levels.tolist() == np.eye(4)[level].tolist()
        rows = np.vstack([clay.rows() for clay in (shown.fine, shown.coarse, shown.flat)])
        counts.append(len(rows))
        ends = np.vstack([rows[:, :4], rows[:, 4:8]])
        low.append((ends[:, :3] - ends[:, 3:]).min(axis=0))
        high.append((ends[:, :3] + ends[:, 3:]).max(axis=0))
    assert (np.diff(counts) < 0).all() and counts[2] < 0.5 * counts[0] and counts[3] <= 6
    size = high[0] - low[0]
    for a, b in zip(low[1:], high[1:], strict=True):
        assert (np.abs(a - low[0]) < 0.22 * size.max()).all() and (np.abs(b - high[0]) < 0.22 * size.max()).all()


def test_footprints_as_instances_are_the_old_triangles(picture, sim):
    trail = Trail()
    trail.look(sim)
    for kind, character in enumerate(sim.kinds):
        outline = bodies.outline(character)
        rows = trail.rows[kind][: trail.count[kind]][:7]
        rows[:, 4] += 0.2
        rows[:, 4:7] /= np.linalg.norm(rows[:, 4:7], axis=1, keepdims=True)
        wanted = reference.footprint_triangles(rows[:, :3], rows[:, 3], rows[:, 4:7], outline)
        program = picture.ctx.program(vertex_shader=shaders.VERSION + shaders.PRINT_VERTEX, varyings=["p", "n"])
        corners = picture.ctx.buffer(outline.reshape(-1, 2).astype("f4"))
        instances = picture.ctx.buffer(np.ascontiguousarray(rows))
        content = [(corners, "2f", "in_outline"), (instances, "4f 3f 4x/i", "place", "lie")]
        found = picture.ctx.buffer(reserve=24 * 3 * len(outline) * len(rows))
        picture.target.use()
        picture.ctx.vertex_array(program, content).transform(found, instances=len(rows))
        assert np.frombuffer(found.read(), "f4").reshape(-1, 6) == pytest.approx(wanted, abs=2e-5)


def test_the_trail_takes_each_footprint_once():
    made = Simulation(load_level("forest"), [load_character("human"), load_character("bird")], Wander(), 5)
    trail, late = Trail(), Trail(most=16)
    made.keep_footprints()
    trail.look(made), late.look(made)
    for tick in range(900):
        made.tick()
        new = trail.look(made)
        assert sum(len(rows) for _, _, rows in new) <= 4
        if tick % 450 == 449:
            late.look(made)  # so late that the crowd has forgotten some
    log = made.footprints.arrays(made.crowd)
    for kind in range(2):
        mine = made.kind[log["footprint_character"]] == kind
        wanted = np.column_stack([log["footprint_position"][mine], log["footprint_contact_time"][mine]])
        rows = trail.rows[kind][: trail.count[kind]][:, [0, 1, 2, 7]]
        assert rows[np.argsort(rows[:, 3])] == pytest.approx(wanted[np.argsort(wanted[:, 3])], abs=1e-4)
        last = late.rows[kind][:, [0, 1, 2, 7]]
        assert last[np.argsort(last[:, 3])] == pytest.approx(wanted[np.argsort(wanted[:, 3])][-16:], abs=1e-4)


def test_buffers_are_kept(picture, sim):
    picture.frame(sim)
    arrays = [len(mesh._arrays) for mesh in picture.renderer._clay.values()]
    kept = [mesh._rows.glo for mesh in picture.renderer._clay.values() if mesh._rows]
    for k in range(5):
        picture.frame(sim, focus=0, time=sim.time - 0.01 * k)
    assert kept == [mesh._rows.glo for mesh in picture.renderer._clay.values() if mesh._rows]
    assert arrays == [len(mesh._arrays) for mesh in picture.renderer._clay.values()]
    highest = picture.ctx.buffer(reserve=4)
    picture.frame(sim)
    assert picture.ctx.buffer(reserve=4).glo == highest.glo + 1


def test_a_tree_planted_leaves_the_others_alone(picture, sim):
    world = load_level("forest")
    picture.renderer._forest.plant(world)
    before = picture.renderer._forest.rows
    picture.renderer._forest.plant(world.with_tree(5.0, 5.0, 0.3))
    assert (picture.renderer._forest.rows[:-1] == before).all()
    picture.renderer._world = None


def test_the_first_wears_its_files_colours_and_the_others_do_not():
    human = load_character("human")
    colours = colours_of([human] * 50, 3)
    for key in COLOURS:
        assert colours[key][0] == pytest.approx(getattr(human.look, key)) and colours[key].shape == (50, 3)
        assert len(np.unique(colours[key].round(6), axis=0)) == 50 and (colours[key] >= 0).all()
    assert colours["main"].argmax(axis=1).tolist() != [int(np.argmax(human.look.main))] * 50
    assert (colours["main"] == colours_of([human] * 50, 3)["main"]).all()


def test_clay_leaves_out_what_is_too_small():
    clay, one = Clay(), np.zeros((3, 3))
    clay.smallest = 0.1
    clay.add(one, 0.03, one + (0, 0, 0.02), 0.03, (1, 0, 0))
    clay.add(one, 0.01, one + (0, 0, 0.5), 0.01, (1, 0, 0))
    assert len(clay.rows()) == 3
    for _ in range(2000):
        clay.add(one, 0.2, one, 0.2, (0, 1, 0))
    assert len(clay.rows()) == 6003 and (clay.rows()[-1, 8:11] == (0, 1, 0)).all()


def test_a_click_takes_the_nearest_character(sim):
    com, camera = sim.com(), Camera(target=sim.com()[7].copy(), distance=3.0, elevation=1.2)
    assert picking.character_at(com, 0.4, *camera.ray(0.0, 0.0, 1.6)) == 7
    assert picking.character_at(com, 0.4, camera.eye, np.array([0.0, 0.0, 1.0])) is None
