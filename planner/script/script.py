"""From a scene to footprints: given one by one, or laid along a Hermite path with a step length (paper, Fig. 4)."""

from math import radians
from typing import NamedTuple

import numpy as np

from motion.characters.biped import Biped
from planner.script.scene import Print, Scene, Stretch
from planner.stepping import strides
from worlds.errors import InputError

PIECES = 64
"""Straight pieces by which a Hermite piece of a path is measured."""


class Script(NamedTuple):
    """What a character does after its first two footprints: K rows, each a footprint, or standing on where it stands."""

    side: np.ndarray  # (K,) 0 left, 1 right
    place: np.ndarray  # (K, 2) [m]
    heading: np.ndarray  # (K,) [rad], unwrapped
    wait: np.ndarray  # (K,) seconds to stand on; 0: this row is a step
    step_time: np.ndarray  # (K,) of the footprint before [s]; NaN: automatic
    stance_time: np.ndarray  # (K,) the same
    crouch: np.ndarray  # (K,) share of the nominal leg length
    facing: np.ndarray  # (K,) [rad]
    support: int  # ROLL, MIDDLE or TOE
    rest: float  # standing at the end [s]


ROLL, MIDDLE, TOE = range(3)
SUPPORTS = {"roll": ROLL, "middle": MIDDLE, "toe": TOE}
"""Where a standing foot presses: rolling from heel to toe, or at one place throughout (paper, section 2.4)."""


def prints_of(scene: Scene, biped: Biped) -> list[Print]:
    """The scene's footprints, those along a path laid out; the first two are stood on."""
    return list(scene.footprints) if scene.path is None else _along(scene.path, biped)


def script_of(scene: Scene, prints: list[Print]) -> Script:
    """The script of a scene's footprints. Raises InputError where feet cannot do that."""
    rows: list[tuple] = []
    headings = _unwrapped(prints)
    if scene.stand_before:
        rows += _standing(prints, 1, prints[2].side, scene.stand_before, headings)
    for i in range(2, len(prints)):
        before, p = prints[i - 1], prints[i]
        timing = (np.nan if t is None else t for t in (before.step_time, before.stance_time))
        rows.append((p.side == "right", *p.position, headings[i], 0.0, *timing, p.crouch, radians(p.facing_deg)))
        if p.stand:
            if prints[i - 1].side == p.side:
                raise InputError(
                    f"{scene.name}: footprint.{i}.stand: after a hop the other foot is in the air; add its footprint"
                )
            rows += _standing(prints, i, prints[i + 1].side if i + 1 < len(prints) else before.side, p.stand, headings)
    columns = np.array(rows, np.float64)
    side, x, y, *rest = columns.T
    heading, wait, step_time, stance_time, crouch, facing = (column.copy() for column in rest)
    return Script(
        side.astype(np.int64), np.column_stack([x, y]), heading, wait, step_time, stance_time, crouch, facing,
        support=SUPPORTS[scene.support], rest=scene.stand_after,
    )  # fmt: skip


def _unwrapped(prints: list[Print]) -> np.ndarray:
    return np.unwrap(np.radians([p.heading_deg for p in prints]))


def _standing(prints: list[Print], i: int, following: str, seconds: float, headings) -> list[tuple]:
    """Rows of standing on footprints i - 1 and i, in the order that lets foot `following` step next."""
    order = [i - 1] if prints[i - 1].side != following else [i - 1, i]
    return [
        (prints[k].side == "right", *prints[k].position, headings[k], seconds / len(order), np.nan, np.nan, prints[i].crouch,
         radians(prints[i].facing_deg))
        for k in order
    ]  # fmt: skip


def hermite_path(points) -> np.ndarray:
    """Points (P, 2) along the cubic Hermite curve through given ones; a tangent is half the way between its neighbours."""
    p = np.array(points, np.float64)
    if len(p) == 2:
        return p
    tangents = np.gradient(p, axis=0)
    s = np.linspace(0, 1, PIECES + 1)[:, None]
    pieces = [
        (2 * s**3 - 3 * s**2 + 1) * a + (s**3 - 2 * s**2 + s) * u + (3 * s**2 - 2 * s**3) * z + (s**3 - s**2) * v
        for a, z, u, v in zip(p[:-1], p[1:], tangents[:-1], tangents[1:], strict=True)
    ]
    return np.vstack([pieces[0], *(piece[1:] for piece in pieces[1:])])


def _distances(stretch: Stretch, length: float) -> np.ndarray:
    """Where along the way the feet land; all steps a little longer or shorter, so that they end where it ends."""
    lengths = np.atleast_1d(np.array(stretch.step_length, np.float64))
    ends = [0.0]
    while ends[-1] < length:
        share = np.linspace(0, 1, len(lengths))
        ends.append(ends[-1] + float(np.interp(ends[-1] / length, share, lengths)))
    if len(ends) > 2 and ends[-1] - length > 0.5 * (ends[-1] - ends[-2]):
        ends.pop()
    return np.array(ends[1:]) * length / ends[-1]


def _along(stretch: Stretch, biped: Biped) -> list[Print]:
    line = hermite_path(stretch.points)
    length = float(np.hypot(*np.diff(line, axis=0).T).sum())
    middles, ways = strides.along(line, np.concatenate([[0.0, 0.0], _distances(stretch, length), [length]]))
    width = biped.record.step_width if stretch.step_width is None else stretch.step_width
    side = 1 if stretch.first == "left" else 0  # the foot that steps first is the older of the two stood on
    prints = []
    for k, (middle, way) in enumerate(zip(middles, np.unwrap(ways), strict=True)):
        foot = (side + k + 1) % 2
        heading = way + radians(stretch.feet_deg)
        across = 0.5 * width * (1 - 2 * foot)
        place = (middle[0] - across * np.sin(heading), middle[1] + across * np.cos(heading))
        prints.append(_print(stretch, foot, place, heading, k > 1, last=k == len(middles) - 1))
    return prints


def _print(stretch: Stretch, foot: int, place, heading: float, moving: bool, last: bool) -> Print:
    return Print(
        side="right" if foot else "left",
        position=place,
        heading_deg=float(np.degrees(heading)),
        step_time=stretch.step_time if moving else None,
        stance_time=stretch.stance_time if moving else None,
        stand=stretch.stand if last else 0.0,
        crouch=stretch.crouch,
        facing_deg=stretch.facing_deg,
    )
