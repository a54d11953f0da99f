"""What is wrong with the data of a file, in words for whoever wrote it: key, value, what is needed, the nearest name."""

import difflib
import re
from collections.abc import Iterable
from typing import Any, get_args

from pydantic import BaseModel, ValidationError

_A_WHOLE, _A_NUMBER, _A_TABLE = "a whole number is needed", "a number is needed", "a table of keys is needed"
NEEDS = {
    "bool_type": "true or false is needed",
    "bool_parsing": "true or false is needed",
    "int_type": _A_WHOLE,
    "int_from_float": _A_WHOLE,
    "int_parsing": _A_WHOLE,
    "int_parsing_size": _A_WHOLE,
    "float_type": _A_NUMBER,
    "float_parsing": _A_NUMBER,
    "finite_number": "a finite number is needed",
    "string_type": 'text in "..." is needed',
    "string_too_short": "it is too short",
    "string_too_long": "{max_length} letters are allowed at most",
    "list_type": "a list in [...] is needed",
    "tuple_type": "a list in [...] is needed",
    "dict_type": _A_TABLE,
    "model_type": _A_TABLE,
    "too_short": "{min_length} or more are needed, not {actual_length}",
    "too_long": "{max_length} are allowed at most, not {actual_length}",
    "greater_than": "more than {gt:g} is needed",
    "greater_than_equal": "{ge:g} or more is needed",
    "less_than": "less than {lt:g} is needed",
    "less_than_equal": "{le:g} or less is needed",
    "literal_error": "{expected} is allowed",
    "value_error": "{error}",
}
"""By kinds of faults; what is in braces stands in their context."""
_SORTS = {"list_type", "tuple_type", "dict_type", "model_type", "float_type", "int_type", "string_type", "bool_type"}
_SORT = re.compile(r"(constrained-\w+|function-[\w-]+|(float|int|str|bool|tuple|list|dict|nullable)(\[.*\])?)(\(.*\))?\Z")
"""What pydantic puts into a place where values of several sorts are allowed."""
LONGEST = 60
"""Letters of a value that are told."""


def nearest(word: str, known: Iterable[str]) -> str:
    """ ", did you mean X?" for the known word that a misspelt one is nearest to; nothing where none is near."""
    found = difflib.get_close_matches(word, list(known), 1, 0.6)
    return f"; did you mean {found[0]}?" if found else ""


def faults_of(error: ValidationError, model: type[BaseModel]) -> list[str]:
    """All that is wrong, in our words."""
    return list(dict.fromkeys(_fault(one, model) for one in _of_one_sort(error.errors())))


def _of_one_sort(faults: list[Any]) -> list[Any]:
    """Where a value may be of several sorts, only what is wrong with the sort that was meant; one fault where none was.

    A list that is short only since some of its values are wrong is not told as short.
    """
    kept = []
    for one in faults:
        at = next((i for i, part in enumerate(one["loc"]) if _is_sort(part)), None)
        if at is not None:
            place, sort = one["loc"][:at], one["loc"][at]
            beside = [each for each in faults if each["loc"][:at] == place and len(each["loc"]) > at]
            other = {each["loc"][at] for each in beside}
            wrong = {each["loc"][at] for each in beside if each["type"] in _SORTS and len(each["loc"]) == at + 1}
            if sort in wrong and wrong != other:
                continue
            if wrong == other and len(other) > 1:
                needed = " or ".join(dict.fromkeys(_needed(each).removesuffix(" is needed") for each in beside))
                kept.append(one | {"loc": place, "type": "value_error", "ctx": {"error": f"{needed} is needed"}})
                continue
        deeper = any(each["loc"][: len(one["loc"])] == one["loc"] and each is not one for each in faults)
        if one["type"] != "too_short" or not deeper:
            kept.append(one | {"loc": tuple(part for part in one["loc"] if not _is_sort(part))})
    return kept


def _is_sort(part: Any) -> bool:
    return isinstance(part, str) and _SORT.match(part) is not None


def _needed(one: Any) -> str:
    """What is needed instead."""
    needs = NEEDS.get(one["type"])
    if needs is None:
        return str(one["msg"])
    return needs.format(**one.get("ctx", {}))


def _told(value: Any) -> str:
    """A value as a file has it, shortened."""
    said = str(value).lower() if isinstance(value, bool) else repr(value)
    return said if len(said) < LONGEST else f"{said[: LONGEST - 3]}..."


def _fault(one: Any, model: type[BaseModel]) -> str:
    place, kind, value = one["loc"], one["type"], one["input"]
    key = ".".join(str(part) for part in place)
    if kind == "extra_forbidden":
        return f"{key}: unknown key{nearest(str(place[-1]), _keys_at(model, place[:-1]))}"
    if kind == "missing" and isinstance(place[-1], int):
        within = ".".join(str(part) for part in place[:-1])
        return f"{within} = {_told(value)}: {place[-1] + 1} or more values are needed, not {len(value)}"
    if kind == "missing":
        return f"{key}: is missing"
    if kind == "value_error" and isinstance(value, dict):  # of a whole table: it names the key itself
        return f"{key}: {_needed(one)}" if key else _needed(one)
    said = f"{key} = {_told(value)}: {_needed(one)}"
    if kind in ("list_type", "tuple_type") and isinstance(value, dict):
        said = f"{key}: there may be several: write [[{key}]], not [{key}]"
    if kind == "literal_error":
        said += nearest(str(value), re.findall(r"'([^']*)'", one["ctx"]["expected"]))
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
