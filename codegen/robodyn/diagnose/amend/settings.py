"""Parameters of amendments: read by the catalogue, summed with an entry, held to their bounds."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from robodyn.diagnose.amend.combined import significant, total
from robodyn.effects.effect import Effect, Parameter
from robodyn.errors import InputError
from robodyn.robot.effects import default_of
from robodyn.robot.model import AXES, Inertia, Robot, Setting
from robodyn.robot.values import ZERO, Affine


def read_settings(effect: Effect, parameters: Mapping[str, Any], joints: int) -> dict[str, Any]:
    """Those parameters that are ``parameters``, numbers rounded to six digits; vectors and tensors may be
    given by their entries (``com_x``; ``xx`` or ``inertia_xx``).

    Raises
    ------
    InputError: one of them is not the effect's, or not of its kind.
    """
    known = {p.name: p for p in effect.parameters}
    values: dict[str, Any] = {}
    for name, value in parameters.items():
        path = f"{effect.id}: {name}"
        if name in known:
            values[name] = _setting(known[name], value, path, joints)
        elif "com" in known and name in ("com_x", "com_y", "com_z"):
            com = list(values.get("com", (ZERO,) * 3))
            com["xyz".index(name[-1])] = _number(value, path)
            values["com"] = tuple(com)
        elif "inertia" in known and name.removeprefix("inertia_") in AXES:
            entries = {axes: getattr(values.get("inertia", Inertia()), axes) for axes in AXES}
            values["inertia"] = Inertia(**{**entries, name.removeprefix("inertia_"): _number(value, path)})
        else:
            raise InputError(f"{path}: no such parameter", expected=f"one of {', '.join(known)}")
    return values


def _setting(parameter: Parameter, value: Any, path: str, joints: int) -> Setting:
    kind = parameter.kind
    if kind in ("choice", "text"):
        if not isinstance(value, str) or (kind == "choice" and value not in parameter.choices):
            expected = " or ".join(parameter.choices) if kind == "choice" else "text"
            raise InputError(f"{path}: not what may stand there", found=repr(value), expected=expected)
        return value
    if kind == "joint":
        finite = _number(value, path)
        if finite.denominator != 1 or not 1 <= finite <= joints:
            raise InputError(f"{path}: no such joint", found=repr(value), expected=f"1 to {joints}")
        return int(finite)
    if kind == "vector":
        x, y, z = (_number(part, path) for part in value)
        return x, y, z
    if kind == "efficiency" and not isinstance(value, (int, float)):
        return tuple((_number(load, path), _number(share, path)) for load, share in value)
    if kind == "inertia":
        return Inertia(**{axes: _number(part, path) for axes, part in value.items()})
    return _number(value, path)


def _number(value: Any, path: str) -> Fraction:
    try:
        return significant(float(value))
    except (TypeError, ValueError, OverflowError):
        raise InputError(f"{path}: not a number", found=repr(value), expected="a finite number") from None


def summed(effect: Effect, old: Mapping[str, Any], added: Mapping[str, Any]) -> dict[str, Any]:
    """The settings ``old`` with what is ``added``: added where the effect is linear in it, else
    in its place."""
    values = dict(old)
    for name, value in added.items():
        adds = name in effect.linear or name in effect.traits.adds
        values[name] = total(old[name], value) if adds and name in old else value
    if "rated_torque" in values and not isinstance(values["efficiency"], tuple):
        del values["rated_torque"]
    return values


def checked(
    effect: Effect,
    joint: int | None,
    values: Mapping[str, Any],
    robot: Robot,
    remarks: list[str],
    *,
    bounds: bool = True,
) -> tuple[tuple[str, Setting], ...]:
    """The settings of an entry, in the catalogue's order with all defaults; what must not be negative is 0
    where it would be, and ``remarks`` say so. Without ``bounds`` nothing is held to them.

    Raises
    ------
    InputError: a parameter is missing, or the catalogue does not allow such values.
    """
    where = effect.id if joint is None else f"joint {joint}: {effect.id}"
    settings: dict[str, Any] = {}
    for p in effect.parameters:
        value = values.get(p.name, default_of(p))
        if value is None:
            if p.required:
                raise InputError(f"{where}: {p.name} is missing", expected=p.doc)
            continue
        settings[p.name] = _bounded(p, value, where, remarks) if bounds else value
    if not bounds:
        return tuple(settings.items())
    low, high = settings.get("level"), settings.get("static")
    if isinstance(low, Fraction) and isinstance(high, Fraction) and high < low:
        remarks.append("the static level would be below the Coulomb level, and is that instead")
        settings["static"] = low
    if joint is not None and settings.get("with") == joint:
        raise InputError(f"{where}: with names the joint itself", found=str(joint))
    revolute = joint is None or robot.links[joint - 1].joint.kind == "revolute"
    fault = effect.check(settings, revolute)
    if fault:
        raise InputError(f"{where}: {fault.parameter} {fault.what}", expected=fault.expected)
    return tuple(settings.items())


def _bounded(p: Parameter, value: Any, where: str, remarks: list[str]) -> Any:
    if p.sign == "any" or isinstance(value, Affine):
        return value
    if p.sign == "nonnegative":
        if value < 0:
            remarks.append(f"the sum of {p.name} would be {float(value):.3g}, and is 0 instead")
        return max(value, ZERO)
    shares = [share for _, share in value] if isinstance(value, tuple) else [value]
    if min(shares) <= 0 or (p.sign == "share" and max(shares) > 1):
        expected = "more than 0" + (" and at most 1" if p.sign == "share" else "")
        raise InputError(f"{where}: {p.name} is out of range", found=f"{value}", expected=expected)
    return value
