"""Base parameters: the fewest combinations of a rigid arm's inertial numbers that its torques depend on.

Torques are linear in mass, first and second moments of each link about the origin of its frame, in rotor
inertias and friction coefficients. Of the moments some make no difference to a link that they would not make
to the one before (:mod:`~robodyn.dynamics.regroup`), which holds for every arm; what is special to one (no
gravity along an axis, parallel axes at the base) shows in the columns themselves. Both are exact: columns are
compared at random points of finite fields, which are drawn from the arm's numbers, and what one is of others
is a rational number that as many fields agree upon as it takes to write it.

Sources: Gautier and Khalil 1990; Khalil and Dombre 2002, ch. 9.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from numbers import Rational
from typing import Any, NamedTuple

from robodyn.dynamics.arm import Arm, JointAngle, Symmetric, build_motion
from robodyn.dynamics.limits import MOST_FIELDS
from robodyn.dynamics.lump import Lump
from robodyn.dynamics.parallel import single_turns
from robodyn.dynamics.regressor import Accelerated, accelerated, unit_torques_at
from robodyn.dynamics.regroup import about_axis_z, in_parent
from robodyn.dynamics.state import Posture
from robodyn.errors import InputError
from robodyn.ir.field import Field, Residue
from robodyn.ir.fingerprint import in_drawn_field

#: Mass, first and second moments of a link about the origin of its frame.
MOMENTS = ("m", "mx", "my", "mz", "Kxx", "Kyy", "Kzz", "Kxy", "Kxz", "Kyz")
#: What the drives add, where torques are the motors'.
DRIVE = ("rotor", "viscous", "coulomb")


class Standard(NamedTuple):
    """A number of a link (from 1) as it is described."""

    quantity: str
    link: int

    def __str__(self) -> str:
        return f"{self.quantity}{self.link}"


@dataclass(frozen=True, slots=True)
class BaseParameter:
    """A combination of numbers of links. Its column is the torques that a unit of ``own`` alone takes."""

    own: Standard
    terms: tuple[tuple[Standard, Fraction], ...]

    def value(self, numbers: Mapping[Standard, Any]) -> Any:
        """Its value where the links' ``numbers`` are these; those that are missing are 0."""
        total: Any = 0
        for standard, factor in self.terms:
            if standard in numbers:
                total = total + factor * numbers[standard]
        return total

    def to_dict(self) -> dict[str, Any]:
        """As JSON has it: its own number, and all that it is made of with factors."""
        return {"own": str(self.own), "terms": {str(x): float(factor) for x, factor in self.terms}}

    def __str__(self) -> str:
        text = ""
        for standard, factor in self.terms:
            size = "" if abs(factor) == 1 else f"{_decimal(abs(factor))} "
            sign = "-" if factor < 0 else "+" if text else ""
            text += f" {sign} {size}{standard}" if text else f"{sign}{size}{standard}"
        return text


def numbers_of(arm: Arm, lumps: Sequence[Lump]) -> dict[Standard, Any]:
    """The numbers of the links of ``arm``, whose moments of mass are ``lumps``, and of their drives."""
    numbers: dict[Standard, Any] = {}
    for i, (body, lump) in enumerate(zip(arm.bodies, lumps, strict=True), 1):
        moments = (lump.mass, *lump.first, *lump.second.entries())
        drive = (body.motor_inertia, body.viscous, body.coulomb)
        values = zip((*MOMENTS, *DRIVE), (*moments, *drive), strict=True)
        numbers.update({Standard(quantity, i): value for quantity, value in values})
    return numbers


def _decimal(x: Fraction) -> str:
    """The shortest decimal that is ``x``, else the nearest of 12 digits."""
    below = x.denominator
    for prime in (2, 5):
        while below % prime == 0:
            below //= prime
    exact = below == 1 and x.denominator < 10**15
    return f"{float(x):.15g}" if exact else f"{float(x):.12g}"


#: What may make a difference of its own at a revolute joint, and at a prismatic one; cheap columns first.
_OWN = {True: ("Kxx", "Kyy", "Kxy", "Kxz", "Kyz", "mx", "my"), False: ("m", "mx", "my", "mz")}
_ORDER = {quantity: k for k, quantity in enumerate((*MOMENTS, *DRIVE))}
#: Numbers of links with factors.
_Form = dict[Standard, Fraction]


