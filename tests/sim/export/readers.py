"""Somebody else's readers, where they are installed; a test that needs one that is not is skipped, and says what is missing."""

import json
import shutil
import subprocess
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from sim.export.clip.asked import Asked
from sim.export.clip.cutting import clip_of
from sim.files.recording import Recorder, Recording
from sim.files.taking import span_of, taken
from sim.stage.making import make_simulation

NODE = Path(__file__).parent / "node"


def node(script, *arguments):
    """What a script of `node/` prints, as JSON."""
    if shutil.which("node") is None or not (NODE / "node_modules").is_dir():
        pytest.skip(f"needs Node.js, and `npm ci` in {NODE.name}/ beside this test")
    done = subprocess.run(["node", str(NODE / script), *arguments], capture_output=True, text=True, cwd=NODE)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


@cache
def recording(character="human", count=1, seconds=3.0, level="forest", crossing=False):
    """A short recorded run."""
    sim = make_simulation(level, character, count, 3, crossing)
    recorder = Recorder(sim)
    recorder.capture()
    while sim.time < seconds:
        sim.tick()
        recorder.capture()
    return recorder.recording()


def clip(source, **asked):
    """What is exported of a recording or a cast."""
    what = Asked(**asked).check()
    if not isinstance(source, Recording):
        source = taken(source, span_of(source, what.begin, what.end), what.rate or source.tick_rate, lambda share: None)
    return clip_of(source, what)


def moments(clip, count=20):
    """So many frames of a clip, spread over all of it."""
    return np.linspace(0, len(clip.time) - 1, count).round().astype(int)
