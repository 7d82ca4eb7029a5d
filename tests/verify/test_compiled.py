"""The whole road with a kernel that was compiled."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from robodyn.ir.signature import Signature
from robodyn.kernels.kernel import load
from robodyn.robot.model import Inertia, Joint, Link, Robot
from robodyn.robot.values import PI, ZERO, angle, parameter
from robodyn.verify import verify


@pytest.mark.parametrize("scalar", ["double", "float"])
@pytest.mark.parametrize("wrong", [False, True])
def test_a_compiled_kernel(scalar: Any, wrong: bool, tmp_path: Path) -> None:
    """A pendulum written by hand."""
    rod = Joint("revolute", angle(PI / 2), ZERO, ZERO, angle(ZERO), viscous=Fraction(1, 4))
    link = Link("rod", rod, parameter("m"), (Fraction(1, 2), ZERO, ZERO), Inertia(zz=Fraction(1, 16)))
    robot = Robot("rod", (link,), gravity=(ZERO, ZERO, Fraction(-10)))
    header = f"typedef {scalar} rod_real;\ntypedef struct {{ rod_real m; }} rod_params;\n"
    arguments = ", ".join(f"const rod_real {x}[1]" for x in ("q", "qd", "qdd"))
    prototype = f"void rod_inverse_dynamics({arguments}, rod_real tau[1], const rod_params *p)"
    length = "4.9999" if wrong else "5"
    source = f"""#include "rod.h"
#include <math.h>
{prototype}
{{
    const rod_real inertia = p->m / 4 + (rod_real)0.0625;
    tau[0] = inertia * qdd[0] + p->m * (rod_real){length} * (rod_real)cos(q[0]) + qd[0] / 4;
}}
"""
    signature = Signature(
        "rod", "inverse_dynamics", (("q", 1), ("qd", 1), ("qdd", 1)), (("tau", 1),), ("m",), scalar
    )
    files = {"rod.h": f"{header}{prototype};\n", "rod.c": source}
    kernel = load([signature], files, mode="abi", cache=tmp_path)
    report = verify(robot, kernel)
    assert report.passed != wrong
    assert {c.against for c in report.comparisons} == {"reference", "exact", "lagrangian"}
    if not wrong:
        assert all(c.ulps is None or c.ulps < 4 for c in report.comparisons)
