"""Blind tests of the diagnosis by another engine: MuJoCo moves the arm, own formulas hide the effects."""

import sys
from pathlib import Path

# Numbers of a robot are read as the peers of the tests read them.
sys.path.insert(0, str(Path(__file__).parents[2] / "tests"))
