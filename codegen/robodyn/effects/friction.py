"""Friction that depends on the velocity alone, and the friction that remembers."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from robodyn.effects.effect import Effect, Fault, Memory, Parameter, Site, Values
from robodyn.effects.scalars import exponential, is_finite, is_positive, is_zero, magnitude, power, sign

TORQUE, FORCE = "N m", "N"


def level(name: str, doc: str, symbol: str, **more: Any) -> Parameter:
    """A parameter that is a torque of friction: not negative."""
    return Parameter(name, doc, TORQUE, FORCE, sign="nonnegative", symbol=symbol, **{"names": True, **more})


VISCOUS = Effect(
    id="viscous_friction",
    title="Viscous friction",
    level="joint",
    place="motor",
    parameters=(
        Parameter(
            "coefficient",
            "Torque by speed.",
            "N m s/rad",
            "N s/m",
            sign="nonnegative",
            names=True,
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
)

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


POWER_LAW = Effect(
    id="power_law_friction",
    title="Friction by a power of the speed",
    level="joint",
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
)  # fmt: skip


COULOMB = Effect(
    id="coulomb_friction",
    title="Coulomb friction",
    level="joint",
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
)


def _asymmetric(p: Values, at: Site) -> Any:
    # The cases of the equation as one: each level times the direction, whatever lies between -1 and 1.
    forward, backward = p["positive"], p["negative"]
    even = (forward - backward) / 2
    return (forward + backward) / 2 * at.direction + even * magnitude(at.direction)


ASYMMETRIC = Effect(
    id="asymmetric_friction",
    title="Coulomb friction that differs by direction",
    level="joint",
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
)


def _stribeck(p: Values, at: Site) -> Any:
    ratio = at.qd / p["velocity"]
    exponent = p["exponent"]
    bent = ratio * ratio if exponent == 2 else power(magnitude(ratio), exponent)
    return (p["level"] + (p["static"] - p["level"]) * exponential(-bent)) * at.direction


def _stribeck_fault(p: Values, revolute: bool) -> Fault | None:
    low, high = p["level"], p["static"]
    if isinstance(low, Fraction) and isinstance(high, Fraction) and high < low:
        return Fault(
            "static",
            "is below the Coulomb level",
            f"level = {float(low)!r} or more",
            "exchange the two, or use coulomb_friction",
        )
    return None


STRIBECK = Effect(
    id="stribeck_friction",
    title="Stribeck friction",
    level="joint",
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
)  # fmt: skip


def _bristle_rate(p: Values, at: Site, state: tuple[Any, ...]) -> tuple[Any, ...]:
    (z,) = state
    return (at.qd - p["stiffness"] * magnitude(at.qd) / p["level"] * z,)


def _bristle_torque(p: Values, at: Site, state: tuple[Any, ...]) -> Any:
    (z,) = state
    (rate,) = _bristle_rate(p, at, state)
    return p["stiffness"] * z + p["damping"] * rate


def _bristle_step(p: Values, at: Site, state: tuple[Any, ...], dt: Any) -> tuple[tuple[Any, ...], Any]:
    # Exact for a velocity that is constant over dt: stable for any dt, however stiff the bristles. Where the
    # velocity or dt is infinite or no number, or dt negative, z stays, to the bit: left is 1 then, full 0.
    (z,) = state
    way = p["stiffness"] * magnitude(at.qd) / p["level"] * dt
    moving = is_positive(way) * is_finite(way)
    left = power(exponential(-magnitude(way)), moving)
    full = p["level"] / p["stiffness"] * (sign(at.qd) * moving)
    moved = (full + (z - full) * left,)
    # That a velocity is no number shows in the torque all the same.
    nothing = magnitude(at.qd) - sign(at.qd) * at.qd
    return moved, _bristle_torque(p, at, moved) + nothing


PRESLIDING = Effect(
    id="presliding_hysteresis",
    title="Presliding hysteresis (LuGre)",
    level="joint",
    place="motor",
    parameters=(
        Parameter(
            "stiffness", "Stiffness of the contact before it slides.", "N m/rad", "N/m", sign="positive",
            names=True, symbol=r"\sigma_0",
        ),
        Parameter(
            "level", "Coulomb level, reached when it slides.", TORQUE, FORCE, sign="positive", names=True,
            symbol="F_c",
        ),
        Parameter(
            "damping", "Damping of the contact.", "N m s/rad", "N s/m", sign="nonnegative",
            default=Fraction(0), names=True, symbol=r"\sigma_1",
        ),
    ),
    latex=r"\dot z = \dot q - \frac{\sigma_0 |\dot q|}{F_c} z, \qquad \tau = \sigma_0 z + \sigma_1 \dot z",
    doc="The contact is a spring until it slides: friction depends on the way since the last reversal. "
    "State z [rad or m] is how far it is bent; begun at z = 0 it never feeds energy in. In steady motion, "
    "and in functions without memory, tau is F_c sgn(qd).",
    signature="after a reversal the torque follows the distance, not the velocity; a loop over position",
    rivals=("coulomb_friction", "stribeck_friction", "backlash", "joint_elasticity"),
    separates="reversals of several amplitudes below level/stiffness",
    source="Canudas de Wit, Olsson, Astrom and Lischinsky 1995; Dahl 1968 without damping",
    equation=lambda p, at: p["level"] * at.direction,
    memory=Memory(("z",), _bristle_step, _bristle_rate, _bristle_torque),
    dissipative=True,
)  # fmt: skip

EFFECTS = (VISCOUS, COULOMB, ASYMMETRIC, STRIBECK, POWER_LAW, PRESLIDING)
