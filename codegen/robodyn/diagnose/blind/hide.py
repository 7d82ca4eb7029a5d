"""A blind test on one's own arm: effects hidden from a model, logs that show them, and the answer sealed.

The arm with the effects is simulated under a controller that knows the given model only; encoders and torque
channel have their steps and noise.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.amend.amend import Amendment, amended
from robodyn.diagnose.blind.drawn import draw, form, places, settings, sized, usual
from robodyn.diagnose.blind.limits import (
    BASE_FREQUENCY,
    DRAWS,
    HARMONICS,
    LEAST_SIZE,
    LIMITS_SHARE,
    QUIET_SHARE,
)
from robodyn.diagnose.blind.seal import seal
from robodyn.effects.catalogue import CATALOGUE, effect
from robodyn.effects.effect import Effect
from robodyn.errors import InputError
from robodyn.identify.known import covariance_text, with_covariance_read
from robodyn.identify.predict import model_torque, offsets
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.logs.provenance import provenance
from robodyn.robot.effects import belongs
from robodyn.robot.model import Robot
from robodyn.simulate.gains import default_gains
from robodyn.simulate.limits import with_limits
from robodyn.simulate.plant import build_plant
from robodyn.simulate.sensors import Sensors, measure, measured_position, measured_torque, resolution_of
from robodyn.simulate.simulation import Follow, simulate
from robodyn.simulate.trajectories.fourier import fourier
from robodyn.simulate.trajectories.trajectory import Trajectory


@dataclass(frozen=True, slots=True)
class Setup:
    """How logs are made: their ``duration`` [s] and ``rate`` [Hz]; ``noise`` of the torques as a share of
    their RMS; ``encoder_bits`` a turn (prismatic: a metre), None for exact ones; the gap of a drawn effect is
    ``ratio`` noise floors, where it shows best."""

    duration: float = 10.0
    rate: float = 1000.0
    noise: float = 0.015
    encoder_bits: int | None = 20
    ratio: float = 4.0
    seed: int = 0


@dataclass(frozen=True, slots=True, eq=False)
class Blind:
    """A blind test: the ``model`` and its ``text``, logs, and the answer: the ``effects`` that are
    hidden, the ``true`` robot; RMS [n] of the torques' ``noise`` and of what the model lacks (``gap``), in
    the training log."""

    model: Robot
    text: str
    true: Robot
    effects: tuple[Amendment, ...]
    train: Log
    validate: Log
    noise: Floats
    gap: Floats
    setup: Setup

    @property
    def ratio(self) -> float:
        """The gap in units of the noise, at the joint where it shows best."""
        return float((self.gap / self.noise).max())

    def files(self) -> dict[str, str | bytes]:
        """``given.yaml``, and beside it the covariance that it names, the two logs with what is to be said of
        them, ``answer.sealed``."""
        files: dict[str, str | bytes] = {"given.yaml": self.text}
        covariance = covariance_text(self.model)
        if covariance is not None and self.model.covariance is not None:
            files[self.model.covariance.file] = covariance
        files.update(self.train.files("train.csv"))
        files.update(self.validate.files("validate.csv"))
        hashes = {name: _hash(files[name]) for name in ("train.csv", "validate.csv")}
        files["answer.sealed"] = seal(self.answer(hashes))
        return files

    def answer(self, logs: Mapping[str, str] | None = None) -> dict[str, Any]:
        """What is hidden, ready for JSON; ``logs``: hashes of the logs by name."""
        return {
            "robot": self.model.name,
            "effects": [
                {"effect": one.effect, "joint": one.joint, "parameters": dict(one.parameters)}
                for one in self.effects
            ],
            "noise": self.noise.tolist(),
            "gap": self.gap.tolist(),
            "ratio": self.ratio,
            "setup": {name: getattr(self.setup, name) for name in Setup.__slots__},
            "given": _hash(self.text),
            "logs": dict(logs or {}),
        }


def hide(
    robot: Robot,
    wanted: Sequence[Amendment] = (),
    *,
    random: int = 0,
    setup: Setup | None = None,
    motions: Sequence[Trajectory] = (),
    text: str | None = None,
    progress: Callable[[str], object] | None = None,
    cache: Path | None = None,
) -> Blind:
    """Logs of ``robot`` with the ``wanted`` effects and ``random`` drawn ones, which ``robot`` lacks.

    Of an effect that is wanted without what it needs, joint and parameters are drawn, so that it shows as
    ``setup.ratio`` says; what is given of them stays. ``motions``: of the training log and, if there are two,
    of the validation; else periodic motions inside the limits, which follow from the seed. ``text`` is the
    robot's description. None at all, and none drawn, is a test too: of false alarms.

    Raises
    ------
    InputError: an effect does not fit the robot, or cannot be as large as is wanted; the robot has run-time
    parameters; the simulation does not come to its end.
    ToolError: no C compiler.
    """
    from robodyn.robot.writer import to_yaml

    tell = progress or (lambda _: None)
    how, robot = setup or Setup(), with_covariance_read(robot)
    if robot.parameters:
        raise InputError(
            f"{robot.name} has run-time parameters, of which a log knows no values",
            found=", ".join(robot.parameters),
            remedy="write numbers in their place",
        )
    first, second = _motions(robot, how, motions)
    bench = _Bench(robot, how, first, tell, cache)
    effects = bench.chosen(wanted, random)
    true = amended(robot, effects)
    tell("simulating")
    logs = []
    arm = Arm(robot, true, first, cache)
    exact = arm.log(first, how.rate)
    sensors = _sensors(robot, how, bench.noise)
    for k, (motion, which) in enumerate(((first, exact), (second, None))):
        clean = which or arm.log(motion, how.rate)
        shown = measure(clean, sensors, true.effects, seed=_stream(how.seed, 7, k))
        provenance = _provenance(robot, text, how, motion, sensors)
        logs.append(replace(shown, provenance=provenance))
    gap = rms(lacking(robot, measured(exact, true)))
    return Blind(robot, text or to_yaml(robot), true, effects, logs[0], logs[1], bench.noise, gap, how)


# --- what is hidden ---------------------------------------------------------------------------------------


class _Bench:
    """A robot on a motion, on which effects are given their size."""

    def __init__(
        self, robot: Robot, how: Setup, motion: Trajectory, tell: Callable[[str], object], cache: Path | None
    ) -> None:
        self.robot, self.how, self.tell, self.cache = robot, how, tell, cache
        step = max(1, len(motion) // 2000)
        self.motion = motion
        self.t, self.q, self.qd, self.qdd = (x[::step] for x in (motion.t, motion.q, motion.qd, motion.qdd))
        size = rms(Model(robot).torque(self.q, self.qd, self.qdd))
        self.noise = how.noise * np.maximum(size, QUIET_SHARE * max(float(size.max()), 1e-6))
        self.usual = usual(robot, motion)

    def chosen(self, wanted: Sequence[Amendment], random: int) -> tuple[Amendment, ...]:
        """The effects with all their parameters."""
        rng = np.random.default_rng(_stream(self.how.seed, 3))
        named = tuple(self._placed(one, rng) for one in wanted)
        amendments = [self._sized(one, rng)[0] for one in named]
        missing = random
        for _ in range(DRAWS):
            for one in draw(self.usual, missing, rng, amendments):
                sized, ratio = self._sized(one, rng)
                if ratio > LEAST_SIZE * self.how.ratio:
                    amendments.append(sized)
                    missing -= 1
            if not missing:
                return tuple(amendments)
        raise InputError(
            f"no effect shows {self.how.ratio:g} times the noise of {self.robot.name} on this motion",
            remedy="a lower --ratio, less --noise, or a livelier trajectory",
        )

    def _placed(self, one: Amendment, rng: np.random.Generator) -> Amendment:
        known = effect(one.effect)
        if one.joint is not None or belongs(known, of_robot=True):
            return one
        fit = places(one.effect, self.usual)
        if not fit:
            raise InputError(f"{one.effect} shows at no joint of {self.robot.name}", remedy="name a joint")
        return replace(one, joint=fit[int(rng.integers(len(fit)))])

    def _sized(self, one: Amendment, rng: np.random.Generator) -> tuple[Amendment, float]:
        """The effect with all its parameters, and the gap that it makes, in noise floors."""
        if any(not isinstance(value, str) for value in one.parameters.values()):
            whole = replace(one, parameters=settings({}, one.parameters))
            try:
                amended(self.robot, [whole])
            except InputError:
                pass  # something is missing: it is drawn, or the error comes again
            else:
                return whole, self._shows(whole)
        if one.joint is not None and not 1 <= one.joint <= self.robot.n:
            amended(self.robot, [one])  # refuses it
        self.tell("sizing an effect")
        drawn = form(one.effect, one.joint, self.usual, rng)

        def built(x: float) -> Amendment:
            return replace(one, parameters=settings(drawn.build(x), one.parameters))

        x, ratio = sized(drawn, self.how.ratio, lambda x: self._shows(built(x)))
        return built(x), ratio

    def _shows(self, one: Amendment) -> float:
        """The gap that an effect makes, in noise floors, where it shows best."""
        true = amended(self.robot, [one])
        if _is_tried(effect(one.effect)):
            exact = Arm(self.robot, true, self.motion, self.cache).log(self.motion, 500.0)
            gap = lacking(self.robot, measured(exact, true))
        else:
            tau = Model(true).torque(self.q, self.qd, self.qdd)
            gap = lacking(self.robot, measured(Log(self.t, self.q, self.qd, self.qdd, tau), true))
        return max(float((rms(gap) / self.noise).max()), 1e-9)


# --- how the logs come about ------------------------------------------------------------------------------


def _is_tried(known: Effect) -> bool:
    """Whether the gap of an effect must be tried out: steady formulas do not tell it."""
    channel = known.traits.channel
    limits = channel is not None and channel.acts == "limit"
    return limits or known.coupler is not None or known.place == "outside"


def _sensors(robot: Robot, how: Setup, noise: Floats) -> Sensors:
    steps = [0.0] * robot.n
    if how.encoder_bits is not None:
        turn = resolution_of(how.encoder_bits)
        linear = [link.joint.kind == "prismatic" for link in robot.links]
        steps = [turn / (2 * np.pi) if each else turn for each in linear]
    return Sensors(
        position_resolution=tuple(steps),
        velocity="none",
        acceleration="none",
        torque_noise=tuple(float(f"{x:.6g}") for x in noise),
    )


def _motions(robot: Robot, how: Setup, own: Sequence[Trajectory]) -> tuple[Trajectory, Trajectory]:
    motions = list(own[:2])
    if any(motion.n != robot.n for motion in motions):
        raise InputError(f"the trajectory does not fit {robot.name}", expected=f"{robot.n} joints")
    limited, _ = with_limits(robot)
    periods = max(1, round(BASE_FREQUENCY * how.duration))
    while len(motions) < 2:
        seed = _stream(how.seed, 1, len(motions))
        motions.append(
            fourier(limited, periods / how.duration, HARMONICS, seed, periods=periods, share=LIMITS_SHARE)
        )
    return motions[0], motions[1]


def _provenance(
    robot: Robot, text: str | None, how: Setup, motion: Trajectory, sensors: Sensors
) -> dict[str, Any]:
    """Where a log comes from, as far as that does not give the answer away: seeds would."""
    motion_data = {key: value for key, value in motion.describe().items() if key != "seed"}
    options = {
        "drive": {"kind": "follow", "trajectory": motion_data, "controller": "pd", "model": robot.name},
        "duration": motion.duration,
        "rate": how.rate,
        "noise": how.noise,
        "encoder_bits": how.encoder_bits,
        "blind": "the arm may have effects that this file does not list",
    }
    return provenance(robot, yaml=text, options=options, sensors=sensors.describe(), solver="adaptive")


def _stream(seed: int, *key: int) -> int:
    """A seed of its own for every use."""
    if seed < 0:
        raise InputError("a seed is a number of 0 or more", found=str(seed))
    return int(np.random.SeedSequence(seed, spawn_key=key).generate_state(1)[0])


def _hash(content: str | bytes) -> str:
    return hashlib.sha256(content.encode() if isinstance(content, str) else content).hexdigest()


# --- the true arm, and what its model lacks ---------------------------------------------------------------


class Arm:
    """The true arm, compiled, under a controller that takes it for the given one."""

    def __init__(self, model: Robot, true: Robot, motion: Trajectory, cache: Path | None) -> None:
        self.model, self.true = model, true
        self.plant = build_plant(true, model=model, energy=False, cache=cache)
        self.gains = default_gains(self.plant.system, motion, "pd", 1e-3, {})

    def log(self, motion: Trajectory, rate: float) -> Log:
        """What perfect sensors show of the arm on ``motion``."""
        follow = Follow(motion, "pd", *self.gains, model=self.model)
        run = simulate(
            self.true, follow, sample_period=1 / rate, method="adaptive", step=1e-2, plant=self.plant
        )
        return run.true_log()


def measured(exact: Log, true: Robot) -> Log:
    """An ``exact`` log as the sensors of ``true`` show it, without noise."""
    q = measured_position(exact.q, true.effects)
    return replace(exact, q=q, tau=measured_torque(exact.tau, exact.t, true.effects))


def lacking(model: Robot, log: Log) -> Floats:
    """The torque [K, n] of ``log``, which has true rates, that ``model`` does not explain."""
    assert log.qd is not None
    assert log.qdd is not None
    if any(CATALOGUE[entry.effect].kind == "state" for entry in model.effects):
        return np.asarray(log.tau - model_torque(model, log.t, log.q, log.qd, log.qdd, log.tau))
    tau = Model(model).torque(log.q - offsets(model), log.qd, log.qdd)
    return np.asarray(log.tau - measured_torque(tau, log.t, model.effects))


def rms(x: Floats) -> Floats:
    """Root mean square [n] of ``x`` [K, n]."""
    return np.asarray(np.sqrt(np.mean(x**2, axis=0)))
