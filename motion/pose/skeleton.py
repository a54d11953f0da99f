"""The skeleton of a character: bones with names, parents and a rest pose; and where it is at one time.

At rest the character faces +x, its legs and arms hang straight down and every bone's own axes are the world's. A bone begins at
its head, `offset` from its parent's head in the parent's axes; `tip` is its far end in its own. A pose is the root's place, a
rotation of each bone against its parent, and its stretch (motion.pose.bones). The positions of all joints follow:

    R_b = R_parent q_b,    head_b = head_parent + R_parent (stretch_parent * offset_b)
"""

from typing import NamedTuple

import numpy as np

from motion.characters.character import Character
from motion.pose.bones import BONES, parent_of
from motion.pose.limbs import TAIL, neck_links

WING = (0.12, 0.23, 0.10)
"""Where wings begin, from the com, in nominal legs; the second times the bird's girth."""


class Skeleton(NamedTuple):
    """B bones of one character, parents first, metres; world axes at rest."""

    names: tuple[str, ...]
    parent: np.ndarray  # (B,) index, -1 of the root
    offset: np.ndarray  # (B, 3) head of the bone from that of its parent; of the root its height when standing
    tip: np.ndarray  # (B, 3) far end of the bone from its head


def skeleton_of(character: Character) -> Skeleton:
    """The bones that a character has."""
    offsets, tips = _offsets(character), _tips(character)
    names = tuple(name for name in BONES if _has(character, name))
    parents = []
    for name in names:
        above = parent_of(name)
        while above and above not in names:  # a leg of two links has no metatarsus
            above = parent_of(above)
        parents.append(names.index(above) if above else -1)
    return Skeleton(
        names, np.array(parents), np.array([offsets[name] for name in names], np.float64),
        np.array([tips[name] for name in names], np.float64),
    )  # fmt: skip


def _has(character: Character, name: str) -> bool:
    body = character.biped.body
    if name.startswith(("upper_arm", "forearm", "hand")):
        return body.upper_arm + body.forearm > 0
    if name.startswith("metatarsus"):
        return character.biped.leg.metatarsus > 0
    if name == "neck_2":
        return body.head_bob > 0
    if name.startswith("tail"):
        return body.tail_length > 0
    return character.look.plan == "bird" if name.startswith("wing") else True


def _offsets(character: Character) -> dict[str, tuple[float, float, float]]:
    """Of every bone that there can be."""
    leg, foot, body, nothing = character.biped.leg, character.biped.foot, character.biped.body, (0.0, 0.0, 0.0)
    unit = leg.nominal_length
    chest = (body.shoulder_forward, 0.0, body.shoulder_up)
    wing = (WING[0] * unit - chest[0], WING[1] * character.look.girth * unit, WING[2] * unit - chest[2])
    below, (lower, upper) = leg.metatarsus if leg.metatarsus > 0 else leg.shank, neck_links(character.biped)
    standing = -leg.hip_up + leg.thigh + leg.shank + leg.metatarsus + foot.ankle_height
    single = {
        "root": (0.0, 0.0, standing), "body": nothing, "pelvis": nothing, "spine": nothing, "chest": chest,
        "neck": (body.neck_forward - chest[0], 0.0, body.neck_up - chest[2]), "neck_2": lower,
        "head": upper if body.head_bob > 0 else (body.head_forward - body.neck_forward, 0.0, body.head_up - body.neck_up),
        "tail_1": (body.tail_forward, 0.0, body.tail_up),
    } | {f"tail_{k + 1}": (-body.tail_length / TAIL, 0.0, 0.0) for k in range(1, TAIL)}  # fmt: skip
    left = {
        "upper_arm": (0.0, body.shoulder_side, 0.0), "forearm": (0.0, 0.0, -body.upper_arm), "hand": (0.0, 0.0, -body.forearm),
        "thigh": (leg.hip_forward, leg.hip_side, leg.hip_up), "shank": (0.0, 0.0, -leg.thigh),
        "metatarsus": (0.0, 0.0, -leg.shank), "foot": (0.0, 0.0, -below),
        "toes": (foot.ball_forward - foot.ankle_forward, 0.0, -foot.ankle_height), "wing": wing,
    }  # fmt: skip
    return single | _both_sides(left)


def _tips(character: Character) -> dict[str, tuple[float, float, float]]:
    """Where each bone ends: at its child, or where nothing follows."""
    leg, foot, body, nothing = character.biped.leg, character.biped.foot, character.biped.body, (0.0, 0.0, 0.0)
    offsets = _offsets(character)
    single = {
        "root": nothing, "body": nothing, "pelvis": (leg.hip_forward, 0.0, leg.hip_up), "spine": offsets["chest"],
        "chest": offsets["neck"], "neck": offsets["neck_2" if _has(character, "neck_2") else "head"],
        "neck_2": offsets["head"], "head": (0.0, 0.0, 0.1 * leg.nominal_length),
    } | {f"tail_{k + 1}": (-body.tail_length / TAIL, 0.0, 0.0) for k in range(TAIL)}  # fmt: skip
    left = {
        "upper_arm": offsets["forearm_left"], "forearm": offsets["hand_left"], "hand": (0.0, 0.0, -0.2 * body.forearm),
        "thigh": offsets["shank_left"], "shank": (0.0, 0.0, -leg.shank), "metatarsus": offsets["foot_left"],
        "foot": (-0.5 * foot.length - foot.ankle_forward, 0.0, -foot.ankle_height),
        "toes": (0.5 * foot.length - foot.ball_forward, 0.0, 0.0), "wing": (-0.4 * leg.nominal_length, 0.0, 0.0),
    }  # fmt: skip
    return single | _both_sides(left)


def _both_sides(left: dict[str, tuple[float, float, float]]) -> dict[str, tuple[float, float, float]]:
    """The left side's bones, and their mirror images."""
    both = {}
    for name, (x, y, z) in left.items():
        both[f"{name}_left"], both[f"{name}_right"] = (x, y, z), (x, -y, z)
    return both
