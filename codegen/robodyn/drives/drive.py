"""The drives of an arm: from the rigid arm's torque on a joint to the torque of its motor, over any scalar.

The order in which effects act stands in :mod:`robodyn.effects.effect`. Here a robot is split into a rigid
arm, whose torques any recursion gives, and a :class:`Layer` of drives that is put on top of them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any, NamedTuple

from robodyn.dynamics.arm import scalar_of
from robodyn.dynamics.joints import smoothed_sign
from robodyn.dynamics.state import Rotor
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect, Site
from robodyn.effects.scalars import is_zero
from robodyn.robot.model import EffectEntry, Inertia, Robot
from robodyn.robot.values import ZERO, Affine

Vector = tuple[Any, Any, Any]
_DRIVE = ("link", "bearing", "coupler", "gear", "motor", "pair")
#: Behind the gear there is nothing else.
_LINK_SIDE = ("link", "bearing")


@dataclass(frozen=True, slots=True)
class Acting:
    """An effect with its parameters in the scalars in use."""

    effect: Effect
    values: Mapping[str, Any]

    def torque(self, at: Site) -> Any:
        """What it adds at ``at``."""
        assert self.effect.equation is not None
        return self.effect.equation(self.values, at)


@dataclass(frozen=True, slots=True)
class JointDrive:
    """What lies between a link and its motor: effects by place; rotor inertia, viscous and Coulomb friction
    of the description, where the rigid arm has them not."""

    revolute: bool
    link: tuple[Acting, ...] = ()
    bearing: tuple[Acting, ...] = ()
    coupler: Acting | None = None
    gear: tuple[Acting, ...] = ()
    motor: tuple[Acting, ...] = ()
    rotor: Any = 0
    viscous: Any = 0
    coulomb: Any = 0

    @property
    def memories(self) -> tuple[Acting, ...]:
        """Motor-side effects with a state."""
        return tuple(acting for acting in self.motor if acting.effect.memory is not None)


@dataclass(frozen=True, slots=True)
class Pair:
    """A motor that turns with joint ``one`` and, by ``ratio``, with joint ``other`` (from 0)."""

    one: int
    other: int
    ratio: Any
    acting: Acting


@dataclass(frozen=True, slots=True)
class Layer:
    """The drives of all joints, and the motors that drive two."""

    joints: tuple[JointDrive, ...]
    pairs: tuple[Pair, ...] = ()

    @property
    def needs_reactions(self) -> tuple[int, ...]:
        """Joints (from 0) whose bearings feel force and moment, not only the torque."""
        return tuple(
            i
            for i, drive in enumerate(self.joints)
            if any(acting.values["bearing"] != "torque" for acting in drive.bearing)
        )

    @property
    def is_affine(self) -> bool:
        """Whether torques are affine in accelerations: no friction depends on the load."""
        return not any(drive.bearing or drive.gear for drive in self.joints)

    def rotors(self) -> list[Rotor]:
        """The rotors that are here and not in :func:`rigid_part`."""
        own = [
            Rotor(drive.rotor, ((i, 1),)) for i, drive in enumerate(self.joints) if not is_zero(drive.rotor)
        ]
        shared = [
            Rotor(pair.acting.values["inertia"], ((pair.one, 1), (pair.other, pair.ratio)))
            for pair in self.pairs
            if not is_zero(pair.acting.values["inertia"])
        ]
        return own + shared

    @property
    def state_names(self) -> tuple[str, ...]:
        """Names of the states of the inverse dynamics, joint by joint."""
        names: list[str] = []
        for i, drive in enumerate(self.joints, 1):
            if drive.coupler is not None:
                names += [f"twist{i}", f"twist_rate{i}", f"twist_acceleration{i}"]
            for acting in drive.memories:
                assert acting.effect.memory is not None
                names += [f"{name}{i}" for name in acting.effect.memory.names]
        return tuple(names)


@dataclass(frozen=True, slots=True)
class Loads:
    """What the rigid arm puts on its joints: torques ``tau`` [n]; force ``f`` and moment ``n`` by joint (from
    0), where they are known."""

    tau: Sequence[Any]
    f: Mapping[int, Vector] = field(default_factory=dict)
    n: Mapping[int, Vector] = field(default_factory=dict)


class Rates(NamedTuple):
    """Positions, velocities and accelerations [n] of one side of the drives, and directions of motion."""

    q: Sequence[Any]
    qd: Sequence[Any]
    qdd: Sequence[Any]
    direction: Sequence[Any]


def has_drive_effects(robot: Robot) -> bool:
    """Whether torques depend on more than the rigid arm, rotors, viscous and Coulomb friction."""
    return any(_acts(robot, entry) for entry in robot.effects)


def _acts(robot: Robot, entry: EffectEntry) -> bool:
    place = CATALOGUE[entry.effect].place
    return place in (_DRIVE if robot.torque_side == "motor" else _LINK_SIDE)


def rigid_part(robot: Robot, *, bare: bool = False) -> Robot:
    """``robot`` without the effects of its drives, the payload kept.

    Rotor, viscous and Coulomb friction stay where nothing comes between them and the link; with ``bare``
    nowhere.
    """
    between = _parted(robot)
    links = tuple(
        replace(link, joint=replace(link.joint, motor_inertia=ZERO, viscous=ZERO, coulomb=ZERO))
        if bare or i in between
        else link
        for i, link in enumerate(robot.links, 1)
    )
    kept = tuple(entry for entry in robot.effects if entry.definition.traits.body)
    return replace(robot, links=links, effects=kept)


def _parted(robot: Robot) -> set[int | None]:
    """The joints where something comes between motor and link."""
    return {
        entry.joint
        for entry in robot.effects
        if CATALOGUE[entry.effect].place in ("bearing", "coupler", "gear")
    }


def layer_of(
    robot: Robot,
    constant: Callable[[Fraction], Any],
    parameter: Callable[[str], Any],
    *,
    bare: bool = False,
) -> Layer:
    """The drives that :func:`rigid_part` leaves out, ``constant`` applied to constants."""

    def scalar(value: Any) -> Any:
        if isinstance(value, Affine | Fraction):
            return scalar_of(value, constant, parameter)
        if isinstance(value, Inertia):
            return value
        return tuple(scalar(x) for x in value) if isinstance(value, tuple) else value

    def acting(entry: EffectEntry) -> Acting:
        values = {name: scalar(value) for name, value in entry.settings}
        return Acting(CATALOGUE[entry.effect], values)

    motor = robot.torque_side == "motor"
    between = _parted(robot)
    joints: list[JointDrive] = []
    pairs: list[Pair] = []
    for i, link in enumerate(robot.links, 1):
        by_place: dict[str, list[Acting]] = {place: [] for place in _DRIVE}
        for entry in robot.effects_at(i):
            if _acts(robot, entry):
                by_place[CATALOGUE[entry.effect].place].append(acting(entry))
        joint = link.joint
        drive = (joint.motor_inertia, joint.viscous, joint.coulomb)
        numbers = drive if motor and (bare or i in between) and any(drive) else (0, 0, 0)
        joints.append(
            JointDrive(
                joint.kind == "revolute",
                tuple(by_place["link"]),
                tuple(by_place["bearing"]),
                by_place["coupler"][0] if by_place["coupler"] else None,
                tuple(by_place["gear"]),
                tuple(by_place["motor"]),
                *map(scalar, numbers),
            )
        )
        for pair in by_place["pair"]:
            pairs.append(Pair(i - 1, pair.values["with"] - 1, pair.values["ratio"], pair))
    return Layer(tuple(joints), tuple(pairs))


# --- torques ----------------------------------------------------------------------------------------------


def passed_on(layer: Layer, loads: Loads, link: Rates) -> list[Any]:
    """Torques [n] that the links ask of their drives: the rigid arm's, springs, bearings."""
    torques: list[Any] = []
    for i, drive in enumerate(layer.joints):
        at = _site(drive, link, i)
        total = loads.tau[i]
        for acting in drive.link:
            total = total + acting.torque(at)
        loaded = replace(at, tau=total, f=loads.f.get(i, (0, 0, 0)), n=loads.n.get(i, (0, 0, 0)))
        torques.append(_sum(total, [acting.torque(loaded) for acting in drive.bearing]))
    return torques


