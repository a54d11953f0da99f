"""The first start compiles kernels for the very types that they are called with later."""

import io
import subprocess
import sys
from unittest.mock import Mock

import numpy as np
import pytest

from motion import motion
from motion.characters.character import load_character
from motion.pose import turning
from planner.modes.wander import Wander
from planner.script import laying
from planner.script.scene import load_scene
from sim.rows import crowd, posing, rounds
from sim.stage import kernels, warmup
from sim.stage.scripted.performance import Performance
from sim.stage.simulation import Simulation
from sim.view.bodies.figure import figure_of
from worlds.compiled.parts import Part
from worlds.level import load_level


def test_nothing_is_left_to_compile():
    needed = kernels.steps()
    every = [kernel for step in needed.values() for kernel, _ in step]
    warmup._compile(needed, lambda name: None)
    compiled = [_compiled(kernel) for kernel in every]
    sim = Simulation(load_level("forest"), [load_character("human")] * 3, Wander(), 1)
    for _ in range(90):
        sim.tick()
    figure_of(sim.characters[0], sim.snapshot()), sim.com()
    Performance(load_scene("fig01_steps_and_a_hop"))
    assert {
        rounds.advance_all,
        rounds.plan_step,
        rounds.optimise_step,
        motion.solve_track,
        laying.lay_steps,
        laying.by_themselves,
        laying.finish_steps,
        posing.pose_rows,
        turning.fill_all_bones,
        turning.lay_bones,
        crowd.stand,
    } <= set(every)
    assert [_compiled(kernel) for kernel in every] == compiled


def test_threads_run_before_kernels_are_loaded():
    """Else a kernel from the cache that calls a parallel one may find nothing there: see worlds.compiled.jit.start_threads."""
    alone = """
import numba
from motion.characters.character import load_character
from motion.pose import turning
from sim.stage.cast import Cast
from worlds.world import World
Cast(World("empty", (9.0, 9.0)), [load_character("bird")], 1, 60)
print(numba.threading_layer())
"""
    ran = subprocess.run([sys.executable, "-c", alone], cwd=warmup.ROOT, capture_output=True, text=True, check=False)
    assert ran.stdout == "workqueue\n", ran.stderr


def _compiled(kernel) -> list:
    return [kernel.address] if isinstance(kernel, Part) else list(kernel.signatures)


@pytest.mark.parametrize("command", warmup.NEEDED)
def test_progress_names_what_is_compiled(command, tmp_path, monkeypatch):
    names = warmup.NEEDED[command]
    assert set(names) <= set(kernels.steps()) and len(set(names)) == len(names)
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(kernels, "steps", lambda: {name: [] for name in names})
    helped = Mock(poll=lambda: 0, stdout=(), stdin=io.StringIO())
    monkeypatch.setattr(warmup.subprocess, "Popen", Mock(return_value=helped))
    told: list[str] = []
    warmup.warm_up(command, told.append)
    assert told == [f"compiling {k + 1} of {len(names)}: {name} ..." for k, name in enumerate(names)]
    helped.wait.assert_called_once()
    warmup.warm_up(command, told.append)
    assert len(told) == len(names)


def test_the_second_process_takes_what_is_left(monkeypatch):
    """It asks for a name by a line, and is told by an end that there is none."""
    helper = Mock(stdout=iter("\n" * 3), stdin=io.StringIO())
    monkeypatch.setattr(helper.stdin, "close", lambda: None)
    untaken = iter(("a", "b", "c"))
    assert next(untaken) == "a"
    warmup._give(helper, untaken)
    assert helper.stdin.getvalue() == "b\nc\n" and next(untaken, None) is None
    monkeypatch.setattr(warmup.sys, "stdin", io.StringIO(helper.stdin.getvalue()))
    assert list(warmup._given()) == ["b", "c"]


def test_one_who_is_alone_needs_no_way_around_others():
    world, bird = load_level("forest"), load_character("bird")
    alone, several = (Simulation(world, [bird] * count, Wander(), 1) for count in (1, 3))
    assert alone.work.value.others == 0 and several.work.value.others == rounds.go_around["steps"].address
    needed = [warmup.NEEDED[name] for name in ("wander", "wander of many", "river", "river of many")]
    assert [warmup.OTHERS in names for names in needed] == [False, True, False, True]


def test_many_are_told_what_they_need(tmp_path, monkeypatch):
    names: list[str] = []
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(kernels, "steps", lambda: {name: [] for name in (*kernel_names,)})
    monkeypatch.setattr(warmup.subprocess, "Popen", lambda *_, **__: Mock(poll=lambda: 0, stdout=(), stdin=io.StringIO()))
    kernel_names = [name for needed in warmup.NEEDED.values() for name in needed]
    for characters in (1, 2, 1, 2):
        warmup.warm_up("wander", names.append, characters)
    assert [warmup.OTHERS in line for line in names if "placing" in line or warmup.OTHERS in line] == [False, False, True]


@pytest.mark.parametrize("some", [[2, 0], [1]])
def test_posing_some_is_posing_all(some):
    sim = Simulation(load_level("forest"), [load_character("bird")] * 3, Wander(), 2)
    for _ in range(100):
        sim.tick()
    everyone, few = sim.snapshot(), sim.snapshot(rows=np.array(some))
    for all_of_it, part in zip(everyone, few, strict=True):
        np.testing.assert_array_equal(all_of_it[some], part)
    np.testing.assert_array_equal(sim.com(), everyone.com)
