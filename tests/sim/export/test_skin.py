"""The skin against the body as the view models it."""

import numpy as np
import pytest

from motion.characters.character import character_names, load_character
from motion.pose.bones import Placed
from sim.export.skeletons import skin
from sim.export.skeletons.skin import skin_of
from tests.sim.export.readers import clip, recording


@pytest.mark.parametrize("name", character_names())
def test_a_skin_follows_the_body_as_drawn(name):
    """Capsules' ends, carried by bones through a walk, beside those that the view models at each moment."""
    character = load_character(name)
    body, actor = skin_of(character), clip(recording(name), rate=12.0).actors[0]
    at = Placed(*(column[4:] for column in actor.placed))
    rest = skin._poses(actor.skeleton)
    modelled = skin._model(character, at, {})
    frames = np.stack(skin.axes_of(at.rotation_wxyz.reshape(-1, 4)), axis=2).reshape(*at.rotation_wxyz.shape[:2], 3, 3)
    normal = body.normal
    radius = np.take_along_axis(modelled.radii[body.capsule], _end(body)[:, None], axis=1)
    centre = body.position - radius * normal
    local = centre[:, None] - rest.head[0, body.bones]
    carried = np.einsum("fvbij,vbj->fvbi", frames[:, body.bones], local) + at.head[:, body.bones]
    found = (carried * body.weight[..., None]).sum(axis=2)
    expected = modelled.ends[body.capsule, :, _end(body)].transpose(1, 0, 2)
    apart = np.linalg.norm(found - expected, axis=2) / character.biped.leg.nominal_length
    assert np.quantile(apart, 0.9) < 0.02 and apart.max() < 0.08


def _end(body):
    return np.tile(skin.capsule(skin.RINGS, skin.SIDES)[0][:, 3].astype(int), body.capsule.max() + 1)


@pytest.mark.parametrize("name", character_names())
def test_a_skin_is_whole(name):
    body = skin_of(load_character(name))
    np.testing.assert_allclose(body.weight.sum(axis=1), 1.0)
    np.testing.assert_allclose(np.linalg.norm(body.normal, axis=1), 1.0, atol=1e-6)
    assert body.triangles.max() == len(body.position) - 1 and body.position[:, 2].min() > -0.05
    corners = body.position[body.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    outward = np.einsum("ti,ti->t", normals, body.normal[body.triangles].mean(axis=1))
    assert (outward > -1e-9).all()  # faces look outward
