"""A record of numbers of each of WIDE characters: `biped.leg.thigh` is then Lanes."""

from typing import Any

import numba
import numpy as np
from llvmlite import ir
from numba.core import cgutils, types
from numba.core.typing.templates import AttributeTemplate, infer_getattr, signature
from numba.extending import lower_getattr_generic, models, register_model

from worlds.compiled.beside.wide import NUMBERS, WIDE, addresses, gather, lanes_in
from worlds.compiled.jit import intrinsic, stack_array


class BesideType(types.Type):
    """A record's numbers side by side, or those of a table in it, from number `first` on."""

    def __init__(self, record: Any, first: int = 0) -> None:
        self.record, self.first = record, first
        super().__init__(name=f"beside({record}, {first})")


@register_model(BesideType)
class _BesideModel(models.PrimitiveModel):
    def __init__(self, manager: Any, fe_type: Any) -> None:
        super().__init__(manager, fe_type, ir.DoubleType().as_pointer())


@infer_getattr
class _Number(AttributeTemplate):
    key = BesideType

    def generic_resolve(self, kind: Any, name: str) -> Any:  # type: ignore[override]
        field = kind.record.fields.get(name)
        if field is None:
            return None
        first = kind.first + field.offset // 8
        return BesideType(field.type, first) if isinstance(field.type, types.Record) else NUMBERS


@lower_getattr_generic(BesideType)
def _number(context: Any, builder: Any, kind: Any, value: Any, name: str) -> Any:
    field = kind.record.fields[name]
    if isinstance(field.type, types.Record):
        return value
    at = builder.gep(value, [ir.Constant(ir.IntType(64), WIDE * (kind.first + field.offset // 8))])
    return builder.load(builder.bitcast(at, NUMBERS.vector.as_pointer()), align=8)


def records_beside(dtype: np.dtype) -> Any:
    """What makes, of an array of records of these numbers and of Wholes, the records' numbers side by side, on the stack."""
    record, many = numba.from_dtype(dtype), dtype.itemsize // 8
    kind, room = BesideType(record), stack_array(many, WIDE)

    @intrinsic
    def make(_, records, rows, block):
        def codegen(context, builder, sig, args):
            array = context.make_array(records)(context, builder, args[0])
            base, size = builder.ptrtoint(array.data, ir.IntType(64)), context.get_constant(types.intp, dtype.itemsize)
            first = lanes_in(builder, addresses(context, builder, base, args[1], size))
            block_at = context.make_array(block)(context, builder, args[2]).data
            with cgutils.for_range(builder, context.get_constant(types.intp, many)) as loop:
                offset = builder.mul(loop.index, ir.Constant(ir.IntType(64), 8))
                found = gather(context, builder, types.float64, [builder.add(one, offset) for one in first])
                at = builder.gep(block_at, [builder.mul(loop.index, ir.Constant(ir.IntType(64), WIDE))])
                builder.store(found, builder.bitcast(at, found.type.as_pointer()), align=8)
            return block_at

        return signature(kind, records, rows, block), codegen

    return make, room
