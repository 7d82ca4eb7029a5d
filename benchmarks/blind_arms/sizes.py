"""Effects of a wanted size: how large they are is found by a trial run."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from benchmarks.blind_arms.arms import RANDOM, bare, index_of
from benchmarks.blind_arms.logs import (
    effect,
    gravity_varies,
    hidden_log,
    outsider,
    peak_and_inertia,
    quiet,
    typical,
)

from peers.numbers import Array, number
from robodyn.robot.model import EffectEntry

_TRIALS = 5
Build = Callable[[float], EffectEntry]


@dataclass(frozen=True, slots=True)
class Sized:
    """An effect of any size: ``build(x)``; ``start``: a first guess of x, near a twentieth of the torque,
    of the sign that x is to have; ``least``, ``most``: what is physically likely of its size."""

    build: Build
    start: float
    least: float = 0.0
    most: float = np.inf


def sized(arm: str, form: Sized, share: float, *, seed: int, duration: float, **how: Any) -> EffectEntry:
    """The effect of which the gap, where it shows best, is ``share`` of the RMS torque there; ``how``:
    further arguments of :func:`~benchmarks.blind_arms.logs.hidden_log`."""
    x = form.start
    tried: list[tuple[float, float]] = []
    for _ in range(_TRIALS):
        made = hidden_log(
            arm, [form.build(x)], seed=seed, duration=duration, noise_share=1.0,
            validation=False, encoder_bits=None, **{"step": 5e-4, **how},
        )  # fmt: skip
        found = max(float(made.truth.ratio.max()), 1e-9) / share
        tried.append((abs(x), found))
        if 2 / 3 < found < 3 / 2:
            size = min(max(abs(x) / found, form.least), form.most)
            break
        size = min(max(_next(tried), form.least), form.most)
        if size == abs(x):
            break
        x = size if x > 0 else -size
    else:
        size, _ = min(tried, key=lambda trial: abs(np.log(trial[1])))
    return form.build(size if x > 0 else -size)


def _next(tried: list[tuple[float, float]]) -> float:
    """The size at which the gap would be right (1), by the sizes and gaps that were tried: between the
    nearest on either side, or in proportion beyond."""
    below = max((trial for trial in tried if trial[1] < 1), default=None)
    above = min((trial for trial in tried if trial[1] >= 1), default=None)
    if below and above:
        power = np.log(above[1] / below[1]) / np.log(above[0] / below[0])
        return float(below[0] * below[1] ** (-1 / max(power, 0.2)))
    size, found = tried[-1]
    return size / found


#: Joints (from 1) that gravity loads, of the arms with names.
_LOADED = (2, 3)
_LOADED_PANDA = (2, 4)
#: What shows by the load of a joint.
_BY_LOAD = (
    "load_dependent_friction", "journal", "transmission_loss", "torque_gain", "encoder_offset",
    "joint_elasticity", "backlash", "inertial_error", "torque_saturation",
)  # fmt: skip
#: A random arm's joint is loaded if what gravity takes varies by this share of its RMS torque.
_VARIES = 0.2


def joints(arm: str, id: str) -> tuple[int | None, ...]:
    """Joints (from 1) at which an effect shows, the first the plainest; None for the whole robot. Of a random
    arm there may be none."""
    n = bare(arm).n
    random = arm.startswith(RANDOM)
    if id in ("payload", "base_tilt", "external_contact", "time_delay", "swinging_tool"):
        upright = bare(arm).gravity[0] == 0 or id != "base_tilt"
        return (None,) if upright else ()
    if random:
        strong, loaded = _strong(arm), _loaded(arm)
        if id == "motor_coupling":
            turning = [j for j in strong if bare(arm).links[j - 1].joint.kind == "revolute"]
            return tuple(j for j in turning if j - 1 in turning)[-1:]
        if id == "inertial_error":  # of the last link it would be a payload
            return tuple(j for j in loaded if j < n)
        return loaded if id in (*_BY_LOAD, "gas_spring", "torque_ripple") else strong
    if id == "motor_coupling":
        return (n,)
    if id == "gas_spring":
        return (2,)
    if id in _BY_LOAD:
        return _LOADED_PANDA if arm == "panda" else _LOADED
    return tuple(range(1, n + 1))


@cache
def _strong(arm: str) -> tuple[int, ...]:
    tau = typical(arm, 0)[0]
    return tuple(int(j) + 1 for j in np.flatnonzero(tau >= quiet(arm, tau)))


@cache
def _loaded(arm: str) -> tuple[int, ...]:
    varies = gravity_varies(arm, 0) >= _VARIES * typical(arm, 0)[0]
    turns = [link.joint.kind == "revolute" for link in bare(arm).links]
    return tuple(j for j in _strong(arm) if varies[j - 1] and turns[j - 1])


def form(arm: str, id: str, joint: int | None, seed: int) -> Sized:
    """The effect ``id`` at ``joint``, its shape drawn by ``seed``, its size open."""
    rng = np.random.default_rng((seed, index_of(arm), sum(map(ord, id)), joint or 0))
    robot = bare(arm)
    tau, speed, rate, slow = typical(arm, seed)
    peak, weight = peak_and_inertia(arm, seed)
    j = (joint or 2) - 1
    near = float(0.05 * tau[j])
    revolute = robot.links[j].joint.kind == "revolute"
    middle = _middle(arm)

    def drawn(low: float, high: float) -> float:
        return float(np.exp(rng.uniform(np.log(low), np.log(high))))

    match id:
        case "viscous_friction":
            return Sized(lambda x: effect(id, joint, coefficient=x), near / speed[j])
        case "coulomb_friction":
            return Sized(lambda x: effect(id, joint, level=x), near)
        case "power_law_friction":
            power = float(rng.choice([0.5, 0.6, 0.7, 2.0]))
            return Sized(lambda x: effect(id, joint, level=x, exponent=power), near / speed[j] ** power)
        case "asymmetric_friction":
            lean = float(rng.choice([-1, 1])) * drawn(0.25, 0.5)
            return Sized(lambda x: effect(id, joint, positive=x * (1 + lean), negative=x * (1 - lean)), near)
        case "stribeck_friction":
            rise, knee = drawn(1.6, 2.5), float(slow[j]) * drawn(0.7, 1.4)
            return Sized(lambda x: effect(id, joint, level=x, static=rise * x, velocity=knee), near)
        case "load_dependent_friction":
            return _bearing(joint, revolute, near, rng)
        case "journal":
            radius, span = drawn(0.01, 0.06), drawn(0.05, 0.3)
            return Sized(lambda x: _journal(joint, x, radius, span), 0.05, 0.0005, 2.0)
        case "transmission_loss":
            rest = float(rng.choice([0.0, 0.3]))
            rms = float(tau[j])
            return Sized(
                lambda x: effect(id, joint, efficiency=1 / (1 + x), breakaway=rest * x * rms),
                0.05,
                0.005,
                1.0,
            )
        case "rotor_inertia":
            return Sized(lambda x: effect(id, joint, inertia=x), near / rate[j])
        case "motor_coupling":
            assert joint
            other, ratio = joint - 1, float(rng.choice([-1.0, 1.0]))
            return Sized(
                lambda x: effect(
                    id, joint, **{"with": other}, ratio=ratio, inertia=0.6 * x / rate[j],
                    viscous=0.5 * x / speed[j], coulomb=0.5 * x,
                ),
                near,
            )  # fmt: skip
        case "payload":
            com = tuple(float(c) for c in rng.uniform([-0.05, -0.05, 0.03], [0.05, 0.05, 0.15]))
            return Sized(lambda x: effect(id, None, mass=x, com=com), 0.3, 0.01, 10.0)
        case "inertial_error":
            mass = number(robot.links[j].mass)
            way = rng.standard_normal(3) * 0.05
            return Sized(
                lambda x: effect(
                    id, joint, delta_mass=0.5 * x * mass, delta_com_x=x * float(way[0]),
                    delta_com_y=x * float(way[1]), delta_zz=0.2 * x,
                ),
                0.3, 0.01, 3.0,
            )  # fmt: skip
        case "base_tilt":
            angle = rng.uniform(0, 2 * np.pi)
            return Sized(
                lambda x: effect(id, None, tilt_x=x * float(np.cos(angle)), tilt_y=x * float(np.sin(angle))),
                0.05, 0.001, 0.2,
            )  # fmt: skip
        case "spring":
            rest = float(middle[j] + rng.uniform(-0.3, 0.3) * (1.0 if revolute else 0.3))
            return Sized(lambda x: effect(id, joint, stiffness=x, rest=rest), near)
        case "gas_spring":
            center = float(middle[j] + rng.uniform(-1.2, 1.2))
            crank, rise = float(rng.uniform(0.15, 0.35)), float(rng.uniform(0.0, 0.5))
            return Sized(
                lambda x: effect(id, joint, torque=x, dead_center=center, ratio=crank, rise=rise), near
            )
        case "torque_ripple":
            waves, phase = float(round(drawn(20, 60))), float(rng.uniform(-3, 3))
            return Sized(
                lambda x: effect(id, joint, amplitude=x, cycles_per_rev=waves, phase=phase), 1.4 * near
            )
        case "joint_elasticity":
            softest = float(weight[j]) * (2 * np.pi * 6.0) ** 2
            return Sized(
                lambda x: effect(id, joint, stiffness=1 / x, damping=2e-3 / x), 1 / softest, 1e-7, 1 / softest
            )
        case "backlash":
            teeth = float(weight[j]) * (2 * np.pi * 12.0) ** 2
            return Sized(
                lambda x: effect(id, joint, gap=x, stiffness=teeth, damping=2e-3 * teeth), 0.005, 1e-4, 0.02
            )
        case "presliding_hysteresis":
            way = drawn(3e-3, 2e-2)
            return Sized(
                lambda x: effect(id, joint, level=x, stiffness=x / way, damping=0.01 * x / way), near
            )
        case "torque_bias":
            return Sized(lambda x: effect(id, joint, bias=x), near * float(rng.choice([-1, 1])))
        case "torque_gain":
            way = float(rng.choice([-1, 1]))
            return Sized(lambda x: effect(id, joint, gain=way * x), 0.05, 0.005, 0.4)
        case "time_delay":
            return Sized(lambda x: effect(id, joint, delay=x), 0.005, 0.0005, 0.05)
        case "encoder_offset":
            way = float(rng.choice([-1, 1]))
            return Sized(lambda x: effect(id, joint, offset=way * x), 0.03, 0.001, 0.2)
        case "torque_saturation":
            who = str(rng.choice(["drive", "sensor"]))
            start, least = (0.02, 0.002) if who == "drive" else (0.15, 0.03)
            top = float(peak[j])
            return Sized(lambda x: effect(id, joint, limit=top / (1 + x), clips=who), start, least, 0.6)
        case "external_contact":
            start, width = float(rng.uniform(2.0, 6.0)), float(rng.uniform(0.3, 0.8))
            push = rng.standard_normal(3)
            push = push / np.linalg.norm(push)
            n = robot.n
            return Sized(
                lambda x: effect(
                    id, None, start=round(start, 3), end=round(start + width, 3), link=n,
                    **{f"force_{axis}": x * float(each) for axis, each in zip("xyz", push, strict=True)},
                ),
                30.0, 2.0, 200.0,
            )  # fmt: skip
        case "swinging_tool":
            length = drawn(0.15, 0.3)
            return Sized(lambda x: outsider(id, None, mass=x, length=length), 0.5, 0.02, 4.0)
        case "random_offset":
            dwell = drawn(0.4, 1.2)
            return Sized(lambda x: outsider(id, joint, level=x, dwell=dwell), 2 * near)
        case "acceleration_friction":
            return Sized(lambda x: outsider(id, joint, coefficient=x), near / rate[j])
    raise ValueError(id)


def _bearing(joint: int | None, revolute: bool, near: float, rng: np.random.Generator) -> Sized:
    id = "load_dependent_friction"
    if not revolute:
        return Sized(lambda x: effect(id, joint, bearing="linear", mu=x, span=0.3), 0.05, 0.0005, 0.5)
    match str(rng.choice(["torque", "radial", "journal"])):
        case "torque":
            return Sized(lambda x: effect(id, joint, bearing="torque", mu=x), 0.05, 0.002, 0.5)
        case "radial":
            return Sized(lambda x: effect(id, joint, bearing="radial", mu_r=x), 0.005, 0.0002, 0.1)
    return Sized(lambda x: _journal(joint, x, 0.06, 0.2), 0.1, 0.002, 1.0)


def _journal(joint: int | None, mu: float, radius: float, span: float) -> EffectEntry:
    return effect("load_dependent_friction", joint, bearing="journal", mu=mu, radius=radius, span=span)


def _middle(arm: str) -> Array:
    bounds = [link.joint.limits.position for link in bare(arm).links]
    return np.array([(float(pair[0]) + float(pair[1])) / 2 for pair in bounds if pair])
