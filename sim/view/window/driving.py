"""Driving the character that is followed: keys that are held and a gamepad, as directions over the ground and paces.

Forward is away from the camera. No pygame but in `Pad`, which reads a gamepad where there is one.
"""

from math import atan2, hypot, pi
from types import ModuleType
from typing import Any, NamedTuple

from motion.track.footprints import walker_headings
from sim.stage.cast import Cast
from sim.stage.commands import steer
from sim.stage.simulation import Simulation

AHEAD, ASIDE = {"w": 1, "up": 1, "s": -1, "down": -1}, {"a": 1, "left": 1, "d": -1, "right": -1}
SIDESTEPS = {"q": 0.5 * pi, "e": -0.5 * pi}
PACES = {"left shift": "run", "right shift": "run", "left ctrl": "creep", "right ctrl": "creep"}
KEYS = {*AHEAD, *ASIDE, *SIDESTEPS, *PACES, "space"}
"""What drives; all other keys do what they do elsewhere."""
HELP = (
    "W A S D or arrows  walk, as the camera looks      Q E  sidestep",
    "shift  run         ctrl  creep                    space  leap",
    "gamepad: left stick walks, and runs fully pushed   right stick turns on the spot   A leaps",
    "p  pause           .  single tick       [ ]  slower, faster      esc  quit",
    "c  character       o  overlays          f  follow                v  plan view",
    "r  restart         n  next level        tab  panel               h  help",
    "m  record, stop   = -  larger, smaller letters",
    "enter  edit what was walked, in the studio, which opens beside this window",
    "drag: orbit   wheel: zoom   click: follow   T+click: tree   K+click: rock   X+click: remove",
)
DEAD, FULL, CREEPS = 0.25, 0.92, 0.5
"""A stick pushed less than that is at rest; further than that one runs, and less than that one creeps."""


class Sticks(NamedTuple):
    """A gamepad of the moment: how far its sticks are pushed, -1..1, right and away from the player; whether it leaps."""

    x: float = 0.0
    y: float = 0.0
    turn_x: float = 0.0
    turn_y: float = 0.0
    leap: bool = False


AT_REST = Sticks()


class Wish(NamedTuple):
    """What the player wants: as sim.stage.commands.Steer has it."""

    direction: float  # over the ground [rad]
    pace: str
    aside: float = 0.0  # [rad]


def is_driven(sim: Cast) -> bool:
    """Whether its characters go where they are told."""
    return isinstance(sim, Simulation) and hasattr(sim.planner, "tell")


class Driver:
    """Keys that are held, and what they mean for the one who is followed."""

    def __init__(self) -> None:
        self.held: set[str] = set()
        self._leap, self._held_leap, self._facing, self._last = False, False, 0.0, 0

    def press(self, sim: Cast, focus: int, name: str) -> bool:
        """A key was pressed; whether it is one that drives."""
        if name not in KEYS:
            return False
        self._leap |= name == "space" and name not in self.held
        if name in SIDESTEPS and not self.held & set(SIDESTEPS):
            self._facing = float(walker_headings(sim.feet())[focus, 1])
        self.held.add(name)
        return True

    def release(self, name: str) -> None:
        """A key was let go."""
        self.held.discard(name)

    def drive(self, sim: Cast, focus: int, azimuth: float, sticks: Sticks = AT_REST) -> None:
        """Tells the one who is followed what the player wants; who was followed before stands. azimuth: the camera's [rad]."""
        if not isinstance(sim, Simulation) or not is_driven(sim):
            return
        if self._last != focus and self._last < len(sim.characters):
            steer(sim, 0.0, "stand", characters=self._last)
        wish = self._wish(azimuth, sticks)
        if wish.pace == "stand":  # a direction that nobody goes in is no news
            wish = Wish(float(sim.plans.direction[focus]), "stand", float(sim.plans.aside[focus]))
        steer(sim, *wish, leap=self._leap or (sticks.leap and not self._held_leap), characters=focus)
        self._held_leap, self._leap, self._last = sticks.leap, False, focus

    def _wish(self, azimuth: float, sticks: Sticks) -> Wish:
        """What keys and sticks say; keys go before sticks."""
        ahead, aside = self._sum(AHEAD), self._sum(ASIDE)
        pace = next((PACES[name] for name in sorted(self.held, reverse=True) if name in PACES), "walk")
        if ahead or aside:
            return Wish(azimuth + pi + atan2(aside, ahead), pace)
        side = sum(SIDESTEPS[name] for name in self.held & set(SIDESTEPS))
        if side:
            return Wish(self._facing + side, pace, side)
        return _pushed(azimuth, sticks)

    def _sum(self, keys: dict[str, int]) -> int:
        """Which of two opposite ways is held: 1, -1, or 0 for neither or both."""
        return max(min(sum(keys[name] for name in self.held & set(keys)), 1), -1)


def _pushed(azimuth: float, sticks: Sticks) -> Wish:
    """What the sticks say: the left one goes, the right one turns."""
    far = hypot(sticks.x, sticks.y)
    if far > DEAD:
        pace = "run" if far > FULL else "creep" if far < CREEPS else "walk"
        return Wish(azimuth + pi + atan2(-sticks.x, sticks.y), pace)
    if hypot(sticks.turn_x, sticks.turn_y) > 2 * DEAD:
        return Wish(azimuth + pi + atan2(-sticks.turn_x, sticks.turn_y), "turn")
    return Wish(0.0, "stand")


class Pad:
    """The first gamepad, if there is one; it may be plugged in at any time."""

    def __init__(self, pygame: ModuleType) -> None:
        self.pygame = pygame
        self.stick: Any = None
        pygame.joystick.init()

    def read(self) -> Sticks:
        """Its sticks now."""
        joystick: Any = self.pygame.joystick
        if not joystick.get_count():
            self.stick = None
            return AT_REST
        self.stick = self.stick or joystick.Joystick(0)
        axes = [self.stick.get_axis(k) for k in range(min(self.stick.get_numaxes(), 5))] + [0.0] * 5
        leaps = bool(self.stick.get_numbuttons() and self.stick.get_button(0))
        return Sticks(axes[0], -axes[1], axes[3], -axes[4], leaps)
