"""What keys do in the studio: one table, which the help overlay and the menus show, too."""

from collections.abc import Callable
from dataclasses import dataclass

from planner.script.shaping import ComPull, Key, Stretch
from sim.files.studio import edits, groups, shapes
from sim.files.studio.document import Spot, footprint_at, footprints_in, spots_of
from sim.view.studio.desk import desk as desks
from sim.view.studio.desk import gaits
from sim.view.studio.desk.desk import Desk

NUDGE = 0.01
"""Arrow keys move what is chosen so far [m], ten times as far with shift."""
FRAME = 1 / 30


@dataclass(frozen=True)
class Action:
    """Something that a key does."""

    key: str  # as it is shown: "Ctrl+Z"
    words: str
    group: str
    does: Callable[[Desk], None]


def _chosen(make: Callable[[tuple[Spot, ...]], edits.Edit]) -> Callable[[Desk], None]:
    """Does an edit to what is chosen; says so where nothing is."""

    def act(desk: Desk) -> None:
        if desk.selection:
            desk.do(make(desk.spots))
        else:
            desk.say("Choose footprints first: click one, or draw a box around several")

    return act


def _tool(name: str) -> Callable[[Desk], None]:
    def act(desk: Desk) -> None:
        desk.tool, desk.drawn = (desks.SELECT if desk.tool == name else name), []

    return act


def _delete(desk: Desk) -> None:
    if desk.selection:
        gone, desk.selection = desk.spots, set()
        desk.do(edits.Delete(gone))
    elif desk.path >= 0:
        from sim.files.studio.paths import RemovePath

        desk.do(RemovePath(desk.track, desk.path))


def _last(desk: Desk) -> int:
    """After which footprint something is put: the last one chosen, or the last one of all."""
    mine = [s.number for s in desk.spots if s.track == desk.track]
    return mine[-1] if mine else len(footprints_in(desk.document.tracks[desk.track])) - 1


def _paste(desk: Desk, prints: tuple, after: int) -> None:
    """Puts footprints behind a number, as far on as its way goes, and chooses them."""
    order = footprints_in(desk.document.tracks[desk.track])
    by = (0.0, 0.0)
    if prints and 0 <= after < len(order):
        first, before = prints[0].position, order[after].footprint
        two = order[max(after - 1, 0)].footprint
        stride = (before.position[0] - two.position[0], before.position[1] - two.position[1])
        middle = tuple(0.5 * (a + b) for a, b in zip(before.position, two.position, strict=True))
        by = (middle[0] + 1.5 * stride[0] - first[0], middle[1] + stride[1] - first[1])
    if desk.do(groups.Paste(desk.track, after, prints, by)):
        desk.selection = {Spot(desk.track, after + 1 + k) for k in range(len(prints))}


def _copy(desk: Desk) -> None:
    desk.clipboard = groups.copied(desk.document, desk.spots)
    desk.say(f"Copied {len(desk.clipboard)}")


def _all(desk: Desk) -> None:
    everything = {s for s in spots_of(desk.document) if s.track == desk.track}
    desk.selection = set() if desk.selection == everything else everything


def _pin(desk: Desk) -> None:
    """Pins what is chosen to the time that it has, or lets it go."""
    for spot in desk.spots:
        pinned = footprint_at(desk.document, spot).at is not None
        laid = desk.act(spot.track).laid
        time = round(float(laid.footprints.contact_time[laid.row[spot.number]]), 4)
        desk.do(edits.Set((spot,), "at", None if pinned else time, "Let go of a time" if pinned else f"Pin to {time:.2f} s"))


def _step_time(frames: int) -> Callable[[Desk], None]:
    def act(desk: Desk) -> None:
        desk.playing.on = False
        desk.playing.time = min(max(desk.playing.time + frames * FRAME, 0.0), desk.show.end)

    return act


def _loop(desk: Desk) -> None:
    """Loops over what is chosen, or over nothing."""
    laid = desk.act(desk.track).laid
    rows = [int(laid.row[s.number]) for s in desk.spots if s.track == desk.track]
    if desk.playing.loop or not rows:
        desk.playing.loop = None
        return
    contact, stance = laid.footprints.contact_time, laid.footprints.stance_time
    desk.playing.loop = (float(contact[min(rows)]), float(min(contact[max(rows)] + stance[max(rows)], desk.show.end)))


