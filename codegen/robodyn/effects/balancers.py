"""Spring balancers: a spring between a pivot on the link and one on the previous link balances gravity."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from robodyn.effects.effect import Effect, Fault, Parameter, Site, Values
from robodyn.effects.friction import FORCE, TORQUE
from robodyn.effects.scalars import cosine, is_zero, root, sine
from robodyn.effects.traits import Form, Hidden, Law, Traits, Usual

#: The position of these effects in listings of all effects.
ORDER = 45

#: Default of ``ratio``, from the gas springs at the second joint of large arms (KUKA KR300).
_RATIO = Fraction(1, 4)
#: Largest ``ratio``: at 1 the pivots can meet, and the direction of the spring is undefined there.
_LARGEST_RATIO = Fraction(19, 20)
#: Largest dead centre [rad]: the joint position minus a larger one would lose digits.
_LARGEST_ANGLE = 1000
#: Dead centres [rad] of the search grid. They are one turn away from 0, since refinement multiplies them.
_DEAD_CENTERS = tuple(2 * math.pi * (1 + k / 24) for k in range(24))
#: Largest rise of the search: the pressure of a gas spring hardly doubles over its stroke.
_MOST_RISE = 0.8


def _lever(p: Values, q: Any) -> tuple[Any, Any, Any]:
    """Sine of the crank's angle, length of the spring, and its travel from the dead centre.

    The length is divided by the distance from the axis to the fixed pivot, the travel by the crank length.
    The formula of the travel has no cancellation near the dead centre.
    """
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
        return Fault("torque", "needs a crank, and a prismatic joint has none", "a revolute joint",
                     "use spring")  # fmt: skip
    if isinstance(p["dead_center"], Fraction) and abs(p["dead_center"]) > _LARGEST_ANGLE:
        return Fault("dead_center", "is so many turns that a position less it loses its digits",
                     "-1000 to 1000 rad", "take whole turns off")  # fmt: skip
    if abs(p["ratio"]) > _LARGEST_RATIO:
        return Fault("ratio", "is so large that pivots nearly meet", "-0.95 to 0.95", "see docs/effects.md")
    return None


def _wrap_angle(angle: float) -> float:
    """The same angle, wrapped to -pi to pi."""
    return math.remainder(angle, 2 * math.pi)


def _shape(values: Mapping[str, float]) -> dict[str, float]:
    return {"dead_center": _wrap_angle(values["turn"]), "ratio": values["ratio"]}


def _columns(values: Mapping[str, float], at: Site) -> Sequence[Any]:
    s, length, travel = _lever(_shape(values), at.q)
    constant = s / length
    return constant, (1 + _MOST_RISE * travel) * constant


def _parameters_of(x: Sequence[float], values: Mapping[str, float]) -> dict[str, float | str]:
    torque = float(x[0] + x[1])
    return {"torque": torque, "rise": _MOST_RISE * float(x[1]) / torque if torque else 0.0, **_shape(values)}


def _form(u: Usual, way: float, rng: Any) -> Form:
    center = _wrap_angle(u.upright + way * rng.uniform(0.0, 0.2))
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
            "torque", "Spring force at the dead centre times crank length.", TORQUE, FORCE,
            sign="nonnegative", names=True, symbol="T",
        ),
        Parameter(
            "dead_center", "Position at which the pivots and the axis lie in a line and the spring holds the "
            "joint.", "rad", default=Fraction(0), names=True, symbol="q_0",
        ),
        Parameter(
            "rise", "Relative increase of the force over a travel of one crank length.", "1",
            sign="nonnegative", default=Fraction(0), symbol="c",
        ),
        Parameter(
            "ratio", "Crank length (axis to moving pivot) divided by the distance from the axis to the fixed "
            "pivot. Negative for a spring that pushes: its crank points away from the fixed pivot at the "
            "dead centre.", "1", default=_RATIO,
            symbol=r"\rho",
        ),
    ),
    latex=r"\tau = \frac{T (1 + c s) \sin\delta}{\lambda}, \quad \delta = q - q_0, \quad "
    r"\lambda = \sqrt{1 + \rho^2 - 2 \rho \cos\delta}, \quad "
    r"s = \frac{2 (1 - \cos\delta)}{\lambda + 1 - \rho}",
    doc="A spring between a pivot on the link and a pivot on the previous link balances gravity at a "
    "revolute joint. lambda is the length of the spring divided by the distance from the axis to the "
    "fixed pivot, s its travel divided by the crank length. The model's force is linear in the travel. "
    "The force of a gas spring exceeds this line, by 5 % when the gas volume has shrunk by a fifth. "
    "From a data sheet: torque is preload times crank length; rise is crank length times spring rate "
    "divided by preload, and for a gas spring crank length times piston area divided by gas volume. A "
    "spring of zero free length (its force is proportional to its length) has ratio 0 and rise 0.",
    signature="depends on the joint's own position and on nothing else; against gravity, with the shape of a "
    "sine",
    rivals=("spring", "inertial_error", "payload", "base_tilt"),
    separates="more than 90 degrees of travel; the same motion with another payload; fast motions, since a "
    "spring adds no inertia",
    source="the law of cosines; the gas spring of a KUKA KR300 in Robot_Identification (Weigand 2021)",
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
                _columns, (1, 1), _parameters_of, 4, kind="revolute", balances=True,
                grid=tuple({"turn": turn, "ratio": float(_RATIO)} for turn in _DEAD_CENTERS),
                spread=(1.02, 1.002),
            ),
        ),
        contains=("torque_bias",),
        shape=("ratio", "rise"),
        hidden=Hidden(_form, needs="gravity", kind="revolute"),
        over="position",
    ),
)  # fmt: skip

EFFECTS = (GAS_SPRING,)
