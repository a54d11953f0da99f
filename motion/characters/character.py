"""Who walks: a character from a file (`motion/characters/*.toml`, or anybody's).

A file has the tables of motion.characters.dimensions, one number to a line; a table [look], which only the view reads; and
`scale`, which makes a character of another size of it: lengths grow by it, speeds by similarity.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field, create_model

from motion.characters import former
from motion.characters.checks import faults
from motion.characters.dimensions import TABLES, Dimensions, flat_name, record_of
from motion.characters.quantities import SCALES, Quantity, quantities_of
from worlds import reading
from worlds.errors import InputError

CHARACTERS = Path(__file__).parent
PLANS = ("human", "bird", "dinosaur")
"""Shapes that the view can give a body."""
Colour = tuple[Annotated[float, Field(ge=0, le=1)], Annotated[float, Field(ge=0, le=1)], Annotated[float, Field(ge=0, le=1)]]
Share = Annotated[float, Field(gt=0, le=5, allow_inf_nan=False)]
Scale = Annotated[float, Field(ge=SCALES[0], le=SCALES[1], allow_inf_nan=False)]
GREY = (0.7, 0.7, 0.7)


class Look(BaseModel):
    """[look]: the body's plan, its colours (red, green, blue in 0..1), and what varies a bird."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)
    plan: Literal["human", "bird", "dinosaur"] = "human"
    skin: Colour = Field(default=GREY, strict=False)
    main: Colour = Field(default=GREY, strict=False)
    second: Colour = Field(default=GREY, strict=False)
    detail: Colour = Field(default=GREY, strict=False)
    girth: Share = 1.0
    neck: Share = 1.0
    beak: Share = 1.0
    crest: bool = True


@dataclass(frozen=True)
class Character:
    """A name, the dimensions for the kernels, and the looks for the view."""

    name: str
    biped: Dimensions
    look: Look = Look()

    def to_dict(self) -> dict:
        """The dimensions as plain numbers without tables, for a recording's meta (dimensions.flat_name)."""
        numbers = {
            flat_name(table, field): float(getattr(getattr(self.biped, table), field))
            for table, kind in TABLES.items()
            for field in quantities_of(kind)
        }
        return {"name": self.name, **numbers}

    @classmethod
    def from_dict(cls, plain: dict, look: dict) -> "Character":
        """The character that `to_dict` described, with these looks. Raises InputError naming every fault."""
        known = {flat_name(table, field): q for table, kind in TABLES.items() for field, q in quantities_of(kind).items()}
        plain = {name: q.from_file(q.default, 1.0) for name, q in known.items() if q.default is not None} | plain
        wrong = [
            f"{name} = {plain.get(name)!r}: {_allowed(quantity)}"
            for name, quantity in known.items()
            if not _is_number(plain.get(name)) or not quantity.can_be(plain[name])
        ]
        wrong += [f"{name}: is nothing of a character" for name in plain if name not in known and name != "name"]
        if not isinstance(plain.get("name"), str):
            wrong.append(f"name = {plain.get('name')!r}: text is needed")
        if wrong:
            raise InputError("\n".join(f"character: {fault}" for fault in wrong))
        looks = reading.checked("character: look", look, Look)
        character = cls(plain["name"], record_of(lambda table, field: float(plain[flat_name(table, field)])), looks)
        if together := faults(character.biped):
            raise InputError("\n".join(f"character: {fault}" for fault in together))
        return character


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _allowed(quantity: Quantity) -> str:
    low, high = quantity.from_file(quantity.low, 1.0), quantity.from_file(quantity.high, 1.0)
    return f"a number from {low:.4g} to {high:.4g} {quantity.unit}, times the scale, is needed".replace(" ,", ",")


def _limits(table: type) -> Any:
    """The checked data of a table."""
    fields = {}
    for name, quantity in quantities_of(table).items():
        needed = ... if quantity.default is None else quantity.default
        fields[name + quantity.key] = (float, Field(needed, ge=quantity.low, le=quantity.high, allow_inf_nan=False))
    return create_model(table.__name__, __config__=ConfigDict(extra="forbid", strict=True), **fields)  # type: ignore[call-overload]


_File: Any = create_model(
    "_File",
    __config__=ConfigDict(extra="forbid", strict=True),
    format=(Literal[2], ...),
    name=(Annotated[str, Field(min_length=1, max_length=100)], ...),
    scale=(Scale, 1.0),
    **{name: (_limits(table), ...) for name, table in TABLES.items()},
    look=(Look, Look()),
)  # type: ignore[call-overload]


def character_names() -> list[str]:
    """Names of the characters that ship."""
    return reading.names_in(CHARACTERS)


def load_character(name_or_path: str | Path, scale: float = 1.0) -> Character:
    """A shipped character by name, or any character file by path, `scale` times as large as the file says.

    Raises InputError naming every fault.
    """
    path = reading.named_file(CHARACTERS, name_or_path, "character")
    needs = f"format, name, {', '.join(f'[{name}]' for name in TABLES)}"
    plain = reading.read_toml(path, "character", needs)
    if former.is_former(plain):
        raise InputError("\n".join(f"{path}: {line}" for line in former.renamed(plain)))
    file = reading.checked(path, plain, _File)

    def number(table: str, field: str) -> float:
        quantity = quantities_of(TABLES[table])[field]
        return quantity.from_file(getattr(getattr(file, table), field + quantity.key), file.scale * scale)

    character = Character(file.name, record_of(number), file.look)
    wrong = faults(character.biped)
    if wrong:
        raise InputError("\n".join(f"{path}: {fault}" for fault in wrong))
    return character
