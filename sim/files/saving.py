"""A running simulation in one file, and on from there, bit by bit.

The file holds the rows of the crowd, the plans, and in `meta` the world, the characters, the planner, the weights and what was
changed. What others reserve follows from the rows, and chance from (seed, character, step), so nothing else is needed. Only the
version that has written a state goes on from it: another one might step otherwise.
"""

import hashlib
import json
from pathlib import Path
from typing import Any

import numpy as np

from motion.characters.character import Character
from planner.crowd.apart import one_inside_another
from planner.planner import NoWay, Planner
from planner.planners import PLANNERS
from planner.round.weights import Weights
from sim import VERSION
from sim.files import archive
from sim.files.archive import HEIGHTS
from sim.files.schema import StateMeta, check_crowd, check_log
from sim.rows.crowd import empty_crowd
from sim.stage.cast import Change, kinds_of
from sim.stage.commands import from_plain
from sim.stage.simulation import Simulation, State
from worlds.errors import InputError
from worlds.reading import checked
from worlds.world import World

FORMAT = 4
CROWD, PLANS, LOG = "crowd", "plans", "footprint_"


def save(sim: Simulation, path: str | Path) -> None:
    """Writes the state of a simulation. Raises InputError where that cannot be done, or nobody could go on from it."""
    _check_planner(sim)
    arrays = archive.flat(CROWD, sim.crowd) | ({} if sim.plans is None else archive.flat(PLANS, sim.plans))
    arrays |= sim.footprints.kept() | {HEIGHTS: sim.world.heights}
    sim.measure()
    meta = _meta(sim)
    archive.write(path, arrays, meta | {"digest": _digest(arrays, meta)}, compressed=False)


def _check_planner(sim: Simulation) -> None:
    """Raises InputError for a planner that could not be restored."""
    planner, name = sim.planner, sim.planner.name
    said = f"--save: the planner {name!r} cannot be saved"
    if name in PLANNERS and type(planner) is not PLANNERS[name]:
        raise InputError(f"{said}: it has the name of one that ships; give it a name of its own")
    try:
        values = planner.values()
        if not isinstance(values, dict) or not all(isinstance(key, str) for key in values):
            raise ValueError(f"values() = {values!r}: a table of the keyword arguments of its class is needed")
        json.dumps(values)
        _plans_of(planner, {} if sim.plans is None else archive.flat(PLANS, sim.plans), len(sim.characters))
        if sim.plans is not None and getattr(planner.planning, "sample", None) is None:
            raise ValueError("nothing tells the types of its plans: Compiled(next_step, plans) takes a sample of them")
    except (KeyError, TypeError, ValueError, AttributeError, RecursionError) as error:
        raise InputError(f"{said}: {error}") from None


def _plans_of(planner: Planner, arrays: archive.Arrays, count: int) -> Any:
    """A planner's plans out of the arrays of a file, for so many characters. Raises KeyError, ValueError."""
    sample: Any = getattr(planner.planning, "sample", None)
    plans = None if sample is None else archive.unflat(PLANS, sample, arrays, count)
    check_plans = getattr(planner, "check_plans", None)
    if check_plans is not None:
        check_plans(plans, count)
    return plans


def _meta(sim: Simulation) -> dict:
    return {
        "format": FORMAT,
        "program": "footfall",
        "version": VERSION,
        "ticks": sim.ticks,
        "tick_rate": sim.tick_rate,
        "seed": sim.seed,
        "steps": sim.footprints.steps,
        "recasts": sim.footprints.recasts.tolist(),
        "distance": sim.gone.tolist(),
        "world": sim.world.to_dict(heights=False),
        "first_world": sim.first_world.to_dict(heights=False) if sim.first_world is not sim.world else None,
        "kinds": [{"dimensions": kind.to_dict(), "look": kind.look.model_dump()} for kind in sim.kinds],
        "kind": sim.kind.tolist(),
        "weights": sim.weights._asdict(),
        "planner": {"name": sim.planner.name, "values": sim.planner.values()},
        "changes": [change._asdict() for change in sim.changes],
    }


