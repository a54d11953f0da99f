"""Reading files that people write: TOML in, checked data out, every fault of a file in one report."""

import tomllib
from pathlib import Path
from typing import TypeVar

from pydantic import BaseModel, ValidationError

from worlds.errors import InputError

LARGEST_FILE = 2_000_000
"""Bytes: these files are written by a person; anything larger is something else."""
Model = TypeVar("Model", bound=BaseModel)


def named_file(folder: Path, name_or_path: str | Path, what: str) -> Path:
    """A file that ships, by name, or any file by path. Raises InputError where there is none."""
    path = folder / f"{name_or_path}.toml"
    if path.is_file():
        return path
    path = Path(name_or_path)
    if path.is_dir():
        raise InputError(f"{path}: is a folder; a {what} is a TOML file")
    if not path.exists():
        raise InputError(f"{path}: no such {what}; there are {', '.join(names_in(folder))}, or give a .toml file")
    return path


def names_in(folder: Path) -> list[str]:
    """Names of the files that ship in a folder."""
    return sorted(path.stem for path in folder.glob("*.toml"))


def tables_of(path: str | Path) -> set[str]:
    """The names at the top of a file; none where it is no readable TOML file: whoever reads it then says what is wrong."""
    try:
        return (
            set(tomllib.loads(Path(path).read_text(encoding="utf-8"))) if Path(path).stat().st_size <= LARGEST_FILE else set()
        )
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError):
        return set()


def read_model(path: Path, model: type[Model], what: str, needs: str) -> Model:
    """The file as checked data. Raises InputError naming every fault."""
    try:
        return model.model_validate(_read(path, what, needs))
    except ValidationError as error:
        raise InputError("\n".join(f"{path}: {_fault(one)}" for one in error.errors())) from None


def _read(path: Path, what: str, needs: str) -> dict:
    if path.stat().st_size > LARGEST_FILE:
        raise InputError(f"{path}: {path.stat().st_size} bytes; a {what} file has at most {LARGEST_FILE}")
    try:
        values = tomllib.loads(path.read_bytes().decode("utf-8"))
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise InputError(f"{path}: is not a TOML text file: {error}") from None
    if not values:
        raise InputError(f"{path}: is empty; a {what} needs {needs}")
    return values


def _fault(one) -> str:
    key = ".".join(str(part) for part in one["loc"])
    if one["type"] == "extra_forbidden":
        return f"{key}: unknown key"
    if one["type"] == "missing":
        return f"{key}: is missing"
    value = repr(one["input"])
    return f"{key} = {value if len(value) < 60 else value[:57] + '...'}: {one['msg']}"
