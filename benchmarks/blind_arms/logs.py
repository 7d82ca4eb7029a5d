"""Blind tests: logs of an arm that has effects which the model given for it lacks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, Literal, NamedTuple

import numpy as np
from benchmarks.blind_arms.arms import RANDOM, bare, perturbed, rubbing
from benchmarks.blind_arms.laws import Motion, law_of
from benchmarks.blind_arms.model import Solid, Tool
from benchmarks.blind_arms.motion import Drive, Run, felt_inertia, inverse, reference, run
from benchmarks.blind_arms.now import Scale, width_of

from peers.numbers import Array, number
from robodyn.effects.catalogue import CATALOGUE
from robodyn.logs.log import Log
from robodyn.robot.effects import default_of
from robodyn.robot.folding import folded
from robodyn.robot.model import EffectEntry, Robot
from robodyn.simulate.trajectories.trajectory import Law

__all__ = ["Hidden", "Truth", "effect", "hidden_log", "outsider"]

STEP = 2.5e-4
#: Closed loop of the controllers [rad/s].
_BANDWIDTH = 50.0
#: A torque channel is no quieter than one of this share of the arm's largest RMS torque.
_QUIET = 0.05

Rates = Literal["none", "velocity", "both"]


@dataclass(frozen=True, slots=True, eq=False)
class Truth:
    """What is hidden: ``robot`` with its ``effects``; ``noise`` [n]: standard deviation of the torque's;
    ``gap`` [n]: RMS of what the model lacks, were it exact otherwise; ``ratio`` [n]: gap over noise;
    ``clean``: the training log without noise, quantisation, with rates and with what sensors do."""

    robot: Robot
    effects: tuple[EffectEntry, ...]
    noise: Array
    gap: Array
    ratio: Array
    clean: Log


class Hidden(NamedTuple):
    """A blind test: the model that is given, a log to fit, another to validate, and the answer."""

    given: Robot
    train: Log
    validate: Log
    truth: Truth


def effect(id: str, joint: int | None = None, /, **settings: Any) -> EffectEntry:
    """An entry of the catalogue's effect ``id``; what is left out is at its default."""
    defaults = {p.name: default_of(p) for p in CATALOGUE[id].parameters}
    values = {name: value for name, value in defaults.items() if value is not None}
    values.update({name: _exact(given) for name, given in settings.items()})
    return EffectEntry(id, joint, tuple(values.items()))


def outsider(id: str, joint: int | None = None, /, **settings: Any) -> EffectEntry:
    """An entry that no catalogue knows: ``swinging_tool``, ``random_offset`` (``level``, ``dwell``) or
    ``acceleration_friction`` (``coefficient``)."""
    return EffectEntry(id, joint, tuple((name, _exact(given)) for name, given in settings.items()))


def _exact(given: Any) -> Any:
    if isinstance(given, tuple):
        return tuple(map(_exact, given))
    return Fraction(repr(float(f"{given:.9g}"))) if isinstance(given, float) else given


def hidden_log(
    arm: str,
    effects: Sequence[EffectEntry],
    *,
    seed: int,
    duration: float = 10.0,
    rate: float = 1000.0,
    noise_share: float = 0.01,
    ratio: float | None = None,
    encoder_bits: int | None = 20,
    rates: Rates | bool = "none",
    friction: bool = False,
    inertia_error: float = 0.0,
    motion: Motion = "full",
    validation: bool = True,
    step: float = STEP,
    sticks: bool = False,
    jitter: float = 0.0,
) -> Hidden:
    """Logs of ``arm`` (a name of :data:`~benchmarks.blind_arms.arms.ARMS`) with the hidden ``effects``.

    The noise of the torques is ``noise_share`` of each joint's RMS torque (of a
    weak joint's, of a twentieth of the strongest's); with a ``ratio`` it is scaled for
    all joints, so that the gap of the joint where it shows best is that many times its noise. ``friction``:
    the arm has viscous and Coulomb friction that the given model knows. ``inertia_error``: masses, centres
    and inertias of the given model are off by that share. Trajectories follow from ``seed``; ``motion`` may
    be poor on purpose. Without ``validation`` the second log is the first. ``sticks``: dry friction holds a
    joint at rest, else it creeps. Encoders jitter by ``jitter`` steps (standard deviation).
    """
    known = rubbing(bare(arm)) if friction else bare(arm)
    true = _true(known, effects)
    given = perturbed(known, inertia_error, seed) if inertia_error else known
    every = max(1, round(1 / (rate * step)))
    train, scale = _measured(
        true, known, law_of(known, 2 * seed, duration, motion), duration, every, step, seed, sticks
    )
    clean = _clipped(true, train)
    gap = np.sqrt(np.mean(_lacking(known, clean, scale) ** 2, axis=0))
    size = np.sqrt(np.mean(clean.tau**2, axis=0))
    noise = noise_share * np.maximum(size, quiet(arm, size))
    if ratio is not None:
        noise = noise * float((gap / noise).max()) / ratio
    second = train
    if validation:
        law = law_of(known, 2 * seed + 1, duration, motion)
        second, _ = _measured(true, known, law, duration, every, step, seed + 1, sticks)
    kind: Rates = ("both" if rates else "none") if isinstance(rates, bool) else rates
    logs = [
        _noisy(log, true, noise, encoder_bits, kind, np.random.default_rng((seed, which)), jitter)
        for which, log in enumerate((train, second))
    ]
    return Hidden(given, logs[0], logs[1], Truth(true, tuple(effects), noise, gap, gap / noise, clean))


