"""python -m sim: the command line, as `footfall` and main.py have it."""

from sim.cli.entry import console

console()
