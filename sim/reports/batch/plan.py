"""What a batch is to do, kept in its folder: who goes on with it must mean the same."""

import hashlib
import json
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import NamedTuple

from motion.characters.character import load_character
from sim import VERSION
from sim.files import outputs
from worlds.errors import InputError
from worlds.level import load_level

NAME = "batch.json"
MOST_JOBS = 1_000_000


class Job(NamedTuple):
    """One run, as plain values."""

    name: str  # of its files
    level: str
    seed: int
    task: str  # wander or river
    character: str
    characters: int
    seconds: float
    plan: str  # digest of the plan that it belongs to


@dataclass(frozen=True)
class Plan:
    """Which runs a batch has: every level with every seed."""

    levels: tuple[str, ...]
    first_seed: int
    last_seed: int  # not one of them any more
    task: str
    character: str
    characters: int
    seconds: float

    def jobs(self) -> list[Job]:
        """The runs, in the order of the table."""
        digest, of = self.digest(), (self.task, self.character, self.characters, self.seconds)
        return [
            Job(f"{k:03d}-{Path(level).stem}-{seed:08d}", level, seed, *of, digest)
            for k, level in enumerate(self.levels)
            for seed in range(self.first_seed, self.last_seed)
        ]

    def digest(self) -> str:
        """Of all that the runs depend on: levels and characters by what they are, and the version."""
        worlds = [load_level(level).to_dict() for level in self.levels]
        plain = {**asdict(self), "worlds": worlds, "walker": load_character(self.character).to_dict(), "version": VERSION}
        return hashlib.sha256(json.dumps(plain, sort_keys=True).encode()).hexdigest()[:16]


def plan_of(levels: list[str], seeds: tuple[int, int], task: str, character: str, characters: int, seconds: float) -> Plan:
    """A plan whose levels and character are there; files by their whole paths. Raises InputError."""
    worlds = [load_level(level) for level in levels]
    load_character(character)
    if task == "river" and (lacking := [level for level, world in zip(levels, worlds, strict=True) if world.goal is None]):
        raise InputError(f"--level {lacking[0]}: has no [goal]; --task river needs one")
    if len(levels) * (seeds[1] - seeds[0]) > MOST_JOBS:
        raise InputError(f"--seeds: {len(levels) * (seeds[1] - seeds[0]):,} runs; {MOST_JOBS:,} at most are allowed")
    return Plan(tuple(_whole(level) for level in levels), *seeds, task, _whole(character), characters, seconds)


def _whole(name: str) -> str:
    """A file by its whole path; what ships by its name."""
    return str(Path(name).resolve()) if name.endswith(".toml") else name


def keep(plan: Plan, folder: Path) -> None:
    """Writes the plan into a new folder, or sees that the one there is the same. Raises InputError."""
    path = folder / NAME
    said = {**asdict(plan), "levels": list(plan.levels), "digest": plan.digest(), "version": VERSION}
    if path.exists():
        _compare(path, said)
        return
    with outputs.whole(path) as part:
        part.write_text(json.dumps(said, indent=1, sort_keys=True), "utf-8")


def _compare(path: Path, said: dict) -> None:
    try:
        kept = json.loads(path.read_text("utf-8"))
        other = sorted(key for key in said if kept.get(key) != said[key])
    except (OSError, ValueError, AttributeError) as error:
        raise InputError(f"{path}: is no batch that can be gone on with ({error}); give another --out") from None
    if other:
        words = "; ".join(f"{key} was {kept.get(key)!r}, is {said[key]!r}" for key in other if key != "digest")
        raise InputError(f"{path}: is of another batch: {words or 'a level or character file has changed'}; give another --out")
