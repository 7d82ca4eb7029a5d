"""Measuring: our kernels, their peers, and plans for a processor."""
