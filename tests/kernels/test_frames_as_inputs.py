"""Inputs that are frames, and inputs that may be left out."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from robodyn.errors import InputError
from robodyn.ir.signature import Signature
from robodyn.kernels.kernel import Kernel, load

#: The trace of the rotation, plus the place times 1, 10 and 100, plus joint 2's reference.
BODY = "tau[0] = T[0] + T[5] + T[10] + T[3] + 10*T[7] + 100*T[11]; tau[1] = q_near[1];"
SIGNATURE = Signature("toy", "of_a_pose", (("T", 12), ("q_near", 2)), (("tau", 2),), joints=2)
T = np.array([[1.0, 0.0, 0.0, 0.25], [0.0, 1.0, 0.0, 0.5], [0.0, 0.0, 1.0, 0.75]])
NEAR = [0.5, -0.5]
EXPECTED = 3 + 0.25 + 5 + 75


@pytest.fixture(scope="module")
def kernel() -> Kernel:
    prototype = "void toy_of_a_pose(const toy_real T[12], const toy_real q_near[2], toy_real tau[2])"
    header = f"#ifndef TOY_H\n#define TOY_H\ntypedef double toy_real;\n{prototype};\n#endif\n"
    return load([SIGNATURE], {"toy.h": header, "toy.c": f'#include "toy.h"\n{prototype}\n{{ {BODY} }}\n'})


WITH_ROW = np.vstack([T, [0.0, 0.0, 0.0, 1.0]])


@pytest.mark.parametrize(
    "pose", [T, T.ravel(), WITH_ROW, T.tolist(), np.asfortranarray(WITH_ROW)], ids=range(5)
)
def test_a_frame_as_a_matrix_or_as_numbers(kernel: Kernel, pose: Any) -> None:
    assert kernel.of_a_pose(pose, NEAR).tolist() == [EXPECTED, -0.5]
    many = np.array([pose, pose])
    assert kernel.of_a_pose(many, [NEAR, NEAR]).tolist() == [[EXPECTED, -0.5]] * 2


def test_what_may_be_left_out_is_zero(kernel: Kernel) -> None:
    assert kernel.of_a_pose(T).tolist() == [EXPECTED, 0.0]
    assert kernel.of_a_pose(T, None).tolist() == [EXPECTED, 0.0]
    assert kernel.of_a_pose(T=[T, T, T]).tolist() == [[EXPECTED, 0.0]] * 3
    assert "q_near: [2] or [N, 2], double; joint positions" in (kernel.of_a_pose.__doc__ or "")
    assert "zeros if left out" in (kernel.of_a_pose.__doc__ or "")


@pytest.mark.parametrize(
    ("pose", "message"),
    [
        (T[:, :3], r"T has the wrong shape; found \[3, 3\]; expected \[3, 4\] or \[N, 3, 4\]"),
        (np.vstack([T, [0.0, 0.0, 0.1, 1.0]]), r"T is no frame; found the last row \[0.0, 0.0, 0.1, 1.0\]"),
        (np.zeros((2, 2, 3, 4)), r"T has the wrong shape; found \[2, 2, 3, 4\]"),
    ],
)
def test_what_is_no_frame_is_refused(kernel: Kernel, pose: Any, message: str) -> None:
    with pytest.raises(InputError, match=message):
        kernel.of_a_pose(pose)


def test_a_pose_must_be_there(kernel: Kernel) -> None:
    with pytest.raises(InputError, match="the arguments do not fit; found no T"):
        kernel.of_a_pose(q_near=NEAR)
