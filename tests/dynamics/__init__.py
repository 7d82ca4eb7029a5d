"""Tests of the formulations, on exact rationals."""
