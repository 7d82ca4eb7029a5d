"""Blind tests of diagnosis and identification, in which MuJoCo moves the arm (``tests/diagnose/hidden``)."""

import sys
from pathlib import Path

# The arms, and the formulas of what is hidden, are those of the tests.
sys.path.insert(0, str(Path(__file__).parents[3] / "tests"))
