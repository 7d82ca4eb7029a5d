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
from dataclasses import replace
from fractions import Fraction
from numbers import Rational
from typing import Any

from robodyn.dynamics.arm import Arm, Motion, Symmetric
from robodyn.dynamics.base_parameter import DRIVE, MOMENTS, BaseParameter, Standard
from robodyn.dynamics.limits import MOST_FIELDS
from robodyn.dynamics.lump import NO_LUMP, Lump
from robodyn.dynamics.parallel import Turns, single_turns
from robodyn.dynamics.regressor import Accelerated, accelerated, unit_torques_at
from robodyn.dynamics.regroup import about_axis_z, in_parent
from robodyn.errors import InputError
from robodyn.ir.field import Field, Residue
from robodyn.ir.fingerprint import in_drawn_field

#: What may make a difference of its own at a revolute joint, and at a prismatic one; cheap columns first.
_OWN = {True: ("Kxx", "Kyy", "Kxy", "Kxz", "Kyz", "mx", "my"), False: ("m", "mx", "my", "mz")}


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
    bodies = tuple(
        replace(
            body,
            cos_alpha=_fraction(body.cos_alpha),
            sin_alpha=_fraction(body.sin_alpha),
            a=_fraction(body.a),
            b=_fraction(body.b),
            d=_fraction(body.d),
            mass=0,
            com=(0, 0, 0),
            inertia=NO_LUMP.second,
            motor_inertia=0,
            viscous=0,
            coulomb=0,
        )
        for body in arm.bodies
    )
    gravity = (_fraction(arm.gravity[0]), _fraction(arm.gravity[1]), _fraction(arm.gravity[2]))
    return _base_set(Arm(bodies, gravity, arm.rest_velocity, arm.dead_band, motors=arm.motors))


def _fraction(x: Any) -> Any:
    """``x`` as a fraction if it is a rational number of any kind, sympy's too; else as it is."""
    return Fraction(int(x.numerator), int(x.denominator)) if isinstance(x, Rational) else x


@functools.lru_cache(maxsize=64)
def _base_set(arm: Arm) -> tuple[BaseParameter, ...]:
    forms = _regrouped(arm)
    candidates = [
        Standard(quantity, i) for i, body in enumerate(arm.bodies, 1) for quantity in _OWN[body.revolute]
    ]
    joints = range(1, len(arm.bodies) + 1)
    if arm.motors:
        rotors = [Standard(DRIVE[0], i) for i in joints]
        candidates += rotors
        forms.update({x: {x: Fraction(1)} for x in rotors})
    independent, relations = _independent(arm, candidates)
    if arm.motors:  # friction is odd in the rates, all else is even
        friction = [Standard(quantity, i) for quantity in DRIVE[1:] for i in joints]
        forms.update({x: {x: Fraction(1)} for x in friction})
        independent += friction
    parameters = []
    for own in independent:
        form = dict(forms[own])
        for other, factors in relations.items():
            if own in factors:
                _add(form, forms[other], factors[own])
        terms = tuple(
            (x, form[x])
            for x in sorted(form, key=lambda x: (x != own, x.link, _ORDER[x.quantity]))
            if form[x]
        )
        parameters.append(BaseParameter(own, terms))
    return tuple(sorted(parameters, key=lambda x: (x.own.link, _ORDER[x.own.quantity])))


_ORDER = {quantity: k for k, quantity in enumerate((*MOMENTS, *DRIVE))}
#: Numbers of links with factors.
_Form = dict[Standard, Fraction]


def _add(form: _Form, other: _Form, factor: Fraction) -> None:
    for x, share in other.items():
        form[x] = form.get(x, Fraction(0)) + factor * share


def _regrouped(arm: Arm) -> dict[Standard, _Form]:
    """What each link's moments stand for after all that makes no difference moved to its parent."""
    forms: dict[Standard, _Form] = {
        Standard(quantity, i): {Standard(quantity, i): Fraction(1)}
        for i in range(1, len(arm.bodies) + 1)
        for quantity in MOMENTS
    }
    for i in reversed(range(1, len(arm.bodies))):
        body = arm.bodies[i]
        for quantity in MOMENTS:
            if quantity in _OWN[body.revolute]:
                continue
            lump = _unit(quantity)
            if not body.revolute:
                lump = about_axis_z(lump, body.theta.cos, body.theta.sin)
            moved = in_parent(lump, arm, i, body.d)
            numbers = zip(MOMENTS, (moved.mass, *moved.first, *moved.second.entries()), strict=True)
            for other, factor in numbers:
                if factor:
                    _add(forms[Standard(other, i)], forms[Standard(quantity, i + 1)], Fraction(factor))
    return forms


def _unit(quantity: str) -> Lump:
    mass, x, y, z, *second = (int(quantity == other) for other in MOMENTS)
    return Lump(mass, (x, y, z), Symmetric(*second))


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


def _somewhere(field: Field, arm: Arm, k: int) -> tuple[Arm, Motion, Turns, list[Accelerated]]:
    """``arm`` in the field, at a random point, and the motion of its links there."""

    def number(x: Any) -> Any:
        return x if x in (0, 1, -1) else Residue(field, field.number(x))

    def drawn(name: str, i: int) -> Residue:
        return Residue(field, field.random(f"{name} {i} {k}"))

    bodies, c, s, d = [], [], [], []
    for i, body in enumerate(arm.bodies):
        names = ("cos_alpha", "sin_alpha", "a", "b", "d")
        bodies.append(replace(body, **{name: number(getattr(body, name)) for name in names}))
        if body.revolute:
            cosine, sine = field.circle(f"q {i} {k}")
            c.append(Residue(field, cosine))
            s.append(Residue(field, sine))
            d.append(bodies[i].d)
        else:
            c.append(number(body.theta.cos))
            s.append(number(body.theta.sin))
            d.append(drawn("q", i))
    qd, qdd = (tuple(drawn(name, i) for i in range(len(c))) for name in ("qd", "qdd"))
    x, y, z = map(number, arm.gravity)
    rest, band = (None if speed is None else number(speed) for speed in (arm.rest_velocity, arm.dead_band))
    moved = Arm(tuple(bodies), (x, y, z), rest, band)
    motion = Motion(tuple(c), tuple(s), tuple(d), qd, qdd)
    turns = single_turns(motion)
    return moved, motion, turns, accelerated(moved, motion, turns)


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
