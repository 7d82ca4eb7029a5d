"""Friction of joints and transmissions as the thesis has it, over any scalar.

Source: Dhanaraj 1990, chapter 3: Eqs 3.2 to 3.6, Tables 3.1 and 3.2. ``f`` [N] and ``n`` [N m] are force and
moment at the joint, along the link's axes with z the joint's; ``direction`` is sgn(qd), by whatever rule it
is taken near rest. Coulomb's law with loads that the dynamics give, so friction comes after them. Not
modelled by the source: stiction, and what qd = 0 means.

Corrected: Eq 3.3 (see :func:`journal_bearing`), and Eq 3.5, printed with f_x where Table 3.1 has f_z.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from robodyn.effects.scalars import magnitude, root

_HALF = Fraction(1, 2)
Vector = tuple[Any, Any, Any]


def journal_bearing(
    mu: Any, r: Any, d: Any, f: Vector, n: Vector, direction: Any, *, as_printed: bool = False
) -> Any:
    """Friction torque [N m] of a revolute joint in two journals of radius ``r`` [m], ``d`` [m] apart (3.3).

    The journals, at z = +d/2 and -d/2, carry ``(f_x/2 + n_y/d, f_y/2 - n_x/d)`` and ``(f_x/2 - n_y/d,
    f_y/2 + n_x/d)``; without a moment they give ``mu r |f|``. ``as_printed`` pairs n_x and n_y with equal
    signs, as Eq 3.3 does: right only where f_x n_y or f_y n_x is zero. It takes as many operations.
    """
    turned = n[0] if as_printed else -n[0]
    one = _square(_HALF * d * f[0] + n[1]) + _square(_HALF * d * f[1] + turned)
    other = _square(_HALF * d * f[0] - n[1]) + _square(_HALF * d * f[1] - turned)
    return mu * r / d * (root(one) + root(other)) * direction


def linear_bearing(mu: Any, d: Any, f: Vector, n: Vector, direction: Any) -> Any:
    """Friction force [N] of a prismatic joint in two sliding bearings ``d`` [m] apart along z (3.4).

    Each of the two carries along x and along y, on surfaces of their own.
    """
    along_x = magnitude(_HALF * d * f[0] + n[1]) + magnitude(_HALF * d * f[0] - n[1])
    along_y = magnitude(_HALF * d * f[1] + n[0]) + magnitude(_HALF * d * f[1] - n[0])
    return mu / d * (along_x + along_y) * direction


def thrust_bearing(mu: Any, r: Any, f: Vector, direction: Any) -> Any:
    """Friction torque [N m] of a thrust bearing of mean radius ``r`` [m] under ``f_z`` (3.5)."""
    return mu * r * magnitude(f[2]) * direction


def with_friction(torque: Any, friction: Any) -> Any:
    """Torque [N m or N] with the joint's friction (3.6): ``friction`` carries sgn(qd) already, so that in
    Eq 3.7, which has sgn(qd) besides, the sign would count twice."""
    return torque + friction


# --- the transmission -------------------------------------------------------------------------------------


def load_fraction(torque: Any, rated: Any) -> Any:
    """``|torque| / rated``, what the efficiency depends on."""
    return magnitude(torque) / rated


def linear_efficiency(load: Any, e: Sequence[Any]) -> Any:
    """Efficiency on a straight piece of its curve: ``e_0 + e_1 load``."""
    return e[0] + e[1] * load


def cubic_efficiency(load: Any, e: Sequence[Any]) -> Any:
    """Efficiency on a piece of a cubic spline, by Horner's rule."""
    return e[0] + load * (e[1] + load * (e[2] + load * e[3]))


def cubic_efficiency_in_pairs(load: Any, e: Sequence[Any]) -> Any:
    """The same as ``e_0 + e_1 load + load^2 (e_2 + e_3 load)``: a multiplication more, a shorter chain."""
    return e[0] + e[1] * load + load * load * (e[2] + e[3] * load)


def driving(torque: Any, efficiency: Any, breakaway: Any, direction: Any) -> Any:
    """Torque into the transmission where the joint's ``torque`` goes with the motion (Table 3.2, cases 1
    and 3): ``torque / efficiency + breakaway sgn(qd)``, all on the output side."""
    return torque / efficiency + breakaway * direction


def braking(torque: Any, efficiency: Any, breakaway: Any, direction: Any) -> Any:
    """The same where it goes against it (cases 2 and 4): ``torque efficiency + breakaway sgn(qd)``."""
    return torque * efficiency + breakaway * direction


def _square(x: Any) -> Any:
    return x * x
