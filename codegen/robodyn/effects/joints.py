"""Springs, elastic and loose joints, and what turns with the motor."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from robodyn.effects.effect import Coupler, Effect, Fault, Parameter, Site, Values
from robodyn.effects.friction import FORCE, TORQUE, level
from robodyn.effects.scalars import cosine, is_zero, logarithm, magnitude, root, sign, sine

# --- springs ----------------------------------------------------------------------------------------------


def _spring(p: Values, at: Site) -> Any:
    x = at.q - p["rest"]
    torque = p["stiffness"] * x
    return torque if is_zero(p["cubic"]) else torque + p["cubic"] * (x * x * x)


def _spring_energy(p: Values, q: Any) -> Any:
    square = (q - p["rest"]) * (q - p["rest"])
    return p["stiffness"] * square / 2 + p["cubic"] * (square * square) / 4


SPRING = Effect(
    id="spring",
    title="Spring, cable or hose at the joint",
    level="joint",
    place="link",
    parameters=(
        Parameter(
            "stiffness", "Torque by way; negative where it pulls away.", "N m/rad", "N/m", names=True,
            symbol="k",
        ),
        Parameter(
            "rest", "Position at which it is slack.", "rad", "m", default=Fraction(0), names=True,
            symbol="q_0",
        ),
        Parameter(
            "cubic", "Torque by the cube of the way.", "N m/rad^3", "N/m^3", default=Fraction(0), names=True,
            symbol="k_3",
        ),
    ),
    latex=r"\tau = k\,(q - q_0) + k_3\,(q - q_0)^3",
    doc="A torque of the position alone, in parallel to the drive.",
    signature="depends on the joint's own position and on nothing else; monotone",
    rivals=("torque_bias", "inertial_error", "base_tilt", "encoder_offset"),
    separates="more than 90 degrees of travel, which tells a line from a sine; a repeat with the cable moved",
    source="Hooke 1678",
    equation=_spring,
    potential=_spring_energy,
    linear=("stiffness", "cubic"),
)  # fmt: skip


_ENCODER = Parameter(
    "encoder", "The side that is measured.", kind="choice", choices=("motor", "link"), default="motor"
)


def _lag(p: Values, tau: Any) -> Any:
    return p["damping"] / p["stiffness"]


ELASTICITY = Effect(
    id="joint_elasticity",
    title="Joint elasticity",
    level="joint",
    place="coupler",
    parameters=(
        Parameter("stiffness", "Torque by twist.", "N m/rad", "N/m", sign="positive", names=True, symbol="K"),
        Parameter(
            "damping", "Torque by rate of twist.", "N m s/rad", "N s/m", sign="nonnegative",
            default=Fraction(0), names=True, symbol="D",
        ),
        _ENCODER,
    ),
    latex=r"\tau_L = K(\theta - q) + D(\dot\theta - \dot q)",
    doc="A spring between motor (theta, on the joint's side of the gear) and link (q). A kernel that is "
    "given the motor's motion takes the link's rates to be the motor's, as they are well below the "
    "resonance; simulation and diagnosis do not.",
    signature="a sag under static load and a lag at high frequency, along with the load and its derivatives",
    rivals=("encoder_offset", "time_delay", "payload", "presliding_hysteresis"),
    separates="a multisine near the resonance; best an encoder on either side",
    source="Spong 1987",
    equation=lambda p, at: 0,
    coupler=Coupler(
        twist=lambda p, tau: tau / p["stiffness"],
        torque=lambda p, twist, rate: p["stiffness"] * twist + p["damping"] * rate,
        lag=_lag,
        energy=lambda p, twist: p["stiffness"] * twist * twist / 2,
    ),
)  # fmt: skip


def _play(p: Values, tau: Any) -> Any:
    return tau / p["stiffness"] + p["gap"] / 2 * tau / (magnitude(tau) + p["transition"])


def _play_lag(p: Values, tau: Any) -> Any:
    """Damping times the slope of the twist over the torque: long within the gap, short on the flanks."""
    near = magnitude(tau) + p["transition"]
    return p["damping"] * (1 / p["stiffness"] + p["gap"] / 2 * p["transition"] / (near * near))


def _flank(p: Values, twist: Any, rate: Any) -> Any:
    x, k, w = magnitude(twist), p["stiffness"], p["transition"]
    b = k * (x - p["gap"] / 2) - w
    return sign(twist) * ((b + root(b * b + 4 * w * k * x)) / 2) + p["damping"] * rate


def _flank_energy(p: Values, twist: Any) -> Any:
    tau = magnitude(_flank(p, twist, 0))
    w = p["transition"]
    dual = tau * tau / (2 * p["stiffness"]) + p["gap"] / 2 * (tau - w * logarithm(1 + tau / w))
    return tau * magnitude(twist) - dual


BACKLASH = Effect(
    id="backlash",
    title="Backlash",
    level="joint",
    place="coupler",
    parameters=(
        Parameter("gap", "Full width of the play.", "rad", "m", sign="positive", names=True, symbol="g"),
        _ENCODER,
        Parameter(
            "stiffness", "Stiffness of the teeth in contact.", "N m/rad", "N/m", sign="positive",
            default=Fraction(10_000), names=True, symbol="K",
        ),
        Parameter(
            "damping", "Damping between the two sides.", "N m s/rad", "N s/m", sign="nonnegative",
            default=Fraction(1), names=True, symbol="D",
        ),
        Parameter(
            "transition", "Torque at which half of the play is taken up.", TORQUE, FORCE, sign="positive",
            default=Fraction(1, 20), names=True, symbol="w",
        ),
    ),
    latex=r"\theta - q = \frac{\tau_L}{K} + \frac g2\,\frac{\tau_L}{|\tau_L| + w}",
    doc="Play in the gear with stiff teeth: the motor runs ahead of the link by half the gap, on the side to "
    "which the torque pushes. The flanks are rounded by `transition`, so that torque and twist are smooth "
    "functions of each other.",
    signature="pulses where the joint torque changes sign, at no particular velocity",
    rivals=("presliding_hysteresis", "stribeck_friction", "joint_elasticity"),
    separates="an unloaded joint that passes zero torque while it keeps moving one way",
    source="Nordin and Gutman 2002, with rounded flanks",
    equation=lambda p, at: 0,
    coupler=Coupler(twist=_play, torque=_flank, lag=_play_lag, energy=_flank_energy),
)  # fmt: skip


# --- the motor --------------------------------------------------------------------------------------------

ROTOR = Effect(
    id="rotor_inertia",
    title="Rotor inertia",
    level="joint",
    place="rigid",
    parameters=(
        Parameter(
            "inertia", "Inertia of rotor and gear, reflected to the joint.", "kg m^2", "kg",
            sign="nonnegative", names=True, symbol="I_r",
        ),
    ),
    latex=r"\tau = I_r\,\ddot q",
    doc="Adds to `motor_inertia`, where it is better written.",
    signature="in phase with the joint's own acceleration",
    rivals=("inertial_error", "time_delay"),
    separates="poses in which the arm's own inertia about the joint differs",
    source="Craig, Introduction to Robotics, section 9.10",
    equation=lambda p, at: p["inertia"] * at.qdd,
    linear=("inertia",),
)  # fmt: skip


#: A phase [rad] beyond this would take digits from the position that it is added to.
_LARGEST_PHASE = 10_000


def _ripple_fault(p: Values, revolute: bool) -> Fault | None:
    if abs(p["phase"]) <= _LARGEST_PHASE:
        return None
    return Fault(
        "phase",
        "is so many turns that a position added to it loses its digits",
        f"-{_LARGEST_PHASE} to {_LARGEST_PHASE} rad",
        "take whole turns off",
    )


def _ripple_energy(p: Values, q: Any) -> Any:
    return -(p["amplitude"] / p["cycles_per_rev"] * cosine(p["cycles_per_rev"] * q + p["phase"]))


RIPPLE = Effect(
    id="torque_ripple",
    title="Torque ripple",
    level="joint",
    place="motor",
    parameters=(
        Parameter(
            "amplitude", "Size of the ripple.", TORQUE, FORCE, sign="nonnegative", names=True, symbol="A",
        ),
        Parameter(
            "cycles_per_rev", "Ripples in a turn of the joint; prismatic: in 2 pi m.", "1", "1/m",
            sign="positive", symbol="N",
        ),
        Parameter("phase", "Phase at q = 0.", "rad", default=Fraction(0), symbol=r"\varphi"),
    ),
    latex=r"\tau = A \sin(N q + \varphi)",
    doc="A wave over the joint's position: cogging, gear teeth, the wave generator of a harmonic drive.",
    signature="a peak in the spectrum over angle, at the same angle at every speed",
    rivals=("spring", "presliding_hysteresis"),
    separates="slow sweeps recorded at the full rate; a low-pass filter erases it",
    source="Preissner, Royston and Shu 2012",
    equation=lambda p, at: p["amplitude"] * sine(p["cycles_per_rev"] * at.q + p["phase"]),
    potential=_ripple_energy,
    check=_ripple_fault,
    linear=("amplitude",),
)  # fmt: skip

COUPLING = Effect(
    id="motor_coupling",
    title="A motor that drives two joints",
    level="pair",
    place="pair",
    parameters=(
        Parameter("with", "Number of the other joint.", kind="joint"),
        Parameter(
            "ratio", "What a turn of the other joint turns the motor.", "1", default=Fraction(1),
            symbol=r"\rho",
        ),
        Parameter(
            "inertia", "Inertia of the motor.", "kg m^2", "kg", sign="nonnegative", default=Fraction(0),
            names=True, symbol="I",
        ),
        Parameter(
            "viscous", "Its viscous friction.", "N m s/rad", "N s/m", sign="nonnegative", default=Fraction(0),
            names=True, symbol="F_v",
        ),
        level("coulomb", "Its Coulomb friction.", "F_c", default=Fraction(0)),
    ),
    latex=r"u = q_j + \rho\,q_k, \quad T = I\ddot u + F_v\dot u + F_c\operatorname{sgn}\dot u, \quad"
    r"\tau_j \mathrel{+}= T, \ \tau_k \mathrel{+}= \rho\,T",
    doc="A motor that turns with joint j and, by `ratio`, with joint k, as in the wrists whose last motor "
    "drives through the joint before.",
    signature="the torque of either joint contains velocity and acceleration of the other",
    rivals=("inertial_error", "rotor_inertia"),
    separates="moving the two joints at different frequencies",
    source="Gautier 1996; Staubli TX40",
    equation=lambda p, at: p["inertia"] * at.qdd + p["viscous"] * at.qd + p["coulomb"] * at.direction,
    linear=("inertia", "viscous", "coulomb"),
    dissipative=True,
)  # fmt: skip

EFFECTS = (SPRING, ELASTICITY, BACKLASH, ROTOR, RIPPLE, COUPLING)
