"""The formats by the endings of their names. A new one is a line here, and a file whose function writes a clip.

It needs nothing but Python: the command line is read before anything is installed.
"""

from typing import NamedTuple

FILMS = (".mp4", ".m4v", ".mov", ".mkv", ".avi", ".gif", ".webm")


class Format(NamedTuple):
    """A format, and who writes it."""

    about: str
    where: str  # module.function in sim.export
    apart: bool = False  # each character is a file of its own
    needs: tuple[str, str] | None = None  # a module that may be missing, and the package that brings it


FFMPEG = ("imageio_ffmpeg", "imageio-ffmpeg")
USD = ("pxr", "usd-core")
FORMATS = {
    ".csv": Format("contacts and supporting forces, or --array NAME", "tables.contacts.export_contacts"),
    ".parquet": Format("contacts and supporting forces", "tables.contacts.export_contacts", needs=("pyarrow", "pyarrow")),
    ".glb": Format("bodies and motion: Blender, Godot, Unity, Unreal, three.js", "skeletons.glb.export_glb"),
    **{ending: Format("bodies and motion, UsdSkel", "skeletons.usd.export_usd", needs=USD) for ending in (".usda", ".usdc")},
    ".bvh": Format("skeleton and motion, a file per character", "skeletons.bvh.export_bvh", apart=True),
    **{ending: Format("a film", "films.export_film", needs=FFMPEG) for ending in FILMS},
    ".png": Format("a sheet of sprites, of one character from its side", "films.export_sprites"),
    ".html": Format("a page that plays it, by itself", "page.export_page"),
    ".txt": Format("trajectories, PedPy and JuPedSim", "tables.trajectories.export_text"),
    ".sqlite": Format("trajectories, JuPedSim", "tables.trajectories.export_sqlite"),
    ".traj": Format("footsteps, Vadere", "tables.trajectories.export_footsteps"),
}