def _digest(arrays: archive.Arrays, meta: dict) -> str:
    whole = hashlib.sha256(json.dumps({k: v for k, v in meta.items() if k != "digest"}, sort_keys=True).encode())
    for name in sorted(arrays):
        array = np.ascontiguousarray(arrays[name])
        whole.update(f"{name} {array.dtype.descr} {array.shape}".encode() + array.tobytes())
    return whole.hexdigest()


def restore(path: str | Path, planner: Planner | None = None) -> Simulation:
    """The simulation that `save` wrote; `planner`: the one it had, where that is none of those that ship.

    Raises InputError for files of another version, of something else, or damaged.
    """
    arrays, meta = archive.read(path, "a saved state", "--save STATE.npz", (f"{CROWD}.kind",), FORMAT)
    if meta.get("version") != VERSION:
        raise InputError(f"{path}: was saved by version {meta.get('version')!r} of Footfall; only that one can go on from it")
    if meta.get("digest") != _digest(arrays, meta):
        raise InputError(f"{path}: is damaged: its contents are not what was saved")
    checked(f"{path}: meta", meta, StateMeta)
    if planner is None and meta["planner"]["name"] not in PLANNERS:
        known, name = ", ".join(PLANNERS), meta["planner"]["name"]
        raise InputError(f"{path}: its planner {name!r} is none of {known}: restore(path, planner) takes it at hand")
    try:
        return _simulation(arrays, meta, planner or PLANNERS[meta["planner"]["name"]](**meta["planner"]["values"]))
    except (KeyError, TypeError, ValueError, AttributeError, IndexError, NoWay) as error:
        raise InputError(f"{path}: is damaged: {error}") from None


def _check_apart(sim: Simulation) -> None:
    """Raises ValueError where two are in one place."""
    there, radius = np.flatnonzero(sim.present()), np.array([float(one.biped.body.radius) for one in sim.characters])
    found = one_inside_another(radius[there], sim.feet().position[there, :, :2].mean(axis=1))
    if found is not None:
        one, other = (int(there[k]) for k in found)
        raise ValueError(f"characters {other} and {one} are in one place")


def _simulation(arrays: archive.Arrays, meta: dict, planner: Planner) -> Simulation:
    kinds = [Character.from_dict(kind["dimensions"], kind["look"]) for kind in meta["kinds"]]
    crowd = archive.unflat(CROWD, empty_crowd(arrays[f"{CROWD}.kind"]), arrays)
    plans = _plans_of(planner, arrays, len(crowd.kind))
    cast = [kinds[k] for k in meta["kind"]]
    time = meta["ticks"] / meta["tick_rate"]
    check_crowd(crowd, kinds_of(cast)[1], time, _there(planner, plans, time, len(cast)))
    for name in ("recasts", "distance"):
        if len(meta[name]) != len(cast):
            raise ValueError(f"meta.{name}: {len(meta[name])} for {len(cast)} characters")
    kept = {name: array for name, array in arrays.items() if name.startswith(LOG)}
    check_log(kept, meta["recasts"])
    world = World.from_dict(meta["world"], arrays[HEIGHTS])
    state, weights = State(meta["ticks"], crowd, plans), Weights(**meta["weights"])
    sim = Simulation(world, cast, planner, meta["seed"], meta["tick_rate"], state, weights)
    _check_apart(sim)
    sim.gone[:] = meta["distance"]
    for change in meta["changes"]:
        from_plain(change["command"])
        sim.changes.append(Change(**change))
    if meta["first_world"] is not None:
        sim.first_world = World.from_dict(meta["first_world"], arrays[HEIGHTS])
    sim.footprints.take(meta["steps"], meta["recasts"], kept)
    sim.footprints.away[:] = ~sim.present()
    return sim


def _there(planner: Planner, plans: Any, time: float, count: int) -> np.ndarray:
    """(C,) bool: who is there at a time [s]."""
    there = getattr(planner, "there", None)
    return np.ones(count, bool) if there is None else there(plans, time)
