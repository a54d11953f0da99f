"""The one place that wraps numba's decorators.

A kernel keeps its Python signature for the type checker: what is decorated is called as it is written.
"""

import os
from collections.abc import Callable
from typing import Any, TypeVar

from worlds.compiled import cache

os.environ.setdefault("NUMBA_CACHE_DIR", str(cache.folder()))
os.environ.setdefault("NUMBA_THREADING_LAYER", "workqueue")

import numba  # noqa: E402  (the cache folder is read at import)
from llvmlite import ir  # noqa: E402
from numba.core import cgutils, types  # noqa: E402
from numba.extending import intrinsic as _intrinsic  # noqa: E402

# Where numba was imported before, it has not read them.
numba.config.CACHE_DIR = os.environ["NUMBA_CACHE_DIR"]  # type: ignore[attr-defined]
numba.config.THREADING_LAYER = os.environ["NUMBA_THREADING_LAYER"]  # type: ignore[attr-defined]

_OWNING: dict[str, Any] = {"cache": True, "error_model": "numpy", "nogil": True, "_nrt": True}
BORROWING: dict[str, Any] = _OWNING | {"_nrt": False}

Kernel = TypeVar("Kernel", bound=Callable)
intrinsic: Callable[[Callable], Callable[..., Any]] = _intrinsic
"""For functions that write the compiler's code: they are called without the first argument that they are written with."""


def _compiler(**options: Any) -> Callable[[Kernel], Kernel]:
    """A decorator that compiles with these options, and is plain to the type checker."""

    def decorate(kernel: Kernel) -> Kernel:
        return numba.njit(**options)(kernel)

    return decorate


jit = _compiler(**_OWNING)
jit_borrowing = _compiler(**BORROWING)
"""For kernels that make no arrays: they only borrow those they are given, and do not count who holds them. Counting is a
call and a locked addition for every mention of an array, which took half of the time. What they return must be numbers, or
tables that borrow (worlds.compiled.tables)."""
jit_inline = _compiler(**BORROWING, forceinline=True)
"""For the few small functions inside the hottest loops: a call would copy its arguments, arrays' headers included. They
make no arrays either."""
jit_parallel = _compiler(**_OWNING, parallel=True)


def kernel_of(function: Kernel) -> Kernel:
    """jit_borrowing, also of a function that was typed in at a prompt, which has no file to be kept beside."""
    try:
        return jit_borrowing(function)
    except RuntimeError:
        return _compiler(**(BORROWING | {"cache": False}))(function)


def start_threads() -> None:
    """Starts numba's threads, where they do not run yet: before any kernel is loaded that calls a parallel one.

    numba starts them when it loads a parallel kernel, but not when it loads one that calls it, if that was compiled while the
    parallel one came from the cache (a first start that was cut short, or two at once): its calls would lead nowhere.
    """
    numba.get_num_threads()


def stack_array(rows: int, columns: int) -> Any:
    """What makes a float64 array (rows, columns) on the stack, for kernels that make none; it lives while the kernel runs."""
    kind, shape = types.Array(types.float64, 2, "C"), (rows, columns)

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        data = cgutils.alloca_once(builder, ir.ArrayType(ir.DoubleType(), rows * columns))
        array = context.make_array(kind)(context, builder)
        numbers = [context.get_constant(types.intp, n) for n in (*shape, 8 * columns, 8)]
        context.populate_array(
            array,
            data=builder.bitcast(data, array.data.type),
            shape=cgutils.pack_array(builder, numbers[:2]),
            strides=cgutils.pack_array(builder, numbers[2:]),
            itemsize=numbers[3],
            meminfo=None,
        )
        return array._getvalue()

    @intrinsic
    def make(_: Any) -> Any:
        return kind(), codegen

    return make