def _true(known: Robot, effects: Sequence[EffectEntry]) -> Robot:
    """``known`` with the ``effects``; those of no catalogue stay entries."""
    robot = folded(replace(known, effects=tuple(e for e in effects if e.effect in CATALOGUE)))
    outside = tuple(e for e in effects if e.effect not in CATALOGUE)
    return replace(robot, effects=(*robot.effects, *outside))


def _measured(
    true: Robot, known: Robot, law: Law, duration: float, every: int, step: float, seed: int, sticks: bool
) -> tuple[Log, Scale]:
    """The noiseless log: what the sensors show that are not noisy, before they clip."""
    t, q, qd, qdd = reference(law, duration, step)
    coarse = slice(None, None, max(1, round(2e-3 / step)))
    ahead = inverse(replace(known, effects=()), q[coarse], qd[coarse], qdd[coarse])
    ahead_of = np.column_stack([np.interp(t, t[coarse], column) for column in ahead.T])
    diagonal, least = felt_inertia(
        replace(true, effects=tuple(e for e in true.effects if e.effect == "payload")), q
    )
    elastic = {e.joint for e in true.effects if e.effect in ("joint_elasticity", "backlash")}
    bandwidth = np.array([_BANDWIDTH / (2 if j + 1 in elastic else 1) for j in range(true.n)])
    drive = Drive(
        q, qd, ahead_of, bandwidth**2 * diagonal, 1.4 * bandwidth * diagonal,
        _at_joints(true, "encoder_offset", "offset", 0.0), _clip(true, "drive"),
    )  # fmt: skip
    rotors = np.array([number(link.joint.motor_inertia) for link in true.links])
    felt = np.array([rotors[j] if j + 1 in elastic else least[j] for j in range(true.n)])
    scale = Scale(step, felt, duration, seed, sticks)
    made = run(true, drive, scale, every, _tool(true))
    return _shown(true, made), scale


def _tool(robot: Robot) -> Tool | None:
    for entry in robot.effects:
        if entry.effect == "swinging_tool":
            mass, length = entry.number("mass"), entry.number("length")
            slim = mass * 0.03**2
            return Tool(Solid(mass, np.array([0.0, 0.0, length]), slim * np.eye(3)), (1.0, 0.0, 0.0), 0.02)
    return None


def _shown(robot: Robot, made: Run) -> Log:
    tau = made.tau.copy()
    for entry in robot.effects:
        if entry.effect == "time_delay":
            joints = range(robot.n) if entry.joint is None else [entry.joint - 1]
            for j in joints:
                tau[:, j] = np.interp(made.t - entry.number("delay"), made.t, made.tau[:, j])
    tau = tau * (1 + _at_joints(robot, "torque_gain", "gain", 0.0)) + _at_joints(
        robot, "torque_bias", "bias", 0.0
    )
    q = made.q + _at_joints(robot, "encoder_offset", "offset", 0.0)
    return Log(made.t, q, made.qd, made.qdd, tau)


def _clipped(robot: Robot, log: Log) -> Log:
    limit = _clip(robot, "sensor")
    return replace(log, tau=np.clip(log.tau, -limit, limit))


