"""A document as the text of its file: what the user wrote, comments and order, with only what has changed put in its place.

Tables of a list (footprints, trees) are matched by what they hold, so a comment stays with its footprint when another one is
inserted before it. New ones are set apart as the others are (sim.files.studio.leads). Numbers are written so that reading them
gives the same bits.
"""

import difflib
from pathlib import Path
from typing import Any

import tomlkit
from tomlkit.items import AoT, Table

from sim.files import outputs
from sim.files.studio.document import Document, sheet_of
from sim.files.studio.leads import headers, parsed, usual_lead

ORDER = (
    "format", "name", "figure", "about", "character", "character_scale", "stand_before", "stand_after", "support", "segments",
    "world",
)  # fmt: skip
"""Keys of a new file, in this order; lists of tables follow."""


def text_of(document: Document, written: str = "") -> str:
    """The text of a document's file, in which what was `written` before stays, but for what has changed."""
    sheet = sheet_of(document)
    least, whole = sheet.model_dump(exclude_defaults=True), sheet.model_dump(exclude_none=True)
    text = parsed(written)
    if not written:
        least = {key: least[key] for key in (*ORDER, *least) if key in least}
    lead, leads = usual_lead(text), {id(one): (one, one.trivia.indent) for one in headers(text)}
    _merge(text, least, whole)
    for table in headers(text):
        table.trivia.indent = leads.get(id(table), (table, lead))[1]
    return tomlkit.dumps(text).lstrip("\n")


def write_scene(document: Document, path: str | Path) -> None:
    """Writes a new file, whole or not at all. Raises InputError."""
    with outputs.whole(path) as part:
        part.write_bytes(text_of(document).encode("utf-8"))


def _merge(table: Any, least: dict[str, Any], whole: dict[str, Any]) -> None:
    """Makes a table say what `whole` says: keys that are there are changed where they differ, others of `least` are added."""
    for key in [key for key in table if key not in whole]:
        del table[key]
    for key in [key for key in table if key in whole]:
        _change(table, key, least.get(key, whole[key]), whole[key])
    for key in (key for key in least if key not in table and key in whole):
        table[key] = _item(least[key])


def _change(table: Any, key: str, least: Any, whole: Any) -> None:
    old = table[key]
    if isinstance(old, Table) and isinstance(whole, dict):
        _merge(old, least, whole)
    elif isinstance(old, Table) and _is_tables(whole) and len(whole) == 1:  # one path, written as a table
        _merge(old, least[0], whole[0])
    elif isinstance(old, AoT) and _is_tables(whole):
        _change_list(table, key, old, least, whole)
    elif not _same(old.unwrap() if hasattr(old, "unwrap") else old, whole):
        table[key] = _item(least)


def _is_tables(value: Any) -> bool:
    return isinstance(value, list | tuple) and len(value) > 0 and all(isinstance(one, dict) for one in value)


def _change_list(table: Any, key: str, old: AoT, least: Any, whole: Any) -> None:
    """Makes a list of tables: those that are the same, or stand in the same place, go on with their comments."""
    before = [_frozen(one.unwrap()) for one in old]
    bare = [_frozen(_plain(one)) for one in least]
    if [_frozen(_plain(one)) for one in whole] == before or bare == before:
        return
    new = tomlkit.aot()
    for _, i, j, k, n in difflib.SequenceMatcher(None, before, bare, False).get_opcodes():
        shift = _shift(before[i:j], bare[k:n])
        for at in range(k, n):
            if 0 <= at - k - shift < j - i:
                item = old[i + at - k - shift]
                _merge(item, least[at], whole[at])
                new.append(item)
            else:
                new.append(_table(least[at]))
    table[key] = new


def _shift(before: list[Any], after: list[Any]) -> int:
    """How far on the tables before stand among those after, so that most of what they hold is the same."""
    shifts = range(max(len(after) - len(before), 0) + 1)
    return max(shifts, key=lambda s: sum(len(set(a) & set(b)) for a, b in zip(before, after[s:], strict=False)))


def _item(value: Any) -> Any:
    if isinstance(value, dict):
        return _table(value)
    if _is_tables(value):
        tables = tomlkit.aot()
        for one in value:
            tables.append(_table(one))
        return tables
    return tomlkit.item(_plain(value))


def _table(keys: dict[str, Any]) -> Table:
    table = tomlkit.table()
    for key, value in keys.items():
        if value is not None:
            table[key] = _item(value)
    return table


def _plain(value: Any) -> Any:
    """Values as TOML has them: lists for tuples, nothing for None."""
    if isinstance(value, dict):
        return {key: _plain(one) for key, one in value.items() if one is not None}
    if isinstance(value, list | tuple):
        return [_plain(one) for one in value]
    return value


def _same(old: Any, new: Any) -> bool:
    return bool(_plain(old) == _plain(new))


def _frozen(value: Any) -> Any:
    """A value that can be compared and hashed."""
    if isinstance(value, dict):
        return tuple(sorted((key, _frozen(one)) for key, one in value.items()))
    return tuple(_frozen(one) for one in value) if isinstance(value, list) else value
