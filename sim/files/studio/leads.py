"""What stands above the headers of a TOML text, its leads: blank lines, and the comments that speak of the table below.

tomlkit counts them to the table before, so they would stay behind when their own table moves, and go with one that is deleted.
Moved to the header, into what it calls its indent, they go where their table goes; the text is the same.
"""

from collections.abc import Iterator
from typing import Any

import tomlkit
from tomlkit.items import AoT, Comment, Null, Table, Whitespace


def parsed(written: str) -> tomlkit.TOMLDocument:
    """A text, with leads at their headers; it ends with a line's end."""
    whole = written if not written or written.endswith("\n") else written + "\n"
    text = tomlkit.parse(whole)
    before: Any = text
    for table in headers(text):
        table.trivia.indent = _taken(before) + table.trivia.indent
        before = table.value
    return text if tomlkit.dumps(text) == whole else tomlkit.parse(whole)


def headers(container: Any) -> Iterator[Table]:
    """The tables that have a header of their own, in the order of the text."""
    for _, item in container.body:
        for table in item.body if isinstance(item, AoT) else [item] if isinstance(item, Table) else []:
            if not table.is_super_table():
                yield table
            yield from headers(table.value)


def usual_lead(text: tomlkit.TOMLDocument) -> str:
    """What stands above a new header: a blank line, unless most headers of the text have none."""
    blank = [table.trivia.indent.startswith(("\n", "\r\n")) for table in headers(text)]
    return "\n" if 2 * sum(blank) >= len(blank) else ""


def _taken(container: Any) -> str:
    """Takes blank lines and comments away that stand last in a container, before its first header; returns their text."""
    body, found = container.body, []
    end = next((k for k, (_, item) in enumerate(body) if isinstance(item, Table | AoT)), len(body))
    while end > 0 and isinstance(body[end - 1][1], Whitespace | Comment | Null):
        end -= 1
        found.append(body[end][1].as_string())
        body[end] = (None, Null())
    return "".join(reversed(found))