def _at_joints(robot: Robot, id: str, name: str, none: float) -> Array:
    """The parameter ``name`` of the effect ``id`` at every joint [n]."""
    values = np.full(robot.n, none)
    for entry in robot.effects:
        if entry.effect == id:
            values[slice(None) if entry.joint is None else entry.joint - 1] = entry.number(name)
    return values


def _clip(robot: Robot, who: str) -> Array:
    limits = np.full(robot.n, np.inf)
    for entry in robot.effects:
        if entry.effect == "torque_saturation" and entry.text("clips") == who and entry.joint:
            limits[entry.joint - 1] = entry.number("limit")
    return limits


def _lacking(known: Robot, log: Log, scale: Scale) -> Array:
    """The gap [K, n] of a noiseless log: torque less that of the arm without the hidden effects, of which the
    friction is known even where it sticks."""
    assert log.qd is not None
    assert log.qdd is not None
    model = inverse(known, log.q, log.qd, log.qdd)
    speed = log.qd - log.qdd * (scale.step / 2)  # what friction went by
    for j, link in enumerate(known.links):
        viscous, coulomb = number(link.joint.viscous), number(link.joint.coulomb)
        model[:, j] += viscous * speed[:, j]
        width = width_of(scale, j, coulomb)
        if scale.sticks:  # at rest, and where it stops: whatever the set holds
            held = np.clip(log.tau[:, j] - model[:, j], -coulomb, coulomb)
            model[:, j] += np.where(abs(speed[:, j]) < width, held, coulomb * np.sign(speed[:, j]))
        else:
            model[:, j] += coulomb * np.clip(speed[:, j] / width, -1, 1)
    gap: Array = log.tau - model
    return gap


def _noisy(
    log: Log, robot: Robot, noise: Array, bits: int | None, rates: Rates, rng: np.random.Generator,
    jitter: float = 0.0,
) -> Log:  # fmt: skip
    q = log.q
    if bits is not None:
        turn = np.array([2 * np.pi if link.joint.kind == "revolute" else 1.0 for link in robot.links])
        steps = q / (turn / 2**bits)
        if jitter:
            steps = steps + jitter * rng.standard_normal(q.shape)
        q = np.round(steps) * (turn / 2**bits)
    tau = log.tau + noise * rng.standard_normal(q.shape)
    rates_seen = log.qd if rates != "none" else None, log.qdd if rates == "both" else None
    return _clipped(robot, Log(log.t, q, *rates_seen, tau))


def quiet(arm: str, size: Array) -> Array:
    """Of RMS torques ``size`` [n], the least that noise is a share of. A random arm's joints are compared
    with those of their kind, for N and N m do not compare; those of the other arms are as they were."""
    if not arm.startswith(RANDOM):
        return np.full(len(size), _QUIET * size.max())
    kinds = np.array([link.joint.kind for link in bare(arm).links])
    return np.array([_QUIET * size[kinds == kind].max() for kind in kinds])


def typical(arm: str, seed: int) -> tuple[Array, Array, Array, Array]:
    """Of the bare arm on the training way of ``seed``, in ten seconds, [n] each: RMS torque, RMS speed, RMS
    acceleration, and the speed below which a tenth of the time is spent."""
    robot = bare(arm)
    _, q, qd, qdd = reference(law_of(robot, 2 * seed, 10.0, "full"), 10.0, 0.01)
    rms = [np.sqrt(np.mean(x**2, axis=0)) for x in (inverse(robot, q, qd, qdd), qd, qdd)]
    return rms[0], rms[1], rms[2], np.quantile(np.abs(qd), 0.1, axis=0)


def peak_and_inertia(arm: str, seed: int) -> tuple[Array, Array]:
    """Largest torque, and mean of what a joint's spring carries (the mass matrix without the rotor), [n]."""
    robot = bare(arm)
    _, q, qd, qdd = reference(law_of(robot, 2 * seed, 10.0, "full"), 10.0, 0.01)
    rotors = np.array([number(link.joint.motor_inertia) for link in robot.links])
    return np.abs(inverse(robot, q, qd, qdd)).max(axis=0), felt_inertia(robot, q)[0] - rotors


def gravity_varies(arm: str, seed: int) -> Array:
    """Standard deviation [n] of what gravity takes, on the same way."""
    robot = bare(arm)
    q = reference(law_of(robot, 2 * seed, 10.0, "full"), 10.0, 0.01)[1]
    varies: Array = inverse(robot, q, 0 * q, 0 * q).std(axis=0)
    return varies
