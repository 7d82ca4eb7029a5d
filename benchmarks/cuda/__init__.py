"""Kernels in CUDA: registers and spilled bytes as ``ptxas`` says, and times on a GPU."""
