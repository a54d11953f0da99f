"""Files cut short and changed by chance, of every format: read, or refused by name; nothing else comes out of a reader."""

import numpy as np
import pytest

from sim.files.imports import texts
from sim.files.imports.trackways.prints import read_prints
from sim.files.imports.trajectories.people import read_ways
from tests.sim.files.imports.test_people import database, text
from tests.sim.files.imports.test_trackways import course, tps
from worlds.errors import InputError

TIMES = 150
VADERE = "pedestrianId simTime endTime-PID1 startX-PID1 startY-PID1 endX-PID1 endY-PID1\n" + "".join(
    f"{c} {0.5 * k} {0.5 * k + 0.5} {0.6 * k} {c} {0.6 * k + 0.6} {c}\n" for c in range(3) for k in range(9)
)


def samples(folder):
    """Files that are fine, and who reads them."""
    written = {name: text(name) for name in ("jupedsim.txt", "pedpy_cm.txt", "obsmat.txt", "plain.csv", "plain.txt")}
    written |= {"steps.traj": VADERE, "prints.tps": tps(course(), course(8))}
    for name, content in written.items():
        (folder / name).write_text(content, "utf-8")
    database(folder / "t.sqlite")
    return sorted(folder.iterdir())


def changed(data, chance):
    """A file cut, with bytes changed, doubled, or another piece of itself in it."""
    kind, at = chance.integers(4), int(chance.integers(len(data)))
    if kind == 0:
        return data[:at]
    if kind == 1:
        some = bytearray(data)
        for place in chance.integers(len(data), size=int(chance.integers(1, 6))):
            some[place] = int(chance.integers(256))
        return bytes(some)
    other = int(chance.integers(len(data)))
    piece = data[other : other + int(chance.integers(1, 60))]
    return data[:at] + piece + (data[at:] if kind == 2 else data[at + len(piece) :])


def test_whatever_a_file_holds_it_is_read_or_refused(tmp_path):
    chance, refused = np.random.default_rng(3), 0
    for path in samples(tmp_path):
        data, read = path.read_bytes(), read_prints if path.suffix == ".tps" else read_ways
        assert read(path)
        for k in range(TIMES):
            other = tmp_path / f"{k}-{path.name}"
            other.write_bytes(changed(data, chance))
            try:
                assert len(read(other))
            except InputError as error:
                refused += 1
                assert str(error).startswith(str(other))
            other.unlink()
    assert refused > TIMES


def test_files_that_are_too_large_are_not_read(tmp_path, monkeypatch):
    monkeypatch.setattr(texts, "LARGEST", 1000)
    path = tmp_path / "people.txt"
    path.write_text(text("plain.txt"), "utf-8")
    with pytest.raises(InputError, match="more than 1,000 bytes"):
        texts.text_of(path, "a file", texts.LARGEST)
