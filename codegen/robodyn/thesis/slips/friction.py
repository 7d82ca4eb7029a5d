"""Chapter 3: bearings against statics, sign rules and ratios against the thesis's own Table 3.5.

Source: Dhanaraj 1990, Eqs 3.1 to 3.11, Tables 3.1 to 3.5.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from robodyn.arrays import Floats
from robodyn.effects import thesis_friction as friction
from robodyn.thesis.case_arm import efficiency_point
from robodyn.thesis.printed import TABLE_3_4, TABLE_3_5
from robodyn.thesis.slips import Comparison, compare

_COUNT: Final = 1000
#: Ratios of gears at which Eq 3.11 is tried.
RATIOS: Final = (2, 10, 100)
#: What a sum of two numbers may miss a third by where each is rounded to four decimals [N m].
_ROUNDED: Final = 1.5e-4


def _loads() -> tuple[Floats, Floats, Floats, Floats, Floats, Floats]:
    """Random bearings: mu, radius and distance [K] (m), forces [3, K] (N), moments [3, K] (N m), sgn(qd)."""
    rng = np.random.default_rng(33)
    mu, r, d = (rng.uniform(*reach, _COUNT) for reach in ((0.01, 0.2), (0.02, 0.2), (0.05, 0.5)))
    f, n = rng.uniform(-200, 200, (3, _COUNT)), rng.uniform(-30, 30, (3, _COUNT))
    return mu, r, d, f, n, rng.choice([-1.0, 1.0], _COUNT)


def _journal_loads(d: Floats, f: Floats, n: Floats) -> Floats:
    """Forces [K, 2, 2] (N) along x and y of two journals at z = +d/2 and -d/2 by equilibrium, solved."""
    loads = []
    for k in range(len(d)):
        up, down = d[k] / 2, -d[k] / 2
        # unknown: F1x F1y F2x F2y; sums of forces, moments about x (-z Fy) and y (z Fx)
        balance = np.array([[1, 0, 1, 0], [0, 1, 0, 1], [0, -up, 0, -down], [up, 0, down, 0]])
        loads.append(np.linalg.solve(balance, [f[0, k], f[1, k], n[0, k], n[1, k]]).reshape(2, 2))
    return np.array(loads)


_STATICS: Final = "two bearings in equilibrium, 1000 loads"


def journal_bearing() -> Comparison:
    """3.3: n_x and n_y with equal signs under a root."""
    mu, r, d, f, n, direction = _loads()
    truth = mu * r * np.linalg.norm(_journal_loads(d, f, n), axis=2).sum(axis=1) * direction
    by_print, mended = (
        _each(friction.journal_bearing, mu, r, d, f, n, direction, as_printed=way) for way in (True, False)
    )
    return compare(by_print, mended, truth, "N m", _STATICS)


def journal_bearing_without_moment() -> Comparison:
    """3.2: a journal under a force alone, right as printed."""
    mu, r, d, f, n, direction = _loads()
    truth = mu * r * np.linalg.norm(_journal_loads(d, f, 0 * n), axis=2).sum(axis=1) * direction
    printed = mu * r * np.sqrt(f[0] ** 2 + f[1] ** 2) * direction
    return compare(printed, printed, truth, "N m", _STATICS)


def linear_bearing() -> Comparison:
    """3.4: sliding bearings, right as printed but for the names."""
    mu, _, d, f, n, direction = _loads()
    truth = mu * np.abs(_journal_loads(d, f, n)).sum(axis=(1, 2)) * direction
    ours = _each(friction.linear_bearing, mu, d, f, n, direction)
    return compare(ours, ours, truth, "N", _STATICS)


def thrust_bearing(along: int = 0) -> Comparison:
    """3.5: ``f_x`` for ``f_z``; ``along`` is the component that is printed, 2 in Table 3.1."""
    mu, r, _, f, _, direction = _loads()
    truth = mu * r * np.abs(np.array([0.0, 0.0, 1.0]) @ f) * direction
    printed, right = (
        _each(friction.thrust_bearing, mu, r, f[order], direction) for order in ([0, 1, along], [0, 1, 2])
    )
    return compare(printed, right, truth, "N m", "the load along the axis, 1000 loads")


def _each(law: Any, *given: Floats, **way: bool) -> Floats:
    """``law`` load by load: numbers [K] and vectors [3, K]."""
    return np.array(
        [law(*(x[k] if x.ndim == 1 else tuple(x[:, k]) for x in given), **way) for k in range(_COUNT)]
    )


# --- sign rules and ratios --------------------------------------------------------------------------------


def sign_rule() -> Comparison:
    """3.7 where the joint brakes, with a friction that has its sign, against the totals of Table 3.5."""
    right = [friction.with_friction(row.dynamic, row.joint_friction) for row in TABLE_3_5]
    printed = [
        row.dynamic - row.joint_friction if row.dynamic * row.joint_friction < 0 else signed
        for row, signed in zip(TABLE_3_5, right, strict=True)
    ]
    by_print, mended, truth = (
        list(map(float, x)) for x in (printed, right, (row.joint_total for row in TABLE_3_5))
    )
    return compare(by_print, mended, truth, "N m", "joint totals of Table 3.5", _ROUNDED)


def ratio() -> Comparison:
    """3.11: ``tau_in = tau_out / eta`` without the ratio m of 3.8 and 3.10: the share of the power that comes
    out, against eta, exactly, at the points of Table 3.5."""
    shares = []
    for row, drive in zip(TABLE_3_5, TABLE_3_4, strict=True):
        eta = efficiency_point(row, drive).efficiency
        at_joint = row.joint_total / eta
        shares += [
            (row.joint_total / (at_joint * m), row.joint_total / (at_joint / m * m), eta) for m in RATIOS
        ]
    printed, right, truth = (list(map(float, column)) for column in zip(*shares, strict=True))
    return compare(printed, right, truth, "efficiency", f"eta, gears of {RATIOS} to 1")


def efficiency_and_breakaway() -> Comparison:
    """3.10 against 3.11: eta as the whole ratio of powers, of link 1 in Table 3.5, against the eta that
    Table 3.2 gives with the breakaway torque beside it."""
    row, drive = TABLE_3_5[0], TABLE_3_4[0]
    eta = efficiency_point(row, drive).efficiency
    whole = row.joint_total / row.input
    apart = row.joint_total / friction.braking(row.input, 1, drive.breakaway, -1)
    return compare(float(whole), float(apart), float(eta), "efficiency", "eta of link 1 by Table 3.2")