def at_motors(
    layer: Layer,
    passed: Sequence[Any],
    motor: Rates,
    pair_directions: Sequence[Any],
    remembered: Mapping[int, Sequence[Any]] | None = None,
) -> list[Any]:
    """Torques [n] of the motors, of the torques ``passed`` on to the drives.

    ``remembered`` gives by joint the torques of stateful effects; without it they are at their steady
    values.
    """
    torques: list[Any] = []
    for i, drive in enumerate(layer.joints):
        at = replace(_site(drive, motor, i), tau=passed[i])
        total = _sum(passed[i], [acting.torque(at) for acting in drive.gear])
        if not is_zero(drive.rotor) and not is_zero(motor.qdd[i]):
            total = total + drive.rotor * motor.qdd[i]
        if not is_zero(motor.qd[i]):
            if not is_zero(drive.viscous):
                total = total + drive.viscous * motor.qd[i]
            if not is_zero(drive.coulomb):
                total = total + drive.coulomb * motor.direction[i]
        for acting in drive.motor:
            if acting.effect.memory is None or remembered is None:
                total = total + acting.torque(at)
        torques.append(_sum(total, list((remembered or {}).get(i, ()))))
    for pair, direction in zip(layer.pairs, pair_directions, strict=True):
        site = Site(
            revolute=layer.joints[pair.one].revolute,
            qd=combined(pair, motor.qd),
            qdd=combined(pair, motor.qdd),
            direction=direction,
        )
        shared = pair.acting.torque(site)
        torques[pair.one] = torques[pair.one] + shared
        torques[pair.other] = torques[pair.other] + pair.ratio * shared
    return torques


def combined(pair: Pair, rates: Sequence[Any]) -> Any:
    """What the motor of ``pair`` makes of the rates of its two joints."""
    return rates[pair.one] + pair.ratio * rates[pair.other]


def _site(drive: JointDrive, rates: Rates, i: int) -> Site:
    return Site(drive.revolute, rates.q[i], rates.qd[i], rates.qdd[i], rates.direction[i])


def _sum(first: Any, rest: Sequence[Any]) -> Any:
    for term in rest:
        first = first + term
    return first


def directions(robot: Robot, qd: Sequence[Any], constant: Callable[[Fraction], Any]) -> list[Any]:
    """Directions of motion [n] as ``friction_at_rest`` has them."""
    rest = None if robot.rest_velocity is None else constant(robot.rest_velocity)
    band = None if robot.dead_band is None else constant(robot.dead_band)
    return [0 if is_zero(v) else smoothed_sign(v, rest, band) for v in qd]
