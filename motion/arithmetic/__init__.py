"""The arithmetic that every part of the motion speaks: gravity, angles, triples, rotations. Each word has one home."""
