"""Serial arms of any length, made by rule: what growth with the number of joints is measured on."""

from __future__ import annotations

from robodyn.errors import InputError

_LONGEST = 200
_ALPHA = (0.3, -1.1, 0.7, -0.5, 1.3)


def family_text(joints: int) -> str:
    """The YAML of the arm with so many revolute joints: axes in general position, full inertias, rotors.

    Link i does not depend on how many come after it. Nothing in it is zero, parallel or perpendicular, so
    that no length is favoured by what falls away.

    Raises
    ------
    InputError: no joint, or more than 200.
    """
    if not 1 <= joints <= _LONGEST:
        raise InputError("an arm of the family", found=f"{joints} joints", expected=f"1 to {_LONGEST}")
    lines = [f"name: serial{joints}", f"title: Serial arm by rule, {joints} revolute joints", "links:"]
    for i in range(1, joints + 1):
        wave, step, turn = i % 3, i % 4, i % 5
        lines += [
            "  - joint: revolute",
            f"    alpha: {_ALPHA[turn]}",
            f"    a: {(10 + 2 * (i % 7)) / 100}",
            f"    d: {(5 + 3 * step) / 100}",
            f"    mass: {(10 + 7 * wave) / 10}",
            f"    com: [{(2 + turn) / 100}, {(10 + 15 * wave) / 1000}, {-(1 + 2 * step) / 100}]",
            f"    inertia: {{xx: {(20 + step) / 1000}, yy: {(25 + wave) / 1000}, zz: {(30 - i % 2) / 1000},"
            " xy: 0.001, xz: -0.0015, yz: 0.002}",
            "    motor_inertia: 0.1",
        ]
    return "\n".join(lines) + "\n"
