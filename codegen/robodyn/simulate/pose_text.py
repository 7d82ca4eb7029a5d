"""Poses as people and files write them: numbers to frames [3, 4], and back."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Final

import numpy as np

from robodyn.arrays import Floats
from robodyn.errors import InputError, Place
from robodyn.files import label, parsed_json, read_text

#: Largest file of poses [bytes], and most poses in one.
_SIZE, _MOST = 1 << 26, 100_000
#: How far the nine numbers of a rotation may be off one: they have few digits, and the nearest is taken.
_DIGITS: Final = 1e-4
#: The ways to write a pose, by how many numbers it is.
FORMS: Final = "6 numbers x y z roll pitch yaw, 12 of [R p] row by row, or 16 with the row 0 0 0 1"


def frame_of(numbers: Sequence[float], *, degrees: bool = False) -> Floats:
    """The frame ``[R p]`` [3, 4] of 6, 12 or 16 numbers: lengths in m; roll, pitch and yaw in rad, or in
    ``degrees``, about fixed axes x, y and z as in URDF.

    Raises
    ------
    InputError: another count, numbers that are not finite, or no rotation.
    """
    values = np.array(numbers, np.float64)
    if values.shape not in ((6,), (12,), (16,)):
        raise InputError("this is not a pose", found=f"{values.size} numbers", expected=FORMS)
    if not np.isfinite(values).all():
        raise InputError("a pose has numbers that are not finite", found=str(values.tolist()), expected=FORMS)
    if len(values) == 6:
        angles = np.radians(values[3:]) if degrees else values[3:]
        return np.column_stack([_rotation(*angles.tolist()), values[:3]])
    if len(values) == 16 and np.abs(values[12:] - (0, 0, 0, 1)).max() > _DIGITS:
        raise InputError(
            "the last row of a pose is wrong", found=str(values[12:].tolist()), expected="0 0 0 1"
        )
    frame = values[:12].reshape(3, 4)
    U, sizes, V = np.linalg.svd(frame[:, :3])
    if np.abs(sizes - 1).max() > _DIGITS or np.linalg.det(U @ V) < 0:
        raise InputError(
            "the first three columns of a pose are no rotation",
            found=str(frame[:, :3].tolist()),
            expected="a matrix with columns of length 1, across each other, of determinant 1",
        )
    return np.column_stack([U @ V, frame[:, 3]])


def _rotation(roll: float, pitch: float, yaw: float) -> Floats:
    (cr, sr), (cp, sp), (cy, sy) = ((math.cos(x), math.sin(x)) for x in (roll, pitch, yaw))
    return np.array(
        [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr],
        ]
    )


def roll_pitch_yaw(R: Floats) -> tuple[float, float, float]:
    """The angles [rad] of a rotation [3, 3]; where the pitch is a quarter turn the roll is 0."""
    pitch = math.atan2(-R[2, 0], math.hypot(R[0, 0], R[1, 0]))
    if math.hypot(R[2, 1], R[2, 2]) < 1e-12:
        return 0.0, pitch, math.atan2(-R[0, 1], R[1, 1])
    return math.atan2(R[2, 1], R[2, 2]), pitch, math.atan2(R[1, 0], R[0, 0])


def frames_in(path: str | Path, *, degrees: bool = False) -> Floats:
    """The poses [K, 3, 4] in a file: in JSON a list of poses, or an object with such a list as ``poses``, a
    pose being a list of numbers or of rows; in any other file rows of numbers between commas, under names or
    not.

    Raises
    ------
    InputError: it cannot be read, or has something else in it; says where.
    """
    file = label(path)
    text = read_text(path, _SIZE, "poses in JSON or CSV", file)
    rows = _json_rows(text, file) if Path(path).suffix.lower() == ".json" else _csv_rows(text, file)
    if not rows:
        raise InputError("there is no pose in the file", where=Place(file), expected=FORMS)
    if len(rows) > _MOST:
        raise InputError(
            "too many poses", where=Place(file), found=f"{len(rows)}", expected=f"at most {_MOST}"
        )
    frames = []
    for place, numbers in rows:
        try:
            frames.append(frame_of(numbers, degrees=degrees))
        except InputError as error:
            raise InputError(error.what, where=place, found=error.found, expected=error.expected) from None
    return np.array(frames)


_Rows = list[tuple[Place, list[float]]]


def _csv_rows(text: str, file: str) -> _Rows:
    rows: _Rows = []
    for k, row in enumerate(csv.reader(io.StringIO(text)), start=1):
        if not any(cell.strip() for cell in row):
            continue
        try:
            rows.append((Place(file, k), [float(cell) for cell in row]))
        except ValueError as error:
            if rows or k > 1:
                raise InputError(
                    "a row of poses has something else than numbers", where=Place(file, k), found=str(error)
                ) from None
    return rows


def _json_rows(text: str, file: str) -> _Rows:
    try:
        data = parsed_json(text)
    except ValueError as error:
        raise InputError("the file is not JSON", where=Place(file), found=str(error)) from None
    poses = data.get("poses") if isinstance(data, dict) else data
    if not isinstance(poses, list):
        raise InputError("there is no list of poses in the file", where=Place(file), expected=FORMS)
    if poses and _is_number(poses[0]):
        poses = [poses]
    return [(Place(file), _flat(pose, k, file)) for k, pose in enumerate(poses, start=1)]


def _flat(pose: Any, k: int, file: str) -> list[float]:
    rows = pose if isinstance(pose, list) else [pose]
    numbers = [x for row in rows for x in (row if isinstance(row, list) else [row])]
    if not all(map(_is_number, numbers)):
        raise InputError(f"pose {k} has something else than numbers", where=Place(file), expected=FORMS)
    return [float(x) for x in numbers]


def _is_number(x: Any) -> bool:
    return isinstance(x, (int, float)) and not isinstance(x, bool)
