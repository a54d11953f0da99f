"""Colours that pictures, figures and the window share."""

from motion.track import phases

PHASES = {phases.LEFT_STANCE: (0.92, 0.18, 0.85), phases.RIGHT_STANCE: (0.90, 0.12, 0.12)}
PHASES |= {phases.DOUBLE_STANCE: (0.10, 0.14, 0.55), phases.FLIGHT: (0.55, 0.80, 0.98)}
"""Red, green and blue in which the paper's figures draw each phase."""
