"""What the code says of its own structure: modules, functions and imports, read without running anything."""

import ast
from dataclasses import dataclass
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FLOORS = ("worlds", "motion", "planner", "sim")


@dataclass(frozen=True)
class Function:
    """A function, where it is, how long it is and how much it asks for."""

    place: str
    lines: int
    arguments: int


@cache
def modules() -> dict[str, ast.Module]:
    """Every module of the four floors by its dotted name; a package by its folder's."""
    found = {}
    for floor in FLOORS:
        for path in sorted((ROOT / floor).rglob("*.py")):
            parts = path.relative_to(ROOT).with_suffix("").parts
            found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = ast.parse(path.read_text("utf-8"))
    return found


@cache
def imports_of(name: str) -> frozenset[str]:
    """What a module imports, anywhere in it: ours by module, others by their first word."""
    found = set()
    for node in ast.walk(modules()[name]):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            found |= {_module(node.module, alias.name) for alias in node.names}
    return frozenset(one if one in modules() else one.split(".")[0] for one in found)


def _module(package: str, name: str) -> str:
    return f"{package}.{name}" if f"{package}.{name}" in modules() else package


def reached_from(name: str) -> set[str]:
    """All that a module imports, and what that imports, and so on."""
    found, waiting = set[str](), [name]
    while waiting:
        new = imports_of(waiting.pop()) - found
        found |= new
        waiting += [one for one in new if one in modules()]
    return found


def folders() -> list[str]:
    """Packages that hold modules, and "" for the top."""
    return ["", *sorted({name.rpartition(".")[0] for name in modules()} - {""})]


def arrows_in(folder: str) -> set[tuple[str, str]]:
    """The picture of a folder: (who, whom) between its files and folders, of which one imports something of the other."""
    arrows = set()
    for name in modules():
        mine = _room(folder, name)
        for other in imports_of(name) & set(modules()):
            theirs = _room(folder, other)
            if mine and theirs and mine != theirs:
                arrows.add((mine, theirs))
    return arrows


def _room(folder: str, name: str) -> str:
    """The file or folder of a folder in which a module lies; "" for none."""
    inside = name.removeprefix(f"{folder}.") if folder else name
    return "" if folder and inside == name else inside.split(".")[0]


def functions(paths: list[Path]) -> list[Function]:
    """All functions of these files; self does not count as an argument."""
    return [
        _function(path, node) for path in paths for node in ast.walk(ast.parse(path.read_text("utf-8"))) if _is_function(node)
    ]


def _is_function(node: ast.AST) -> bool:
    return isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)


def _function(path: Path, node: ast.FunctionDef) -> Function:
    asked = [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs, node.args.vararg, node.args.kwarg]
    count = sum(one is not None and one.arg not in ("self", "cls") for one in asked)
    return Function(f"{path}:{node.lineno} {node.name}", node.end_lineno - node.lineno + 1, count)
