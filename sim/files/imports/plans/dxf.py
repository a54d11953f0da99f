"""DXF drawings (AutoCAD's, R12 and later), by ezdxf: lines, polylines, arcs, circles, ellipses and splines of the model space,
and those of the blocks in it, seen from above. Metres by the drawing's own units, where it tells them.
"""

from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

from sim.files.imports.plans.lines import Plan, checked
from sim.files.imports.texts import FARTHEST, content_of
from worlds.errors import InputError
from worlds.reading import nearest

KINDS = ("LINE", "LWPOLYLINE", "POLYLINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE")
SAGITTA = 0.02
"""Arcs become polylines that keep this near to them [m]."""
MOST = 200_000
"""Things of a drawing that are looked at."""


def read_dxf(path: str, scale: float | None, layers: list[str] | None) -> Plan:
    """The plan of a drawing; scale: metres in its unit, by default as it tells. layers: only these. Raises InputError."""
    try:
        import ezdxf
        from ezdxf.lldxf.const import DXFError
    except ImportError as error:
        raise InputError(f"{path}: DXF needs ezdxf (pip install ezdxf, or the extra `plans`): {error}") from None
    content_of(path, "a drawing in DXF")
    try:
        drawing = ezdxf.readfile(path)
    except OSError as error:
        raise InputError(f"{path}: is no DXF drawing: {error}") from None
    except (DXFError, ValueError, UnicodeDecodeError) as error:
        raise InputError(f"{path}: is no DXF drawing: {error}") from None
    names = [layer.dxf.name for layer in drawing.layers]
    for layer in layers or ():
        if layer not in names:
            raise InputError(f"--layers {layer}: the drawing has {', '.join(names)}{nearest(layer, names)}")
    metres = scale or _metres(path, drawing)
    lines = [metres * line for line in _lines(path, drawing.modelspace(), layers, SAGITTA / metres)]
    return checked(path, Plan(tuple(lines)))


def _metres(path: str, drawing: Any) -> float:
    """Metres in a unit of the drawing. Raises InputError where it does not tell."""
    from ezdxf import units

    if drawing.units == 0:
        raise InputError(f"{path}: does not tell its unit; give --scale, the metres in one (0.001 for millimetres)")
    return float(units.conversion_factor(units.InsertUnits(drawing.units), units.InsertUnits.Meters))


def _entities(path: str, found: Iterable[Any], layers: list[str] | None, left: list[int]) -> Iterator[Any]:
    """What is drawn, blocks taken apart."""
    for entity in found:
        left[0] -= 1
        if left[0] < 0:
            raise InputError(f"{path}: draws more than {MOST:,} things; give --layers, those with walls")
        if entity.dxftype() == "INSERT":
            yield from _entities(path, entity.virtual_entities(), layers, left)
        elif entity.dxftype() in KINDS and (layers is None or entity.dxf.layer in layers):
            yield entity


def _lines(path: str, space: Any, layers: list[str] | None, sagitta: float) -> Iterator[np.ndarray]:
    from ezdxf.path import make_path

    for entity in _entities(path, space, layers, [MOST]):
        points = np.array([(p.x, p.y) for p in make_path(entity).flattening(sagitta)])
        if len(points) and not np.abs(points).max() <= FARTHEST:
            raise InputError(f"{path}: a {entity.dxftype()} lies further out than {FARTHEST:g} units")
        if len(points) > 1:
            yield points
