"""Benchmarks: every figure a median over runs, rivals side by side in one process."""
