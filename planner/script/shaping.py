"""What an animator does to a motion beyond its footprints: stretches of steps that bend the rules, pulls on the centre of mass,
and hand keys on bones. All are tied to footprints by their numbers, so they go with them when timing changes."""

from dataclasses import replace
from math import radians
from typing import Annotated

from pydantic import Field, model_validator

from motion.characters.character import Character
from motion.characters.dimensions import Dimensions
from motion.motion import Pull
from motion.pose.bones import INDEX
from planner.script.laying import Laid
from planner.script.turned import BoneKey
from worlds.errors import InputError
from worlds.errors.wording import nearest
from worlds.ground import Finite, Part

Number = Annotated[int, Field(ge=0, le=40_000, strict=True)]
"""Of a footprint of the track, in the order in which they are walked, from 0."""
Manner = Annotated[float, Field(ge=0, le=3, allow_inf_nan=False, strict=True)]
Factor = Annotated[float, Field(ge=0.05, le=5, allow_inf_nan=False, strict=True)]
After = Annotated[float, Field(ge=-60, le=60, allow_inf_nan=False, strict=True)]
KEYED = tuple(name for name in INDEX if name != "root")
"""Bones that can be turned by hand: all but the root, on which the legs hang."""
LEAST_BLEND = 0.02


class Manners(Part):
    """How a character carries itself, beside what is its own: 1 as it is, less and more of it."""

    bounce: Manner = 1.0  # how far legs give under the load, and how freely
    sway: Manner = 1.0  # roll of the body and drop of the pelvis
    twist: Manner = 1.0  # turns of pelvis and chest
    arms: Manner = 1.0  # swing of the arms
    lean_deg: Annotated[float, Field(ge=-45, le=45, strict=True)] = 0.0  # forward at speed, more than its own


class Style(Manners):
    """Manners throughout a track."""

    heaviness: Annotated[float, Field(ge=0.3, le=2, strict=True)] = 1.0  # share of gravity that all steps reckon with


class Stretch(Manners):
    """Steps that exaggerate: from the contact of one footprint to the contact after another. Its manners come on top of the
    track's; they come over the step before it and go over the step after it."""

    first: Number
    last: Number
    gravity: Factor = 1.0  # share of gravity that the motion reckons with: less floats, more is heavy
    comfort: Factor = 1.0  # share of the comfort weight: less lets legs be a spring, more holds the body at its height
    leg: Annotated[float, Field(ge=0.5, le=1.1, strict=True)] = 1.0  # share of the comfortable leg: less crouches

    @model_validator(mode="after")
    def _forward(self) -> "Stretch":
        if self.last < self.first:
            raise ValueError(f"last = {self.last} is before first = {self.first}; give the smaller number first")
        return self


def styled(character: Character, style: Style) -> Character:
    """A character with a style: its dimensions are changed where they say how it moves, never how long its bones are."""
    if style == Style():
        return character
    biped = character.biped.copy()  # type: ignore[attr-defined]
    biped["leg"]["loading"] *= style.bounce
    biped["leg"]["push_off"] *= style.bounce
    biped["leg"]["comfort_weight"] *= freedom(style.bounce)
    carry(biped, style, 1.0)
    return replace(character, biped=biped)


def freedom(bounce: float) -> float:
    """Share of the comfort weight that is left where legs give so many times as much."""
    return 1 / (0.25 + 0.75 * bounce)


def carry(biped: Dimensions, manners: Manners, weight: float) -> None:
    """Changes how a body is carried, in its dimensions, by a share of manners: 1 wholly, 0 not at all."""
    body = biped["body"]  # type: ignore[index]
    for names, share in (
        (("roll_amplitude", "pelvis_drop"), manners.sway), (("pelvis_turn", "chest_turn"), manners.twist),
        (("arm_swing",), manners.arms),
    ):  # fmt: skip
        for name in names:
            body[name] *= 1 + weight * (share - 1)
    body["lean_speed"] += weight * radians(manners.lean_deg)


class ComPull(Part):
    """A soft constraint: the centre of mass is pulled toward a place, at a time after a footprint's contact."""

    footprint: Number
    after: After = 0.0  # [s]
    position: tuple[Finite, Finite, Finite]  # [m]
    stiffness: Annotated[float, Field(gt=0, le=1e5, strict=True)] = 300.0  # [1/s/m]


class Key(Part):
    """A hand key: a bone is turned further than the motion has it, at a time after a footprint's contact, and blends back."""

    bone: str
    footprint: Number
    after: After = 0.0  # [s]
    rotation_deg: tuple[Finite, Finite, Finite]  # rotation vector in the bone's own frame
    blend: Annotated[float, Field(ge=LEAST_BLEND, le=60, strict=True)] = 0.3  # from nothing to all of it, and back [s]

    @model_validator(mode="after")
    def _a_bone(self) -> "Key":
        if self.bone not in KEYED:
            raise ValueError(f"bone = {self.bone!r} cannot be turned{nearest(self.bone, KEYED)}")
        return self


def stretched(laid: Laid, stretches: tuple[Stretch, ...], style: Style) -> Laid:
    """Writes the stretches into laid footprints: those from the first to the last, and what stands between."""
    footprints, rows = laid
    footprints.gravity[:] *= style.heaviness
    for one in stretches:
        if one.first < len(rows):
            last = rows[one.last + 1] if one.last + 1 < len(rows) else len(footprints.side)
            part = slice(int(rows[one.first]), int(last))
            footprints.gravity[part] *= one.gravity
            footprints.comfort[part] *= one.comfort * freedom(one.bounce)
            footprints.bounce[part] *= one.bounce
            footprints.nominal_length[part] *= one.leg
    return laid


def pulls_of(laid: Laid, pulls: tuple[ComPull, ...]) -> tuple[Pull, ...]:
    """Pulls by the scene's time; those tied to footprints that are not there do nothing."""
    return tuple(
        Pull(time_of(laid, one.footprint, one.after), one.position, one.stiffness)
        for one in pulls
        if one.footprint < len(laid.row)
    )  # fmt: skip


def keys_of(laid: Laid, keys: tuple[Key, ...]) -> tuple[BoneKey, ...]:
    """Hand keys by the scene's time and in radians."""
    found = []
    for one in keys:
        x, y, z = (radians(angle) for angle in one.rotation_deg)
        found.append(BoneKey(one.bone, time_of(laid, one.footprint, one.after), (x, y, z), one.blend))
    return tuple(found)


def time_of(laid: Laid, footprint: int, after: float) -> float:
    """The scene's time [s], so long after the contact of a footprint of the track."""
    return float(laid.footprints.contact_time[laid.row[footprint]]) + after


def check_numbers(track_name: str, count: int, stretches: tuple[Stretch, ...], tied: tuple[ComPull | Key, ...]) -> None:
    """Whether all footprints that are named are there. Raises InputError."""
    for name, number in [("stretch.last", s.last) for s in stretches] + [(type(one).__name__, one.footprint) for one in tied]:
        if number >= count:
            raise InputError(f"{track_name}: {name} = {number}: there are {count} footprints; 0 to {count - 1} are allowed")
