"""BVH: skeleton and motion of one character in a file, as motion capture has it. Centimetres, y up, z forward.

Rotations are Euler angles in the order Z Y X, degrees. BVH has rigid bones; ours give a little near full extension. Readers
disagree on what the position of a joint means (added to its offset, or instead of it), so what a bone stretches is the position
of a joint of its own, `shank_left_stretch`, whose offset is zero: there both are the same.
"""

from io import StringIO

import numpy as np

from sim.export.clip.asked import Asked
from sim.export.clip.clip import Actor, Clip
from sim.export.skeletons.axes import y_up, y_up_xyzw
from sim.files import outputs

SCALE = 100.0
"""Units per metre."""
LITTLE = 1e-4
"""A bone that never stretches by more than this [m] is rigid."""
POSITION, ROTATION = "Xposition Yposition Zposition", "Zrotation Yrotation Xrotation"


def export_bvh(clip: Clip, path: str, asked: Asked) -> None:
    """Writes the only character of a clip. Raises InputError."""
    with outputs.whole(path) as temporary, open(temporary, "w", encoding="ascii", newline="\n") as file:
        file.write(bvh_of(clip.actors[0], clip.rate))


def bvh_of(actor: Actor, rate: float) -> str:
    """The text of a file, of so many moments per second."""
    text, channels = StringIO(), list[np.ndarray]()
    text.write("HIERARCHY\n")
    _write_joint(actor, 0, 0, text, channels)
    rows = np.concatenate(channels, axis=1)
    text.write(f"MOTION\nFrames: {len(rows)}\nFrame Time: {1 / rate:.8f}\n")
    np.savetxt(text, rows, fmt="%.5f")
    return text.getvalue()


def _write_joint(actor: Actor, b: int, depth: int, text: StringIO, channels: list[np.ndarray]) -> None:
    """A bone and those that hang on it; their channels, (F, n) each, go behind those that there are."""
    skeleton, bones, pad = actor.skeleton, actor.bones, "  " * depth
    given = _given(actor, b)
    if given is not None:
        text.write(f"{pad}JOINT {skeleton.names[b]}_stretch\n{pad}{{\n{pad}  OFFSET 0 0 0\n{pad}  CHANNELS 3 {POSITION}\n")
        channels.append(SCALE * y_up(given))
        depth, pad = depth + 1, pad + "  "
    word = "JOINT" if depth else "ROOT"
    offset = SCALE * y_up(skeleton.offset[b]) if depth else np.zeros(3)
    text.write(f"{pad}{word} {skeleton.names[b]}\n{pad}{{\n{pad}  OFFSET {_plain(offset)}\n")
    if depth:
        text.write(f"{pad}  CHANNELS 3 {ROTATION}\n")
    else:
        text.write(f"{pad}  CHANNELS 6 {POSITION} {ROTATION}\n")
        channels.append(SCALE * y_up(bones.root))
    channels.append(euler_zyx(y_up_xyzw(bones.rotation_wxyz[:, b])))
    below = np.flatnonzero(skeleton.parent == b)
    for child in below:
        _write_joint(actor, int(child), depth + 1, text, channels)
    if not len(below):
        text.write(f"{pad}  End Site\n{pad}  {{\n{pad}    OFFSET {_plain(SCALE * y_up(skeleton.tip[b]))}\n{pad}  }}\n")
    text.write(f"{pad}}}\n")
    if given is not None:
        text.write(f"{pad[:-2]}}}\n")


def _given(actor: Actor, b: int) -> np.ndarray | None:
    """(F, 3) by how much more the bone's head is away from its parent's than at rest [m], or None where that is nothing."""
    above = actor.skeleton.parent[b]
    if above < 0:
        return None
    more = (actor.bones.stretch[:, above, None] - 1) * actor.skeleton.offset[b]
    return more if np.abs(more).max() > LITTLE else None


def euler_zyx(xyzw: np.ndarray) -> np.ndarray:
    """(F, 3) angles about z, y, x [deg], turned in this order about axes that turn along: R = Rz Ry Rx."""
    x, y, z, w = xyzw.T
    about_z = np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
    about_y = np.arcsin(np.clip(2 * (w * y - x * z), -1, 1))
    about_x = np.arctan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))
    angles = np.stack([about_z, about_y, about_x], axis=1)
    return np.degrees(np.unwrap(angles, axis=0))


def _plain(numbers: np.ndarray) -> str:
    return " ".join(f"{number:.6f}" for number in numbers)
