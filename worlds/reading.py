"""Reading files that people write: TOML in, checked data out, every fault of a file in one report."""

import os
import select
import stat
import tomllib
from pathlib import Path
from typing import TypeVar

from pydantic import BaseModel, ValidationError

from worlds.errors import InputError
from worlds.errors.wording import faults_of, nearest

LARGEST_FILE = 2_000_000
"""Bytes: these files are written by a person; anything larger is something else."""
LONGEST_NAME = 255
"""Letters: a longer name is no file's, and is not said in full."""
MARKS = ((b"\xef\xbb\xbf", "utf-8-sig"), (b"\xff\xfe", "utf-16"), (b"\xfe\xff", "utf-16"))
"""First bytes by which a text says how it is written."""
REMEDY = r"""; a backslash in "..." begins a special letter: write C:/folder/file, or 'C:\folder\file'"""
PATIENCE = 10.0
"""Seconds that a pipe is waited for."""
_READ: dict[tuple[int, int], bytes] = {}
"""What came through pipes: it comes once, and may be asked for twice."""
Model = TypeVar("Model", bound=BaseModel)


def named_file(folder: Path, name_or_path: str | Path, what: str) -> Path:
    """A file that ships, by name, or any file by path. Raises InputError where there is none."""
    path = folder / f"{name_or_path}.toml"
    if is_regular(path):
        return path
    path = Path(name_or_path)
    said = str(path) if len(str(path)) <= LONGEST_NAME else f"{str(path)[:60]}... ({len(str(path))} letters)"
    if not _exists(path):
        if path.suffix == ".toml" or len(path.parts) > 1:
            raise InputError(f"{said}: no such {what} file{nearest(path.name[:100], [one.name for one in _beside(path)])}")
        names = names_in(folder)
        raise InputError(
            f"{said}: no such {what}{nearest(str(path), names)}; there are {', '.join(names)}, or give a .toml file"
        )
    if path.is_dir():
        raise InputError(f"{said}: is a folder; a {what} is a TOML file")
    return path


def is_regular(path: Path) -> bool:
    """Whether there is a file of this name that can be read to its end: no pipe, no device, no name that none can have."""
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False


def _exists(path: Path) -> bool:
    try:
        return path.exists()
    except (OSError, ValueError):
        return False


def _beside(path: Path) -> list[Path]:
    """The files of this kind in the same folder, where it is there."""
    try:
        return sorted(path.parent.glob("*.toml"))
    except OSError:
        return []


def names_in(folder: Path) -> list[str]:
    """Names of the files that ship in a folder."""
    return sorted(path.stem for path in folder.glob("*.toml"))


def tables_of(path: str | Path) -> set[str]:
    """The names at the top of a file; none where it is no readable TOML file: whoever reads it then says what is wrong."""
    try:
        return set(read_toml(Path(path), "file", "a table"))
    except (InputError, OSError):
        return set()


def read_model(path: Path, model: type[Model], what: str, needs: str) -> Model:
    """The file as checked data. Raises InputError naming every fault."""
    return checked(path, read_toml(path, what, needs), model)


def checked(path: Path | str, plain: dict, model: type[Model]) -> Model:
    """What a file holds as checked data. Raises InputError naming every fault."""
    try:
        return model.model_validate(plain)
    except ValidationError as error:
        raise InputError("\n".join(f"{path}: {said}" for said in faults_of(error, model))) from None


def read_toml(path: Path, what: str, needs: str) -> dict:
    """What a TOML file holds, as plain values. Raises InputError."""
    try:
        raw = content_of(path, LARGEST_FILE)
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    if raw is None:
        raise InputError(f"{path}: more than {LARGEST_FILE} bytes; a {what} file has at most that many")
    values = _values(path, text_of(path, raw))
    if not values:
        raise InputError(f"{path}: is empty; a {what} needs {needs}")
    return values


def text_of(path: Path, raw: bytes) -> str:
    """What was written, in UTF-8, or in what the first bytes say: editors on Windows put them there."""
    encoding = next((name for mark, name in MARKS if raw.startswith(mark)), "utf-8")
    try:
        return raw.decode(encoding)
    except UnicodeDecodeError as error:
        place = f"byte {error.start} is {raw[error.start]:#04x}"
        raise InputError(f"{path}: is no text in {encoding.upper()} ({place}): save it with the encoding UTF-8") from None


def _values(path: Path, text: str) -> dict:
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        remedy = ""
        if "\\" in str(error) or "hex value" in str(error):
            remedy = REMEDY
        raise InputError(f"{path}: is not a TOML text file: {error}{remedy}") from None
    except RecursionError:
        raise InputError(f"{path}: is nested too deeply; a file of ours has tables in lists, and no more") from None


def content_of(path: Path, most: int) -> bytes | None:
    """What the file holds; None where that is more than `most` bytes. Raises OSError."""
    found = os.stat(path)
    if stat.S_ISREG(found.st_mode):
        with open(path, "rb") as file:
            return _capped(file.read(most + 1), most)
    key = (found.st_dev, found.st_ino)
    if key not in _READ:
        _READ[key] = _through(path, most + 1)
    return _capped(_READ[key], most)


def _capped(data: bytes, most: int) -> bytes | None:
    return data if len(data) <= most else None


def _through(path: Path, most: int) -> bytes:
    """What comes through a pipe, or out of a device, up to `most` bytes. Raises OSError where nothing comes."""
    pipe = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0))
    data = b""
    try:
        while len(data) < most:
            if os.name == "posix" and not select.select([pipe], [], [], PATIENCE)[0]:
                raise TimeoutError(0, f"nothing has come through it for {PATIENCE:.0f} s")
            piece = os.read(pipe, min(most - len(data), 1 << 16))
            if not piece:
                break
            data += piece
    finally:
        os.close(pipe)
    return data
