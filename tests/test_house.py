"""The house: lint, types, import contracts, and what lies at the top."""

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
TOOLS = {
    "lint": [sys.executable, "-m", "ruff", "check", "."],
    "format": [sys.executable, "-m", "ruff", "format", "--check", "."],
    "types": [sys.executable, "-m", "mypy"],
    "imports": [sys.executable, "-c", "from importlinter.cli import lint_imports_command as c; c()", "--no-cache"],
}


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
