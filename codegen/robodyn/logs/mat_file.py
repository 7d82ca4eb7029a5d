"""MATLAB's files as recordings; those of version 7.3 are HDF5, through h5py, which only they need."""

from __future__ import annotations

import math
import mmap
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import Place
from robodyn.files import open_regular
from robodyn.logs.arrays import ArraysRecording, is_numeric, refuse_without_samples
from robodyn.logs.columns import LARGEST
from robodyn.logs.mat_parts import NotMat, arrays_of, variables
from robodyn.logs.recording import damaged
from robodyn.tools.libraries import H5PY

#: Most arrays of a file of version 7.3, and levels of groups in it.
ARRAYS, LEVELS = 1 << 14, 16
#: An array of a log has at most so many times the numbers that are read at once.
SHARE: Final = 1 << 10

_HDF5: Final = b"\x89HDF\r\n\x1a\n"
_REMEDY: Final = "save it with save('log.mat', ..., '-v7')"


def open_mat(path: Path, file: str) -> ArraysRecording:
    """The arrays of numbers in the file at ``path``, which is one of MATLAB's, or HDF5.

    Raises
    ------
    InputError: it is neither, or has no samples.
    ToolError: it is HDF5, and h5py is missing.
    OSError: the file cannot be read.
    """
    with open_regular(path, "a log, such as log.mat", file) as source:
        head = source.read(520) or b""
    if head.startswith(_HDF5) or head[512:520] == _HDF5:
        return _open_hdf5(path, file)
    if not head.startswith(b"MATLAB"):
        text = "no mark of MATLAB's version 5 to 7.3 at its start" if head else "an empty file"
        raise damaged(file, "one of MATLAB's", text, _REMEDY)

    def load(names: set[str]) -> dict[str, NDArray[Any]]:
        arrays: dict[str, NDArray[Any]] = {}
        for name, content, order in _variables(path, file):
            if any(wanted == name or wanted.startswith(f"{name}.") for wanted in names):
                arrays.update(arrays_of(name, content, order))
        return arrays

    shapes: dict[str, tuple[int, ...]] = {}
    for name, content, order in _variables(path, file):
        try:
            shapes.update({key: array.shape for key, array in arrays_of(name, content, order).items()})
        except NotMat as error:
            raise damaged(file, "one of MATLAB's", f"{name}: {error}", _REMEDY) from None
    recording = ArraysRecording(file, "MATLAB", shapes, load)
    refuse_without_samples(recording, shapes)
    return recording


def _variables(path: Path, file: str) -> Iterator[tuple[str, memoryview, str]]:
    """The named variables of the file; what comes after damage is lost."""
    with path.open("rb") as source:
        try:
            data = mmap.mmap(source.fileno(), 0, access=mmap.ACCESS_READ)
        except ValueError:  # empty
            raise damaged(file, "one of MATLAB's", "an empty file") from None
        try:
            for name, content, order in variables(memoryview(data)):
                if name:
                    yield name, memoryview(bytes(content)), order
        except NotMat as error:
            raise damaged(file, "one of MATLAB's", error, _REMEDY) from None


def _open_hdf5(path: Path, file: str) -> ArraysRecording:
    h5py = H5PY.load(where=Place(file), otherwise=_REMEDY)

    shapes: dict[str, tuple[int, ...]] = {}
    try:
        with h5py.File(path, "r") as opened:
            for name, dataset in _datasets(h5py, opened, "", LEVELS):
                shapes[name] = dataset.shape
                if len(shapes) > ARRAYS:
                    raise ValueError(f"more than {ARRAYS} arrays")
    except (OSError, ValueError, KeyError, RuntimeError) as error:
        raise damaged(file, "HDF5", error) from None

    def load(names: set[str]) -> dict[str, NDArray[Any]]:
        with mapped(names) as arrays:
            for name, array in arrays.items():
                if array.size > LARGEST:
                    raise ValueError(f"{name!a} has {array.size} numbers, more than are read at once")
            return {name: np.asarray(array[()]) for name, array in arrays.items()}

    @contextmanager
    def mapped(names: set[str]) -> Iterator[dict[str, Any]]:
        try:
            with h5py.File(path, "r") as opened:
                yield {name: opened[name.replace(".", "/")] for name in names}
        except (OSError, ValueError, KeyError, RuntimeError) as error:
            raise damaged(file, "HDF5", error) from None

    recording = ArraysRecording(file, "HDF5", shapes, load, mapped)
    refuse_without_samples(recording, shapes)
    return recording


def _datasets(h5py: Any, group: Any, path: str, depth: int) -> Iterator[tuple[str, Any]]:
    """The arrays of numbers in ``group``. Links, and arrays that lie in other files, are not followed."""
    for key in group:
        if not depth or not isinstance(group.get(key, getlink=True), h5py.HardLink) or key.startswith("#"):
            continue
        inner = group[key]
        name = f"{path}.{key}" if path else key
        if isinstance(inner, h5py.Group):
            yield from _datasets(h5py, inner, name, depth - 1)
        elif isinstance(inner, h5py.Dataset) and is_numeric(inner.dtype) and "." not in key:
            plain = inner.external is None and not inner.is_virtual
            stored = inner.id.get_storage_size() > 0
            together = math.prod(inner.chunks) if inner.chunks else 0  # numbers that are unpacked at once
            if plain and stored and len(inner.shape) <= 3 and max(inner.size // SHARE, together) <= LARGEST:
                yield name, inner
