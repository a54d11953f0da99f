"""BVH: skeleton and motion of one character in a file, as motion capture has it. Centimetres, y up, z forward.

Rotations are Euler angles in the order Z Y X, degrees. BVH has rigid bones; ours give a little near full extension. Readers
disagree on what the position of a joint means (added to its offset, or instead of it), so a joint that moves has no offset,
where both are the same: it hangs on a joint that only has the offset, as `shank_left` on `shank_left_socket`.
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
    rows = np.concatenate(channels, axis=1)[actor.there]
    text.write(f"MOTION\nFrames: {len(rows)}\nFrame Time: {1 / rate:.8f}\n")
    np.savetxt(text, rows, fmt="%.5f")
    return text.getvalue()


def _write_joint(actor: Actor, b: int, depth: int, text: StringIO, channels: list[np.ndarray]) -> None:
    """A bone and those that hang on it; their channels, (F, n) each, go behind those that there are."""
    skeleton, bones = actor.skeleton, actor.bones
    name, offset = skeleton.names[b], SCALE * y_up(skeleton.offset[b])
    moves = SCALE * y_up(bones.root) if b == 0 else _given(actor, b)
    socket = b > 0 and moves is not None
    if socket:
        _open(text, depth, f"JOINT {name}_socket", offset, ROTATION)
        channels.append(np.zeros((len(bones.root), 3)))
    if moves is not None:
        _open(text, depth + socket, f"{'JOINT' if b else 'ROOT'} {name}", np.zeros(3), f"{POSITION} {ROTATION}")
        channels.append(moves)
    else:
        _open(text, depth, f"JOINT {name}", offset, ROTATION)
    channels.append(euler_zyx(y_up_xyzw(bones.rotation_wxyz[:, b])))
    pad, below = "  " * (depth + socket), np.flatnonzero(skeleton.parent == b)
    for child in below:
        _write_joint(actor, int(child), depth + socket + 1, text, channels)
    if not len(below):
        text.write(f"{pad}  End Site\n{pad}  {{\n{pad}    OFFSET {_plain(SCALE * y_up(skeleton.tip[b]))}\n{pad}  }}\n")
    text.write(f"{pad}}}\n" + (f"{pad[:-2]}}}\n" if socket else ""))


def _open(text: StringIO, depth: int, title: str, offset: np.ndarray, channels: str) -> None:
    """Begins a joint."""
    pad, count = "  " * depth, len(channels.split())
    text.write(f"{pad}{title}\n{pad}{{\n{pad}  OFFSET {_plain(offset)}\n{pad}  CHANNELS {count} {channels}\n")


def _given(actor: Actor, b: int) -> np.ndarray | None:
    """(F, 3) by how much more the bone's head is away from its parent's than at rest, in units; None where that is nothing."""
    above = actor.skeleton.parent[b]
    more = (actor.bones.stretch[:, above, None] - 1) * actor.skeleton.offset[b]
    return SCALE * y_up(more) if np.abs(more).max() > LITTLE else None


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
