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
        "tests/view/studio_files.py",
        "-p",
        "no:cacheprovider",
    ]
    ran = subprocess.run(
        command, cwd=ROOT, capture_output=True, text=True, env={**os.environ, "FOOTFALL_STATE": str(tmp_path / "state")}
    )
    assert ran.returncode == 0, ran.stdout[-8000:] + ran.stderr[-2000:]
    if " passed" not in ran.stdout:
        pytest.skip(f"no window here: {ran.stdout[-400:]}")


def test_a_display_without_opengl_is_named(monkeypatch):
    """SDL's dummy driver is one."""
    pygame = pytest.importorskip("pygame")
    from sim.view.graphics.gl import NoGL
    from sim.view.studio.screen import StudioScreen

    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    pygame.display.quit()
    pygame.display.init()
    try:
        with pytest.raises(NoGL, match="OpenGL|GL"):
            StudioScreen(pygame, (320, 200), 1.0)
    finally:
        pygame.display.quit()