def base_set(arm: Arm) -> tuple[BaseParameter, ...]:
    """The base parameters of ``arm``, base to tip; its lengths and angles are rational numbers of any kind.

    Raises
    ------
    InputError: a length is a run-time parameter.
    """
    if not all(isinstance(x, Rational) for body in arm.bodies for x in (body.a, body.b, body.d)):
        raise InputError(
            "base parameters depend on the arm's lengths",
            found="a length that is a run-time parameter",
            remedy="state it as a number; masses may stay run-time parameters",
        )
    zero: dict[str, Any] = {"mass": 0, "com": (0, 0, 0), "inertia": Symmetric(0, 0, 0, 0, 0, 0)}
    zero |= {"motor_inertia": 0, "viscous": 0, "coulomb": 0}
    bodies = tuple(
        replace(body, **{name: _fraction(getattr(body, name)) for name in _GEOMETRY}, **zero)
        for body in arm.bodies
    )
    gx, gy, gz = map(_fraction, arm.gravity)
    return _base_set(Arm(bodies, (gx, gy, gz), arm.rest_velocity, arm.dead_band, motors=arm.motors))


_GEOMETRY = ("cos_alpha", "sin_alpha", "a", "b", "d")


def _fraction(x: Any) -> Any:
    """``x`` as a fraction if it is a rational number of any kind, sympy's too; else as it is."""
    return Fraction(int(x.numerator), int(x.denominator)) if isinstance(x, Rational) else x


@functools.lru_cache(maxsize=64)
def _base_set(arm: Arm) -> tuple[BaseParameter, ...]:
    forms = _regrouped(arm)
    links = list(enumerate(arm.bodies, 1))
    candidates = [Standard(quantity, i) for i, body in links for quantity in _OWN[body.revolute]]
    drives = [Standard(quantity, i) for quantity in DRIVE for i, _ in links] if arm.motors else []
    rotors, friction = drives[: len(links)], drives[len(links) :]  # which is odd in the rates, all else even
    forms |= {x: {x: Fraction(1)} for x in drives}
    independent, relations = _independent(arm, candidates + rotors)
    parameters = []
    for own in independent + friction:
        form = dict(forms[own])
        for other, factors in relations.items():
            if own in factors:
                _add(form, forms[other], factors[own])
        order = sorted(form, key=lambda x: (x != own, x.link, _ORDER[x.quantity]))
        parameters.append(BaseParameter(own, tuple((x, form[x]) for x in order if form[x])))
    return tuple(sorted(parameters, key=lambda x: (x.own.link, _ORDER[x.own.quantity])))


def _add(form: _Form, other: _Form, factor: Fraction) -> None:
    for x, share in other.items():
        form[x] = form.get(x, Fraction(0)) + factor * share


def _regrouped(arm: Arm) -> dict[Standard, _Form]:
    """What each link's moments stand for after all that makes no difference moved to its parent."""
    links = range(1, len(arm.bodies) + 1)
    own = [Standard(quantity, i) for i in links for quantity in MOMENTS]
    forms: dict[Standard, _Form] = {x: {x: Fraction(1)} for x in own}
    for i in reversed(links[:-1]):
        body = arm.bodies[i]
        for quantity in MOMENTS:
            if quantity in _OWN[body.revolute]:
                continue
            mass, x, y, z, *second = (int(quantity == other) for other in MOMENTS)
            lump = Lump(mass, (x, y, z), Symmetric(*second))
            if not body.revolute:
                lump = about_axis_z(lump, body.theta.cos, body.theta.sin)
            moved = in_parent(lump, arm, i, body.d)
            numbers = (moved.mass, *moved.first, *moved.second.entries())
            for other, factor in zip(MOMENTS, numbers, strict=True):
                if factor:
                    _add(forms[Standard(other, i)], forms[Standard(quantity, i + 1)], Fraction(factor))
    return forms


# --- what is special to an arm ------------------------------------------------------------------------------


def _independent(arm: Arm, candidates: Sequence[Standard]) -> tuple[list[Standard], dict[Standard, _Form]]:
    """Of ``candidates`` those whose columns are independent, and what the others' columns are of theirs."""
    known: list[Standard] | None = None
    modulus = 1
    residues: dict[tuple[Standard, Standard], int] = {}
    for k in range(MOST_FIELDS):
        field, independent, factors = in_drawn_field(
            lambda field: (field, *_reduced(field, arm, candidates)), repr(arm).encode(), b"%d" % k
        )
        if known is not None and independent != known:
            raise AssertionError("two fields differ in what is independent")
        known = independent
        inverse = pow(modulus, -1, field.prime)
        for place, value in factors.items():
            before = residues.get(place, 0)
            residues[place] = before + modulus * ((value - before) * inverse % field.prime)
        modulus *= field.prime
        relations = {place: _rational(value, modulus) for place, value in residues.items()}
        if k and all(x is not None for x in relations.values()):
            # One field more than it takes to write them down: it agrees.
            table: dict[Standard, _Form] = {x: {} for x in candidates if x not in independent}
            for (other, own), factor in relations.items():
                assert factor is not None
                table[other][own] = factor
            return known, table
    raise InputError(
        "the base parameters cannot be written down",
        found=f"factors of more than {MOST_FIELDS * 50} bits",
        remedy="state lengths and angles with fewer digits",
    )


