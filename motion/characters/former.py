"""Character files as versions up to 0.4.1 wrote them, with all numbers in one table [biped]: where each key is now."""

from motion.characters.dimensions import TABLES, flat_name
from motion.characters.quantities import quantities_of


def is_former(plain: dict) -> bool:
    """Whether a file's contents are of the former kind."""
    return "biped" in plain or plain.get("format") == 1


def keys_now() -> dict[str, str]:
    """Former keys of [biped], and the table and key that say the same now."""
    now = {}
    for table, kind in TABLES.items():
        for name, quantity in quantities_of(kind).items():
            now[flat_name(table, name) + quantity.key] = f"{table}.{name}{quantity.key}"
    return now


def renamed(plain: dict) -> list[str]:
    """What to change, key by key."""
    now, lines = keys_now(), ["format = 1: is of version 0.4.1 or older; write format = 2, and its numbers in tables:"]
    biped = plain.get("biped")
    if isinstance(biped, dict):
        lines += [f"biped.{key}: is now {now[key]}" if key in now else f"biped.{key}: unknown key" for key in biped]
    if "body" in plain and "biped" in plain:
        lines.append("[body] with plan and colours: is now [look]")
    return lines
