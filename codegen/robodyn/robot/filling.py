"""Run-time parameters of a robot replaced by their values: on the model, never in its text.

A parameter may have the name of a key (``mass``), of an axis (``x``) or of anything else in a description;
here it is a term of an :class:`~robodyn.robot.values.Affine` number, and cannot be mistaken for one of those.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any, Protocol

from robodyn.errors import InputError
from robodyn.robot import numbers
from robodyn.robot.keys import FRICTION, INERTIA, LINK, SIGNS, Key, allowed
from robodyn.robot.parts import AXES, EffectEntry, Inertia, Link
from robodyn.robot.values import Affine, Value

#: A value of a run-time parameter, in the SI unit of the number it stands for.
Number = float | Fraction
_LINK_KEYS = {key.name: key for key in (*LINK, *FRICTION, *INERTIA)}


class Arm(Protocol):
    """What is filled: a :class:`~robodyn.robot.model.Robot`, which stands above this module."""

    @property
    def name(self) -> str: ...
    @property
    def links(self) -> tuple[Link, ...]: ...
    @property
    def effects(self) -> tuple[EffectEntry, ...]: ...
    @property
    def parameters(self) -> tuple[str, ...]: ...


def filled(robot: Arm, parameters: Mapping[str, Number]) -> tuple[tuple[Link, ...], tuple[EffectEntry, ...]]:
    """Links and effects of ``robot`` with each run-time parameter replaced by its value: for ``Robot.at``.

    A float counts as the shortest decimal that is that double, as in a description, so that the numbers are
    exact and are written as they were given. A :class:`~fractions.Fraction` is taken as it is.

    Raises
    ------
    InputError: a parameter is unknown or has no value, a value is not finite, or what it makes of a number of
    the description is refused there too (a negative mass, a Stribeck peak below the Coulomb level).
    """
    values = _values(robot, parameters)
    if not robot.parameters:
        return robot.links, robot.effects
    work = _Filling(robot, values)
    links = tuple(work.link(i, link) for i, link in enumerate(robot.links, 1))
    return links, tuple(map(work.entry, robot.effects))


def parameter_values(robot: Arm, parameters: Mapping[str, Number] | None) -> dict[str, float]:
    """``parameters`` as doubles in the order of the emitted ``NAME_params``, checked as by :func:`filled`.

    Raises
    ------
    InputError: as :func:`filled`.
    """
    filled(robot, parameters or {})
    return {name: float((parameters or {})[name]) for name in robot.parameters}


def without_values(robot: Arm, parameters: Iterable[str]) -> InputError | None:
    """The complaint that run-time parameters of ``robot`` are not among ``parameters``; None: all are."""
    known = set(parameters)
    missing = [name for name in robot.parameters if name not in known]
    if not missing:
        return None
    return InputError(
        f"{robot.name} has run-time parameters without values",
        found=f"no {', '.join(missing)}",
        expected=f"a number for each of {', '.join(robot.parameters)}",
        remedy="on the command line " + " ".join(f"--param {name}=VALUE" for name in missing),
    )


def _values(robot: Arm, parameters: Mapping[str, Number]) -> dict[str, Fraction]:
    unknown = [name for name in parameters if name not in robot.parameters]
    if unknown:
        known = ", ".join(robot.parameters) or "none: it has no run-time parameters"
        what = f"{robot.name} has no such run-time parameter"
        raise InputError(what, found=", ".join(unknown), expected=known, remedy="remove it")
    complaint = without_values(robot, parameters)
    if complaint is not None:
        raise complaint
    return {name: _exact(robot, name, parameters[name]) for name in robot.parameters}


def _exact(robot: Arm, name: str, value: Any) -> Fraction:
    try:
        if math.isfinite(value):
            return Fraction(value) if isinstance(value, (int, Fraction)) else numbers.shortest(value)
    except (TypeError, ValueError, OverflowError):
        pass  # no number, or one beyond double
    raise InputError(
        f"{robot.name}: the value of the run-time parameter {name} is not a number",
        found=repr(value)[: numbers.LENGTH],
        expected="a finite number within double, in the SI unit of what it stands for",
    )


class _Filling:
    """The numbers of one robot at certain values of its parameters."""

    def __init__(self, robot: Arm, values: Mapping[str, Fraction]) -> None:
        self.robot = robot
        self.values = values

    def link(self, i: int, link: Link) -> Link:
        def number(name: str, value: Value) -> Fraction:
            return self._number(f"link {i}: {name}", value, _LINK_KEYS[name])

        names = ("a", "d", "b", "motor_inertia", "viscous", "coulomb")
        numbers_: dict[str, Any] = {name: number(name, getattr(link.joint, name)) for name in names}
        x, y, z = (number("com", value) for value in link.com)
        joint = replace(link.joint, **numbers_)
        inertia = Inertia(*map(number, AXES, link.inertia.entries))
        return replace(link, joint=joint, mass=number("mass", link.mass), com=(x, y, z), inertia=inertia)

    def entry(self, entry: EffectEntry) -> EffectEntry:
        from robodyn.effects.catalogue import CATALOGUE  # not at the top: a rigid arm does without
        from robodyn.robot.effects import keys_of

        revolute = entry.joint is None or self.robot.links[entry.joint - 1].joint.kind == "revolute"
        keys = {key.name: key for key in keys_of(entry.effect, "revolute" if revolute else "prismatic")}
        place = entry.effect if entry.joint is None else f"joint {entry.joint}: {entry.effect}"
        settings = {
            name: self._setting(f"{place}: {name}", value, keys[name]) for name, value in entry.settings
        }
        fault = CATALOGUE[entry.effect].check(settings, revolute)
        if fault and tuple(settings.items()) != entry.settings:
            raise InputError(
                f"{self.robot.name}: {place}: {fault.parameter} {fault.what}",
                found=", ".join(f"{name} = {numbers.brief(value)}" for name, value in self.values.items()),
                expected=fault.expected,
                remedy="other values of the run-time parameters",
            )
        return replace(entry, settings=tuple(settings.items()))

    def _setting(self, path: str, value: Any, key: Key) -> Any:
        if isinstance(value, Affine):
            return self._number(path, value, key)
        if isinstance(value, Inertia):
            entries = zip(AXES, value.entries, strict=True)
            return Inertia(*(self._number(f"{path} {axes}", entry, key) for axes, entry in entries))
        if isinstance(value, tuple):
            return tuple(self._setting(path, part, key) for part in value)
        return value

    def _number(self, path: str, value: Value, key: Key) -> Fraction:
        if isinstance(value, Fraction):
            return value
        total = value.constant + sum((c * self.values[name] for name, c in value.terms), Fraction(0))
        what, expected = "is beyond double", "numbers well below 1e308"
        unit = f" {key.unit.partition(',')[0]}" if key.unit else ""
        fits = allowed(total, key.sign)
        if not fits:
            what, expected = SIGNS[key.sign]
        try:
            numbers.rounded(total)
        except OverflowError:
            fits = False
        if fits:
            return total
        by = ", ".join(f"{name} = {numbers.brief(self.values[name])}" for name, _ in value.terms)
        raise InputError(
            f"{self.robot.name}: {path} {what}",
            found=f"{numbers.brief(total)}{unit} with {by}",
            expected=expected.format(unit=unit),
            remedy=f"another value of {', '.join(name for name, _ in value.terms)}",
        )
