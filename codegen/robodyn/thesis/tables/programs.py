"""What programs have: D.1.3, the inverse kinematics of the PUMA's first three joints, beside the generated
one; and inertias of the PUMA (Table 2.6) beside what D.2's tensors make of them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Any, Final

from robodyn.counts import count
from robodyn.dynamics.arm import build_arm
from robodyn.dynamics.inverse import inverse_of
from robodyn.kernels.generate import Options, program
from robodyn.robot.model import Robot
from robodyn.thesis.case_arm import D4_BRANCH, LED_ROBOT, led
from robodyn.thesis.printed import D_2, D_2_LAST_DIGIT, PUMA, bundled
from robodyn.thesis.puma_inverse import BRANCHES
from robodyn.thesis.tables.table import Row, verdict_of, words_of

#: Where simulation D.4 begins as the thesis prints it [rad], and where the printed positions put the point
#: [m].
D4_PRINTED: Final = (3.6997, 2.3083, 0.5951)
POINT: Final = (Fraction(4, 10), Fraction(1, 10), Fraction(1, 10))


def generated_branches(robot: Robot, point: Sequence[Fraction]) -> list[list[float]]:
    """Joint positions [4][3] (rad) of all branches by the generated inverse kinematics, in floats."""
    inverse = inverse_of(build_arm(robot, lambda x: x, lambda name: name), [None] * robot.n)
    x, y, z = map(float, point)
    pose: list[Any] = [1.0, 0.0, 0.0, x, 0.0, 1.0, 0.0, y, 0.0, 0.0, 1.0, z]
    solved = inverse.solve(pose, [0.0] * robot.n, Fraction(1, 1 << 52))
    assert all(solved.exists)
    return [[float(x) for x in q] for q in solved.solutions]


def table_of_branches() -> Iterator[Row]:
    """The four branches at the beginning of simulation D.4, and the numbers of D.1.3 that do not fit."""
    robot = bundled(LED_ROBOT)
    ours = generated_branches(robot, POINT)
    by_formulas = led("programs").inverse.positions([float(x) for x in POINT]).tolist()
    for signs, q in zip(BRANCHES, by_formulas, strict=True):
        name = "q1 by {} root, q3 by {} root".format(*("plus" if sign > 0 else "minus" for sign in signs))
        nearest = min(ours, key=lambda other, q=q: _apart(other, q))  # type: ignore[misc]
        beside = ({"what": "off the formulas of D.1.3 [rad]", "largest": f"{_apart(nearest, q):.1e}"},)
        if signs != D4_BRANCH:
            yield Row(name, {}, {"value": _positions(nearest)}, None, "not printed", beside)
            continue
        turned = [nearest[0] % (2 * math.pi), *nearest[1:]]
        same = max(abs(x - y) for x, y in zip(turned, D4_PRINTED, strict=True)) <= 5.1e-5
        printed, found = {"value": _positions(D4_PRINTED)}, {"value": _positions(turned)}
        reason = "where D.4 begins, q1 one turn on; not the branch that D.1.3 takes first"
        yield Row(name, printed, found, verdict_of(same), reason, beside)
    kernel = count(program(robot, "inverse_kinematics", Options(("inverse_kinematics",))))
    yield Row(
        "operations",
        {},
        {"value": str(kernel.total), "operations": kernel.to_dict()},
        None,
        f"not printed; multiplications, additions, divisions and square roots of {robot.name}'s generated "
        "inverse kinematics, all four branches together",
    )
    for row in words_of("inverse")["numbers"]:
        yield Row(row["name"], {"value": row["printed"]}, {"value": row["ours"]}, "differs", row["reason"])


def _apart(one: Sequence[float], other: Sequence[float]) -> float:
    return max(abs(math.remainder(x - y, math.tau)) for x, y in zip(one, other, strict=True))


def _positions(q: Sequence[float]) -> str:
    return ", ".join(f"{x:.4f}" for x in q)


# --- 2.6 --------------------------------------------------------------------------------------------------


def table_2_6() -> Iterator[Row]:
    """A row for each printed figure, and one for the tensor that no body has."""
    half = D_2_LAST_DIGIT / 2
    for k, (link, tensor) in enumerate(zip(PUMA, D_2, strict=True), 1):
        for name, moment, whole, shift, rotor in zip(
            ("Ixx", "Iyy", "Izz"), link.moments, tensor, link.shifts, link.rotors, strict=True
        ):
            if moment is not None and whole is not None:
                yield _inertia(f"link {k}, {name}", moment, whole - shift - rotor, whole)
        (_, iyy, izz), (_, around_y, around_z) = link.moments, tensor
        if izz is not None and around_z is not None:
            tenfold = iyy and around_y and abs(around_y - link.shifts[1] - iyy / 10) <= half
            moment = izz / 10 if tenfold else izz
            yield _inertia(f"link {k}, rotor", link.motor, around_z - link.shifts[2] - moment, around_z)
    for k, link in enumerate(PUMA, 1):
        xx, yy, zz = link.moments
        if xx is None or yy is None or zz is None:
            continue
        spare = min(xx + yy - zz, yy + zz - xx, xx + zz - yy)
        yield Row(
            f"link {k}, triangle",
            {"value": f"{float(xx)} {float(yy)} {float(zz)}"},
            {"value": float(spare)},
            verdict_of(spare >= 0),
            "the least of the sums of two moments less the third, which no body has below 0"
            + ("" if spare >= 0 else ": these moments are no body's"),
        )


def _inertia(name: str, printed: Fraction, ours: Fraction, whole: Fraction) -> Row:
    """A printed figure beside ours, which is D.2's ``whole`` one less what belongs to others."""
    half = D_2_LAST_DIGIT / 2
    same = abs(ours - printed) <= half
    if same:
        reason = "program D.2 has it, moved to the link's origin"
    elif abs(ours - printed / 10) <= half:
        reason = "ten times what program D.2 has"
    elif whole == printed:
        reason = "program D.2 has the printed one about the link's origin: it was not moved there"
    else:
        reason = "program D.2 has another one"
    return Row(name, {"value": float(printed)}, {"value": float(round(ours, 6))}, verdict_of(same), reason)
