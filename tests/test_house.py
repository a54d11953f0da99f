"""The house: lint, types, import contracts, and the rules that keep it small and plain."""

import graphlib
import subprocess
import sys
from pathlib import Path

import pytest

from tests import structure
from tests.structure import ROOT
from worlds.compiled import cache

TOOLS = {
    "lint": [sys.executable, "-m", "ruff", "check", "."],
    "format": [sys.executable, "-m", "ruff", "format", "--check", "."],
    "types": [sys.executable, "-m", "mypy"],
    "imports": [sys.executable, "-c", "from importlinter.cli import lint_imports_command as c; c()", "--no-cache"],
}
MOST_ARGUMENTS, LONGEST_FUNCTION, LONGEST_FILE, MOST_ARROWS = 8, 42, 267, 19
DRAWING = {"pygame", "moderngl", "OpenGL", "imgui_bundle"}
READING = {"worlds.reading", "worlds.ground", "worlds.level", "pydantic", "tomllib", "json", "PIL"}
KERNELS = ("motion.arithmetic", "motion.track", "motion.com", "motion.measures", "planner.round", "planner.stepping",
           "planner.crowd", "sim.rows", "worlds.compiled", "worlds.arrays", "worlds.queries")  # fmt: skip
"""Rooms of kernels; motion.pose too, but for the skeleton, which is a character's."""
FOUNDATION = {"worlds.compiled", "worlds.errors", "worlds.reading"}
"""What of the lowest floor motion may ask for: it knows no world."""


@pytest.mark.parametrize("tool", TOOLS)
def test_tool_finds_nothing(tool):
    found = subprocess.run(TOOLS[tool], cwd=ROOT, capture_output=True, text=True)
    assert found.returncode == 0, found.stdout + found.stderr


def test_five_folders_hold_all_code():
    folders = {path.relative_to(ROOT).parts[0] for path in ROOT.glob("*/**/*.py") if not _hidden(path)}
    assert folders == {"sim", "planner", "motion", "worlds", "tests"}
    assert [path.name for path in ROOT.glob("*.py")] == ["main.py"]


def _hidden(path: Path) -> bool:
    return any(part.startswith((".", "build")) for part in path.relative_to(ROOT).parts)


def _files() -> list[Path]:
    return [path for folder in (*structure.FLOORS, "tests") for path in (ROOT / folder).rglob("*.py")] + [ROOT / "main.py"]


def test_functions_ask_for_little_and_are_short():
    found = structure.functions(_files())
    assert [one for one in found if one.arguments > MOST_ARGUMENTS] == []
    assert [one for one in found if one.lines > LONGEST_FUNCTION] == []


def test_files_are_short():
    lines = {path: len(path.read_text("utf-8").splitlines()) for path in _files()}
    assert {path: count for path, count in lines.items() if count > LONGEST_FILE} == {}


@pytest.mark.parametrize("folder", structure.folders())
def test_the_picture_of_a_folder_is_plain(folder):
    arrows = structure.arrows_in(folder)
    assert len(arrows) <= MOST_ARROWS, sorted(arrows)
    order = graphlib.TopologicalSorter()
    for one, other in arrows:
        order.add(one, other)
    order.prepare()  # raises CycleError where imports go round


def test_only_the_view_draws():
    drawing = [name for name in structure.modules() if DRAWING & structure.imports_of(name)]
    assert drawing and [name for name in drawing if not name.startswith("sim.view.")] == []


def test_the_view_reads_snapshots():
    """It asks the cast, and knows nothing of the crowd's rows."""
    view = [name for name in structure.modules() if name.startswith("sim.view")]
    assert [name for name in view if any(one.startswith("sim.rows") for one in structure.imports_of(name))] == []
    sources = {path: path.read_text("utf-8") for path in (ROOT / "sim/view").rglob("*.py")}
    assert [path for path, text in sources.items() if ".crowd" in text] == []


def test_kernels_read_no_files():
    rooms = [
        name for name in structure.modules() if name.startswith((*KERNELS, "motion.pose.")) and name != "motion.pose.skeleton"
    ]
    assert {name: READING & structure.reached_from(name) for name in rooms if READING & structure.reached_from(name)} == {}


def test_motion_knows_no_world():
    for name in structure.modules():
        if name.startswith("motion"):
            asked = {one for one in structure.imports_of(name) if one.startswith("worlds")}
            assert {one for one in asked if not any(one == f or one.startswith(f"{f}.") for f in FOUNDATION)} == set(), name


def test_rounds_and_saved_states_know_no_planner_by_name():
    """But for the one list of those that ship, and what lets people walk to measure them."""
    modes = {name for name in structure.modules() if name.startswith(("planner.modes.", "planner.river."))}
    knows = {name for name in structure.modules() if modes & structure.imports_of(name)} - modes
    assert knows - {"planner.planners", "sim.stage.making"} <= {"sim.stage.kernels", *_benches(knows)}


def _benches(names: set[str]) -> set[str]:
    return {name for name in names if name.startswith(("sim.bench.", "sim.reports.flows", "sim.reports.rimea"))}


def test_what_is_left_out_of_the_hash_of_kernels_holds_none():
    """Else an edited kernel would be taken from the cache as it was."""

    def is_left_out(name: str) -> bool:
        return bool(cache._WITHOUT_KERNELS & set(name.split(".")[1:-1]))

    compiling = [name for name in structure.modules() if {"numba", "worlds.compiled.jit"} & structure.imports_of(name)]
    assert compiling and [name for name in compiling if is_left_out(name)] == []
