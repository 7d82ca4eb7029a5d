"""What sensors do to what is measured. None of it enters a kernel.

The equations of torques give what is added to the torque ``tau`` of the site; that of the encoder what is
added to the position. A delay needs the past, and is where the past is (``robodyn.simulate.sensors``).
"""

from __future__ import annotations

from typing import Any

from robodyn.effects.effect import Effect, Parameter, Site, Values
from robodyn.effects.friction import FORCE, SHARE, TORQUE
from robodyn.effects.scalars import clamped
from robodyn.effects.traits import Channel, Form, Hidden, Shown, Traits, Usual

#: Where these stand among the others, for a person who reads them.
ORDER = 70

BIAS = Effect(
    id="torque_bias",
    title="Bias of the torque channel",
    place="sensor",
    parameters=(Parameter("bias", "Measured less true.", TORQUE, FORCE, symbol="b"),),
    latex=r"\tau_m = \tau + b",
    doc="The torque channel is off by a constant.",
    signature="a constant, also at rest",
    rivals=("asymmetric_friction", "spring"),
    separates="standstill with brakes on and drive off",
    source="Craig, Introduction to Robotics, section 9",
    equation=lambda p, at: p["bias"],
    linear=("bias",),
    traits=Traits(
        noun="a torque offset",
        one_way="level",
        channel=Channel("bias", "bias"),
        candidates=(Shown(1),),
        hidden=Hidden(lambda u, way, rng: Form(lambda x: {"bias": way * x}, SHARE * u.tau)),
        over="constant",
    ),
)

GAIN = Effect(
    id="torque_gain",
    title="Gain error of the torque channel",
    place="sensor",
    parameters=(Parameter("gain", "Measured = (1 + gain) times true.", "1", symbol="g"),),
    latex=r"\tau_m = (1 + g)\,\tau",
    doc="The torque constant is not what it is taken for; of one joint, or in the robot's list of all.",
    signature="in proportion to the whole torque, friction included, whatever the direction of motion",
    rivals=("payload", "inertial_error", "transmission_loss", "load_dependent_friction"),
    separates="a known payload: an equal gain of all joints is a scale of all masses",
    source="Gautier and Briot 2014",
    equation=lambda p, at: p["gain"] * at.tau,
    linear=("gain",),
    traits=Traits(
        noun="a wrong torque scale",
        of_all=True,
        channel=Channel("gain", "gain"),
        candidates=(Shown(2, of_all=2),),
        reevaluate=True,
        hidden=Hidden(
            lambda u, way, rng: Form(lambda x: {"gain": way * x}, 0.05, 1e-3, 0.5),
            needs="load",
            at_joint=True,
        ),
        over="load",
    ),
)

DELAY = Effect(
    id="time_delay",
    title="Delay of the torque channel",
    place="sensor",
    parameters=(Parameter("delay", "How late the torque is.", "s", sign="nonnegative", symbol="T"),),
    latex=r"\tau_m(t) = \tau(t - T)",
    doc="The torque is logged later than the positions; of one joint, or in the robot's list of all.",
    signature="in proportion to the rate of the torque; the correlation of torque and model peaks beside "
    "zero",
    rivals=("rotor_inertia", "joint_elasticity"),
    separates="fast reversals at two speeds",
    source="Ljung, System Identification, section 3.2",
    traits=Traits(
        noun="a late torque",
        of_all=True,
        channel=Channel("delay", "delay"),
        adds=("delay",),
        candidates=(Shown(3, of_all=2),),
        reevaluate=True,
        hidden=Hidden(lambda u, way, rng: Form(lambda x: {"delay": x}, 0.005, 1e-4, 0.05)),
    ),
)

OFFSET = Effect(
    id="encoder_offset",
    title="Encoder offset",
    place="sensor",
    parameters=(Parameter("offset", "Measured less true.", "rad", "m", symbol=r"\delta"),),
    latex=r"q_m = q + \delta",
    doc="The joint's zero is not where it is taken to be.",
    signature="gravity's torques of several joints, shifted",
    rivals=("payload", "base_tilt", "inertial_error", "spring"),
    separates="a calibration of the kinematics",
    source="Mooring, Roth and Driels 1991",
    equation=lambda p, at: p["offset"],
    linear=("offset",),
    traits=Traits(
        noun="an encoder offset",
        channel=Channel("position", "offset"),
        candidates=(Shown(3),),
        reevaluate=True,
        wide=True,
        hidden=Hidden(
            lambda u, way, rng: Form(lambda x: {"offset": way * x}, 0.03, 1e-4, 0.2), needs="gravity"
        ),
    ),
)


def _clip(p: Values, at: Site) -> Any:
    return clamped(at.tau, -p["limit"], p["limit"]) - at.tau


def _limit_form(u: Usual, way: float, rng: Any) -> Form:
    who = str(rng.choice(["drive", "sensor"]))
    return Form(lambda x: {"limit": u.peak / (1 + x), "clips": who}, 0.15, 0.01, 0.8)


SATURATION = Effect(
    id="torque_saturation",
    title="Saturation of the torque",
    place="sensor",
    parameters=(
        Parameter("limit", "Largest torque, as a size.", TORQUE, FORCE, sign="positive", symbol=r"\tau_s"),
        Parameter(
            "clips",
            "Who clips: the drive (the log has the command), or the sensor (only the log is clipped).",
            kind="choice", choices=("drive", "sensor"), default="drive",
        ),
    ),
    latex=r"\tau_m = \min(\max(\tau, -\tau_s), \tau_s)",
    doc="The torque does not go beyond a limit; whether that of the drive or that of the log, `clips` says.",
    signature="samples pile up at one value, residuals there have one sign",
    rivals=("external_contact",),
    separates="a slower motion, or the drive's own limits",
    source="Craig, Introduction to Robotics, section 9",
    equation=_clip,
    traits=Traits(
        noun="a torque limit",
        channel=Channel("limit", "limit", "clips"),
        candidates=(Shown(2, of_all=2),),
        reevaluate=True,
        hidden=Hidden(_limit_form, needs="load"),
        over="load",
    ),
)  # fmt: skip

EFFECTS = (BIAS, GAIN, DELAY, OFFSET, SATURATION)
