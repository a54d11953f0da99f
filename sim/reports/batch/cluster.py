"""Runs on a Ray cluster (the extra `ray`): by RAY_ADDRESS, or a local one. What they make comes back and is written here."""

import io
import json
import os
from collections.abc import Callable, Sequence
from types import ModuleType
from typing import Any

import numpy as np

from sim.reports.batch.plan import Job
from sim.reports.batch.running import Row, simulate
from sim.reports.batch.shards import Shards
from worlds.compiled.cache import ROOT
from worlds.errors import InputError

AHEAD = 2
"""Runs that are given out at a time, for each processor."""


def _ray() -> ModuleType:
    """The library. Raises InputError where it is not there."""
    try:
        import ray
    except ImportError as error:
        raise InputError(f"--engine ray: needs Ray: pip install ray (the extra `ray`): {error}") from None
    return ray


def made(job: Job) -> tuple[bytes | None, list[Row]]:
    """A run as it travels: the file of its recording, and its rows."""
    ran = simulate(job)
    if ran.recording is None:
        return None, ran.rows
    file = io.BytesIO()
    meta = np.array(json.dumps(ran.recording.meta, sort_keys=True))
    np.savez_compressed(file, allow_pickle=False, **ran.recording.arrays, meta=meta)  # type: ignore[arg-type]
    return file.getvalue(), ran.rows


def run_jobs(jobs: Sequence[Job], shards: Shards, count: int, done: Callable[[Job], None], stop: Callable[[], bool]) -> None:
    """Does the runs on a cluster, on so many processors of a local one; calls `done` after each."""
    ray = _ray()
    ours = {"env_vars": {"NUMBA_NUM_THREADS": "1", "PYTHONPATH": str(ROOT)}}
    options = {} if _is_elsewhere() else {"num_cpus": count, "include_dashboard": False}
    ray.init(ignore_reinit_error=True, log_to_driver=False, runtime_env=ours, **options)
    try:
        remote, todo = ray.remote(made), list(reversed(jobs))
        running: dict[Any, Job] = {}
        most = AHEAD * max(int(ray.cluster_resources().get("CPU", count)), 1)
        while (todo or running) and not stop():
            while todo and len(running) < most:
                job = todo.pop()
                running[remote.remote(job)] = job
            ready, _ = ray.wait(list(running), timeout=0.2)
            for one in ready:
                job = running.pop(one)
                shards.write_bytes(job, *ray.get(one))
                done(job)
    finally:
        ray.shutdown()


def _is_elsewhere() -> bool:
    """Whether a cluster is named that runs already."""
    return bool(os.environ.get("RAY_ADDRESS"))
