"""Motion out to other programs: one file per format, each reads a `Clip` (sim.export.clip.clip)."""
