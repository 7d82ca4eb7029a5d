"""From a robot to its kernels: programs, counts, files; compiled, loaded and called."""
