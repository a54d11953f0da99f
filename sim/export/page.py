"""One self-contained page that plays a clip: three.js, the bodies as a .glb, and what else is drawn are all within it.

What is within is gzip in base64, so a page of ten seconds of one human stays below 2 MB; three.js is a third of that.
"""

import base64
import gzip
import html
import json
import re
from importlib.resources import files

import numpy as np

from motion.measures.forces import supporting_forces
from sim.export.clip.asked import Asked
from sim.export.clip.clip import Actor, Clip
from sim.export.skeletons.axes import y_up
from sim.export.skeletons.glb import add_scenery, gltf_of
from sim.export.skeletons.skin import kind_of
from sim.files import outputs
from sim.view.bodies.bodies import outline

CELLS, TREES = 70, 250
"""Of the ground, either way, and trees around what is exported: so much of the world is in a page."""
SHOWN = 2.0
"""Footprints are kept that are left no longer than this [s] before the clip begins."""


def export_page(clip: Clip, path: str, asked: Asked) -> None:
    """Writes the page. Raises InputError."""
    gltf = gltf_of(clip)
    add_scenery(gltf, clip, CELLS, TREES)
    count = len(clip.actors)
    about = f"{count} character{'s' if count > 1 else ''}, {clip.seconds:.1f} s. Drag to orbit, wheel to zoom, space to pause."
    parts = {
        "title": html.escape(f"Footfall: {clip.name}"), "about": html.escape(about), "css": _part("page.css"),
        "three": _part("three.min.js"), "run": _safe(json.dumps(_run(clip), separators=(",", ":"))),
        "glb": _packed(gltf.as_bytes()), "numbers": _packed(_numbers(clip).tobytes()), "js": _part("page.js"),
    }  # fmt: skip
    page = re.sub(r"\{\{(\w+)\}\}", lambda found: parts[found[1]], _part("page.html"))
    with outputs.whole(path) as temporary:
        temporary.write_text(page, "utf-8")


def _part(name: str) -> str:
    return files("sim.export").joinpath("viewer", name).read_text("utf-8")


def _safe(text: str) -> str:
    """JSON that ends no script early."""
    return text.replace("<", "\\u003c")


def _packed(data: bytes) -> str:
    return base64.b64encode(gzip.compress(data, 9, mtime=0)).decode()


def _run(clip: Clip) -> dict:
    """Who is there, and the footprints of each, in the page's axes."""
    kinds = {kind_of(actor.character): actor.character for actor in clip.actors}
    order, actors, node = list(kinds), list[dict](), 0
    for actor in clip.actors:
        actors.append({
            "name": actor.name, "node": node, "kind": order.index(kind_of(actor.character)),
            "prints": _prints(actor, clip.time), "leg": round(float(actor.character.biped.leg.nominal_length), 4),
        })  # fmt: skip
        node += len(actor.skeleton.names) + 1  # and that of its body
    outlines = [outline(kind).reshape(-1, 2).round(4).tolist() for kind in kinds.values()]
    whole = {"rate": clip.rate, "frames": len(clip.time), "begin": float(clip.time[0])}
    return whole | {"outlines": outlines, "actors": actors}


def _prints(actor: Actor, time: np.ndarray) -> list[dict]:
    """The footprints that are seen in the clip, or on its timeline."""
    rows = actor.footprints
    leaves = rows.contact_time + rows.stance_time
    ahead = np.stack([np.cos(rows.heading), np.sin(rows.heading), np.zeros_like(rows.heading)], axis=1)
    seen = np.flatnonzero((rows.contact_time <= time[-1]) & (leaves > time[0] - SHOWN))
    return [
        {
            "side": int(rows.side[n]), "contact": round(float(rows.contact_time[n]), 4), "leaves": round(float(leaves[n]), 4),
            "place": y_up(rows.position[n]).round(4).tolist(), "normal": y_up(rows.normal[n]).round(4).tolist(),
            "ahead": y_up(ahead[n]).round(4).tolist(),
        }
        for n in seen
    ]  # fmt: skip


def _numbers(clip: Clip) -> np.ndarray:
    """(C, F, 15) float32: centre of mass; point of support and force [N/kg] of left and right foot, zero in the air."""
    found = np.zeros((len(clip.actors), len(clip.time), 15), "<f4")
    for row, actor in zip(found, clip.actors, strict=True):
        pose = actor.pose
        force = supporting_forces(pose.com, pose.com_acceleration, pose.point_of_support, pose.contact)
        feet = np.concatenate([y_up(np.nan_to_num(pose.point_of_support)), y_up(force)], axis=2) * pose.contact[..., None]
        row[:, :3], row[:, 3:] = y_up(pose.com), feet.reshape(len(feet), 12)
    return found
