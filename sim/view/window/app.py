"""What the window shows, and what keys and mouse do to it: no GL, no pygame."""

import time as clock
from collections.abc import Callable
from typing import Any

import numpy as np

from motion.characters.character import character_names
from planner.planner import NoWay
from sim.files.studio.runs.walked import document_of_cast
from sim.stage.cast import Cast
from sim.view.graphics.camera import Camera
from sim.view.pictures import overlays
from sim.view.window import beside, driving, picking, tools
from sim.view.window.choosing import is_scene
from worlds.errors import InputError

FRAME = 1 / 60
"""No more pictures than one in this time [s]."""
MOST_TICKS, TICKING = 6, 0.05
"""Ticks that a frame makes up for after a stall, and seconds that it gives them; the rest of the backlog is dropped, so that
a crowd too large for real time slows down instead of stopping the pictures."""
NOTICE = 6.0
"""Seconds that a notice is shown."""
MOST_KEPT = 100_000
"""Footprints of all characters together that are kept for the studio: 20 MB."""
HELP = (
    "space  pause        .  single tick       [ ]  slower, faster",
    "c  character        o  overlays          f  follow      v  plan view",
    "r  restart          n  next level        m  record, stop            esc  quit",
    "tab  panel          h  help              = -  larger, smaller letters",
    "enter  edit what was walked, in the studio, which opens beside this window",
    "a  everyone         left, right, or a click on it: the character to follow",
    "drag: orbit   wheel: zoom   G+click: goal   T+click: tree   K+click: rock   X+click: remove",
)


def tick_for(sim: Cast, ticks: int, seconds: float = TICKING) -> int:
    """Lets the simulation tick, at most MOST_TICKS and not much longer than `seconds` of wall time; returns how often."""
    begin, done = clock.perf_counter(), 0
    while done < min(ticks, MOST_TICKS) and (done == 0 or clock.perf_counter() - begin < seconds):
        sim.tick()
        done += 1
    return done


