"""The one place that wraps numba's decorators.

Compiled kernels are cached in a folder keyed by a hash of all sources that hold kernels: numba itself notices only edits
of the very file, so an edited helper would leave its callers stale. Without a writable folder the cache goes to a
temporary one.
"""

import hashlib
import os
import tempfile
from pathlib import Path

_ROOT = Path(__file__).resolve().parent.parent
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

jit = numba.njit(cache=True, error_model="numpy", nogil=True)
jit_inline = numba.njit(cache=True, error_model="numpy", nogil=True, forceinline=True)
"""For the few small functions inside the hottest loops: a call would copy its arguments, arrays' headers included."""
jit_parallel = numba.njit(cache=True, error_model="numpy", nogil=True, parallel=True)
