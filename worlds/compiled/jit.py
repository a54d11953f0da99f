"""The one place that wraps numba's decorators.

Compiled kernels are cached in a folder keyed by a hash of all sources that hold kernels: numba itself notices only edits
of the very file, so an edited helper would leave its callers stale. Without a writable folder the cache goes to a
temporary one.
"""

import hashlib
import os
import tempfile
from pathlib import Path
from typing import Any

_ROOT = Path(__file__).resolve().parents[2]
_PACKAGES = ("motion", "worlds", "planner", "sim")


def _source_key() -> str:
    digest = hashlib.sha256()
    for package in _PACKAGES:
        for path in sorted((_ROOT / package).rglob("*.py")):
            if "view" not in path.parts:
                digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


def _cache_folder() -> Path:
    folder = _ROOT / ".numba_cache" / _source_key()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        if os.access(folder, os.W_OK):
            return folder
    except OSError:
        pass
    return Path(tempfile.gettempdir()) / f"footfall-{_source_key()}"


os.environ.setdefault("NUMBA_CACHE_DIR", str(_cache_folder()))
os.environ.setdefault("NUMBA_THREADING_LAYER", "workqueue")

import numba  # noqa: E402  (the cache folder is read at import)
from llvmlite import ir  # noqa: E402
from numba.core import cgutils, types  # noqa: E402
from numba.extending import intrinsic  # noqa: E402

# Where numba was imported before, it has not read them.
numba.config.CACHE_DIR = os.environ["NUMBA_CACHE_DIR"]  # type: ignore[attr-defined]
numba.config.THREADING_LAYER = os.environ["NUMBA_THREADING_LAYER"]  # type: ignore[attr-defined]

_OWNING: dict[str, Any] = {"cache": True, "error_model": "numpy", "nogil": True, "_nrt": True}
BORROWING: dict[str, Any] = _OWNING | {"_nrt": False}

jit = numba.njit(**_OWNING)
jit_borrowing = numba.njit(**BORROWING)
"""For kernels that make no arrays: they only borrow those they are given, and do not count who holds them. Counting is a
call and a locked addition for every mention of an array, which took half of the time. What they return must be numbers, or
arrays that passed through `borrowed`."""
jit_inline = numba.njit(**BORROWING, forceinline=True)
"""For the few small functions inside the hottest loops: a call would copy its arguments, arrays' headers included. They
make no arrays either."""
jit_parallel = numba.njit(**_OWNING, parallel=True)


def start_threads() -> None:
    """Starts numba's threads, where they do not run yet: before any kernel is loaded that calls a parallel one.

    numba starts them when it loads a parallel kernel, but not when it loads one that calls it, if that was compiled while the
    parallel one came from the cache (a first start that was cut short, or two at once): its calls would lead nowhere.
    """
    numba.get_num_threads()


@intrinsic
def borrowed(_, arrays):
    """The same NamedTuple of arrays without a say in how long they live: whoever lends them keeps them alive."""

    def codegen(context, builder, signature, arguments):
        (value,) = arguments
        for i, member in enumerate(signature.return_type.types):
            if isinstance(member, numba.types.Array):
                array = builder.extract_value(value, i)
                for field, owner in enumerate(array.type.elements[:2]):  # its meminfo and its Python object
                    array = builder.insert_value(array, owner(None), field)
                value = builder.insert_value(value, array, i)
        return value

    return arrays(arrays), codegen


def stack_array(rows: int, columns: int) -> Any:
    """What makes a float64 array (rows, columns) on the stack, for kernels that make none; it lives while the kernel runs."""
    kind, shape = types.Array(types.float64, 2, "C"), (rows, columns)

    def codegen(context, builder, signature, arguments):
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
    def make(_):
        return kind(), codegen

    return make
