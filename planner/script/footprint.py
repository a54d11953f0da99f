"""A footprint as a person or a program gives it: the paper's five degrees of freedom, and a few more."""

from typing import Annotated, Literal

from pydantic import Field

from worlds.ground import Finite, Part, Point

Seconds = Annotated[float, Field(gt=0, le=60, allow_inf_nan=False, strict=True)]
Pause = Annotated[float, Field(ge=0, le=60, allow_inf_nan=False, strict=True)]
Moment = Annotated[float, Field(gt=0, le=10_000, allow_inf_nan=False, strict=True)]
Crouch = Annotated[float, Field(ge=0.5, le=1.05, allow_inf_nan=False, strict=True)]


class Footprint(Part):
    """Where a foot rests, and for how long. What is not given is automatic."""

    side: Literal["left", "right"]
    position: Point  # of the sole's middle [m]
    heading_deg: Finite = 0.0
    step_time: Seconds | None = None  # until the next footfall
    stance_time: Seconds | None = None
    stand: Pause = 0.0  # both feet stay this long, once this one has landed
    crouch: Crouch = 1.0  # share of the nominal leg length
    facing_deg: Finite = 0.0  # the body turns away from the feet
    inferred: bool = False  # nobody has seen it: it was put where a missing one must have been
    at: Moment | None = None  # it is there at this time of the scene: the steps before share the difference
