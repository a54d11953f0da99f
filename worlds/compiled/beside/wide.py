"""What WIDE numbers side by side are read from: as many addresses, and what lies there."""

from typing import Any

from llvmlite import ir
from numba.core import types

from worlds.compiled.kinds import LanesType, MaskType, WholesType, spread, truths

WIDE = 8
"""Characters, or pieces of a curve, that are worked on at once: as many as the widest of today's registers hold."""
WHOLES, NUMBERS = WholesType(WIDE), LanesType(WIDE)


def addresses(context: Any, builder: Any, base: Any, index: Any, stride: Any) -> Any:
    """Base, one address or WIDE of them, and index times stride behind it."""
    if base.type == ir.IntType(64):
        base = spread(context, builder, types.int64, base, WHOLES)
    return builder.add(base, builder.mul(index, spread(context, builder, types.int64, stride, WHOLES)))


def element_of(dtype: Any) -> Any:
    """What WIDE elements are."""
    if isinstance(dtype, types.Boolean):
        return MaskType(WIDE)
    return LanesType(WIDE) if isinstance(dtype, types.Float) else WHOLES


def lanes_in(builder: Any, vector: Any) -> list[Any]:
    """Each lane of a vector."""
    return [builder.extract_element(vector, ir.Constant(ir.IntType(32), k)) for k in range(WIDE)]


def gather(context: Any, builder: Any, dtype: Any, places: list[Any]) -> Any:
    """What lies at WIDE addresses."""
    element = context.get_data_type(dtype)
    found = ir.Constant(ir.VectorType(element, WIDE), ir.Undefined)
    for k, at in enumerate(places):
        one = builder.load(builder.inttoptr(at, element.as_pointer()))
        found = builder.insert_element(found, one, ir.Constant(ir.IntType(32), k))
    if isinstance(dtype, types.Boolean):
        return truths(builder, builder.icmp_unsigned("!=", found, ir.Constant(found.type, [0] * WIDE)))
    return found
