"""The examples run as a stranger would run them, and README's first is one of them."""

import os
import re
import subprocess
import sys

import pytest

from tests.structure import ROOT

EXAMPLES = sorted(path.stem for path in (ROOT / "tests/examples").glob("*.py") if path.stem != "__init__")


def said_by(name):
    ran = subprocess.run([sys.executable, "-m", f"tests.examples.{name}"], cwd=ROOT, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    return ran.stdout


@pytest.mark.parametrize("name", EXAMPLES)
def test_example_runs(name):
    assert said_by(name).strip()


def test_a_planner_steps_the_same_compiled_or_not():
    assert said_by("planner_in_python") == said_by("planner_compiled")


def in_readme():
    return re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text("utf-8"), re.S)


@pytest.mark.parametrize("place", range(len(in_readme())))
def test_what_readme_shows_runs(place, tmp_path):
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    ran = subprocess.run(
        [sys.executable, "-c", in_readme()[place]], cwd=tmp_path, env=environment, capture_output=True, text=True
    )
    assert ran.returncode == 0, ran.stderr


def test_readme_begins_with_the_eight_lines():
    first = in_readme()[0]
    assert first == (ROOT / "tests/examples/eight_lines.py").read_text("utf-8")
    assert len([line for line in first.splitlines() if line]) == 8
