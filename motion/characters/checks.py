"""What the numbers of a character may get wrong together, though each is in its range."""

from motion.characters.dimensions import Dimensions


def faults(biped: Dimensions) -> list[str]:
    """Every contradiction: the keys, their values, and what is allowed."""
    leg, foot, gait, reach = biped.leg, biped.foot, biped.gait, biped.reach
    links = leg.thigh + leg.shank + leg.metatarsus
    upper, lower = leg.thigh + leg.metatarsus, leg.shank
    orders = (
        ("leg.min_length", leg.min_length, "leg.nominal_length", leg.nominal_length),
        ("leg.nominal_length", leg.nominal_length, "leg.max_length", leg.max_length),
        ("leg.max_length", leg.max_length, "the links of the leg (thigh + shank + metatarsus)", links),
        ("the shortest that the links can fold to (thigh + metatarsus - shank)", abs(upper - lower), "leg.min_length",
         leg.min_length),
        ("gait.preferred_step", gait.preferred_step, "reach.max_step", reach.max_step),
        ("reach.max_step", reach.max_step, "reach.max_leap", reach.max_leap),
        ("reach.leap_length", reach.leap_length, "reach.max_leap", reach.max_leap),
        ("foot.ankle_forward, either way,", abs(foot.ankle_forward), "half of foot.length", 0.5 * foot.length),
        ("foot.ball_forward, either way,", abs(foot.ball_forward), "half of foot.length", 0.5 * foot.length),
    )  # fmt: skip
    return [
        f"{less} = {small:.4g} m must not be more than {more} = {large:.4g} m; make one of them fit"
        for less, small, more, large in orders
        if small > large + 1e-9
    ]
