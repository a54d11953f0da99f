"""A gait cycle of the human, beside the curves of people: angles of hip, knee and ankle, and the force, contact to contact.

People's curves come from a file of somebody's data (CSV: dataset, gait, speed_mps, quantity, percent, mean; lines that begin
with # tell its source). Laboratories differ by an offset of some degrees, so shapes are compared without their mean difference.
Signs: hip and knee flexion and ankle dorsiflexion are positive; the hip is the thigh against the vertical.
"""

import csv
from pathlib import Path
from typing import NamedTuple

import numpy as np

from motion.arithmetic.gravity import GRAVITY
from motion.measures.forces import friction, needed_force
from motion.track.footprints import LEFT
from sim.stage.scripted.performance import Performance
from worlds.errors import InputError

ANGLES = ("hip_flexion", "knee_flexion", "ankle_dorsiflexion")
PERCENT = np.linspace(0, 100, 201)


class Cycle(NamedTuple):
    """One stride of the left leg, K moments from its contact to the next one."""

    percent: np.ndarray  # (K,) of the stride
    angles: dict[str, np.ndarray]  # of ANGLES, (K,) [deg]
    force: np.ndarray  # (K,) upward, of both feet, in body weights
    friction: np.ndarray  # (K,) that the force needs of the ground: level by upward; 0 where that is little
    speed: float  # [m/s]
    duty: float  # share of the stride that the foot stands


def cycle(show: Performance, n: int) -> Cycle:
    """The stride that begins with footprint n of a scene, of a left foot, and ends with n + 2."""
    motion, footprints = show.motion, show.motion.footprints
    if footprints.side[n] != LEFT or footprints.side[n + 2] != LEFT:
        raise ValueError(f"footprint {n} begins no stride of the left foot")
    begin, end = footprints.contact_time[n], footprints.contact_time[n + 2]
    poses = [motion.pose(t) for t in begin + (end - begin - 1e-9) * PERCENT / 100]
    points = {
        name: np.array([getattr(pose, name)[0, LEFT] for pose in poses]) for name in ("hip", "knee", "ankle", "heel", "ball")
    }
    thigh, shank = (_hanging(points[b] - points[a]) for a, b in (("hip", "knee"), ("knee", "ankle")))
    sole = points["ball"] - points["heel"]
    pitch = np.degrees(np.arctan2(sole[:, 2], np.hypot(sole[:, 0], sole[:, 1])) * np.sign(sole[:, 0] + 1e-12))
    needed = needed_force(np.array([pose.com_acceleration[0] for pose in poses])) / GRAVITY
    way = np.linalg.norm(footprints.position[n + 2, :2] - footprints.position[n, :2])
    angles = dict(zip(ANGLES, (thigh, thigh - shank, pitch - shank), strict=True))
    duty = footprints.stance_time[n] / (end - begin)
    return Cycle(PERCENT, angles, needed[:, 2], friction(needed), float(way / (end - begin)), float(duty))


def _hanging(way: np.ndarray) -> np.ndarray:
    """Angle forward [deg] of a bone that hangs, walking along x."""
    return np.degrees(np.arctan2(way[:, 0], -way[:, 2]))


def people_of(path: str | Path) -> dict[tuple[str, str], np.ndarray]:
    """Curves (K, 2), percent and degrees, by gait and quantity. Raises InputError."""
    curves: dict[tuple[str, str], list] = {}
    try:
        lines = [line for line in Path(path).read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
        for row in csv.DictReader(lines):
            curves.setdefault((row["gait"], row["quantity"]), []).append((float(row["percent"]), float(row["mean"])))
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{path}: cannot be read: {error}") from None
    except (KeyError, TypeError, ValueError) as error:
        raise InputError(f"{path}: is no table of curves (dataset,gait,speed_mps,quantity,percent,mean): {error!r}") from None
    if not curves:
        raise InputError(f"{path}: holds no curves")
    return {key: np.array(sorted(values)) for key, values in curves.items()}


def compared(ours: Cycle, quantity: str, theirs: np.ndarray) -> tuple[float, float]:
    """(rms difference [deg] without its mean, correlation) with a curve of people (K, 2)."""
    mine = np.interp(theirs[:, 0], ours.percent, ours.angles[quantity])
    apart = mine - theirs[:, 1]
    return float(np.std(apart)), float(np.corrcoef(mine, theirs[:, 1])[0, 1])


def at(ours: Cycle, values: np.ndarray, percent: float) -> float:
    """A curve's value at a percent of the stride."""
    return float(np.interp(percent, ours.percent, values))
