"""Who is there in the frames of a recording, and who that is: people may come and go."""

from typing import Any

import numpy as np

from sim.stage.cast import Cast


class Guests:
    """Notes who comes into the rows of a cast, as its frames are captured."""

    def __init__(self, sim: Cast) -> None:
        self.sim = sim
        self.come_and_go = not sim.present().all()
        """Whether anybody has ever been away."""
        self._seen = np.full(len(sim.characters), -1)
        self._kinds: dict[tuple, int] = {}
        self._plain: list[dict] = []
        self._visitors: list[dict] = []

    def see(self, time: float) -> np.ndarray:
        """(C,) bool: who is there at a time of the last step [s]."""
        there, recasts = self.sim.present(time), self.sim.footprints.recasts
        self.come_and_go |= not there.all()
        for c in np.flatnonzero(there & (recasts != self._seen)).tolist():
            self._seen[c] = recasts[c]
            self._visitors.append(
                {"character": c, "recasts": int(recasts[c]), "begin": float(time) - 1e-6, "kind": self._kind(c)}
            )
        return there

    def _kind(self, c: int) -> int:
        character = self.sim.characters[c]
        key = (character.name, character.biped.tobytes(), character.look)  # type: ignore[attr-defined]
        if key not in self._kinds:
            self._kinds[key] = len(self._plain)
            self._plain.append({"dimensions": character.to_dict(), "look": character.look.model_dump(mode="json")})
        return self._kinds[key]

    def meta(self) -> dict[str, Any]:
        """What a recording's meta tells of them; nothing where everyone was there all the time."""
        return {"visitors": self._visitors, "kinds": self._plain} if self.come_and_go else {}
