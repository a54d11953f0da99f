"""Reading files that people write: TOML in, checked data out, every fault of a file in one report."""

import difflib
import re
import tomllib
from collections.abc import Iterable
from pathlib import Path
from typing import Any, TypeVar, get_args

from pydantic import BaseModel, ValidationError

from worlds import files
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
        if path.suffix == ".toml" or len(path.parts) > 1:
            raise InputError(f"{path}: no such {what} file{nearest(path.name, [one.name for one in _beside(path)])}")
        names = names_in(folder)
        raise InputError(
            f"{path}: no such {what}{nearest(str(path), names)}; there are {', '.join(names)}, or give a .toml file"
        )
    return path


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
        content = files.content(Path(path), LARGEST_FILE)
        return set() if content is None else set(tomllib.loads(content.decode("utf-8")))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError):
        return set()


def read_model(path: Path, model: type[Model], what: str, needs: str) -> Model:
    """The file as checked data. Raises InputError naming every fault."""
    return checked(path, read_toml(path, what, needs), model)


def checked(path: Path | str, plain: dict, model: type[Model]) -> Model:
    """What a file holds as checked data. Raises InputError naming every fault."""
    try:
        return model.model_validate(plain)
    except ValidationError as error:
        raise InputError("\n".join(f"{path}: {_fault(one, model)}" for one in error.errors())) from None


def read_toml(path: Path, what: str, needs: str) -> dict:
    """What a TOML file holds, as plain values. Raises InputError."""
    try:
        content = files.content(path, LARGEST_FILE)
        if content is None:
            raise InputError(f"{path}: more than {LARGEST_FILE} bytes; a {what} file has at most that many")
        values = tomllib.loads(content.decode("utf-8"))
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise InputError(f"{path}: is not a TOML text file: {error}") from None
    if not values:
        raise InputError(f"{path}: is empty; a {what} needs {needs}")
    return values


def nearest(word: str, known: Iterable[str]) -> str:
    """ ", did you mean X?" for the known word that a misspelt one is nearest to; nothing where none is near."""
    found = difflib.get_close_matches(word, list(known), 1, 0.6)
    return f"; did you mean {found[0]}?" if found else ""


def _fault(one: Any, model: type[BaseModel]) -> str:
    key = ".".join(str(part) for part in one["loc"])
    if one["type"] == "extra_forbidden":
        return f"{key}: unknown key{nearest(str(one['loc'][-1]), _keys_at(model, one['loc'][:-1]))}"
    if one["type"] == "missing":
        return f"{key}: is missing"
    value = repr(one["input"])
    said = f"{key} = {value if len(value) < 60 else value[:57] + '...'}: {one['msg']}"
    if one["type"] == "literal_error":
        said += nearest(str(one["input"]), re.findall(r"'([^']*)'", one["ctx"]["expected"]))
    return said


def _keys_at(model: type[BaseModel], place: tuple) -> list[str]:
    """The keys of the table at this place of a model."""
    for part in place:
        if isinstance(part, str) and part in model.model_fields:
            inner = _table_in(model.model_fields[part].annotation)
            if inner is None:
                return []
            model = inner
    return list(model.model_fields)


def _table_in(annotation: Any) -> type[BaseModel] | None:
    """The model that a field holds, by itself, in a list, or where it is not left out."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return annotation
    return next((found for part in get_args(annotation) if (found := _table_in(part))), None)
