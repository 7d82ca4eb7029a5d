"""Friction that depends on the velocity alone."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from robodyn.effects.effect import Effect, Fault, Parameter, Site, Values
from robodyn.effects.scalars import exponential, is_zero, magnitude, power
from robodyn.effects.traits import Fold, Form, Hidden, Law, Limit, Traits, Usual, between

#: Where these stand among the others, for a person who reads them.
ORDER = 10
TORQUE, FORCE = "N m", "N"
#: What is usual of a friction torque, as a share of the joint's.
SHARE = 0.05


def level(name: str, doc: str, symbol: str, **more: Any) -> Parameter:
    """A parameter that is a torque of friction: not negative."""
    return Parameter(name, doc, TORQUE, FORCE, sign="nonnegative", symbol=symbol, **{"names": True, **more})


_COEFFICIENT = Law(lambda values, at: (at.qd,), (1,), lambda x, values: {"coefficient": float(x[0])}, 1)

VISCOUS = Effect(
    id="viscous_friction",
    title="Viscous friction",
    place="motor",
    parameters=(
        Parameter(
            "coefficient", "Torque by speed.", "N m s/rad", "N s/m", sign="nonnegative", names=True,
            symbol="F_v",
        ),
    ),
    latex=r"\tau = F_v \dot q",
    doc="Torque in proportion to the speed: grease, oil, back-EMF. Also written `friction: {viscous: ...}`.",
    signature="a straight line through zero over the joint's velocity, nothing at rest",
    rivals=("coulomb_friction", "transmission_loss"),
    separates="three speed levels or more, in both directions",
    source="Stokes 1851; Craig, Introduction to Robotics, section 6.9",
    equation=lambda p, at: p["coefficient"] * at.qd,
    linear=("coefficient",),
    dissipative=True,
    traits=Traits(
        fold=Fold("joint", "viscous", "coefficient", "friction"),
        candidates=(
            _COEFFICIENT,
        ),
        hidden=Hidden(lambda u, way, rng: Form(lambda x: {"coefficient": x}, SHARE * u.tau / u.speed)),
        over="velocity",
    ),
)  # fmt: skip

#: Share of its velocity below which a power of the speed is a straight line, so that its slope is finite.
_STRAIGHT = Fraction(1, 1000)


def _power_law(p: Values, at: Site) -> Any:
    if is_zero(at.qd):  # functions of the positions alone
        return 0
    ratio = at.qd / p["velocity"]
    square = ratio * ratio + _like(_STRAIGHT * _STRAIGHT, ratio)
    return p["level"] * ratio * power(square, _like((p["exponent"] - 1) / 2, ratio))


def _like(constant: Any, x: Any) -> Any:
    """A constant as arrays and floats take it; graphs keep it exact."""
    plain = isinstance(x, float) or hasattr(x, "dtype")
    return float(constant) if plain and isinstance(constant, Fraction) else constant


def _power_form(u: Usual, way: float, rng: Any) -> Form:
    a = float(rng.choice([0.5, 0.6, 0.7, 2.0]))
    return Form(lambda x: {"level": x, "exponent": a}, SHARE * u.tau / u.speed**a)


#: With an exponent below this it is a level.
_FLAT = 0.15


def _power_level(p: Values, speed: float) -> dict[str, float | str]:
    """Its torque at the ``speed``, as a level."""
    velocity = float(p.get("velocity", 1.0))
    return {"level": float(p["level"]) * (speed / velocity) ** float(p["exponent"])}


_POWER = Law(
    lambda values, at: (_power_law({"level": 1.0, "velocity": 1.0, **values}, at),), (1,),
    lambda x, values: {"level": float(x[0]), **values}, 2,
    grid=tuple({"exponent": a} for a in (0.3, 0.4, 0.5, 0.6, 0.7, 0.85, 1.3, 1.6, 2.0)),
    spread=(1.1, 1.01), feasible=lambda x: bool(x[0] > 0),
)  # fmt: skip

POWER_LAW = Effect(
    id="power_law_friction",
    title="Friction by a power of the speed",
    place="motor",
    parameters=(
        level("level", "Torque at the speed `velocity`.", "F_a"),
        Parameter(
            "exponent", "Power of the speed.", "1", sign="positive", default=Fraction(1, 2), symbol="a"
        ),
        Parameter(
            "velocity", "Speed that the level is of.", "rad/s", "m/s", sign="positive", default=Fraction(1),
            symbol="v_1",
        ),
    ),
    latex=r"\tau = F_a \frac{\dot q}{v_1}"
    r" \left[\left(\frac{\dot q}{v_1}\right)^2 + 10^{-6}\right]^{(a - 1)/2}",
    doc="Friction of lubricants that thin as they are sheared, as in harmonic drives (a of 0.5 to 0.7), or "
    "of air (a of 2): a power of the speed, within a thousandth of `velocity` of rest a straight line. It is "
    "0 at rest by itself, whatever `friction_at_rest` says.",
    signature="a curve through zero over the joint's velocity, bent towards the axis or away from it",
    rivals=("viscous_friction", "coulomb_friction", "stribeck_friction"),
    separates="speeds over a range of five to one, in both directions",
    source="Taghirad and Belanger 1998; Tuttle and Seering 1996",
    equation=_power_law,
    linear=("level",),
    dissipative=True,
    traits=Traits(
        candidates=(
            _POWER,
        ),
        contains=("coulomb_friction", "viscous_friction"),
        one_law_with=("viscous_friction", "coulomb_friction"),
        limit=Limit("coulomb_friction", lambda p: float(p["exponent"]) < _FLAT, _power_level),
        hidden=Hidden(_power_form),
        over="velocity",
    ),
)  # fmt: skip


COULOMB = Effect(
    id="coulomb_friction",
    title="Coulomb friction",
    place="motor",
    parameters=(level("level", "Torque that opposes motion, whatever the speed.", "F_c"),),
    latex=r"\tau = F_c \operatorname{sgn}\dot q",
    doc="A torque of constant size against the motion. Also written `friction: {coulomb: ...}`.",
    signature="a step where the velocity reverses, flat otherwise",
    rivals=("viscous_friction", "stribeck_friction", "load_dependent_friction", "asymmetric_friction"),
    separates="reversals, slow and fast segments, and more than one pose",
    source="Coulomb 1785",
    equation=lambda p, at: p["level"] * at.direction,
    linear=("level",),
    dissipative=True,
    traits=Traits(
        one_way="level",
        fold=Fold("joint", "coulomb", "level", "friction"),
        candidates=(
            Law(lambda values, at: (at.direction,), (1,), lambda x, values: {"level": float(x[0])}, 1),
        ),
        hidden=Hidden(lambda u, way, rng: Form(lambda x: {"level": x}, SHARE * u.tau)),
        over="velocity",
    ),
)  # fmt: skip


def _asymmetric(p: Values, at: Site) -> Any:
    # The cases of the equation as one: each level times the direction, whatever lies between -1 and 1.
    forward, backward = p["positive"], p["negative"]
    even = (forward - backward) / 2
    return (forward + backward) / 2 * at.direction + even * magnitude(at.direction)


def _asymmetric_form(u: Usual, way: float, rng: Any) -> Form:
    lean = way * between(rng, 0.25, 0.5)
    return Form(lambda x: {"positive": x * (1 + lean), "negative": x * (1 - lean)}, SHARE * u.tau)


ASYMMETRIC = Effect(
    id="asymmetric_friction",
    title="Coulomb friction that differs by direction",
    place="motor",
    parameters=(
        level("positive", "Level in the positive direction.", "F_c^+"),
        level("negative", "Level in the negative direction, as a size.", "F_c^-"),
    ),
    latex=r"\tau = \begin{cases} F_c^+ \operatorname{sgn}\dot q & \dot q \ge 0 \\"
    r" F_c^- \operatorname{sgn}\dot q & \dot q < 0 \end{cases}",
    doc="A level of its own for either direction of motion.",
    signature="a step at reversals whose middle is not zero",
    rivals=("coulomb_friction", "torque_bias"),
    separates="standstill with brakes on and drive off, or a repeat with the torque sensor zeroed: while the "
    "joint moves it is exactly Coulomb friction and a bias",
    source="Armstrong-Helouvry, Dupont and Canudas de Wit 1994",
    equation=_asymmetric,
    linear=("positive", "negative"),
    dissipative=True,
    traits=Traits(
        levels=("positive", "negative"),
        one_way="nearly",
        candidates=(
            Law(
                lambda values, at: (at.direction, magnitude(at.direction)), (1, 0),
                lambda x, values: {"positive": float(x[0] + x[1]), "negative": float(x[0] - x[1])}, 2,
                feasible=lambda x: bool(abs(x[1]) <= x[0]),
            ),
        ),
        contains=("coulomb_friction",),
        both_ways=True,
        hidden=Hidden(_asymmetric_form),
        over="velocity",
    ),
)  # fmt: skip


def _stribeck(p: Values, at: Site) -> Any:
    ratio = at.qd / p["velocity"]
    exponent = p["exponent"]
    decay = ratio * ratio if exponent == 2 else power(magnitude(ratio), exponent)
    return (p["level"] + (p["static"] - p["level"]) * exponential(-decay)) * at.direction


def _stribeck_fault(p: Values, revolute: bool) -> Fault | None:
    low, high = p["level"], p["static"]
    if isinstance(low, Fraction) and isinstance(high, Fraction) and high < low:
        expected, remedy = f"level = {float(low)!r} or more", "exchange the two, or use coulomb_friction"
        return Fault("static", "is below the Coulomb level", expected, remedy)
    return None


def _stribeck_columns(values: Values, at: Site) -> tuple[Any, Any]:
    """Torques by the level, and by the rise above it."""
    flat, rise = ({"exponent": 2, "level": level, "static": 1.0, **values} for level in (1.0, 0.0))
    return _stribeck(flat, at), _stribeck(rise, at)


def _stribeck_form(u: Usual, way: float, rng: Any) -> Form:
    rise, knee = between(rng, 1.6, 2.5), u.slow * between(rng, 0.7, 1.4)
    return Form(lambda x: {"level": x, "static": rise * x, "velocity": knee}, SHARE * u.tau)


STRIBECK = Effect(
    id="stribeck_friction",
    title="Stribeck friction",
    place="motor",
    parameters=(
        level("level", "Coulomb level, reached at high speed.", "F_c"),
        level("static", "Level at the onset of motion.", "F_s"),
        Parameter(
            "velocity", "Speed over which the rise fades.", "rad/s", "m/s", sign="positive", names=True,
            symbol="v_s",
        ),
        Parameter(
            "exponent", "Shape of the fading.", "1", sign="positive", default=Fraction(2), symbol=r"\delta"
        ),
    ),
    latex=r"\tau = \left[F_c + (F_s - F_c)\,e^{-|\dot q/v_s|^\delta}\right]\operatorname{sgn}\dot q",
    doc="Coulomb friction that is larger near rest. Carries its own Coulomb level.",
    signature="more than Coulomb friction at a few times v_s and below, at that level above",
    rivals=("coulomb_friction", "presliding_hysteresis"),
    separates="constant speeds from a fifth to five times v_s; a twentieth of the samples below v_s",
    source="Bo and Pavelescu 1982",
    equation=_stribeck,
    check=_stribeck_fault,
    linear=("level", "static"),
    dissipative=True,
    traits=Traits(
        levels=("level", "static"),
        one_way="nearly",
        candidates=(
            Law(
                _stribeck_columns, (1, 1),
                lambda x, values: {"level": float(x[0]), "static": float(x[0] + x[1]), **values}, 3,
                grid=tuple({"velocity": v} for v in (0.01, 0.02, 0.04, 0.08, 0.15, 0.3)),
                suits=lambda values, top: values["velocity"] < 0.6 * top,
                # Breakaway of up to three times the level, a choice: more is what a joint does at rest.
                feasible=lambda x: bool(x[1] <= 2 * x[0]),
            ),
        ),
        contains=("coulomb_friction",),
        hidden=Hidden(_stribeck_form),
        over="velocity",
    ),
)  # fmt: skip

EFFECTS = (VISCOUS, COULOMB, ASYMMETRIC, STRIBECK, POWER_LAW)
