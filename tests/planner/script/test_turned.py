"""Hand keys: offsets that come and go, and leave standing feet alone."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from motion.characters.character import load_character
from motion.motion import placed, solve
from planner.script.footprint import Footprint
from planner.script.laying import laid
from planner.script.turned import LEGS, BoneKey, free, offset_at, turned
from worlds.compiled.tables import copied

HUMAN = load_character("human")


@pytest.fixture(scope="module")
def motion():
    given = [
        Footprint(side=("left", "right")[i % 2], position=(1.0 + 0.6 * max(i - 1, 0), 2.0 + 0.06 * (1 - 2 * (i % 2))))
        for i in range(10)
    ]
    return solve(laid(given, HUMAN), HUMAN)


def shown(motion, keys, t):
    bones = copied(motion.bones(t))
    turned(bones, 0, motion.skeleton.names, keys, motion.footprints, t)
    return bones


def test_a_key_turns_its_bone_and_blends_back(motion):
    key, k = BoneKey("head", 2.0, (0.0, 0.0, 0.5), 0.3), motion.skeleton.names.index("head")
    for t, share in ((2.0, 1.0), (1.85, 0.5), (2.15, 0.5), (1.7, 0.0), (2.31, 0.0)):
        plain, now = (
            Rotation.from_quat(b.rotation_wxyz[0, k], scalar_first=True) for b in (motion.bones(t), shown(motion, [key], t))
        )
        np.testing.assert_allclose((plain.inv() * now).as_rotvec(), [0, 0, 0.5 * share], atol=1e-9)
    others = np.delete(np.arange(len(motion.skeleton.names)), k)
    np.testing.assert_array_equal(
        shown(motion, [key], 2.0).rotation_wxyz[0, others], motion.bones(2.0).rotation_wxyz[0, others]
    )


def test_keys_that_meet_blend_and_none_is_exceeded():
    keys = [BoneKey("head", 1.0, (0.4, 0.0, 0.0), 0.5), BoneKey("head", 1.2, (0.4, 0.0, 0.0), 0.5)]
    angles = [offset_at(keys, t)[0] for t in np.linspace(0.4, 1.8, 200)]
    assert max(angles) <= 0.4 + 1e-12 and np.abs(np.diff(angles)).max() < 0.02


def test_feet_that_stand_stay_where_they_stand(motion):
    names = motion.skeleton.names
    keys = [
        BoneKey(f"{bone}_{side}", t, (0.3, 0.2, 0.1), 5.0)
        for bone in LEGS
        if f"{bone}_left" in names
        for side in ("left", "right")
        for t in (1.0, 2.0)
    ]
    moved = 0
    for t in np.arange(0.2, motion.end, 0.05):
        plain, now = placed(motion.bones(t), motion.skeleton), placed(shown(motion, keys, t), motion.skeleton)
        for k, side in enumerate(("left", "right")):
            foot = names.index(f"foot_{side}")
            if free(motion.footprints, k, t) == 0:
                np.testing.assert_array_equal(now.tip[0, foot], plain.tip[0, foot])
            else:
                moved += np.abs(now.tip[0, foot] - plain.tip[0, foot]).max() > 0.01
    assert moved > 5
