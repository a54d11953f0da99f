"""What some characters of one kind wear: their looks, and the colours of each."""

from typing import NamedTuple

import numpy as np

from motion.characters.character import Character, Look

BRIGHTNESS, HUE = 0.16, {"human": 0.5}
"""By how much characters of one kind differ in brightness, and in the hue of their first two colours [turns]: people dress."""
LITTLE = 0.025
"""Difference in hue of all others [turns]."""


class Dress(NamedTuple):
    """C characters of one kind; colours red, green, blue in 0..1, (C, 3)."""

    look: Look
    unit: float  # nominal leg [m]
    skin: np.ndarray
    main: np.ndarray
    second: np.ndarray
    detail: np.ndarray


COLOURS = ("main", "second", "skin", "detail")


def colours_of(characters: list[Character], seed: int) -> dict[str, np.ndarray]:
    """COLOURS of each character, (C, 3): its file's, varied by chance; the first one's are just those."""
    chance = np.random.Generator(np.random.Philox(key=seed)).uniform(-1, 1, (len(characters), 1 + len(COLOURS)))
    chance[0] = 0.0
    hue = 2 * np.pi * np.array([HUE.get(character.look.plan, LITTLE) for character in characters]) * chance[:, 0]
    colours = {}
    for k, key in enumerate(COLOURS):
        own = np.array([getattr(character.look, key) for character in characters])
        turned = _turned(own, hue) if k < 2 else own
        colours[key] = np.clip(turned * (1 + BRIGHTNESS * chance[:, 1 + k : 2 + k]), 0, 1)
    return colours


def _turned(colour: np.ndarray, hue: np.ndarray) -> np.ndarray:
    """Colours (C, 3) turned about the grey axis by hue (C,) [rad]."""
    c, s = np.cos(hue)[:, None], np.sin(hue)[:, None] / np.sqrt(3)
    r, g, b = colour.T
    return c * colour + (1 - c) * colour.mean(axis=1, keepdims=True) + s * np.column_stack([b - g, r - b, g - r])
