"""The simulation, its view, its files and its measures."""

VERSION = "0.12.0"
