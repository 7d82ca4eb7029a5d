"""How far an arm's numbers may be from its description: sizes of links, and a Gaussian about its values."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from robodyn.arrays import Floats
from robodyn.identify.limits import (
    ASYMMETRY,
    FREE_SHARE,
    LEAST_INERTIA,
    LEAST_LENGTH,
    LEAST_MASS,
    UNSTATED_CONFIDENCE,
)
from robodyn.identify.normal import Layout
from robodyn.identify.rows import bare
from robodyn.kernels.array_dynamics import Model
from robodyn.robot.model import Robot
from robodyn.robot.values import Value


@dataclass(frozen=True, slots=True, eq=False)
class Prior:
    """Values [p] of the description and standard deviations [p] about them; ``sizes`` of the links: mass [kg]
    and length [m]."""

    mean: Floats
    sd: Floats
    sizes: tuple[tuple[float, float], ...]


def number_of(value: Value) -> float:
    """A number of a robot without run-time parameters."""
    assert isinstance(value, Fraction), "Robot.at fills parameters in"
    return float(value)


def sizes_of(robot: Robot) -> tuple[tuple[float, float], ...]:
    """Mass [kg] and length [m] of each link, for scale; descriptions have links without either."""
    phi = Model(bare(robot)).standard_parameters()
    joints = [link.joint for link in robot.links]
    reach = [math.hypot(number_of(joint.a), number_of(joint.b), number_of(joint.d)) for joint in joints]
    heaviest, longest = max(float(phi[:, 0].max()), 1e-9), max(*reach, 1e-9)
    sizes = []
    for k in range(robot.n):
        mass = max(float(phi[k, 0]), LEAST_MASS * heaviest)
        beyond = reach[k + 1] if k + 1 < robot.n else 0.0
        centre = float(np.linalg.norm(phi[k, 1:4])) / mass
        gyration = float(np.sqrt(max(float(phi[k, 4:7].max()), 0.0) / mass))
        sizes.append((mass, max(centre, gyration, 0.5 * beyond, LEAST_LENGTH * longest)))
    return tuple(sizes)


def confidence_of(robot: Robot) -> Floats:
    """By which share [n] the inertial numbers of each link may be off."""
    shares = [
        UNSTATED_CONFIDENCE if link.confidence is None else float(link.inertial_share) for link in robot.links
    ]
    return np.array(shares)


@dataclass(frozen=True, slots=True, eq=False)
class Usual:
    """What is usual of the joints [n] in logs: RMS torque, speed and acceleration."""

    torque: Floats
    speed: Floats
    acceleration: Floats


def prior_of(robot: Robot, layout: Layout, usual: Usual, confidence: float | None = None) -> Prior:
    """The prior of ``robot``: friction and rotors may be anything that has torques of the ``usual`` size.
    ``confidence``: in place of what the description says of its links."""
    model, sizes = Model(bare(robot)), sizes_of(robot)
    phi = model.standard_parameters()
    mean, sd = np.zeros(layout.size), np.zeros(layout.size)
    shares = confidence_of(robot) if confidence is None else np.full(robot.n, confidence)
    for k, ((mass, length), share) in enumerate(zip(sizes, shares, strict=True)):
        first = mass * length
        second = np.full(6, LEAST_INERTIA * mass * length**2)
        second = np.maximum(second, float(np.abs(phi[k, 4:]).max()))
        mean[layout.link(k)] = phi[k]
        # A number that is described too small by that share is farther from the truth in its own units.
        spread = share * (1 + ASYMMETRY * share)
        sd[layout.link(k)] = spread * np.concatenate([[mass], np.full(3, first), second])
    motor = robot.torque_side == "motor"
    for j, link in enumerate(robot.links):
        values = {
            "viscous": number_of(link.joint.viscous) if motor else 0.0,
            "coulomb": number_of(link.joint.coulomb) if motor else 0.0,
            "rotor": number_of(link.joint.motor_inertia),
            "offset": 0.0,
        }
        free = {
            "viscous": usual.torque[j] / max(usual.speed[j], 1e-9),
            "coulomb": usual.torque[j],
            "rotor": usual.torque[j] / max(usual.acceleration[j], 1e-9),
            "offset": usual.torque[j],
        }
        for name in layout.own:
            at = layout.joint(name)[j]
            mean[at] = values[name]
            sd[at] = max(FREE_SHARE * free[name], abs(values[name]), 1e-9)
    return Prior(mean, sd, sizes)
