"""The arm with its new numbers, each with its uncertainty, and what the logs could not see."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence, Set
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import numpy as np

from robodyn.arrays import Floats
from robodyn.effects.catalogue import CATALOGUE
from robodyn.identify.combined import combinations_of
from robodyn.identify.consistent import inside
from robodyn.identify.fit import Fit
from robodyn.identify.limits import KEPT_SHARE, MARGIN, UNSEEN_SHARE
from robodyn.identify.problem import Unknowns
from robodyn.kernels.array_dynamics import physical
from robodyn.robot.model import AXES, EffectEntry, Inertia, Link, Robot
from robodyn.robot.values import ZERO

#: By the name of a joint's column the key of the joint that holds it, or what a sensor's effect does.
_KEYS = {"viscous": "viscous", "coulomb": "coulomb", "rotor": "motor_inertia"}
#: By the name of a column what its effect does to a channel, where that is called otherwise.
_ACTS = {"offset": "bias"}
_LINK = ("mass", "com_x", "com_y", "com_z", *(f"inertia_{axes}" for axes in AXES))
_UNITS = ("kg", "m", "m", "m", *["kg m^2"] * 6)


@dataclass(frozen=True, slots=True)
class Estimate:
    """A number of an arm, SI: its ``value``, what its description says (``described``), its standard error,
    None where the logs do not see it; whether logs show it ``only_in_combination`` with others, so that alone
    it rests on the description too."""

    value: float
    described: float
    stderr: float | None
    unit: str
    only_in_combination: bool = False


@dataclass(frozen=True, slots=True)
class Combined:
    """A sum of numbers that logs show, by its ``expression``; of its ``unit``, with its standard error."""

    expression: str
    value: float
    stderr: float
    unit: str


@dataclass(frozen=True, slots=True, eq=False)
class Identified:
    """``robot`` with its new numbers, physically consistent; ``origins``: of each of its effects the index
    among those of the description, None where it is new; ``parameters`` by their names (``link3.mass``);
    ``not_identifiable``: those that the logs say no more of than the description did; ``combinations``: what
    logs show, number by number or as sums."""

    robot: Robot
    origins: tuple[int | None, ...]
    parameters: Mapping[str, Estimate]
    not_identifiable: tuple[str, ...]
    combinations: tuple[Combined, ...]


def identified(fit: Fit) -> Identified:
    """The arm that a fit has found."""
    robot, unknowns, z = fit.robot, fit.unknowns, fit.solution.z
    links = [_with_friction(fit, j, _link(fit, j)) for j in range(robot.n)]
    entries: list[tuple[int | None, EffectEntry]] = list(enumerate(robot.effects))
    sensors: list[tuple[str, Floats]] = [("gain", unknowns.scales(z) - 1)]
    if "offset" in fit.layout.own:
        sensors.append(("bias", z[fit.layout.joint("offset")] * unknowns.scales(z)))
    for acts, values in sensors:
        for j in np.flatnonzero(values).tolist():
            _sensor(entries, acts, j + 1, float(values[j]))
    entries.sort(key=lambda one: (one[1].joint is None, one[1].joint or 0))
    target = replace(robot, links=tuple(links), effects=tuple(entry for _, entry in entries))
    if robot.torque_side == "link" and any(link.joint.viscous or link.joint.coulomb for link in links):
        # The torque behind the gear has friction in it after all; rotors it has not.
        still = [replace(link, joint=replace(link.joint, motor_inertia=ZERO)) for link in target.links]
        target = replace(target, torque_side="motor", links=tuple(still))
    sums, (names, units) = combinations_of(fit), _places(fit)
    shared = {place for one in sums if len(one.terms) > 1 for place, _ in one.terms}
    numbers, unseen = _numbers(fit, shared)
    combined = tuple(
        Combined(one.expression(names), one.value, one.stderr, units[one.terms[0][0]]) for one in sums
    )
    return Identified(target, tuple(origin for origin, _ in entries), numbers, tuple(unseen), combined)


# --- the arm ----------------------------------------------------------------------------------------------


def _link(fit: Fit, k: int) -> Link:
    """The link ``k`` (from 0) with its new mass, centre and inertia; as it was where little is new."""
    link, at = fit.robot.links[k], fit.layout.link(k)
    old, new, sd = fit.unknowns.mean[at], fit.solution.z[at], fit.unknowns.sd[at]
    if np.all(np.abs(new - old) <= KEPT_SHARE * sd):
        return link
    if not fit.unknowns.rigid[k]:
        inertia = replace(link.inertia, zz=_fraction(float(new[4 + AXES.index("zz")])))
        return replace(link, inertia=inertia)
    mass, length = fit.unknowns.sizes[k]
    # A trifle inside of what is possible: rounding must not lead out of it.
    numbers = physical(inside(new, mass, length, MARGIN))
    x, y, z = (_fraction(value) for value in numbers[1:4])
    inertia = Inertia(*(_fraction(value) for value in numbers[4:]))
    return replace(link, mass=_fraction(numbers[0]), com=(x, y, z), inertia=inertia, acknowledged="")


def _with_friction(fit: Fit, j: int, link: Link) -> Link:
    """``link`` with the new friction and rotor of its joint ``j`` (from 0)."""
    joint = link.joint
    changes: dict[str, Any] = {}
    for name, key in _KEYS.items():
        if name not in fit.layout.own:
            continue
        at = fit.layout.joint(name)[j]
        value = float(fit.solution.z[at])
        if fit.unknowns.free[at] and abs(value - fit.unknowns.mean[at]) > KEPT_SHARE * fit.unknowns.sd[at]:
            least = KEPT_SHARE * fit.unknowns.sd[at]
            changes[key] = _fraction(value) if value > least else ZERO
    return replace(link, joint=replace(joint, **changes))


def _sensor(entries: list[tuple[int | None, EffectEntry]], acts: str, joint: int, added: float) -> None:
    """``entries`` with what the torque channel of a ``joint`` does beyond what is known of it."""
    effect = next(e for e in CATALOGUE.values() if e.traits.channel and e.traits.channel.acts == acts)
    assert effect.traits.channel is not None
    name = effect.traits.channel.parameter
    for k, (origin, entry) in enumerate(entries):
        if entry.effect == effect.id and entry.joint == joint:
            old = entry.number(name)
            both = (1 + old) * (1 + added) - 1 if acts == "gain" else old + added
            settings = tuple(
                (key, _fraction(both) if key == name else value) for key, value in entry.settings
            )
            entries[k] = (origin, replace(entry, settings=settings))
            return
    entries.append((None, EffectEntry(effect.id, joint, ((name, _fraction(added)),))))


def _fraction(value: float) -> Fraction:
    """The number with nine digits."""
    return Fraction(f"{value:.9g}")


# --- the numbers ------------------------------------------------------------------------------------------


def _places(fit: Fit) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """What is fitted [p], by name, and units; moments are about the origin of the link's frame."""
    unknowns, names, units = fit.unknowns, [""] * fit.unknowns.size, [""] * fit.unknowns.size
    first = ("mass", "mass*com_x", "mass*com_y", "mass*com_z", *(f"frame_inertia_{axes}" for axes in AXES))
    for k in range(len(unknowns.sizes)):
        for at, name, unit in zip(
            unknowns.body(k), first, ("kg", *["kg m"] * 3, *["kg m^2"] * 6), strict=True
        ):
            names[at], units[at] = f"{_word(fit, k)}.{name}", unit
    own = {name: fit.layout.joint(name) for name in fit.layout.own} | {"gain": unknowns.gain}
    for name, places in own.items():
        for j, at in enumerate(places.tolist()):
            label, units[at] = _label(name, fit.robot.links[j].joint.kind == "revolute")
            names[at] = f"joint{j + 1}.{label}"
    return tuple(names), tuple(units)


