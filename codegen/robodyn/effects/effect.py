"""What an effect is: parameters, equation, where it acts, how it shows, what it is mistaken for.

An effect is defined once. Its equation is a function of numbers of any kind (:mod:`.scalars`): emitted as C,
simulated, fitted, typeset.

A joint's drive, from the link to the motor, is where most effects act; each adds something::

    tau   = torque of the rigid arm on the joint (n_z, at a prismatic joint f_z)
    tau  += LINK effects     (spring)                        link side, q and qd of the link
    tau  += BEARING effects  (load-dependent friction)       link side, with the forces in the joint
    (COUPLER effects: between link and motor lies a spring or backlash; else they move alike)
    tau  += GEAR effects     (transmission loss)             with the torque that the gear passes on
    tau  += rotor inertia times acceleration, MOTOR effects  motor side

All are reflected to the joint's side of the gear.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any, Literal

from robodyn.effects.traits import Site as Site
from robodyn.effects.traits import Traits

#: What a parameter is: a number, three numbers, an efficiency (number or table), an inertia tensor, one of
#: some words, or the number of another joint.
ParameterKind = Literal["number", "vector", "efficiency", "inertia", "choice", "joint", "text"]
Sign = Literal["any", "nonnegative", "positive", "share"]
#: Where in the drive an effect acts; "sensor": on what is measured; "rigid": it changes the rigid arm;
#: "outside": it is reported and simulated, and in no kernel.
Place = Literal["link", "bearing", "coupler", "gear", "motor", "pair", "sensor", "rigid", "outside"]
Level = Literal["joint", "pair", "robot"]
Values = Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class Parameter:
    """One parameter. ``unit`` and ``linear_unit`` are for revolute and prismatic joints. ``default`` None: it
    must be given; ``optional``: it may be left out, and then is not there. ``names``: the name of a run-time
    parameter may stand for it."""

    name: str
    doc: str
    unit: str = ""
    linear_unit: str | None = None
    kind: ParameterKind = "number"
    sign: Sign = "any"
    default: Fraction | str | None = None
    optional: bool = False
    names: bool = False
    choices: tuple[str, ...] = ()
    symbol: str = ""

    @property
    def required(self) -> bool:
        """Whether an entry must have it."""
        return self.default is None and not self.optional

    def unit_at(self, *, revolute: bool) -> str:
        """Its unit at a revolute or a prismatic joint."""
        return self.unit if revolute or self.linear_unit is None else self.linear_unit


#: The torque that an effect adds, of its parameters and its site.
Equation = Callable[[Values, Site], Any]


@dataclass(frozen=True, slots=True)
class Memory:
    """The states of an effect that remembers: how many, and how they move on.

    ``step(p, site, state, dt)``: the states after ``dt`` of steady motion, and the torque at its end;
    ``rates(p, site, state)``: their time derivatives; ``torque(p, site, state)``: the torque at a state.
    Over any scalar.
    """

    names: tuple[str, ...]
    step: Callable[[Values, Site, tuple[Any, ...], Any], tuple[tuple[Any, ...], Any]]
    rates: Callable[[Values, Site, tuple[Any, ...]], tuple[Any, ...]]
    torque: Callable[[Values, Site, tuple[Any, ...]], Any]


@dataclass(frozen=True, slots=True)
class Coupler:
    """What lies between link and motor, as a spring: ``twist`` (motor less link) of the torque that it
    passes on at rest, and the ``torque`` of twist and its rate; the two are each other's inverse.
    ``lag`` of the parameters and that torque: the time [s] with which damping lets the twist follow."""

    twist: Callable[[Values, Any], Any]
    torque: Callable[[Values, Any, Any], Any]
    lag: Callable[[Values, Any], Any]
    energy: Callable[[Values, Any], Any]


@dataclass(frozen=True, slots=True)
class Fault:
    """What is wrong with the values of an entry: at which parameter, what, what was expected, what to do."""

    parameter: str
    what: str
    expected: str
    remedy: str


def _no_fault(values: Values, revolute: bool) -> Fault | None:
    return None


@dataclass(frozen=True, slots=True)
class Effect:
    """One entry of the catalogue.

    ``equation`` gives the torque of an effect of the drive; of one with ``memory`` or ``coupler``, what it
    comes to in steady motion; ``potential`` is the energy [J] over position of a torque that has one.
    ``linear`` are the parameters that it is linear in, ``dissipative`` says that it never feeds energy in.
    ``signature`` says how a log shows it, ``rivals`` what else may look like it, ``separates`` what to record
    to tell them apart. ``traits`` hold what the other rooms ask of it.
    """

    id: str
    title: str
    place: Place
    parameters: tuple[Parameter, ...]
    latex: str
    doc: str
    signature: str
    rivals: tuple[str, ...]
    separates: str
    source: str
    level: Level = "joint"
    equation: Equation | None = None
    memory: Memory | None = None
    coupler: Coupler | None = None
    potential: Callable[[Values, Any], Any] | None = None
    check: Callable[[Values, bool], Fault | None] = _no_fault
    linear: tuple[str, ...] = ()
    dissipative: bool = False
    needs_load: bool = False
    traits: Traits = field(default_factory=Traits)

    @property
    def kind(self) -> str:
        """``algebraic``, ``state``, ``sensor``, ``rigid`` or ``outside``: how it enters kernels."""
        if self.memory is not None or self.coupler is not None:
            return "state"
        return {"sensor": "sensor", "rigid": "rigid", "outside": "outside"}.get(self.place, "algebraic")

    def is_dry(self, values: Values, revolute: bool) -> bool:
        """Whether its torque follows the direction of motion, however slow that is, so that it may hold a
        joint at rest. (What remembers is held by its states.)"""
        if self.equation is None or self.memory is not None:
            return False
        one, two, three = Fraction(1), Fraction(2), Fraction(3)
        forth = Site(revolute, one, one / 8, one, one, two, (one, two, three), (three, one, two))
        return bool(self.equation(values, forth) != self.equation(values, replace(forth, direction=-one)))

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the parameters."""
        return tuple(p.name for p in self.parameters)
