"""Inverse kinematics beside EAIK, ssik and a search: ``python -m benchmarks.inverse_kinematics``."""
