"""Files that are none of ours: refused with a sentence, whatever they hold."""

import io
import zipfile

import numpy as np
import pytest

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


@pytest.mark.parametrize("fault", ["encrypted", "eight terabytes", "no header", "negative", "text", "empty", "pickle"])
def test_files_that_cannot_be_read(fault, tmp_path):
    path = tmp_path / "run.npz"
    if fault == "encrypted":
        data = bytearray(zipped(path, "time.npy", header(b"(1,)") + bytes(8)))
        data[6] |= 1  # the flag of the member, and of its entry in the directory
        data[data.index(b"PK\x01\x02") + 8] |= 1
    elif fault == "eight terabytes":
        data = zipped(path, "time.npy", header(b"(1099511627776,)") + bytes(8))
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
