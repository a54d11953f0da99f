"""A running simulation in one file, and on from there, bit by bit.

The file holds the rows of the crowd, the plans, and in `meta` the world, the characters and the planner. What others reserve
follows from the rows, and chance from (seed, character, step), so nothing else is needed. Only the version that has written a
state goes on from it: another one might step otherwise.
"""

import hashlib
from collections.abc import Callable
from pathlib import Path

import numpy as np

from motion.characters.biped import FIELDS, Biped, record_of
from planner.plan import Plans, plans_of
from planner.river.rock_hop import RockHop
from planner.walking import WalkTo
from planner.wandering import Wander
from sim import VERSION
from sim.files import archive
from sim.rows.crowd import Crowd, empty_crowd
from sim.stage.simulation import Simulation, State
from worlds.errors import InputError
from worlds.world import World

FORMAT = 1
PLANNERS: dict[str, Callable] = {"Wander": Wander, "RockHop": RockHop, "WalkTo": WalkTo}
CROWD, PLANS, LOG = "crowd_", "plans_", "footprint_"


def save(sim: Simulation, path: str | Path) -> None:
    """Writes the state of a simulation. Raises InputError where that cannot be done."""
    arrays = {CROWD + key: array for key, array in sim.crowd._asdict().items()}
    arrays |= {PLANS + key: array for key, array in sim.plans._asdict().items()}
    arrays |= {LOG + key: array for key, array in sim.footprints.kept().items()}
    archive.write(path, arrays, _meta(sim) | {"digest": _digest(arrays)}, compressed=False)


def _meta(sim: Simulation) -> dict:
    kinds = {character.name: character for character in sim.characters}
    return {
        "format": FORMAT,
        "program": "footfall",
        "version": VERSION,
        "ticks": sim.ticks,
        "tick_rate": sim.tick_rate,
        "seed": sim.seed,
        "steps": sim.footprints.steps,
        "world": sim.world.to_dict(),
        "kinds": {name: {"dimensions": b.to_dict(), "body": b.body} for name, b in kinds.items()},
        "characters": [character.name for character in sim.characters],
        "planner": {"name": type(sim.planner).__name__, "values": _values(sim.planner)},
    }


def _values(planner) -> dict:
    """What the planner was made with, as plain values."""
    if isinstance(planner, WalkTo):
        return {
            "starts": planner.places.tolist(),
            "stops": planner.stops.tolist(),
            "again": planner.again,
            "near": planner.near,
        }
    return {}


def _digest(arrays: archive.Arrays) -> str:
    whole = hashlib.sha256()
    for name in sorted(arrays):
        whole.update(name.encode() + np.ascontiguousarray(arrays[name]).tobytes())
    return whole.hexdigest()


def restore(path: str | Path) -> Simulation:
    """The simulation that `save` wrote. Raises InputError for files of another version, of something else, or damaged."""
    needed = (*(CROWD + key for key in Crowd._fields), *(PLANS + key for key in Plans._fields))
    arrays, meta = archive.read(path, "a saved state", "--save STATE.npz", needed, FORMAT)
    if meta.get("version") != VERSION:
        raise InputError(f"{path}: was saved by version {meta.get('version')!r} of Footfall; only that one can go on from it")
    if meta.get("digest") != _digest(arrays):
        raise InputError(f"{path}: is damaged: its contents are not what was saved")
    try:
        return _simulation(arrays, meta)
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise InputError(f"{path}: is damaged: {error!r}") from None


def _simulation(arrays: archive.Arrays, meta: dict) -> Simulation:
    kinds = {
        name: Biped(name, record_of({field: kind["dimensions"][field] for field in FIELDS}), kind["body"])
        for name, kind in meta["kinds"].items()
    }
    planner = PLANNERS[meta["planner"]["name"]](**meta["planner"]["values"])
    crowd = _like(Crowd, empty_crowd(arrays[CROWD + "kind"]), arrays, CROWD)
    plans = _like(Plans, plans_of(0, len(crowd.kind)), arrays, PLANS)
    sim = Simulation(
        World.from_dict(meta["world"]), [kinds[name] for name in meta["characters"]], planner, meta["seed"], meta["tick_rate"],
        State(meta["ticks"], crowd, plans),
    )  # fmt: skip
    sim.footprints.take(meta["steps"], {k.removeprefix(LOG): array for k, array in arrays.items() if k.startswith(LOG)})
    return sim


def _like(kind, model, arrays: archive.Arrays, prefix: str):
    """The named tuple of arrays, of the model's types and numbers of characters."""
    found = {}
    for key, expected in model._asdict().items():
        array = arrays[prefix + key]
        if array.dtype != expected.dtype or array.ndim != expected.ndim or len(array) != len(expected):
            raise ValueError(f"{prefix}{key} is {array.dtype} {array.shape}")
        found[key] = np.ascontiguousarray(array)
    return kind(**found)
