"""MATLAB's files of version 4 to 7, through scipy: numbers, wherever they stand in structures and cells.

Those of version 7.3 are :mod:`~robodyn.logs.formats.hdf5`.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.logs.arrays import is_numeric, recording_of_arrays
from robodyn.logs.formats import LogFormat
from robodyn.logs.recording import Recording

#: Levels of structures that are looked into, and elements of a cell or an array of structures.
LEVELS, ELEMENTS = 16, 64
REMEDY: Final = "save it with save('log.mat', ..., '-v7')"


def open_matlab(path: Path, file: str, gaps: bool) -> Recording:
    """The arrays of numbers in the file at ``path``: ``log.q`` is the field q of the structure log.

    Raises
    ------
    InputError: they have no samples.
    """
    from scipy.io import loadmat

    arrays: dict[str, NDArray[Any]] = {}
    for name, value in loadmat(path).items():
        if not name.startswith("__"):
            _collect(name, value, LEVELS, arrays)
    shapes = {name: array.shape for name, array in arrays.items()}
    return recording_of_arrays(file, "MATLAB", shapes, arrays.__getitem__)


def _collect(path: str, value: Any, levels: int, arrays: dict[str, NDArray[Any]]) -> None:
    """Put the arrays of numbers in ``value`` into ``arrays``. What else there may be is stepped over."""
    from scipy.io.matlab import MatlabFunction, MatlabOpaque

    if not levels or not isinstance(value, np.ndarray) or isinstance(value, (MatlabFunction, MatlabOpaque)):
        return
    elements = value.ravel(order="F")[:ELEMENTS]
    if value.dtype.names is not None:
        for k, element in enumerate(elements):
            for field in value.dtype.names:
                inner = f"{path}.{field}" if value.size == 1 else f"{path}.{k}.{field}"
                _collect(inner, element[field], levels - 1, arrays)
    elif value.dtype.hasobject:
        for k, element in enumerate(elements):
            _collect(f"{path}.{k}", element, levels - 1, arrays)
    elif is_numeric(value.dtype) and value.size > 1:
        arrays[path] = value


FORMAT = LogFormat("matlab", (".mat",), "one of MATLAB's", open_matlab, mark=b"MATLAB", remedy=REMEDY)
