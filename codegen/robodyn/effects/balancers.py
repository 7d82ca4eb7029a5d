"""Springs that take gravity off a joint: between a pivot on the link and one on the link before it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from robodyn.effects.effect import Effect, Fault, Parameter, Site, Values
from robodyn.effects.friction import FORCE, TORQUE
from robodyn.effects.scalars import cosine, is_zero, root, sine
from robodyn.effects.traits import Form, Hidden, Law, Traits, Usual

#: Where these stand among the others, for a person who reads them.
ORDER = 45

#: Crank by distance of the fixed pivot, of the gas springs at the second joint of large arms (KUKA KR300).
_RATIO = Fraction(1, 4)
#: A pivot nearer to the other one would make the lever's direction uncertain.
_LARGEST_RATIO = Fraction(19, 20)
#: An angle [rad] beyond this would take digits from the position that it is taken from.
_LARGEST_ANGLE = 1000
#: Dead centres [rad] that are tried, a turn ahead so that a step of refinement is a factor.
_TURNS = tuple(2 * math.pi * (1 + k / 24) for k in range(24))
#: The steepest rise that is tried: the pressure of a gas spring hardly doubles over its stroke.
_MOST_RISE = 0.8
#: A spring that takes a smaller share of gravity's torque off its joint (RMS) is no counterbalance: along
#: motions of a KUKA KR300 with its payload its gas spring takes about 0.3.
_RELIEF = 0.2


def _lever(p: Values, q: Any) -> tuple[Any, Any, Any]:
    """Sine of the crank's angle, length (1: the distance of the fixed pivot from the axis), and travel from
    the dead centre (1: a crank); no digits are lost near the dead centre."""
    angle, ratio = q - p["dead_center"], p["ratio"]
    c = cosine(angle)
    if is_zero(ratio):
        return sine(angle), 1, 1 - c
    length = root(1 + ratio * ratio - 2 * ratio * c)
    return sine(angle), length, 2 * (1 - c) / (length + (1 - ratio))


def _balance(p: Values, at: Site) -> Any:
    s, length, travel = _lever(p, at.q)
    torque = p["torque"] if is_zero(p["rise"]) else p["torque"] * (1 + p["rise"] * travel)
    return torque * s / length


def _balance_energy(p: Values, q: Any) -> Any:
    _, _, travel = _lever(p, q)
    return p["torque"] * (travel + p["rise"] * (travel * travel) / 2)


def _fault(p: Values, revolute: bool) -> Fault | None:
    if not revolute:
        return Fault("torque", "is of a crank, which a prismatic joint does not have", "a revolute joint",
                     "use spring")  # fmt: skip
    if isinstance(p["dead_center"], Fraction) and abs(p["dead_center"]) > _LARGEST_ANGLE:
        return Fault("dead_center", "is so many turns that a position less it loses its digits",
                     "-1000 to 1000 rad", "take whole turns off")  # fmt: skip
    if abs(p["ratio"]) > _LARGEST_RATIO:
        return Fault("ratio", "is that of pivots that nearly meet", "-0.95 to 0.95", "see docs/effects.md")
    return None


def _turned(angle: float) -> float:
    """The same angle from -pi to pi."""
    return math.remainder(angle, 2 * math.pi)


def _shape(values: Mapping[str, float]) -> dict[str, float]:
    return {"dead_center": _turned(values["turn"]), "ratio": values["ratio"]}


def _columns(values: Mapping[str, float], at: Site) -> Sequence[Any]:
    s, length, travel = _lever(_shape(values), at.q)
    constant = s / length
    return constant, (1 + _MOST_RISE * travel) * constant


def _read(x: Sequence[float], values: Mapping[str, float]) -> dict[str, float | str]:
    torque = float(x[0] + x[1])
    return {"torque": torque, "rise": _MOST_RISE * float(x[1]) / torque if torque else 0.0, **_shape(values)}


def _form(u: Usual, way: float, rng: Any) -> Form:
    center = _turned(u.upright + way * rng.uniform(0.0, 0.2))
    ratio, rise = float(rng.uniform(0.15, 0.35)), float(rng.uniform(0.0, 0.5))
    return Form(
        lambda x: {"torque": x, "rise": rise, "dead_center": center, "ratio": ratio},
        0.6 * u.gravity or u.tau, 0.4 * u.gravity or 0.1 * u.tau,
    )  # fmt: skip


GAS_SPRING = Effect(
    id="gas_spring",
    title="Gas spring or spring balancer",
    place="link",
    parameters=(
        Parameter(
            "torque", "Its force at the dead centre times the crank's length.", TORQUE, FORCE,
            sign="nonnegative", names=True, symbol="T",
        ),
        Parameter(
            "dead_center", "Position at which the pivots and the axis lie in a line and the spring holds the "
            "joint.", "rad", default=Fraction(0), names=True, symbol="q_0",
        ),
        Parameter(
            "rise", "Share by which its force grows over a travel of one crank.", "1", sign="nonnegative",
            default=Fraction(0), symbol="c",
        ),
        Parameter(
            "ratio", "Crank (axis to the moving pivot) by distance of axis and fixed pivot; negative where "
            "the spring pushes, and then the crank points away at the dead centre.", "1", default=_RATIO,
            symbol=r"\rho",
        ),
    ),
    latex=r"\tau = \frac{T (1 + c s) \sin\delta}{\lambda}, \quad \delta = q - q_0, \quad "
    r"\lambda = \sqrt{1 + \rho^2 - 2 \rho \cos\delta}, \quad "
    r"s = \frac{2 (1 - \cos\delta)}{\lambda + 1 - \rho}",
    doc="A strut between a pivot on the link and one on the link before it that takes gravity off a revolute "
    "joint: lambda is its length by the distance of the fixed pivot, s its travel by the crank. The force "
    "rises with the travel by a straight line; that of a gas bends up from it, by 5 % when the gas is "
    "a fifth smaller. From a data sheet: torque is preload times "
    "crank; rise is crank times the spring's rate by its preload, of a gas spring crank times piston area by "
    "gas volume. A spring whose force grows from zero with its length has a ratio of 0 and no rise.",
    signature="depends on the joint's own position and on nothing else; against gravity, with the shape of a "
    "sine",
    rivals=("spring", "inertial_error", "payload", "base_tilt"),
    separates="more than 90 degrees of travel; the same motion with another payload; fast motions, to which "
    "a spring adds no inertia",
    source="the law of cosines; a KUKA KR300's in Robot_Identification (Weigand 2021)",
    equation=_balance,
    potential=_balance_energy,
    check=_fault,
    linear=("torque",),
    traits=Traits(
        noun="a gas spring",
        several=True,
        combines="balancers",
        candidates=(
            Law(
                _columns, (1, 1), _read, 2, kind="revolute", relief=_RELIEF,
                grid=tuple({"turn": turn, "ratio": float(_RATIO)} for turn in _TURNS), spread=(1.02, 1.002),
            ),
        ),
        contains=("torque_bias",),
        shape=("ratio", "rise"),
        hidden=Hidden(_form, needs="gravity", kind="revolute"),
        over="position",
    ),
)  # fmt: skip

EFFECTS = (GAS_SPRING,)
