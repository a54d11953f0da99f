"""The automatic timing as numbers, over the step length (paper, Fig. 12)."""

import numpy as np

from motion.arithmetic.gravity import froude_number
from motion.characters.character import Character
from motion.characters.dimensions import Dimensions
from planner.stepping import timing

SHORTEST = 0.1
"""Shortest step of the table, as a share of the longest walking one."""
COLUMNS = (
    "step_length", "step_time", "stance_time", "swing_time", "double_support_time", "flight_time", "speed", "duty_factor",
    "froude",
)  # fmt: skip


def timing_table(character: Character, count: int = 400) -> dict:
    """Columns (count,) for level, straight steps up to the longest leap, the gait of each, and the Froude number (None where
    that is not reached) at which walking changes to running. Metres and seconds."""
    biped = character.biped
    lengths = np.linspace(SHORTEST * biped.reach.max_step, biped.reach.max_leap, count)
    rows = np.array([_row(biped, float(length)) for length in lengths])
    table = {name: column.tolist() for name, column in zip(COLUMNS, rows.T, strict=True)}
    flies = rows[:, COLUMNS.index("flight_time")] > 0
    gaits = np.where(lengths > biped.reach.leap_length, "leap", np.where(flies, "run", "walk"))
    return {**table, "gait": gaits.tolist(), "run_from": run_from(character)}


def _row(biped: Dimensions, length: float) -> tuple[float, ...]:
    step, stance = timing.step_timing(biped, length, 0.0, 0.0, False)
    speed = length / step
    froude = froude_number(length, step, biped.timing.hip_height)
    return (
        length, step, stance, 2 * step - stance, max(stance - step, 0.0), max(step - stance, 0.0), speed, stance / (2 * step),
        froude,
    )  # fmt: skip


def run_from(character: Character) -> dict[str, float] | None:
    """Step length [m], speed [m/s] and Froude number of the first step with a flight; None where only leaps have one."""
    biped = character.biped
    lengths = np.linspace(0.1 * biped.reach.max_step, biped.reach.leap_length, 2000)
    flies = [float(length) for length in lengths if _row(biped, float(length))[5] > 0]
    if not flies:
        return None
    row = dict(zip(COLUMNS, _row(biped, flies[0]), strict=True))
    return {name: float(row[name]) for name in ("step_length", "speed", "froude")}


def in_words(tables: dict[str, dict]) -> str:
    """Every twentieth row of each character's table, for people."""
    lines = []
    for name, table in tables.items():
        change = table["run_from"]
        told = "runs from {step_length:.2f} m, {speed:.2f} m/s, Froude {froude:.2f}"
        told = told.format(**change) if change else "never runs"
        lines += [f"{name} ({told})", "  step m  time s  stance s  swing s  flight s     m/s    duty  gait"]
        for i in range(0, len(table["gait"]), 20):
            values = [table[column][i] for column in ("step_length", "step_time", "stance_time", "swing_time", "flight_time")]
            values += [table["speed"][i], table["duty_factor"][i]]
            cells = [f"{value:{width}.2f}" for value, width in zip(values, (8, 8, 10, 9, 10, 8, 8), strict=True)]
            lines.append("".join(cells) + f"  {table['gait'][i]}")
    return "\n".join(lines)
