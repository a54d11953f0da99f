"""The dimensions of a biped: what kernels know of a character. A table here is a table of its file, a line is a key.

Each line: the number's meaning, its unit by the function that declares it, and its range where that differs from the unit's
own (see quantities). What kernels get is one record of these tables, in SI units and radians: biped.leg.thigh. The classes
are never made: they give the record's fields their names and types.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from motion.characters.quantities import degrees, dtype_of, metres, place, quantities_of, share, weight


class Leg:
    """[leg]: the virtual leg from hip to ankle, and the links that it is made of."""

    nominal_length: float = metres("virtual leg that is comfortable, hip to ankle")
    max_length: float = metres("virtual leg at full extension")
    min_length: float = metres("virtual leg at the knee's limit of flexion: a swinging leg is not bent more")
    hip_forward: float = place("hips relative to the com, along the heading")
    hip_side: float = metres("half the hip spacing")
    hip_up: float = place("hips relative to the com, upward: negative")
    thigh: float = metres("hip to knee")
    shank: float = metres("knee to ankle, or to the hock of a three-link leg")
    metatarsus: float = metres("hock to ankle; 0 for a leg of two links", low=0.0)
    femur: float = degrees("thigh of a three-link leg, forward of straight down", default=0.0, high=120)
    femur_swing: float = share("share of the leg's swing that the thigh of a three-link leg takes part in", default=1.0)
    shank_radius: float = metres("of the leg below the knee: shanks keep apart by two of them")
    comfort_weight: float = weight("k of the comfort cost")
    loading: float = share("share by which the leg gives when it takes the load", high=0.2, default=0.0)
    push_off: float = share("share by which it is shorter when the foot leaves", high=0.3, default=0.0)


class Foot:
    """[foot]: the sole, and how it rolls."""

    length: float = metres("sole, heel to toe")
    width: float = metres("sole")
    ankle_forward: float = place("ankle from the middle of the sole, along the foot")
    ankle_height: float = metres("ankle above the sole")
    ball_forward: float = place("ball, about which the heel rises, from the middle of the sole")
    heel_off_fraction: float = share("share of the stance, at its end, in which the heel rises", high=0.9)
    heel_off_angle: float = degrees("pitch of the foot when it leaves")
    heel_strike_angle: float = degrees(
        "pitch of the foot when its heel comes down first; 0 lands flat, or on the toes", high=60
    )


class Body:
    """[body]: trunk, head, arms and tail."""

    radius: float = metres("to keep from trees and walls")
    depth: float = metres("chest to back, to keep from others; 0: twice the radius", low=0.0, default=0.0)
    width: float = metres("shoulder to shoulder, to keep from others; 0: twice the radius", low=0.0, default=0.0)
    pitch_amplitude: float = degrees("of the body over a step")
    roll_amplitude: float = degrees("of the body over a stride")
    lean_gain: float = share("share of the lateral acceleration's angle that the body leans into", high=3)
    lean_speed: float = degrees("forward lean at a speed of sqrt(g h)", low=-90)
    pelvis_drop: float = degrees("of the pelvis toward the swinging leg")
    pelvis_turn: float = degrees("of the pelvis with the legs, either way")
    chest_turn: float = degrees("of the chest against the pelvis, either way")
    neck_forward: float = place("base of the neck from the com, along the body")
    neck_up: float = place("base of the neck from the com, upward")
    head_forward: float = place("middle of the head from the com, along the body")
    head_up: float = place("middle of the head from the com, upward")
    head_bob: float = share("share of a step that the head stays behind in place before it is thrust forward, as birds do")
    head_steady: float = share("share of the body's pitch and roll that the head does not take part in")
    shoulder_forward: float = place("shoulder from the com, along the body")
    shoulder_side: float = metres("half the shoulders' spacing", low=0.0)
    shoulder_up: float = place("shoulder from the com, upward")
    upper_arm: float = metres("shoulder to elbow; 0 without arms", low=0.0)
    forearm: float = metres("elbow to hand", low=0.0)
    arm_swing: float = share("swing of the upper arm against the legs, per radian of theirs", high=3)
    elbow_bend: float = degrees("of a resting arm; runners bend more", high=150)
    tail_forward: float = place("root of the tail from the com, along the body: negative")
    tail_up: float = place("root of the tail from the com, upward")
    tail_length: float = metres("of the tail; 0 without one", low=0.0)
    tail_rise: float = degrees("of the tail from its root to its tip, above the body's axis", low=-90)
    tail_sway: float = share("how much the tail lags behind the body's turns and sways: 1 plainly, 0 not", high=3)


class Gait:
    """[gait]: how it goes when nothing hinders."""

    step_width: float = metres("between the lines of left and right footprints")
    run_narrower: float = share("share by which that is less at a run", default=0.0)
    toe_out: float = degrees("how far its feet point outward", low=-45, high=45, default=0.0)
    preferred_step: float = metres("when nothing hinders")
    variation: float = share(
        "by how much steps of a walker's own choice differ in length, as a standard deviation", high=0.2, default=0.0
    )
    clearance: float = metres("foot above the ground at mid-swing")
    run_lift: float = metres("how much higher the foot is lifted at a run of Froude number 1 or more", low=0.0)
    run_crouch: float = share(
        "share by which the nominal leg is shorter at a Froude number of 1 or more; less below, none walking", high=0.5
    )


class Reach:
    """[reach]: the longest, highest and sharpest that it steps."""

    max_step: float = metres("longest walking step")
    leap_length: float = metres("a step longer than this is a leap")
    max_leap: float = metres("longest leap")
    max_rise: float = metres("highest step up")
    max_drop: float = metres("deepest step down")
    max_turn: float = degrees("largest change of heading in a step", low=1, high=180)


class Timing:
    """[timing]: from the distance stepped to the times of a footprint (planner.stepping.timing)."""

    hip_height: float = metres("height of the hips when standing: h of the timing law")
    walking_duty: float = share("share of the stride that a foot stands at the slowest walk; it falls with speed", 0.5, 0.95)
    gait_smoothness: float = share("0 changes abruptly from walk to run, 1 gradually")
    run_speed: float = share(
        "speed in sqrt(g h) of a run whose steps are as long as the hips are high; 0: by the law of the walk",
        high=3,
        default=0.0,
    )
    takeoff_angle: float = degrees("of a leap, from the horizontal", low=5, high=80)
    turn_slowdown: float = share("share by which a turn of one radian lengthens the step time", high=10)
    rise_slowdown: float = share("share by which a rise of one hip height lengthens the step time", high=10)


class Dimensions:
    """One biped: the tables above, as one record."""

    leg: Leg
    foot: Foot
    body: Body
    gait: Gait
    reach: Reach
    timing: Timing


TABLES: dict[str, type] = dict(Dimensions.__annotations__)
DIMENSIONS = np.dtype([(name, dtype_of(table)) for name, table in TABLES.items()])
"""A biped in an array of them."""


def empty_bipeds(count: int) -> Any:
    """A recarray (count,) of DIMENSIONS, all zero: indexing it gives Dimensions."""
    return np.zeros(count, DIMENSIONS).view(np.recarray)


def record_of(number: Callable[[str, str], float]) -> Dimensions:
    """The record whose fields are number(table, name) [SI units, radians]."""
    bipeds = empty_bipeds(1)
    for name, table in TABLES.items():
        for field in quantities_of(table):
            bipeds[name][field] = number(name, field)
    return bipeds[0]


def flat_name(table: str, field: str) -> str:
    """The one name that a number has where there are no tables: foot_length is the length of [foot]."""
    return f"{table}_{field}" if field in ("length", "width", "radius") else field
