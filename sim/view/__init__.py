"""The only code that imports pygame, moderngl and imgui. Drawing reads the simulation and never writes it."""