def _word(fit: Fit, k: int) -> str:
    """What the body ``k`` (from 0) is called."""
    return f"link{k + 1}" if k < fit.layout.n else f"load{k - fit.layout.n + 1}"


def _numbers(fit: Fit, shared: Set[int]) -> tuple[dict[str, Estimate], list[str]]:
    """All numbers by name, and the names of those that the logs do not see; ``shared``: places of those that
    show only with others."""
    numbers: dict[str, Estimate] = {}
    unseen: list[str] = []
    unknowns, z = fit.unknowns, fit.solution.z
    prior = np.diag(unknowns.sd**2)

    def put(name: str, figures: Sequence[float], unit: str, at: Iterable[int], known: bool = False) -> None:
        value, described, error, before = figures
        seen = error < UNSEEN_SHARE * before or known
        together = not known and not shared.isdisjoint(at)
        numbers[name] = Estimate(value, described, error if seen else None, unit, together)
        if not seen:
            unseen.append(name)

    for k in range(len(unknowns.sizes)):
        at = unknowns.body(k)
        word = _word(fit, k)
        if not unknowns.rigid[k]:
            at = at[[4 + AXES.index("zz")]]
            error = math.sqrt(float(fit.covariance[at[0], at[0]]))
            alone = (float(z[at[0]]), float(unknowns.mean[at[0]]), error, float(unknowns.sd[at[0]]))
            put(f"{word}.inertia_zz", alone, "kg m^2", at.tolist())
            continue
        described = physical(unknowns.mean[at])
        # A mass of which logs leave next to nothing has its centre anywhere: no error of it is a number.
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
            values, slopes = physical(z[at]), _slopes(z[at], unknowns, k)
            after = np.sqrt(np.maximum(np.diag(slopes @ fit.covariance[np.ix_(at, at)] @ slopes.T), 0))
            before = np.sqrt(np.diag(slopes @ prior[np.ix_(at, at)] @ slopes.T))
        figures = np.stack([values, described, after, before], axis=1).tolist()
        for i, (name, one, unit) in enumerate(zip(_LINK, figures, _UNITS, strict=True)):
            stated = k >= fit.layout.n and name == "mass" and one[1] > 0  # of a load: as good as it is
            needs = at[[0]] if i == 0 else at[[0, i]] if i < 4 else at
            put(f"{word}.{name}", one, unit, needs.tolist(), known=stated)
    laws = {entry.joint for entry in fit.robot.effects if entry.joint and entry.definition.traits.levels}
    for name in fit.layout.own:
        for j, at in enumerate(fit.layout.joint(name).tolist()):
            free = unknowns.free[at]
            if not free and (name == "offset" or (name == "coulomb" and j + 1 in laws)):
                continue
            label, unit = _label(name, fit.robot.links[j].joint.kind == "revolute")
            spread = float(unknowns.sd[at])
            error = math.sqrt(float(fit.covariance[at, at])) if free else spread
            put(f"joint{j + 1}.{label}", (float(z[at]), float(unknowns.mean[at]), error, spread), unit, [at])
    for j, at in enumerate(unknowns.gain.tolist()):
        label, unit = _label("gain", revolute=True)
        error = math.sqrt(float(fit.covariance[at, at]))
        put(f"joint{j + 1}.{label}", (float(z[at]), 0.0, error, float(unknowns.sd[at])), unit, [at])
    return numbers, unseen


def _slopes(phi: Floats, unknowns: Unknowns, k: int) -> Floats:
    """How mass, centre and inertia [10] change with standard parameters [10]."""
    mass, length = unknowns.sizes[k]
    size = np.array([mass, *[mass * length] * 3, *[mass * length**2] * 6])
    step = 1e-6 * max(min(1.0, float(phi[0]) / mass), 1e-6)
    columns = []
    for axis in np.diag(step * size):
        columns.append((physical(phi + axis) - physical(phi - axis)) / (2 * axis.sum()))
    return np.stack(columns, axis=1)


def _label(name: str, revolute: bool) -> tuple[str, str]:
    """What a joint's number is called, ``effect.parameter``, and its unit."""
    for effect in CATALOGUE.values():
        fold, channel = effect.traits.fold, effect.traits.channel
        if fold is not None and fold.into == "joint" and fold.key == _KEYS.get(name):
            parameter = fold.parameter
        elif channel is not None and channel.acts == _ACTS.get(name, name):
            parameter = channel.parameter
        else:
            continue
        unit = next(p.unit_at(revolute=revolute) for p in effect.parameters if p.name == parameter)
        return f"{effect.id}.{parameter}", unit
    raise KeyError(name)
