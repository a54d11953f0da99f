"""Many worlds and seeds, simulated side by side and measured: resumable, and the same table however it came about."""
