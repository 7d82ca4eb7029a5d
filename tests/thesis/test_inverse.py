"""``tables inverse``: the arm of program D.1.3 is bundled, and its generated branches are the program's."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest

from robodyn.thesis.tables import Table, program_d_1_3
from robodyn.verify.reference import Reference
from thesis.recomputed import bundled, verdicts

ROBOT = "puma560_3dof_d13"
# The lengths of the program, written down for this test: shoulder's offset, upper arm, forearm [m].
G, A, F = 0.127, 0.4318, 0.4318


def by_hand(point: list[float], shoulder: int, elbow: int) -> list[float]:
    """A branch [3] (rad) by the law of cosines: the point in the plane of the arm, then two triangles."""
    x, y, z = point
    u = shoulder * math.sqrt(x * x + y * y - G * G)
    q1 = math.atan2(y, x) - math.atan2(G, u)
    bend = elbow * math.acos((u * u + z * z - A * A - F * F) / (2 * A * F))
    q2 = math.atan2(-z, u) - math.atan2(F * math.sin(bend), A + F * math.cos(bend))
    return [q1, q2, bend - math.pi / 2]  # the forearm is along y of frame 3


def test_the_row_of_operations(tables: dict[str, Table]) -> None:
    table = tables["inverse"]
    assert table.row("operations").ours["value"] == "77"
    assert table.row("operations").verdict is None
    branches = [row for row in table.rows if row.name.startswith("q1 by")]
    assert len(branches) == 4
    assert all(float(row.beside[0]["largest"]) < 1e-12 for row in branches)
    assert verdicts(table)["q1 by minus root, q3 by plus root"] == "reproduced"


@pytest.mark.parametrize("point", [("0.4", "0.1", "0.1"), ("-0.3", "0.2", "0.5"), ("0.2", "-0.6", "-0.1")])
def test_the_bundled_arm_has_the_four_branches_of_the_program(point: tuple[str, str, str]) -> None:
    x, y, z = (Fraction(text) for text in point)
    solutions = program_d_1_3.generated(bundled(ROBOT), (x, y, z))
    place = [float(x), float(y), float(z)]
    poses = Reference(bundled(ROBOT)).tool_pose(np.array(solutions))
    np.testing.assert_allclose(poses[:, :, 3], [place] * 4, atol=1e-14)
    for shoulder in (1, -1):
        for elbow in (1, -1):
            q = by_hand(place, shoulder, elbow)
            off = [max(abs(math.remainder(u - v, math.tau)) for u, v in zip(q, s, strict=True))
                   for s in solutions]  # fmt: skip
            assert min(off) < 1e-12, (shoulder, elbow)