def _slower(desk: Desk) -> None:
    speeds = desks.SPEEDS
    desk.playing.speed = speeds[(speeds.index(desk.playing.speed) - 1) % len(speeds)]


def _nudge(dx: float, dy: float) -> Callable[[Desk], None]:
    return _chosen(lambda spots: edits.Move(spots, (dx, dy)))


def _toggle(name: str) -> Callable[[Desk], None]:
    def act(desk: Desk) -> None:
        setattr(desk.shown, name, not getattr(desk.shown, name))

    return act


def _views(desk: Desk) -> None:
    """Both views, the plan alone, space alone."""
    order = [(True, True), (True, False), (False, True)]
    now = order.index((desk.shown.plan, desk.shown.space))
    desk.shown.plan, desk.shown.space = order[(now + 1) % 3]


def _cancel(desk: Desk) -> None:
    desk.cancel()
    if desk.shown.help or desk.shown.history:
        desk.shown.help = desk.shown.history = False
    elif desk.tool != desks.SELECT:
        desk.tool, desk.drawn = desks.SELECT, []
    else:
        desk.selection, desk.path = set(), -1


def _exaggerate(desk: Desk) -> None:
    mine = [s.number for s in desk.spots if s.track == desk.track]
    if mine:
        desk.do(shapes.AddShape(desk.track, Stretch(first=min(mine), last=max(mine), gravity=0.6)))
    else:
        desk.say("Choose the steps that shall exaggerate first")


def moment_of(desk: Desk) -> tuple[int, float]:
    """The footprint before the time that is shown, and the time since its contact."""
    laid, now = desk.act(desk.track).laid, desk.playing.time
    contact = laid.footprints.contact_time[laid.row]
    number = max(int((contact <= now).sum()) - 1, 0)
    return number, round(now - float(contact[number]), 4)


def _pull(desk: Desk) -> None:
    number, after = moment_of(desk)
    x, y, z = (round(float(v), 4) for v in desk.show.com(desk.playing.time)[desk.track])
    desk.do(shapes.AddShape(desk.track, ComPull(footprint=number, after=after, position=(x, y, z))))


def _key(desk: Desk) -> None:
    number, after = moment_of(desk)
    names = desk.show.skeleton(desk.track).names
    bone = next((name for name in ("upper_arm_right", "wing_right", "head") if name in names), names[-1])
    desk.do(shapes.AddShape(desk.track, Key(bone=bone, footprint=number, after=after, rotation_deg=(0.0, 0.0, 0.0))))


def _insert(desk: Desk) -> None:
    """A footprint between the one chosen and the next."""
    order, after = footprints_in(desk.document.tracks[desk.track]), _last(desk)
    if not order:
        return
    a, b = order[after].footprint, order[min(after + 1, len(order) - 1)].footprint
    place = tuple(0.5 * (u + v) for u, v in zip(a.position, b.position, strict=True))
    if desk.do(edits.Place(desk.track, after, (place[0], place[1]), a.heading_deg)):
        desk.selection = {Spot(desk.track, after + 1)}


def _splice(desk: Desk) -> None:
    if len(desk.document.tracks) > 1:
        desk.do(groups.Splice(desk.track, (desk.track + 1) % len(desk.document.tracks)))


