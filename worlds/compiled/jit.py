"""The one place that wraps numba's decorators.

A kernel keeps its Python signature for the type checker: what is decorated is called as it is written.
"""

import math
import os
import re
import warnings
from collections.abc import Callable
from typing import Any, TypeVar

import numpy as np

from worlds.compiled import cache, telling
from worlds.errors import InputError

_FOLDER = os.environ.get("NUMBA_CACHE_DIR") or cache.folder()
"""Where compiled kernels are kept; None where no folder is ours alone."""
if _FOLDER is not None:
    os.environ["NUMBA_CACHE_DIR"] = str(_FOLDER)
os.environ.setdefault("NUMBA_THREADING_LAYER", "workqueue")

try:
    with warnings.catch_warnings(record=True) as _said:
        warnings.simplefilter("always")
        import numba
    from llvmlite import ir
    from numba.core import cgutils, event, types
    from numba.core.caching import NullCache
    from numba.core.ccallback import CFunc
    from numba.extending import intrinsic as _intrinsic
except (ImportError, ValueError) as error:
    asked = ", ".join(f"{name}={value}" for name, value in sorted(os.environ.items()) if name.startswith("NUMBA_NUM"))
    raise InputError(f"numba, which compiles Footfall, does not start: {error} {asked}".rstrip()) from None
for _warning in _said:
    _name = re.search(r"variable '(NUMBA_\w+)'", str(_warning.message))
    if _name:
        raise InputError(
            f"{_name[1]}={os.environ.get(_name[1])}: is no value that numba, which compiles Footfall, knows; unset it"
        )
    warnings.warn_explicit(_warning.message, _warning.category, _warning.filename, _warning.lineno)
if numba.config.DISABLE_JIT:  # type: ignore[attr-defined]
    raise InputError("NUMBA_DISABLE_JIT is set: Footfall's kernels are compiled, or nothing; unset it")

from worlds.compiled.inner import Compiled  # noqa: E402  (they need numba)
from worlds.compiled.kept import Kept  # noqa: E402

# Where numba was imported before, it has not read them.
numba.config.CACHE_DIR = str(_FOLDER or "")  # type: ignore[attr-defined]
numba.config.THREADING_LAYER = os.environ["NUMBA_THREADING_LAYER"]  # type: ignore[attr-defined]

_OWNING: dict[str, Any] = {"error_model": "numpy", "nogil": True, "_nrt": True}
BORROWING: dict[str, Any] = _OWNING | {"_nrt": False}

Kernel = TypeVar("Kernel", bound=Callable)
intrinsic: Callable[[Callable], Callable[..., Any]] = _intrinsic
"""For functions that write the compiler's code: they are called without the first argument that they are written with."""
intrinsic_of_literals: Callable[[Callable], Callable[..., Any]] = _intrinsic(prefer_literal=True)
"""The same for those that must know a plain number's value, not only its type."""


class _Told(event.Listener):  # type: ignore[misc]
    """Hears from numba what is compiled, so that nobody waits in silence."""

    def on_start(self, event: Any) -> None:
        telling.begin()

    def on_end(self, event: Any) -> None:
        telling.end()


event.register("numba:compile", _Told())


def _kept(kernel: Callable) -> Any:
    """Where what is compiled of a function is kept: nowhere for one that was typed in at a prompt, or without a folder."""
    try:
        return NullCache() if _FOLDER is None else Kept(kernel)
    except (RuntimeError, OSError, TypeError):
        return NullCache()


def _compiler(**options: Any) -> Callable[[Kernel], Kernel]:
    """A decorator that compiles with these options, and is plain to the type checker."""

    def decorate(kernel: Kernel) -> Kernel:
        compiled: Any = numba.njit(**options)(kernel) if "parallel" in options else Compiled(kernel, options)
        compiled._cache = _kept(kernel)
        return compiled

    return decorate


def compiled_callback(kernel: Callable, signature: Any) -> Any:
    """A kernel that is called by its address (worlds.compiled.parts), of this signature; it makes no arrays."""
    options = {name: value for name, value in BORROWING.items() if name != "nogil"}
    made = CFunc(kernel, (signature.args, signature.return_type), locals={}, options=options)
    made._cache = _kept(kernel)  # type: ignore[attr-defined]
    with telling.compiling():
        made.compile()
    return made


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
    return jit_borrowing(function)


def start_threads() -> None:
    """Starts numba's threads, where they do not run yet: before any kernel is loaded that calls a parallel one.

    numba starts them when it loads a parallel kernel, but not when it loads one that calls it, if that was compiled while the
    parallel one came from the cache (a first start that was cut short, or two at once): its calls would lead nowhere.
    """
    try:
        numba.get_num_threads()
    except (ValueError, ImportError) as error:
        layer, reason = os.environ["NUMBA_THREADING_LAYER"], str(error).splitlines()[0]
        raise InputError(f"NUMBA_THREADING_LAYER={layer}: numba has no such threads here ({reason}); unset it") from None


def stack_array(*shape: int, dtype: Any = np.float64) -> Any:
    """What makes an array of this shape on the stack, for kernels that make none; it lives while the kernel runs, and holds
    anything at first."""
    element = np.dtype(dtype)
    kind, size = types.Array(numba.from_dtype(element), len(shape), "C"), element.itemsize * math.prod(shape)
    strides = [element.itemsize * math.prod(shape[k + 1 :]) for k in range(len(shape))]

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        data = cgutils.alloca_once(builder, ir.ArrayType(ir.DoubleType(), (size + 7) // 8))
        array = context.make_array(kind)(context, builder)
        numbers = [context.get_constant(types.intp, n) for n in (*shape, *strides, element.itemsize)]
        context.populate_array(
            array,
            data=builder.bitcast(data, array.data.type),
            shape=cgutils.pack_array(builder, numbers[: len(shape)]),
            strides=cgutils.pack_array(builder, numbers[len(shape) : -1]),
            itemsize=numbers[-1],
            meminfo=None,
        )
        return array._getvalue()

    @intrinsic
    def make(_: Any) -> Any:
        return kind(), codegen

    return make
