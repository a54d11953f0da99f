"""The gizmo of a hand key: rings about the bone, in space, that turn it; shown while the time that is shown is the key's.

A key's offset is exp(r) after the motion's own rotation, in the bone's frame. ImGuizmo turns the bone's whole rotation R into
R', so the new offset is exp(r) R^T R'.
"""

import numpy as np
from imgui_bundle import imguizmo

from motion.motion import placed
from planner.script.shaping import Key, time_of
from sim.files.studio.shapes import SetShape
from sim.view.graphics.camera import look_at, perspective
from sim.view.studio.desk.desk import Desk
from sim.view.studio.table.canvas import Space

gizmo = imguizmo.im_guizmo
NEAR = 0.034
"""The gizmo is shown within so many seconds of its key."""


class Gizmo:
    """Turns the bone of the key at the time that is shown."""

    def __init__(self) -> None:
        self.turning = False

    @property
    def holds(self) -> bool:
        """Whether the mouse is over it, or turns it."""
        return bool(self.turning or gizmo.is_over())

    def draw(self, draw: object, desk: Desk, space: Space) -> None:
        """One frame."""
        gizmo.begin_frame()
        k = key_at(desk)
        if k is None:
            self._let_go(desk)
            return
        box, key = space.box, desk.document.tracks[desk.track].key[k]
        gizmo.set_drawlist(draw)  # type: ignore[arg-type]
        gizmo.set_rect(box.x, box.y, box.width, box.height)
        gizmo.set_orthographic(False)
        place, rotation = _bone(desk, key.bone)
        model = np.eye(4)
        model[:3, :3], model[:3, 3] = rotation, place
        given = _columns(model)
        view, lens = look_at(space.camera.eye, space.camera.target), perspective(box.width / max(box.height, 1.0))
        turned = gizmo.manipulate(_columns(view), _columns(lens), gizmo.OPERATION.rotate, gizmo.MODE.local, given)
        if turned:
            self.turning = True
            after = np.array(given.values, float).reshape(4, 4).T[:3, :3]
            vector = rotation_vector(rotation_matrix(np.radians(key.rotation_deg)) @ rotation.T @ after)
            degrees = tuple(round(float(v), 2) for v in np.degrees(vector))
            desk.preview(SetShape(desk.track, "key", k, Key(**{**dict(key), "rotation_deg": degrees})))
        if not gizmo.is_using():
            self._let_go(desk)

    def _let_go(self, desk: Desk) -> None:
        if self.turning:
            self.turning = False
            desk.drop()


def key_at(desk: Desk) -> int | None:
    """The hand key of the track at the time that is shown, None for none."""
    act = desk.act(desk.track)
    for k, key in enumerate(desk.document.tracks[desk.track].key):
        known = key.footprint < len(act.laid.row) and key.bone in desk.show.skeleton(desk.track).names
        if known and abs(time_of(act.laid, key.footprint, key.after) - desk.playing.time) < NEAR:
            return k
    return None


def _bone(desk: Desk, bone: str) -> tuple[np.ndarray, np.ndarray]:
    """Where a bone begins (3,) and its rotation (3, 3) to the world."""
    skeleton = desk.show.skeleton(desk.track)
    at = placed(desk.show.bones(desk.track, desk.playing.time), skeleton)
    k = skeleton.names.index(bone)
    w, x, y, z = at.rotation_wxyz[0, k]
    vector = 2 * np.arctan2(np.linalg.norm([x, y, z]), w) * np.array([x, y, z]) / max(float(np.linalg.norm([x, y, z])), 1e-12)
    return at.head[0, k], rotation_matrix(vector)


def rotation_matrix(vector: np.ndarray) -> np.ndarray:
    """exp of a rotation vector (3,) [rad], by Rodrigues' formula."""
    angle = float(np.linalg.norm(vector))
    if angle < 1e-12:
        return np.eye(3)
    x, y, z = vector / angle
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.asarray(np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k)


def rotation_vector(matrix: np.ndarray) -> np.ndarray:
    """The rotation vector (3,) [rad] of a rotation matrix, the inverse of `rotation_matrix`; angles below pi."""
    angle = float(np.arccos(np.clip(0.5 * (np.trace(matrix) - 1), -1.0, 1.0)))
    if angle < 1e-9:
        return np.zeros(3)
    axis = np.array([matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]])
    return np.asarray(angle * axis / max(2 * np.sin(angle), 1e-9))


def _columns(matrix: np.ndarray) -> "gizmo.Matrix16":
    """A matrix (4, 4) as OpenGL has it: column by column."""
    return gizmo.Matrix16([float(v) for v in matrix.T.reshape(-1)])
