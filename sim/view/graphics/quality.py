"""How much effort a picture takes, in levels from a real GPU's to a slow processor's."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Quality:
    """Larger is better and slower."""

    shadow_size: int = 2048  # pixels of the shadow map, 0 without shadows
    shadow_samples: int = 4  # per point: 1, or 4 for soft edges
    samples: int = 4  # of multisampling
    scale: float = 1.0  # share of the window's resolution
    slowest: float = 1 / 30  # frames that take longer [s] lead to the next level: a crisp picture may be a little slower


LEVELS = (
    Quality(2048, 4, 4, 1.0), Quality(2048, 4, 0, 1.0), Quality(1024, 1, 0, 1.0, 1 / 26), Quality(1024, 1, 0, 0.75, 1 / 14),
    Quality(512, 1, 0, 0.6, 1 / 10), Quality(0, 1, 0, 0.5),
)  # fmt: skip
SOFTWARE_LEVEL = 2
"""Where a window starts that is drawn by the processor."""