def _reduced(
    field: Field, arm: Arm, candidates: Sequence[Standard]
) -> tuple[list[Standard], dict[tuple[Standard, Standard], int]]:
    """Which columns are independent at random points of ``field``, and the factors of the others.

    A joint feels only what it carries. So combinations of columns that no joint feels are looked for from tip
    to base: those that none further out feels, and the next link's own. Of most arms none is left at any
    joint, and of a row no more is worked out than the columns of one link.
    """
    p = field.prime
    n = len(arm.bodies)
    points = [_somewhere(field, arm, k) for k in range(len(candidates) // n + 2)]
    unfelt: list[_Combination] = []
    for i in reversed(range(n)):
        unfelt += [{column: 1} for column, x in enumerate(candidates) if x.link == i + 1]
        for point in points:
            columns = sorted({column for combination in unfelt for column in combination})
            row = unit_torques_at(i, *point, [candidates[column] for column in columns])
            torques = [x.value if isinstance(x, Residue) else x % p for x in row]
            unfelt = _without_torque(unfelt, dict(zip(columns, torques, strict=True)), p)
            if not unfelt:
                break
    last = _by_last_column(unfelt, p)
    independent = [x for column, x in enumerate(candidates) if column not in last]
    factors = {
        (candidates[other], candidates[column]): -share % p
        for other in sorted(last)
        for column, share in last[other].items()
        if column != other
    }
    return independent, factors


#: A combination of columns: a factor by column, none of them 0.
_Combination = dict[int, int]


def _without_torque(
    combinations: Sequence[_Combination], torques: Mapping[int, int], p: int
) -> list[_Combination]:
    """Of all combinations of ``combinations`` those, as few as span them, whose torque is 0, that of each
    column being one of ``torques``."""
    totals = [sum(torques[column] * x for column, x in one.items()) % p for one in combinations]
    pivot = next((k for k, total in enumerate(totals) if total), None)
    if pivot is None:
        return list(combinations)
    inverse = pow(totals[pivot], -1, p)
    return [
        _less(one, total * inverse, combinations[pivot], p)
        for k, (one, total) in enumerate(zip(combinations, totals, strict=True))
        if k != pivot
    ]


def _by_last_column(combinations: Sequence[_Combination], p: int) -> dict[int, _Combination]:
    """Combinations that span the same, each by its last column: that is 1 in it and 0 in all others."""
    last: dict[int, _Combination] = {}
    for one in combinations:
        for column, other in last.items():
            one = _less(one, one.get(column, 0), other, p)
        end = max(one)
        inverse = pow(one[end], -1, p)
        one = {column: x * inverse % p for column, x in one.items()}
        last = {column: _less(other, other.get(end, 0), one, p) for column, other in last.items()}
        last[end] = one
    return last


def _less(one: _Combination, factor: int, other: _Combination, p: int) -> _Combination:
    """``one - factor * other``."""
    if not factor:
        return one
    result = dict(one)
    for column, x in other.items():
        value = (result.get(column, 0) - factor * x) % p
        if value:
            result[column] = value
        else:
            result.pop(column, None)
    return result


def _somewhere(field: Field, arm: Arm, k: int) -> tuple[Posture, list[Accelerated]]:
    """``arm`` in the field, at a random point, and the motion of its links there."""

    def number(x: Any) -> Any:
        return x if x is None or x in (0, 1, -1) else Residue(field, field.number(x))

    def circle(angle: JointAngle) -> tuple[Residue, Residue]:
        cosine, sine = field.circle(f"q {angle.terms[0][0]} {k}")
        return Residue(field, cosine), Residue(field, sine)

    bodies = tuple(
        replace(body, **{name: number(getattr(body, name)) for name in _GEOMETRY}) for body in arm.bodies
    )
    q, qd, qdd = (
        [Residue(field, field.random(f"{name} {i} {k}")) for i in range(len(bodies))]
        for name in ("q", "qd", "qdd")
    )
    x, y, z = map(number, arm.gravity)
    moved = Arm(bodies, (x, y, z), number(arm.rest_velocity), number(arm.dead_band))
    motion = build_motion(moved, q, qd, qdd, circle, number)
    posture = Posture(moved, motion, single_turns(motion))
    return posture, accelerated(posture)


def _rational(value: int, modulus: int) -> Fraction | None:
    """The fraction that ``value`` is in the integers modulo ``modulus``, of few digits; None: there is none.

    Source: Wang, Guy and Davenport 1982.
    """
    most = math.isqrt(modulus // 2) >> 40  # far fewer than would fit: no chance match
    r0, r1, s0, s1 = modulus, value % modulus, 0, 1
    while r1 > most:
        quotient = r0 // r1
        r0, r1, s0, s1 = r1, r0 - quotient * r1, s1, s0 - quotient * s1
    if not s1 or abs(s1) > most:
        return None
    return Fraction(r1, s1)
