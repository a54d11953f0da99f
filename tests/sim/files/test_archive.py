"""Files that are none of ours: refused with a sentence, whatever they hold."""

import io
import zipfile

import numpy as np
import pytest

from sim.files import archive
from sim.files.recording import load_recording
from worlds.errors import InputError


def zipped(path, name, data):
    with zipfile.ZipFile(path, "w") as file:
        file.writestr(name, data)
    return path.read_bytes()


def header(text):
    head = io.BytesIO()
    np.lib.format.write_array_header_1_0(head, {"descr": "<f8", "fortran_order": False, "shape": (1,)})
    return head.getvalue().replace(b"(1,)", text)


def declared(size):
    """A member that says it has so many bytes, in its header as in the directory."""
    data = bytearray(header(f"({size // 8},)".encode()))
    info = zipfile.ZipInfo("time.npy")
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as made:
        made.writestr(info, bytes(data))
        made.filelist[0].file_size = len(data) + size
    return file.getvalue()


@pytest.mark.parametrize(
    "fault", ["declared", "encrypted", "eight terabytes", "no header", "negative", "text", "empty", "pickle"]
)
def test_files_that_cannot_be_read(fault, tmp_path):
    path = tmp_path / "run.npz"
    if fault == "encrypted":
        data = bytearray(zipped(path, "time.npy", header(b"(1,)") + bytes(8)))
        data[6] |= 1  # the flag of the member, and of its entry in the directory
        data[data.index(b"PK\x01\x02") + 8] |= 1
    elif fault == "eight terabytes":
        data = zipped(path, "time.npy", header(b"(1099511627776,)") + bytes(8))
    elif fault == "declared":
        data = declared(8 << 40)
    elif fault == "no header":
        data = zipped(path, "time.npy", b"\x93NUMPY\x01\x00\x05\x00abcde")
    elif fault == "negative":
        data = zipped(path, "time.npy", header(b"(-1,)"))
    elif fault == "pickle":
        np.savez(path, time=np.array([{}], object))
        data = path.read_bytes()
    else:
        data = b"no zip" if fault == "text" else b""
    path.write_bytes(bytes(data))
    with pytest.raises(InputError, match="run.npz: is not"):
        load_recording(path)


def test_folders_and_devices_are_no_recordings(tmp_path):
    for path in (tmp_path, "/dev/zero", tmp_path / "none.npz"):
        with pytest.raises(InputError):
            load_recording(path)


def test_what_unpacks_to_far_more_than_it_is_made_to_be_a_bomb(tmp_path, monkeypatch):
    monkeypatch.setattr(archive, "SURELY", 1_000_000)
    path = tmp_path / "run.npz"
    np.savez_compressed(path, time=np.zeros(2_000_000))
    assert path.stat().st_size < 50_000
    with pytest.raises(InputError, match="takes 16000000 bytes or more; at most"):
        load_recording(path)


def test_members_are_counted(tmp_path):
    path = tmp_path / "run.npz"
    with zipfile.ZipFile(path, "w") as file:
        for k in range(archive.MOST_MEMBERS + 1):
            file.writestr(f"{k}.npy", b"")
    with pytest.raises(InputError, match="has 1001 members; at most 1000"):
        load_recording(path)


@pytest.mark.parametrize("method", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_only_what_numpy_writes_is_unpacked(method, tmp_path):
    path = tmp_path / "run.npz"
    with zipfile.ZipFile(path, "w", method) as file:
        file.writestr("time.npy", header(b"(1,)") + bytes(8))
    with pytest.raises(InputError, match="packed in a way"):
        load_recording(path)


@pytest.mark.parametrize("text", ["[" * 100_000, '{"a":' * 100_000, "1" * 10_000, '"'])
def test_text_that_is_no_meta(text, tmp_path):
    path = tmp_path / "run.npz"
    np.savez(path, time=np.zeros(1), meta=np.array(text))
    with pytest.raises(InputError, match=r"run\.npz: is not"):
        load_recording(path)


def test_long_arrays_of_few_numbers_are_kept_as_places_in_a_table(tmp_path):
    path, steps = tmp_path / "state.npz", np.random.default_rng(0).integers(0, 65536, (300, 300)) / 65535.0 * 7.3
    archive.write(path, {"heights": steps, "time": np.arange(20_000.0)}, {"format": 1}, compressed=False)
    assert path.stat().st_size < 20_000 * 8 + 0.8 * steps.nbytes + 65_536 * 2
    arrays, _ = archive.read(path, "a state", "--save", ("heights", "time"), 1)
    assert arrays["heights"].tobytes() == steps.tobytes() and sorted(arrays) == ["heights", "time"]


@pytest.mark.parametrize("fault", ["beyond", "signed", "table"])
def test_places_that_are_none_are_refused(fault, tmp_path):
    path, places, table = tmp_path / "run.npz", np.full((4, 4), 3, np.uint16), np.arange(3.0)
    if fault == "signed":
        places, table = places.astype(np.int64) - 4, np.arange(9.0)
    if fault == "table":
        table = np.zeros((9, 2))
    np.savez(path, **{"heights.packed": places, "heights.table": table}, time=np.zeros(1), meta=np.array('{"format": 1}'))
    with pytest.raises(InputError, match=r"run\.npz: is not readable"):
        load_recording(path)
