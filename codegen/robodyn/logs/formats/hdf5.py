"""HDF5, through h5py, and with it MATLAB's files of version 7.3: arrays."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from robodyn.logs.arrays import is_numeric, recording_of_arrays
from robodyn.logs.formats import LogFormat
from robodyn.logs.recording import LARGEST, Recording
from robodyn.tools.libraries import H5PY

#: Levels of groups that are looked into.
LEVELS = 16


def open_hdf5(path: Path, file: str, gaps: bool) -> Recording:
    """The arrays of numbers in the file at ``path``.

    Raises
    ------
    InputError: they have no samples.
    """
    arrays = dict(_datasets(H5PY.load().File(path, "r"), "", LEVELS))
    shapes = {name: array.shape for name, array in arrays.items()}
    return recording_of_arrays(file, "HDF5", shapes, arrays.__getitem__)


def _datasets(group: Any, path: str, levels: int) -> Iterator[tuple[str, Any]]:
    """The arrays of numbers in ``group``. Links, and arrays that lie in other files, are not followed."""
    h5py = H5PY.load()
    for key in group:
        if not levels or not isinstance(group.get(key, getlink=True), h5py.HardLink) or key.startswith("#"):
            continue
        inner = group[key]
        name = f"{path}.{key}" if path else key
        if isinstance(inner, h5py.Group):
            yield from _datasets(inner, name, levels - 1)
        elif isinstance(inner, h5py.Dataset) and is_numeric(inner.dtype) and "." not in key:
            is_here = inner.external is None and not inner.is_virtual and inner.id.get_storage_size() > 0
            if is_here and len(inner.shape) <= 3 and math.prod(inner.chunks or ()) <= LARGEST:
                yield name, inner


FORMAT = LogFormat(
    "hdf5", (".h5", ".hdf5", ".mat"), "HDF5", open_hdf5, library=H5PY, mark=b"\x89HDF\r\n\x1a\n",
    remedy="save it with save('log.mat', ..., '-v7')",
)  # fmt: skip
