"""Blind tests of diagnosis and identification, in which MuJoCo moves the arm (``benchmarks/blind_arms``)."""
