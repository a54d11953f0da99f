"""Who walks: the dimensions of a biped, from `characters/*.toml`.

A character file has a `[biped]` table with one number per field below (lengths in metres, angles in degrees with the
suffix _deg), and a `[body]` table of shapes that only the view reads.
"""

import math
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, ValidationError, create_model

CHARACTERS = Path(__file__).parent

FIELDS = {
    "nominal_length": "virtual leg that is comfortable, hip to ankle [m]",
    "max_length": "virtual leg at full extension [m]",
    "hip_forward": "left hip relative to the com, along the heading [m]",
    "hip_side": "half the hip spacing [m]",
    "hip_up": "hips relative to the com, upward: negative [m]",
    "thigh": "hip to knee [m]",
    "shank": "knee to ankle, or to the hock of a three-link leg [m]",
    "metatarsus": "hock to ankle [m]; 0 for a leg of two links",
    "foot_length": "sole, heel to toe [m]",
    "foot_width": "sole [m]",
    "ankle_forward": "ankle from the middle of the sole, along the foot [m]",
    "ankle_height": "ankle above the sole [m]",
    "ball_forward": "ball, about which the heel rises, from the middle of the sole [m]",
    "heel_off_fraction": "share of the stance, at its end, in which the heel rises",
    "heel_off_angle": "pitch of the foot when it leaves [rad]",
    "heel_strike_angle": "pitch of the foot when its heel comes down first [rad]; 0 lands flat, or on the toes",
    "min_length": "virtual leg at the knee's limit of flexion: a swinging leg is not bent more [m]",
    "shank_radius": "of the leg below the knee: shanks keep apart by two of them [m]",
    "comfort_weight": "k of the comfort cost [1/s^2/m]",
    "hip_height": "height of the hips when standing: h of the timing law [m]",
    "body_radius": "to keep from trees [m]",
    "clearance": "foot above the ground at mid-swing [m]",
    "run_lift": "how much higher the foot is lifted at a run of Froude number 1 or more [m]",
    "step_width": "between the lines of left and right footprints [m]",
    "preferred_step": "when nothing hinders [m]",
    "max_step": "longest walking step [m]",
    "max_leap": "longest leap [m]",
    "max_rise": "highest step up [m]",
    "max_drop": "deepest step down [m]",
    "max_turn": "largest change of heading in a step [rad]",
    "leap_length": "a step longer than this is a leap [m]",
    "walking_duty": "share of the stride that a foot stands at the slowest walk; it falls with speed",
    "gait_smoothness": "0 changes abruptly from walk to run, 1 gradually",
    "takeoff_angle": "of a leap, from the horizontal [rad]",
    "turn_slowdown": "share by which a turn of one radian lengthens the step time",
    "rise_slowdown": "share by which a rise of one hip height lengthens the step time",
    "run_crouch": "share by which the nominal leg is shorter at a Froude number of 1 or more; in proportion below",
    "pitch_amplitude": "of the body over a step [rad]",
    "roll_amplitude": "of the body over a stride [rad]",
    "lean_gain": "share of the lateral acceleration's angle that the body leans into",
    "lean_speed": "forward lean at a speed of sqrt(g h) [rad]",
    "pelvis_drop": "of the pelvis toward the swinging leg [rad]",
    "pelvis_turn": "of the pelvis with the legs, either way [rad]",
    "chest_turn": "of the chest against the pelvis, either way [rad]",
    "neck_forward": "base of the neck from the com, along the body [m]",
    "neck_up": "base of the neck from the com, upward [m]",
    "head_forward": "middle of the head from the com, along the body [m]",
    "head_up": "middle of the head from the com, upward [m]",
    "head_bob": "share of a step that the head stays behind in place before it is thrust forward, as birds do",
    "head_steady": "share of the body's pitch and roll that the head does not take part in",
    "shoulder_forward": "shoulder from the com, along the body [m]",
    "shoulder_side": "half the shoulders' spacing [m]",
    "shoulder_up": "shoulder from the com, upward [m]",
    "upper_arm": "shoulder to elbow [m]; 0 without arms",
    "forearm": "elbow to hand [m]",
    "arm_swing": "swing of the upper arm against the legs, per radian of theirs",
    "elbow_bend": "of a resting arm [rad]; runners bend more",
    "tail_forward": "root of the tail from the com, along the body: negative [m]",
    "tail_up": "root of the tail from the com, upward [m]",
    "tail_length": "of the tail [m]; 0 without one",
    "tail_rise": "of the tail from its root to its tip, above the body's axis [rad]",
    "tail_sway": "how much the tail lags behind the body's turns and sways: 1 plainly, 0 not",
}
_ANGLES = {"heel_off_angle", "heel_strike_angle", "max_turn", "takeoff_angle", "pitch_amplitude", "roll_amplitude"}
_ANGLES |= {"lean_speed", "pelvis_drop", "pelvis_turn", "chest_turn", "elbow_bend", "tail_rise"}
_ANY_SIGN = {"hip_forward", "hip_up", "ankle_forward", "lean_speed", "tail_rise"}
_ANY_SIGN |= {f"{part}_{axis}" for part in ("neck", "head", "shoulder", "tail") for axis in ("forward", "up")}
_MAY_BE_ZERO = {
    "metatarsus",
    "gait_smoothness",
    "heel_off_fraction",
    "heel_off_angle",
    "lean_gain",
    "run_crouch",
    "head_bob",
    "run_lift",
}
_MAY_BE_ZERO |= {"head_steady", "shoulder_side", "upper_arm", "forearm", "arm_swing", "tail_length", "tail_sway"}
BIPED = np.dtype([(name, np.float64) for name in FIELDS])


