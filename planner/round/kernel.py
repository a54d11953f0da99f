"""How a planner's `next_step` is called: compiled by itself and by its address, or in plain Python.

Both are written the same way, `next_step(round, me) -> Wish`. A compiled one may be asked by many threads at once, each for
another character. A Python one is asked through a callback, which takes some 10 microseconds a step: for trying things out.
"""

import ctypes
from collections.abc import Callable
from types import FunctionType
from typing import Any

import numpy as np
from numba.core.errors import NumbaError

from motion.characters.dimensions import empty_bipeds
from motion.track.footprints import Feet, Foot, Step
from planner.round.reservations import Intents, empty_reservations
from planner.round.round import Me, Round, Wish
from planner.round.weights import PEOPLE, table_of_weights
from worlds.arrays import no_world
from worlds.compiled.jit import jit_borrowing, kernel_of
from worlds.compiled.memory import Held, read, write
from worlds.compiled.parts import Handle, Part, handle
from worlds.compiled.tables import empty

_KINDS = np.zeros(1, np.int64)
_FOOT = Foot(0, 0.0, 0.0, 0.0, 0.0, 0.0)
A_ROUND = Round(
    _KINDS,
    empty_bipeds(1),
    no_world(),
    0,
    empty_reservations(empty_bipeds(1), _KINDS, (1.0, 1.0)),
    empty(Intents, 1),
    0,
    table_of_weights(PEOPLE, 1),
)
"""For its types; `plans` is an address, which only the planner can open."""
_, open_round, _, ROUND = handle(A_ROUND)
lend_me, open_me, _, _ = handle(Me(0, 0, True, 0, Feet(_FOOT, _FOOT)))
lend_wish, open_wish, put_wish, _ = handle(Wish(Step(0, 0.0, 0.0, 0.0), 0.0))
STAND = 0.5
"""Who cannot be told what to do stands for so long [s]."""


class Planning:
    """A planner's next_step, as rounds call it."""

    def held(self, plans: Any) -> Held | None:
        """What the planner has prepared, where next_step finds it; None where that is nothing to kernels."""

    def address(self, round: Round) -> int:
        """Where next_step lies, for steps of rounds like this one, its plans included."""
        raise NotImplementedError

    def check(self) -> None:
        """After a tick: raises what went wrong in it."""


class Compiled(Planning):
    """A kernel. `plans`: a sample of what its planner prepares, for its type; without one it is asked for nothing."""

    def __init__(self, next_step: Callable[[Round, Me], Wish], plans: Any = None) -> None:
        self.kernel = kernel_of(next_step)
        self.sample = plans
        """Of what its planner prepares, for its types."""
        self.plans: Handle | None = None if plans is None else handle(plans)
        template = _ask if plans is None else _ask_with_plans
        opened = self.plans.opened if self.plans else None
        names = globals() | {"next_step": self.kernel, "open_plans": opened, "in_numbers": _in_numbers}
        # The compiler keeps what it makes under the file and name of the function: those of the planner's own kernel.
        code = template.__code__.replace(
            co_filename=next_step.__code__.co_filename, co_firstlineno=next_step.__code__.co_firstlineno
        )
        asked = FunctionType(code, names, f"{next_step.__name__}_by_address")
        asked.__module__, asked.__qualname__ = next_step.__module__, f"{next_step.__qualname__}_by_address"
        self.part = Part(asked, 3)

    def __call__(self, round: Round, me: Me) -> Wish:
        """Asks it directly."""
        return self.kernel(round, me)

    def held(self, plans: Any) -> Held | None:
        """The plans by their address."""
        return None if self.plans is None else Held(plans, self.plans.kind)

    def address(self, round: Round) -> int:
        """Where the part lies. Raises TypeError where next_step cannot be compiled."""
        try:
            return self.part.address
        except (NumbaError, TypeError) as error:
            raise TypeError(
                f"{self.kernel.__module__}.{self.kernel.__qualname__} cannot be compiled. It must return a "
                "planner.round.round.Wish (standing and stepping make one; Wish and Step need all their fields here), and call "
                "nothing but kernels and mathematics. Without `compiled` it may do anything. The compiler's reason lies above"
            ) from error


@jit_borrowing
def _in_numbers(wish: Any) -> Wish:
    """A wish whose numbers may be whole ones, in the numbers that a Wish has."""
    step = wish.step
    in_numbers = Step(
        int(step.side), float(step.x), float(step.y), float(step.heading), float(step.time), float(step.stance_time),
        float(step.stands), float(step.crouch), float(step.facing),
    )  # fmt: skip
    return Wish(in_numbers, float(wish.course), float(wish.longest), bool(wish.avoids), bool(wish.goes))


def _ask(round_at: int, me_at: int, wish_at: int) -> None:
    put_wish(wish_at, in_numbers(next_step(open_round(round_at), open_me(me_at))))  # type: ignore[name-defined]  # noqa: F821


def _ask_with_plans(round_at: int, me_at: int, wish_at: int) -> None:
    bare = open_round(round_at)
    round = Round(
        bare.kind, bare.bipeds, bare.world, open_plans(bare.plans), bare.reservations, bare.intents, bare.seed, bare.weights  # type: ignore[name-defined]  # noqa: F821
    )  # fmt: skip
    put_wish(wish_at, in_numbers(next_step(round, open_me(me_at))))  # type: ignore[name-defined]  # noqa: F821


class Interpreted(Planning):
    """A function in plain Python. What it raises is raised by the tick; the character stands meanwhile."""

    def __init__(self, next_step: Callable[[Round, Me], Wish]) -> None:
        self.next_step = next_step
        self._round: Round | None = None
        self._raised: Exception | None = None
        self._callback = ctypes.CFUNCTYPE(None, ctypes.c_int64, ctypes.c_int64, ctypes.c_int64)(self._ask)

    def __call__(self, round: Round, me: Me) -> Wish:
        """Asks it directly."""
        return self.next_step(round, me)

    def address(self, round: Round) -> int:
        """Where its callback lies."""
        self._round = round
        return ctypes.cast(self._callback, ctypes.c_void_p).value or 0

    def check(self) -> None:
        """Raises what the function has raised in a tick."""
        raised, self._raised = self._raised, None
        if raised is not None:
            raise raised

    def _ask(self, _: int, me_at: int, wish_at: int) -> None:
        me = read(Me, me_at)
        try:
            write(Wish, self.next_step(self._round, me), wish_at)  # type: ignore[arg-type]
        except Exception as error:  # kept for the tick: nothing may be raised into compiled code
            self._raised = self._raised or error
            foot = me.feet.older
            write(Wish, Wish(Step(foot.side, foot.x, foot.y, foot.heading, stands=STAND), foot.heading), wish_at)
