"""Runs on the processors of this machine: a process each, with one thread, that is given run after run."""

import json
import os
import queue
import subprocess
import sys
import threading
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path

from sim.reports.batch.plan import Job
from worlds.compiled import leaving
from worlds.compiled.cache import ROOT
from worlds.errors import InputError

TRIES = 3
"""A run during which so many processes have ended is given up."""
LISTEN = 0.2
"""Seconds between two looks at whether the batch is to stop."""


def processors() -> int:
    """How many there are for us."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def run_jobs(
    jobs: Sequence[Job], folder: Path, count: int, done: Callable[[Job], None], stop: Callable[[], bool]
) -> None:  # fmt: skip
    """Does the runs on so many processes; calls `done` after each. Ends early where `stop` says so. Raises InputError."""
    todo: queue.SimpleQueue[Job] = queue.SimpleQueue()
    answers: queue.SimpleQueue[tuple[Job, str]] = queue.SimpleQueue()
    for job in jobs:
        todo.put(job)
    hands = [_Hand(folder, todo, answers) for _ in range(min(count, len(jobs)))]
    try:
        left = len(jobs)
        while left and not stop():
            with suppress(queue.Empty):
                finished, fault = answers.get(timeout=LISTEN)
                if fault:
                    raise InputError(fault)
                done(finished)
                left -= 1
    finally:
        for hand in hands:
            hand.end()


class _Hand:
    """A process, and the thread that gives it runs."""

    def __init__(self, folder: Path, todo: queue.SimpleQueue, answers: queue.SimpleQueue) -> None:
        self.folder, self.todo, self.answers = folder, todo, answers
        self.ended = False
        self.process = self._begin()
        self.thread = threading.Thread(target=self._give, daemon=True)
        self.thread.start()

    def _begin(self) -> subprocess.Popen:
        process = subprocess.Popen(
            [sys.executable, "-m", "sim.reports.batch.worker", str(self.folder)], cwd=ROOT, stdin=subprocess.PIPE, text=True,
            stdout=subprocess.PIPE, env={**os.environ, "NUMBA_NUM_THREADS": "1"}, start_new_session=os.name == "posix",
        )  # fmt: skip
        leaving.remember(self, self.end)
        return process

    def _give(self) -> None:
        while not self.ended:
            try:
                job = self.todo.get_nowait()
            except queue.Empty:
                return
            self.answers.put((job, self._do(job)))

    def _do(self, job: Job) -> str:
        """Has a run done; what is wrong with it, or nothing. A process that ends on the way is followed by another."""
        for _ in range(TRIES):
            with suppress(OSError, ValueError):
                self.process.stdin.write(json.dumps(job) + "\n")  # type: ignore[union-attr]
                self.process.stdin.flush()  # type: ignore[union-attr]
                return str(json.loads(self.process.stdout.readline()))  # type: ignore[union-attr]
            if self.ended:
                return "the batch has ended"
            self.process = self._begin()
        return f"{job.name}: {TRIES} processes have ended while they simulated this run"

    def end(self) -> None:
        """Ends the process: what it had not finished is not there."""
        self.ended = True
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        leaving.forget(self)