@dataclass(frozen=True)
class Biped:
    """A character: its name, its record of BIPED for the kernels, and its file's [body] table for the view."""

    name: str
    record: np.record
    body: dict

    def to_dict(self) -> dict:
        """The dimensions as plain numbers, for a recording's meta."""
        return {"name": self.name, **{field: float(self.record[field]) for field in FIELDS}}


class CharacterError(ValueError):
    """A character file that cannot be used: every fault, with file, key, value and what is allowed."""


def _limits(name):
    if name in _ANY_SIGN:
        return Field(allow_inf_nan=False)
    if name in _MAY_BE_ZERO or name in _ANGLES or name.endswith(("slowdown",)):
        return Field(ge=0, allow_inf_nan=False)
    return Field(gt=0, allow_inf_nan=False)


def _definitions() -> dict[str, Any]:
    return {f"{name}_deg" if name in _ANGLES else name: (float, _limits(name)) for name in FIELDS}


_STRICT = ConfigDict(extra="forbid")
_Dimensions: Any = create_model(
    "_Dimensions",
    __config__=_STRICT,
    **_definitions(),
)


class _Character(BaseModel):
    model_config = _STRICT
    format: int = Field(ge=1, le=1)
    name: str = Field(min_length=1)
    biped: _Dimensions  # type: ignore[valid-type]
    body: dict = {}


def character_names() -> list[str]:
    """Names of the characters that ship."""
    return sorted(path.stem for path in CHARACTERS.glob("*.toml"))


def load_biped(name_or_path: str | Path) -> Biped:
    """A shipped character by name, or any character file by path. Raises CharacterError."""
    path = CHARACTERS / f"{name_or_path}.toml"
    if not path.exists():
        path = Path(name_or_path)
    if not path.is_file():
        raise CharacterError(f"{name_or_path}: no such character; there are {', '.join(character_names())}")
    try:
        parsed = _Character.model_validate(tomllib.loads(path.read_text(encoding="utf-8")))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise CharacterError(f"{path}: not a TOML file: {error}") from None
    except ValidationError as error:
        faults = [f"{'.'.join(map(str, e['loc']))} = {e['input']!r}: {e['msg']}" for e in error.errors()]
        raise CharacterError("\n".join(f"{path}: {fault}" for fault in faults)) from None
    values = parsed.biped.model_dump()
    plain = {name: math.radians(values[f"{name}_deg"]) if name in _ANGLES else values[name] for name in FIELDS}
    return Biped(parsed.name, record_of(plain), parsed.body)


def record_of(values: dict[str, float]) -> np.record:
    """The record of BIPED of these dimensions [SI units, radians]."""
    table = np.zeros(1, BIPED).view(np.recarray)
    for name in FIELDS:
        table[name] = values[name]
    return table[0]
