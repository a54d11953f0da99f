"""The panel at the right: what is chosen in numbers, its path, who walks, what shapes it, what would heal the worst places."""

from typing import Any

from imgui_bundle import imgui

from motion.characters.character import character_names
from planner.script.path import Path
from planner.script.shaping import KEYED, ComPull, Key, Manners, Stretch, Style
from sim.files.studio import edits, groups, paths, shapes
from sim.files.studio.document import Spot, footprint_at, footprints_in
from sim.view import theme
from sim.view.studio.desk.desk import Desk
from sim.view.studio.desk.healing import Healing
from sim.view.studio.table.layout import Layout

FLAGS = (
    imgui.WindowFlags_.no_move | imgui.WindowFlags_.no_resize | imgui.WindowFlags_.no_collapse | imgui.WindowFlags_.no_title_bar
)


LIMITS = {
    "lean_deg": (-45.0, 45.0), "heaviness": (0.3, 2.0), "leg": (0.5, 1.1), "gravity": (0.05, 3.0), "comfort": (0.05, 3.0),
}  # fmt: skip
"""Of what a style or a stretch may be, where it is not 0 to 3."""

CURVES = {"smooth": "smooth", "phase": "a cubic per phase", "step": "a cubic per step"}
"""A track's `segments` in words."""


