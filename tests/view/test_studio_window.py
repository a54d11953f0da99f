"""The tests of the studio's window, in a process that has no other window."""

import os
import subprocess
import sys

import pytest

from tests.structure import ROOT


def test_the_studio_is_driven_by_mouse_and_keys(tmp_path):
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-q",
        "-rs",
        "--durations=0",
        "tests/view/studio_window.py",
        "-p",
        "no:cacheprovider",
    ]
    ran = subprocess.run(
        command, cwd=ROOT, capture_output=True, text=True, env={**os.environ, "FOOTFALL_STATE": str(tmp_path / "state")}
    )
    assert ran.returncode == 0, ran.stdout[-8000:] + ran.stderr[-2000:]
    if " passed" not in ran.stdout:
        pytest.skip(f"no window here: {ran.stdout[-400:]}")
