"""The studio beside a live run: a program of its own, for a window with OpenGL is all that one program can be sure to get."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from sim.files.studio.document import Document
from sim.files.studio.keeping import PIPED
from sim.files.studio.writing import text_of

ROOT = Path(__file__).resolve().parents[3]


def open_studio(document: Document) -> "subprocess.Popen[bytes]":
    """Opens the studio on a document that lies in no file. Whatever becomes of this program, it goes on. Raises OSError."""
    paths = [str(ROOT), *filter(None, [os.environ.get("PYTHONPATH")])]
    with tempfile.TemporaryFile() as scene:
        scene.write(text_of(document).encode("utf-8"))
        scene.seek(0)
        return subprocess.Popen(
            [sys.executable, "-m", "sim", "edit", PIPED],
            stdin=scene,
            env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)},
            start_new_session=os.name == "posix",  # Ctrl-C is for the run
        )