class Inspector:
    """Draws the panel; a number that is dragged is an edit when it is let go."""

    def __init__(self) -> None:
        self.healing = Healing()

    def draw(self, desk: Desk, layout: Layout) -> None:
        """One frame."""
        box = layout.panel
        if box is None:
            return
        imgui.set_next_window_pos((box.x, box.y))
        imgui.set_next_window_size((box.width, box.height))
        imgui.begin("panel", None, FLAGS)
        imgui.push_item_width(-92 * layout.scale)
        self._characters(desk)
        if desk.selection:
            self._footprint(desk)
        if desk.path >= 0:
            self._path(desk)
        self._shapes(desk)
        self._heal(desk)
        imgui.pop_item_width()
        imgui.end()

    def number(self, desk: Desk, label: str, value: float, make: Any, speed: float = 0.005, shown: str = "%.2f") -> None:
        """A number to drag, or to type with a double click; make(value) is the edit."""
        changed, new = imgui.drag_float(label, value, speed, 0.0, 0.0, shown)
        if changed:
            desk.preview(make(round(float(new), 4)))
        if imgui.is_item_deactivated_after_edit():
            desk.drop()

    def _characters(self, desk: Desk) -> None:
        """The tracks, by who walks them."""
        for k, track in enumerate(desk.document.tracks):
            count = len(footprints_in(track))
            said = f"{track.character}, {count} footprints##track{k}"
            if imgui.selectable(said, k == desk.track)[0]:
                desk.track, desk.path = k, -1
        track = desk.document.tracks[desk.track]
        names = character_names()
        at = names.index(track.character) if track.character in names else -1
        changed, at = imgui.combo("who walks", at, names)
        if changed:
            desk.do(groups.SetTrack(desk.track, "character", names[at], "Change the character"))
        if imgui.small_button("add"):
            desk.do(groups.AddTrack(track.character))
            desk.track = len(desk.document.tracks) - 1
        imgui.same_line()
        if imgui.small_button("remove"):
            desk.do(groups.RemoveTrack(desk.track))
        self._style(desk)

    def _style(self, desk: Desk) -> None:
        """How the character carries itself, and how its curve is laid."""
        track = desk.document.tracks[desk.track]
        style = track.style
        if not imgui.collapsing_header("style"):
            return
        for name in Style.model_fields:
            words = name.replace("_deg", "")
            new = _slid(name, getattr(style, name))
            if new is not None:
                carried = style.model_copy(update={name: new})
                desk.preview(groups.SetTrack(desk.track, "style", carried, f"Style: {words}"))
            if imgui.is_item_deactivated_after_edit():
                desk.drop()
        changed, at = imgui.combo("curve", list(CURVES).index(track.segments), list(CURVES.values()))
        if changed:
            desk.do(groups.SetTrack(desk.track, "segments", list(CURVES)[at], "Lay the curve otherwise"))

    def _footprint(self, desk: Desk) -> None:
        """What is chosen, in numbers; of several, the first."""
        spots = desk.spots
        one, first = footprint_at(desk.document, spots[0]), spots[0]
        laid = desk.act(first.track).laid
        if first.number >= len(laid.row):
            return
        row = laid.row[first.number]
        imgui.separator_text(f"footprint {first.number}" if len(spots) == 1 else f"{len(spots)} footprints")
        imgui.text_colored((*theme.SIDES[one.side == "right"], 1.0), one.side)
        imgui.same_line()
        imgui.text_disabled(f"lands at {float(laid.footprints.contact_time[row]):.2f} s")
        x, y = one.position
        self.number(desk, "x, m", x, lambda v: edits.Move(spots, (v - x, 0.0)))
        self.number(desk, "y, m", y, lambda v: edits.Move(spots, (0.0, v - y)))
        self.number(desk, "heading", one.heading_deg, lambda v: edits.Turn(spots, v - one.heading_deg), 0.5, "%.1f deg")
        stance, step = (float(getattr(laid.footprints, key)[row]) for key in ("stance_time", "step_time"))
        given = (one.stance_time is not None, one.step_time is not None)
        for key, value, auto in (("stance_time", stance, not given[0]), ("step_time", step, not given[1])):
            words = key.replace("_time", "")
            shown = "%.3f s, auto" if auto else "%.3f s"
            self.number(
                desk, words, value, lambda v, key=key, w=words: edits.Set(spots, key, v, f"Change the {w} time"), 0.002, shown
            )
        pinned = one.at is not None
        if imgui.checkbox("pinned to its time", pinned)[0]:
            at = None if pinned else round(float(laid.footprints.contact_time[row]), 4)
            desk.do(edits.Set((first,), "at", at, "Let go of a time" if pinned else "Pin to a time"))
        if one.at is not None:
            self.number(desk, "at, s", one.at, lambda v: edits.Set((first,), "at", v, "Pin to a time"), 0.01)
        self.number(desk, "stand", one.stand, _setting(spots, "stand", "Stand a while"), 0.01, "%.2f s")
        self.number(desk, "crouch", one.crouch, _setting(spots, "crouch", "Crouch"), 0.002)
        self.number(desk, "facing", one.facing_deg, _setting(spots, "facing_deg", "Turn the body"), 0.5, "%.0f deg")
        if imgui.small_button("automatic"):
            desk.do(edits.AutoTime(spots))

    def _path(self, desk: Desk) -> None:
        """The path that is chosen."""
        track, k = desk.track, desk.path
        path: Path = desk.document.tracks[track].path[k]
        imgui.separator_text(f"path, {len(path.points)} points")
        step = path.step_length if isinstance(path.step_length, float) else path.step_length[0]
        width = path.step_width if path.step_width is not None else float(desk.act(track).character.biped.gait.step_width)

        def setting(key: str, words: str) -> Any:
            return lambda v: paths.SetPath(track, k, {key: v}, f"Change a path's {words}")

        self.number(desk, "step, m", step, setting("step_length", "steps"))
        self.number(desk, "width, m", width, setting("step_width", "width"))
        self.number(desk, "stagger, m", path.stagger, setting("stagger", "stagger"))
        self.number(desk, "crouch##path", path.crouch, setting("crouch", "crouch"), 0.002)
        self.number(desk, "feet", path.feet_deg, setting("feet_deg", "feet"), 0.5, "%.0f deg")
        gaits = {"automatic": (None, None), "walk": (0.55, 0.69), "run": (0.36, 0.25)}
        now = next((n for n, t in gaits.items() if t == (path.step_time, path.stance_time)), "automatic")
        changed, at = imgui.combo("gait", list(gaits).index(now), list(gaits))
        if changed:
            times = list(gaits.values())[at]
            desk.do(paths.SetPath(track, k, {"step_time": times[0], "stance_time": times[1]}, "Change a path's gait"))
        if imgui.small_button("free its footprints"):
            desk.do(paths.FreePath(track))

    def _shapes(self, desk: Desk) -> None:
        """Stretches, pulls and keys of the track."""
        track = desk.document.tracks[desk.track]
        if not (track.stretch or track.pull or track.key):
            return
        imgui.separator_text("shaped")
        for k, stretch in enumerate(track.stretch):
            self._stretch(desk, k, stretch)
        for k, pull in enumerate(track.pull):
            imgui.push_id(f"pull{k}")
            imgui.text_colored((*theme.COM_PULL, 1.0), f"pull at footprint {pull.footprint} {pull.after:+.2f} s")
            self._remove(desk, "pull", k)
            self.number(
                desk,
                "stiffness",
                pull.stiffness,
                lambda v, k=k, p=pull: _changed(desk, "pull", k, p, stiffness=max(v, 1.0)),
                5.0,
                "%.0f",
            )
            imgui.pop_id()
        for k, key in enumerate(track.key):
            self._key(desk, k, key)

    def _stretch(self, desk: Desk, k: int, stretch: Stretch) -> None:
        imgui.push_id(f"stretch{k}")
        imgui.text_colored((*theme.ACCENT, 1.0), f"steps {stretch.first} to {stretch.last}")
        self._remove(desk, "stretch", k)
        for name in ("gravity", "comfort", "leg", *Manners.model_fields):
            new = _slid(name, getattr(stretch, name))
            if new is not None:
                desk.preview(_changed(desk, "stretch", k, stretch, **{name: new}))
            if imgui.is_item_deactivated_after_edit():
                desk.drop()
        imgui.pop_id()

    def _key(self, desk: Desk, k: int, key: Key) -> None:
        """A bone turned by hand: its three angles, and how long it takes to come and go."""
        imgui.push_id(f"key{k}")
        names = [name for name in desk.show.skeleton(desk.track).names if name in KEYED]
        imgui.text_colored((*theme.KEY, 1.0), f"key at footprint {key.footprint} {key.after:+.2f} s")
        self._remove(desk, "key", k)
        changed, at = imgui.combo("bone", names.index(key.bone) if key.bone in names else 0, names)
        if changed:
            desk.do(_changed(desk, "key", k, key, bone=names[at]))
        angles = [float(a) for a in key.rotation_deg]
        changed, new = imgui.drag_float3("turn", angles, 0.5, -180.0, 180.0, "%.0f")
        if changed:
            desk.preview(_changed(desk, "key", k, key, rotation_deg=tuple(round(float(a), 2) for a in new)))
        if imgui.is_item_deactivated_after_edit():
            desk.drop()
        self.number(desk, "blend", key.blend, lambda v: _changed(desk, "key", k, key, blend=max(v, 0.02)), 0.005, "%.2f s")
        if imgui.small_button("go there"):
            laid = desk.act(desk.track).laid
            desk.playing.time = float(laid.footprints.contact_time[laid.row[key.footprint]]) + key.after
        imgui.pop_id()

    def _remove(self, desk: Desk, kind: shapes.Kind, k: int) -> None:
        imgui.same_line()
        if imgui.small_button("x"):
            desk.do(shapes.SetShape(desk.track, kind, k, None))

    def _heal(self, desk: Desk) -> None:
        """The worst places, and what would heal them."""
        places = self.healing.look(desk)
        if not places:
            return
        imgui.separator_text("where it borrows")
        for n, place in enumerate(places):
            imgui.push_id(f"place{n}")
            colour = (theme.PHYSICS, theme.COMFORT, theme.REACH)[place.kind]
            imgui.text_colored((*colour, 1.0), place.words)
            imgui.same_line()
            if imgui.small_button("show"):
                desk.playing.time, desk.playing.on = place.time, False
                desk.selection = {Spot(desk.track, place.number)}
            for k, cure in enumerate(place.cures):
                if imgui.button(f"{cure.words}: {cure.share:.0%} less##{k}", (-1, 0)):
                    desk.do(cure.edit)
            imgui.pop_id()


def _slid(name: str, value: float) -> float | None:
    """A slider; the value that it is drawn to, None where it is not."""
    low, high = LIMITS.get(name, (0.0, 3.0))
    changed, new = imgui.slider_float(name.replace("_deg", ""), value, low, high, "%.2f")
    return round(float(min(max(new, low), high)), 3) if changed else None


def _setting(spots: tuple[Spot, ...], key: str, words: str) -> Any:
    """The edit that sets a key of footprints, for its value."""
    return lambda value: edits.Set(spots, key, value, words)


def _changed(desk: Desk, kind: shapes.Kind, k: int, shape: Stretch | ComPull | Key, **keys: Any) -> edits.Edit:
    """An edit that changes keys of a stretch, a pull or a key; a value that is not allowed leaves it as it is."""
    values = {name: getattr(shape, name) for name in type(shape).model_fields} | keys
    try:
        return shapes.SetShape(desk.track, kind, k, type(shape)(**values))
    except ValueError:
        return shapes.SetShape(desk.track, kind, k, shape)