ACTIONS = (
    Action("N", "place footprints", "footprints", _tool(desks.PLACE)),
    Action("P", "draw a path", "footprints", _tool(desks.DRAW)),
    Action("I", "insert after", "footprints", _insert),
    Action("F", "flip the side", "footprints", _chosen(edits.Flip)),
    Action("Del", "delete", "footprints", _delete),
    Action("D", "duplicate", "footprints", lambda desk: _paste(desk, groups.copied(desk.document, desk.spots), _last(desk))),
    Action("M", "mirror", "footprints", _chosen(edits.Mirror)),
    Action("R", "reverse", "footprints", _chosen(groups.Reverse)),
    Action("K", "snap to rocks and stairs", "footprints", gaits.snap),
    Action("J", "splice with the next track", "footprints", _splice),
    Action("[", "shorter stride", "footprints", _chosen(lambda spots: edits.ScaleStride(spots, 1 / 1.05))),
    Action("]", "longer stride", "footprints", _chosen(lambda spots: edits.ScaleStride(spots, 1.05))),
    Action("T", "pin to its time, or let go", "time", _pin),
    Action("A", "automatic timing", "time", _chosen(edits.AutoTime)),
    Action("-", "quicker", "time", lambda desk: gaits.scale_time(desk, 1 / 1.05)),
    Action("=", "slower", "time", lambda desk: gaits.scale_time(desk, 1.05)),
    Action("W", "make it a walk", "time", lambda desk: gaits.make(desk, gaits.WALK)),
    Action("G", "make it a run", "time", lambda desk: gaits.make(desk, gaits.RUN)),
    Action("E", "exaggerate these steps", "shape", _exaggerate),
    Action("U", "pull the centre of mass", "shape", _pull),
    Action("B", "key a bone here", "shape", _key),
    Action("Space", "play, stop", "play", lambda desk: setattr(desk.playing, "on", not desk.playing.on)),
    Action(",", "a frame back", "play", _step_time(-1)),
    Action(".", "a frame on", "play", _step_time(1)),
    Action("Home", "to the beginning", "play", lambda desk: setattr(desk.playing, "time", 0.0)),
    Action("End", "to the end", "play", lambda desk: setattr(desk.playing, "time", desk.show.end)),
    Action("L", "loop what is chosen", "play", _loop),
    Action("S", "slow motion", "play", _slower),
    Action("V", "plan, space, both", "view", _views),
    Action("O", "ghosts", "view", _toggle("ghosts")),
    Action("X", "forces", "view", _toggle("forces")),
    Action("C", "the curve", "view", _toggle("curve")),
    Action("Y", "daggers", "view", _toggle("daggers")),
    Action("Z", "camera follows", "view", _toggle("follow")),
    Action("Q", "where it borrows", "view", _toggle("strips")),
    Action("Tab", "side panel", "view", _toggle("inspector")),
    Action("H", "this help", "view", _toggle("help")),
    Action("Esc", "back, choose nothing", "view", _cancel),
    Action("Ctrl+Z", "undo", "document", Desk.undo),
    Action("Ctrl+Y", "do again", "document", Desk.redo),
    Action("Ctrl+C", "copy", "document", _copy),
    Action("Ctrl+V", "paste", "document", lambda desk: _paste(desk, desk.clipboard, _last(desk))),
    Action("Ctrl+A", "choose all", "document", _all),
    Action("Ctrl+N", "new scene", "document", lambda desk: setattr(desk, "asked", "new")),
    Action("Ctrl+O", "open ...", "document", lambda desk: setattr(desk, "asked", "open")),
    Action("Ctrl+S", "save", "document", lambda desk: setattr(desk, "asked", "save")),
    Action("Ctrl+Shift+S", "save as ...", "document", lambda desk: setattr(desk, "asked", "save as")),
    Action("Ctrl+Q", "quit", "document", lambda desk: setattr(desk, "asked", "quit")),
    Action("Left", "nudge", "", _nudge(-NUDGE, 0)),
    Action("Right", "nudge", "", _nudge(NUDGE, 0)),
    Action("Up", "nudge", "", _nudge(0, NUDGE)),
    Action("Down", "nudge", "", _nudge(0, -NUDGE)),
    Action("Shift+Left", "nudge", "", _nudge(-10 * NUDGE, 0)),
    Action("Shift+Right", "nudge", "", _nudge(10 * NUDGE, 0)),
    Action("Shift+Up", "nudge", "", _nudge(0, 10 * NUDGE)),
    Action("Shift+Down", "nudge", "", _nudge(0, -10 * NUDGE)),
    Action("Ctrl+Shift+Z", "do again", "", Desk.redo),
    Action("F1", "help", "", _toggle("help")),
)
"""All of them; those without a group are not shown."""
BY_KEY = {action.key.lower(): action for action in ACTIONS}
NAMES = {"escape": "esc", "delete": "del", "backspace": "del", "return": "enter", "?": "h", "+": "="}
"""Other names by which keyboards call these keys."""


def pressed(desk: Desk, key: str, ctrl: bool, shift: bool) -> bool:
    """A key was pressed; whether it does something."""
    key = NAMES.get(key, key)
    name = ("ctrl+" if ctrl else "") + ("shift+" if shift and (ctrl or len(key) > 1) else "") + key
    action = BY_KEY.get(name) or (BY_KEY.get(key) if shift and not ctrl else None)
    if action:
        action.does(desk)
    return action is not None
