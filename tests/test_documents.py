"""What the documents show runs: their Python and JavaScript in the order in which it stands there, and their commands."""

import ast
import importlib.util
import os
import re
import shlex
import subprocess
import sys

import pytest

from sim.cli import parser
from tests.sim.export.readers import NODE, node
from tests.structure import ROOT

PAGES = ["README.md", *sorted(f"docs/{path.name}" for path in (ROOT / "docs").glob("*.md"))]
MADE = (
    "wander --headless --seconds 4 --characters 2 --character human --record run.npz",
    *(f"export run.npz run{ending}" for ending in (".glb", ".bvh", ".txt", ".sqlite", ".traj")),
)
"""What leaves the files that the documents speak of."""
JS = """import {{ readFileSync }} from 'fs';
import * as THREE from 'three';
import {{ GLTFLoader as Loader }} from 'three/addons/loaders/GLTFLoader.js';
class GLTFLoader {{ loadAsync(path) {{ return new Loader().parseAsync(readFileSync('{folder}/' + path).buffer, ''); }} }}
const scene = new THREE.Scene();
{block}
mixer.setTime(1);
console.log(JSON.stringify([gltf.animations.length, scene.children.length]));
"""
"""Without a browser a file is read, not fetched."""
QUICK = re.compile(
    r"python main\.py (?:(?:wander )?--headless|export|measure|timing|check|play --list)(?! (?:RUN|SCENE|STATE|my_))"
)
"""Commands that are done in a moment, and write nothing outside of the folder that they run in."""


def blocks(page, language):
    return re.findall(rf"```{language}\n(.*?)```", (ROOT / page).read_text("utf-8"), re.S)


def commands(page):
    return re.findall(r"^ {4}(python main\.py[^\n#]*)", (ROOT / page).read_text("utf-8"), re.M)


def run(folder, *command):
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    ran = subprocess.run([sys.executable, *command], cwd=folder, env=environment, capture_output=True, text=True)
    assert ran.returncode == 0, f"{command}: {ran.stderr}"


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Where `run.npz` lies, and what it was exported to."""
    made = tmp_path_factory.mktemp("shown")
    usd = ("export run.npz run.usdc",) if importlib.util.find_spec("pxr") else ()
    for command in (*MADE, *usd):
        run(made, "-m", "sim", *shlex.split(command))
    return made


def missing(block):
    """Libraries that it imports, and that are not here."""
    imports = [one for one in ast.walk(ast.parse(block)) if isinstance(one, ast.Import | ast.ImportFrom)]
    names = [one.module or "" for one in imports if isinstance(one, ast.ImportFrom)]
    names += [alias.name for one in imports if isinstance(one, ast.Import) for alias in one.names]
    return sorted({name for name in (full.split(".")[0] for full in names) if importlib.util.find_spec(name) is None})


@pytest.mark.parametrize(
    "page, place", [(page, k) for page in PAGES if page != "README.md" for k in range(len(blocks(page, "python")))]
)
def test_python_of_a_page_runs(page, place, folder):
    shown = blocks(page, "python")[: place + 1]
    if lacking := missing(shown[place]):
        pytest.skip(f"needs {', '.join(lacking)}")
    run(folder, "-c", "\n".join(block for block in shown if not missing(block)))


@pytest.mark.parametrize("page", [page for page in PAGES if blocks(page, "js")])
def test_javascript_of_a_page_runs(page, folder):
    for block in blocks(page, "js"):
        script = folder / "shown.mjs"
        script.write_text(JS.format(folder=folder, block=block))
        if (NODE / "node_modules").is_dir() and not (folder / "node_modules").exists():
            (folder / "node_modules").symlink_to(NODE / "node_modules")
        assert node(str(script)) == [2, 1]


def test_commands_of_the_pages_are_ours():
    every = [command for page in PAGES for command in commands(page)]
    assert len(every) > 30
    for command in every:
        arguments = shlex.split(command.split("#")[0])[2:]
        if arguments[:1] != ["test"]:
            parser.parsed(arguments)


def test_quick_commands_of_readme_run_in_their_order(tmp_path):
    quick = [command for command in commands("README.md") if QUICK.match(command) and "--video" not in command]
    assert len(quick) >= 8
    for command in quick:
        run(tmp_path, "-m", "sim", *shlex.split(command)[2:])
    assert {"run.npz", "end.png", "state.npz", "run.glb", "sprint.html"} <= {path.name for path in tmp_path.iterdir()}


@pytest.mark.parametrize("page", ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md"])
def test_files_and_folders_that_pages_name_are_there(page):
    named = set(re.findall(r"`((?:sim|planner|motion|worlds|tests|docs)/[\w./]*)`", (ROOT / page).read_text(encoding="utf-8")))
    assert named and [path for path in sorted(named) if not (ROOT / path).exists()] == []
