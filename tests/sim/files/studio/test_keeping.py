"""Documents on disk: comments stay, others' work is not written over, a crash loses seconds."""

import io
import os
import signal
import subprocess
import sys

import pytest

from sim.files.studio import edits, groups
from sim.files.studio.document import Spot, footprint_at, new_document
from sim.files.studio.history import begun
from sim.files.studio.keeping import Autosave, Opened, lost, open_scene, piped, recent, recover, remember, save, world_for
from sim.files.studio.writing import text_of
from tests.structure import ROOT
from worlds.errors import InputError

TEXT = """# A walk of three steps.
format = 1          # of the file
name = "Three"
stand_after = 0.7   # a breath

[world]
size = [9.0, 4.0]   # wide enough

# the first two are stood on
[[footprint]]
side = "left"
position = [1.0, 2.06]
[[footprint]]
side = "right"
position = [1.0, 1.94]

# off we go
[[footprint]]
side = "left"       # with the left
position = [1.6, 2.06]
[[footprint]]
side = "right"
position = [1.6, 1.94]  # and stop
"""


@pytest.fixture
def path(tmp_path, monkeypatch):
    monkeypatch.setenv("FOOTFALL_STATE", str(tmp_path / "state"))
    path = tmp_path / "three.toml"
    path.write_text(TEXT)
    return path


def test_a_file_that_has_not_changed_is_written_as_it_was(path):
    opened = open_scene(path)
    save(opened.document, opened, path)
    assert path.read_text() == TEXT


EDITS = (
    edits.Place(0, 1, (1.3, 2.06), 0.0),
    edits.Place(0, 3, (2.2, 2.06), 0.0),
    edits.Delete((Spot(0, 1),)),
    edits.Delete((Spot(0, 3),)),
    edits.Move((Spot(0, 2),), (0.1, 0.0)),
)


@pytest.mark.parametrize("edit", EDITS)
@pytest.mark.parametrize("blank", ["\n", ""])
def test_what_is_edited_is_set_apart_as_all_else_is(path, edit, blank):
    """A blank line above each header, or above none; a comment above one goes and stays with it."""
    lines = [line for line in TEXT.split("\n") if line]
    spaced = [blank + line if line.startswith(("#", "[")) and lines[k - 1][:1] != "#" else line for k, line in enumerate(lines)]
    path.write_text("\n".join(spaced).lstrip("\n") + "\n")
    opened = open_scene(path)
    text = text_of(edit.apply(opened.document), opened.written)
    found = text.split("\n")
    for k, line in enumerate(found[1:-1], 1):
        if line.startswith("["):
            above = next(j for j in range(k - 1, -1, -1) if found[j][:1] != "#")
            assert (found[above] == "") == (blank == "\n"), text
    assert "\n\n\n" not in text and '# off we go\n[[footprint]]\nside = "left"       # with the left\n' in text


def test_comments_stay_with_their_footprints(path):
    opened = open_scene(path)
    history = begun(opened.document)
    history.do(edits.Place(0, 1, (1.3, 2.1), 0.0))
    history.do(edits.Set((Spot(0, 3),), "stance_time", 0.7))
    save(history.document, opened, path)
    text = path.read_text()
    for comment in ("# A walk of three steps.", "# of the file", "# a breath", "# wide enough", "# off we go", "# and stop"):
        assert comment in text
    assert text.index("1.3") < text.index("# with the left") < text.index("stance_time = 0.7")
    assert open_scene(path).document == history.document


def test_a_file_that_somebody_else_has_changed_is_not_written_over(path):
    opened = open_scene(path)
    history = begun(opened.document)
    history.do(edits.Move((Spot(0, 2),), (0.1, 0.0)))
    path.write_text(TEXT.replace("Three", "Another"))
    with pytest.raises(InputError, match="changed"):
        save(history.document, opened, path)
    assert "Another" in path.read_text()
    save(history.document, opened, path, force=True)
    assert "Another" not in path.read_text()


def test_what_cannot_be_written_leaves_the_file(path):
    opened = open_scene(path)
    with pytest.raises(InputError):
        save(opened.document, opened, path.parent / "none" / "x.toml")
    with pytest.raises(InputError, match="ships"):
        shipped = open_scene("sprint")
        save(groups.AddTrack("bird").apply(shipped.document), shipped, shipped.path)


def test_recent_files_are_remembered(path):
    remember(path)
    assert recent() == [str(path.resolve())]
    path.unlink()
    assert recent() == []


CRASH = """
import sys, time
from sim.files.studio import edits
from sim.files.studio.document import Spot
from sim.files.studio.history import begun
from sim.files.studio.keeping import Autosave, open_scene
opened = open_scene(sys.argv[1])
history, autosave = begun(opened.document), Autosave()
begin = time.monotonic()
for k in range(10_000):
    history.do(edits.Move((Spot(0, 2),), (0.001, 0.0)))
    autosave.look(history.document, opened)
    print(k, time.monotonic() - begin, flush=True)
    time.sleep(0.02)
"""


@pytest.mark.skipif(os.name != "posix", reason="kill -9 is of POSIX")
def test_kill_9_loses_at_most_five_seconds(path):
    run = subprocess.Popen([sys.executable, "-c", CRASH, str(path)], cwd=ROOT, stdout=subprocess.PIPE, text=True)
    said = []
    while not said or float(said[-1][1]) < 5.5:  # seconds of editing
        words = run.stdout.readline().split()
        said += [words] if len(words) == 2 else []
    run.send_signal(signal.SIGKILL)
    said += [line.split() for line in run.stdout.read().splitlines() if len(line.split()) == 2]
    run.wait()
    found = lost()
    assert len(found) == 1
    back = recover(found[0])
    done = round((footprint_at(back.document, Spot(0, 2)).position[0] - 1.6) / 0.001)
    ends = {int(k) + 1: float(t) for k, t in said}
    assert done in ends and float(said[-1][1]) - ends[done] < 5.0
    assert "# with the left" in back.written and path.read_text() == TEXT


def test_what_is_saved_is_not_kept_twice(path):
    autosave, opened = Autosave(every=0.0), open_scene(path)
    changed = edits.Move((Spot(0, 2),), (0.1, 0.0)).apply(opened.document)
    autosave.look(changed, opened)
    autosave._thread.join()
    assert autosave.place.is_file()
    autosave.look(changed, Opened(changed, path))
    autosave.forget()
    assert not autosave.place.exists() and new_document() == new_document()


def test_a_scene_comes_through_a_pipe():
    document = open_scene("sprint").document
    assert piped(io.BytesIO(text_of(document).encode())) == document
    wrong = {b"format = ": "no TOML", b"\xff\xfa": "UTF-8", b"format = 1": "name", b" " * 3_000_000: "at most"}
    for raw, said in wrong.items():
        with pytest.raises(InputError, match=said):
            piped(io.BytesIO(raw))


def test_a_scene_without_footprints_may_have_anything_in_the_middle(path):
    path.write_text(TEXT.split("# the first")[0] + "[[tree]]\nposition = [4.5, 2.0]\nradius = 0.3\n")
    opened = open_scene(path)
    assert world_for(opened.document, path).trees.shape == (1, 3)
