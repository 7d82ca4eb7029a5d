"""Springs at a joint, and joints that are elastic or loose."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from robodyn.effects.effect import Coupler, Effect, Parameter, Site, Values
from robodyn.effects.friction import FORCE, SHARE, TORQUE
from robodyn.effects.scalars import is_zero, logarithm, magnitude, root, sign
from robodyn.effects.traits import Form, Hidden, Line, Traits, Twist, Usual

#: Where these stand among the others, for a person who reads them.
ORDER = 40

# --- springs ----------------------------------------------------------------------------------------------


def _spring(p: Values, at: Site) -> Any:
    x = at.q - p["rest"]
    torque = p["stiffness"] * x
    return torque if is_zero(p["cubic"]) else torque + p["cubic"] * (x * x * x)


def _spring_energy(p: Values, q: Any) -> Any:
    square = (q - p["rest"]) * (q - p["rest"])
    return p["stiffness"] * square / 2 + p["cubic"] * (square * square) / 4


def _line_read(x: Sequence[float], values: Mapping[str, float]) -> dict[str, float | str]:
    rest = values["middle"] - float(x[1] / x[0]) if x[0] else 0.0
    return {"stiffness": float(x[0]), "rest": rest, "cubic": 0.0}


def _spring_form(u: Usual, way: float, rng: Any) -> Form:
    rest = float(u.middle + rng.uniform(-0.3, 0.3) * (1.0 if u.revolute else 0.3))
    return Form(lambda x: {"stiffness": x, "rest": rest}, SHARE * u.tau)


SPRING = Effect(
    id="spring",
    title="Spring, cable or hose at the joint",
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
    traits=Traits(
        noun="a spring or cable",
        in_files=("stiffness", "rest"),
        combines="springs",
        candidates=(Line(_line_read, 3),),
        contains=("torque_bias",),
        hidden=Hidden(_spring_form),
        over="position",
    ),
)  # fmt: skip


_ENCODER = Parameter(
    "encoder", "The side that is measured.", kind="choice", choices=("motor", "link"), default="motor"
)


def _lag(p: Values, tau: Any) -> Any:
    return p["damping"] / p["stiffness"]


#: Natural frequencies [Hz] tried for a joint on its spring, and for one on the teeth of its gear.
_NATURAL_FREQUENCIES, _TEETH = tuple(4.0 * 1.25**k for k in range(12)), (8.0, 12.0, 18.0, 30.0)
#: Widths of backlash that are tried [rad or m], and the torques of its rounding [N m or N].
_GAPS, _ROUNDED, _TRANSITIONS = tuple(1e-3 * 1.25**k for k in range(17)), 0.05, (0.05, 0.5)
#: Play of a gear [rad or m] that is wider is hardly one: worn hobby servos have as much.
_WIDEST = 0.05
#: How far steps of refinement go, in logarithms.
_REACH = {"stiffness": 0.3, "damping": 0.5}


def _soft_read(x: Sequence[float], values: Mapping[str, float]) -> dict[str, float | str]:
    return {"stiffness": float(1 / x[0]) if x[0] > 0 else 1e12, "damping": 0.0, "encoder": "link"}


def _soft_form(u: Usual, way: float, rng: Any) -> Form:
    softest = u.weight * (2 * math.pi * 6.0) ** 2
    return Form(
        lambda x: {"stiffness": 1 / x, "damping": 2e-3 / x, "encoder": "motor"},
        0.3 / softest, 1e-9, 1 / softest,
    )  # fmt: skip


ELASTICITY = Effect(
    id="joint_elasticity",
    title="Joint elasticity",
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
    "resonance; simulation and diagnosis do not. Only `inverse_dynamics` takes steps: functions without "
    "memory have the joint stiff.",
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
    traits=Traits(
        candidates=(Twist(_NATURAL_FREQUENCIES, _REACH, ({"stiffness": 1.0},), _soft_read, 5),),
        twist="stiffness",
        reevaluate=True,
        wide=True,
        hidden=Hidden(_soft_form, needs="load"),
        over="load, each way",
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


def _play_read(x: Sequence[float], values: Mapping[str, float]) -> dict[str, float | str]:
    return {"gap": float(x[0]), "encoder": "link", "transition": values["transition"]}


def _play_form(u: Usual, way: float, rng: Any) -> Form:
    teeth = u.weight * (2 * math.pi * 12.0) ** 2
    return Form(
        lambda x: {"gap": x, "stiffness": teeth, "damping": 2e-3 * teeth, "encoder": "motor"},
        0.005, 1e-4, 0.03,
    )  # fmt: skip


BACKLASH = Effect(
    id="backlash",
    title="Backlash",
    place="coupler",
    parameters=(
        Parameter("gap", "Full width of the backlash.", "rad", "m", sign="positive", names=True, symbol="g"),
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
            "transition", "Torque at which half of the backlash is taken up.", TORQUE, FORCE, sign="positive",
            default=Fraction(1, 20), names=True, symbol="w",
        ),
    ),
    latex=r"\theta - q = \frac{\tau_L}{K} + \frac g2\,\frac{\tau_L}{|\tau_L| + w}",
    doc="Play in the gear with stiff teeth: the motor runs ahead of the link by half the gap, on the side to "
    "which the torque pushes. The flanks are rounded by `transition`, so that torque and twist are smooth "
    "functions of each other. `damping` acts on the rate of the twist, as in an elastic joint. Only "
    "`inverse_dynamics` takes steps: functions without memory have the joint stiff.",
    signature="pulses where the joint torque changes sign, at no particular velocity",
    rivals=("presliding_hysteresis", "stribeck_friction", "joint_elasticity"),
    separates="an unloaded joint that passes zero torque while it keeps moving one way",
    source="Nordin and Gutman 2002, with rounded flanks",
    equation=lambda p, at: 0,
    coupler=Coupler(twist=_play, torque=_flank, lag=_play_lag, energy=_flank_energy),
    traits=Traits(
        absorbs=("joint_elasticity",),
        candidates=(
            Twist(
                _TEETH, {"gap": 0.1, **_REACH},
                tuple({"gap": 1.0, "stiffness": math.inf, "transition": w} for w in _TRANSITIONS),
                _play_read, 5, more=tuple({"gap": gap} for gap in _GAPS), fixed={"transition": _ROUNDED},
                likely={"gap": _WIDEST},
            ),
        ),
        reevaluate=True,
        chosen=("transition",),
        wide=True,
        wears="gap",
        hidden=Hidden(_play_form, needs="load"),
        over="load",
    ),
)  # fmt: skip

EFFECTS = (SPRING, ELASTICITY, BACKLASH)