class App:
    """What the window shows and what keys and mouse do to it. Owns no GL: `screen` draws it."""

    def __init__(self, make: Callable[..., Cast], sim: Cast, options: Any, levels: list[str]) -> None:
        self.make, self.sim, self.levels = make, sim, levels
        self.level, self.character, self.seed = options.level, options.character, options.seed
        self.camera = Camera()
        self.until: float | None = getattr(options, "seconds", None)
        self.paused, self.speed, self.running = False, 1.0, True
        self.show_overlays, self.show_panel, self.show_help = True, True, False
        self.focus, self.behind = 0, 0.0
        self.message, self.said_at, self.recording = "", 0.0, ""
        self.shown, self.scale = set(overlays.NAMES), float(getattr(options, "scale", 1.0))
        self.in_view, self.ticking = 0, TICKING
        self.pressed: tuple[int, int] | None = None
        self.driver, self.sticks = driving.Driver(), driving.AT_REST
        self._tool: str | None = None
        self._take(sim)

    def _take(self, sim: Cast) -> None:
        """Another run is shown; its footprints are kept, for whoever wants to edit them."""
        self.sim = sim
        sim.keep_footprints(MOST_KEPT)
        self._reset_view()

    def _reset_view(self) -> None:
        """Looks at the first character; where there are others, from so far that a crowd is seen."""
        self.focus, self.behind = 0, 0.0
        if (site := self.sim.site) is not None:
            self.camera.frame(site.middle, site.radius, 6.5 * self._unit())
        else:
            self.camera.meet(self.sim.com(), 0, 6.5 * self._unit())
        self.camera.follow = site is None

    @property
    def driven(self) -> bool:
        """Whether keys drive the one who is followed."""
        return driving.is_driven(self.sim)

    @property
    def help(self) -> tuple[str, ...]:
        """What keys and mouse do."""
        return driving.HELP if self.driven else HELP

    def _unit(self) -> float:
        """Leg length of the character that is followed [m]."""
        return self.sim.leg(self.focus)

    def advance(self, seconds: float) -> None:
        """Lets wall time pass: whole ticks, at most MOST_TICKS."""
        if self.paused:
            return
        self.driver.drive(self.sim, self.focus, self.camera.azimuth, self.sticks)
        self.behind += seconds * self.speed * self.sim.tick_rate
        self.behind -= tick_for(self.sim, min(int(self.behind), self.ticks_left()), self.ticking)
        self.behind = min(self.behind, 1.0)

    def ticks_left(self) -> int:
        """Ticks until --seconds are over; without them, no end is near."""
        return MOST_TICKS if self.until is None else max(int(round(self.until * self.sim.tick_rate)) - self.sim.ticks, 0)

    def say(self, text: str) -> None:
        """Shows a sentence for a while."""
        self.message, self.said_at = text, clock.monotonic()

    @property
    def notice(self) -> str:
        """What was said lately."""
        return self.message if clock.monotonic() - self.said_at < NOTICE else ""

    def rebuild(self) -> None:
        """Starts over with the present level and character; says so where that cannot be, and keeps what runs."""
        self.choose()

    def choose(self, **other: Any) -> None:
        """Starts over with another `level`, `character` or `seed`; says so where that cannot be, and keeps what runs."""
        wanted = {"level": self.level, "character": self.character, "seed": self.seed} | other
        if "level" in other and is_scene(str(other["level"])):
            wanted["character"] = None  # its own
        try:
            sim = self.make(**wanted)
        except (InputError, NoWay) as error:
            self.say(str(error))
            return
        self.level, self.character, self.seed = wanted["level"], wanted["character"], wanted["seed"]
        self._take(sim)
        self.say(sim.world.name)

    def record(self) -> None:
        """Begins a recording, or ends it."""
        now = clock.strftime("%Y-%m-%d_%H-%M-%S")
        self.recording = "" if self.recording else f"footfall_{now}.npz"
        if self.recording:
            self.say(f"recording {self.recording}")

    def toggle_overlay(self, name: str) -> None:
        """Shows an overlay, or hides it."""
        self.shown ^= {name}

    def key(self, name: str) -> None:
        """A key was pressed: first those that drive, where somebody is driven."""
        if self.driven and self.driver.press(self.sim, self.focus, name):
            return
        pause = "p" if self.driven else "space"
        actions = {
            pause: self.toggle, ".": self._single, "[": self._slower, "]": self._faster, "c": self._next_character,
            "o": self._overlays, "f": self._follow, "v": self._plan, "r": self.rebuild, "n": self._next_level,
            "tab": self._panel, "h": self._help, "escape": self._quit, "a": self.everyone, "left": self._previous,
            "right": self._next, "return": self.edit_scene, "m": self.record, "=": self._larger,
            "-": self._smaller,
        }  # fmt: skip
        if name in actions:
            actions[name]()
        elif name in "gtkx":
            self._tool = name

    def key_up(self, name: str) -> None:
        """A key was let go."""
        self.driver.release(name)
        if name == self._tool:
            self._tool = None

    def edit_scene(self) -> None:
        """Opens the studio beside this window, on what has been walked so far; says so where that cannot be."""
        try:
            kinds = [str(self.character)] if self.character else []
            beside.open_studio(document_of_cast(self.sim, self.focus, self.level, kinds))
            self.paused = True
            self.say("the studio opens beside this window, with what was walked")
        except (InputError, OSError) as error:
            self.say(str(error))

    def toggle(self) -> None:
        """Pauses, or goes on."""
        self.paused = not self.paused

    def _single(self) -> None:
        self.paused = True
        self.sim.tick()

    def _larger(self) -> None:
        self.scale = min(self.scale * 1.15, 4.0)

    def _smaller(self) -> None:
        self.scale = max(self.scale / 1.15, 0.6)

    def _slower(self) -> None:
        self.speed = max(self.speed / 2, 1 / 16)

    def _faster(self) -> None:
        self.speed = min(self.speed * 2, 4.0)

    def _next_character(self) -> None:
        names = character_names()
        at = names.index(self.character) if self.character in names else -1
        self.choose(character=names[(at + 1) % len(names)])

    def _next_level(self) -> None:
        place = self.levels.index(self.level) if self.level in self.levels else -1
        self.choose(level=self.levels[(place + 1) % len(self.levels)])

    def _overlays(self) -> None:
        self.show_overlays = not self.show_overlays

    def _follow(self) -> None:
        self.camera.follow = not self.camera.follow

    def _plan(self) -> None:
        self.camera.plan = not self.camera.plan

    def everyone(self) -> None:
        """An overview: all characters in view, nobody followed."""
        com = self.sim.com()
        com = com[there] if (there := self.sim.present()).any() else com
        middle = 0.5 * (com.min(axis=0) + com.max(axis=0))
        self.camera.frame(middle, float(np.linalg.norm(com - middle, axis=1).max()), 6.5 * self._unit())
        self.camera.follow = False

    def _previous(self) -> None:
        self.follow((self.focus - 1) % len(self.sim.characters))

    def _next(self) -> None:
        self.follow((self.focus + 1) % len(self.sim.characters))

    def follow(self, character: int) -> None:
        """Follows another character; comes near where it would be too small to see."""
        self.focus, self.camera.follow = character, True
        self.camera.distance = min(self.camera.distance, 14.0 * self._unit())

    def _panel(self) -> None:
        self.show_panel = not self.show_panel

    def _help(self) -> None:
        self.show_help = not self.show_help

    def _quit(self) -> None:
        self.running = False

    def drag(self, dx: float, dy: float) -> None:
        """The mouse moved with a button down."""
        self.camera.orbit(dx, dy)

    def click(self, x: float, y: float, aspect: float) -> None:
        """A click at x, y in -1..1 (y up): what it does depends on the key that is held; without one it follows."""
        ray = self.camera.ray(x, y, aspect)
        if self._tool:
            place = picking.ground_point(self.sim.world, *ray)
            if place is not None:
                self.edit(self._tool, *place)
        else:
            found = picking.character_at(self.sim.com(), 0.7 * self._unit(), *ray)
            if found is not None:
                self.follow(found)

    def edit(self, tool: str, x: float, y: float) -> None:
        """g: goal, t: plant a tree, k: put a rock, x: remove the nearest tree or rock. Says what was refused, and why."""
        self.say(tools.used(self.sim, tool, x, y))
