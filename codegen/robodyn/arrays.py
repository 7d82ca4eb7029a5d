"""Types of arrays, whose shapes docstrings give in brackets."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]
Indices = NDArray[np.intp]
Mask = NDArray[np.bool_]
