"""Blind trials of identification: an arm whose inertial numbers are wrong and whose friction is unknown."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from benchmarks.blind_arms.arms import bare
from benchmarks.blind_arms.logs import Hidden
from benchmarks.gap.blind.files import answer
from benchmarks.gap.blind.grade import graded
from benchmarks.gap.blind.trials import Trial, arm_of, model_of

from robodyn.diagnose.run import diagnose
from robodyn.errors import RobodynError
from robodyn.gate.gate import inspect
from robodyn.identify.fit import Load, Options
from robodyn.identify.predict import lacking
from robodyn.identify.run import Identification, identify
from robodyn.logs.log import Log
from robodyn.robot import read_text
from robodyn.robot.model import Robot
from robodyn.robot.values import Affine, Value

#: An identified arm may leave this many times the noise, over all joints.
FLOORS = 1.2
#: Torque constants are off by this share at most.
_CONSTANTS = 0.25
_AXES = ("xx", "yy", "zz", "xy", "xz", "yz")

Make = Callable[[Trial], Hidden]


def free_of(trial: Trial) -> Trial:
    """The trial with nothing hidden, on another motion."""
    return replace(trial, kind="identify", effect=None, joint=None, ratio=1.0, seed=trial.seed + 500)


def described(trial: Trial) -> Robot:
    """What is known of the arm beforehand: no friction, and wrong numbers."""
    return model_of(trial, bare(trial.arm))


def numbers(trial: Trial, make: Make, only: Sequence[str] = ()) -> dict[str, Any]:
    """Identification alone: what it leaves of another motion in noise floors, beside what the true arm leaves
    (positions are filtered, and friction turns round within a sample), and each number's interval."""
    free = make(trial)
    result = identify(described(trial), [free.train], free.validate)
    left = result.residual.validate_after / free.truth.noise
    gate = inspect(free.validate, described(trial), source="validation")
    true = lacking(arm_of(trial), gate, result.fit.rest.speeds)
    edge = len(true) // 100
    of_truth = np.sqrt((true[edge:-edge] ** 2).mean(axis=0)) / free.truth.noise
    return {
        "status": "right" if _rms(left) <= FLOORS else "wrong",
        "truth_ratio": of_truth.round(3).tolist(),
        "floor_ratio": left.round(3).tolist(),
        "plain_ratio": (result.residual.validate_plain / free.truth.noise).round(3).tolist(),
        "strict": strict(result),
        "values": values(result, arm_of(trial)),
        "unseen": len(result.not_identifiable),
    }


def name_after(trial: Trial, make: Make, only: Sequence[str] = ()) -> dict[str, Any]:
    """Identification on a free log, then a diagnosis of the identified arm with an effect hidden in it, which
    looks for ``only`` these."""
    free, hidden = make(free_of(trial)), make(trial)
    result = identify(described(trial), [free.train, free.validate])
    found = diagnose(result.model, [hidden.train], hidden.validate, only=only)
    return graded(answer(hidden), found.to_dict())


def payload_after(trial: Trial, make: Make, only: Sequence[str] = ()) -> dict[str, Any]:
    """The mass of a payload where torque constants are wrong on file: by both logs together, and by a
    diagnosis of the arm as the free log has it."""
    free, hidden = make(free_of(trial)), make(trial)
    rng = np.random.default_rng((trial.seed, 25))
    constants = 1 + rng.uniform(-_CONSTANTS, _CONSTANTS, bare(trial.arm).n)
    logs = [_scaled(log, constants) for log in (free.train, free.validate, hidden.train, hidden.validate)]
    robot = described(trial)
    together = identify(robot, logs[:3], options=Options(gains=True, loads=(Load((2,)),)))
    mass = hidden.truth.effects[0].number("mass")
    estimate = together.parameters["load1.mass"]
    arm = identify(robot, logs[:2], options=Options(gains=True)).model
    diagnosis = diagnose(arm, logs[2:3], logs[3])
    loads = [f.parameters["mass"].value for f in diagnosis.findings if "com_z" in f.parameters]
    by_both = estimate.value / mass - 1
    off = {"together": by_both, "diagnosed": [float(x) / mass - 1 for x in loads]}
    scaled = hidden._replace(truth=replace(hidden.truth, noise=hidden.truth.noise * constants))
    return {
        **graded(answer(scaled), diagnosis.to_dict()),
        "status": "right" if abs(by_both) <= 0.1 else "wrong",
        "masses": off,
        "values": [["load.mass", estimate.value, estimate.stderr, mass]],
    }


RUNS: dict[str, Callable[[Trial, Make, Sequence[str]], dict[str, Any]]] = {
    "identify": numbers,
    "after": name_after,
    "payload": payload_after,
}


def values(result: Identification, true: Robot) -> list[list[Any]]:
    """[kind, value, standard error, true value] of each number that was identified; those of a kind are the
    same number of other links or joints."""
    rows: list[list[Any]] = []
    for name, estimate in result.parameters.items():
        place, _, what = name.partition(".")
        rows.append([what, estimate.value, estimate.stderr, _truth(true, place, what)])
    return [row for row in rows if row[2] is not None and row[3] is not None]


def _truth(robot: Robot, place: str, what: str) -> float | None:
    """A number of ``robot`` by its name in ``identify.json``; None for a sensor's, which it does not have."""
    link = robot.links[int(place.lstrip("abcdefghijklmnopqrstuvwxyz")) - 1]
    if place.startswith("link"):
        plain: dict[str, Value] = {"mass": link.mass}
        plain |= {f"com_{axis}": c for axis, c in zip("xyz", link.com, strict=True)}
        plain |= {f"inertia_{axes}": getattr(link.inertia, axes) for axes in _AXES}
        return _float(plain[what])
    keys = {
        "viscous_friction.coefficient": link.joint.viscous,
        "coulomb_friction.level": link.joint.coulomb,
        "rotor_inertia.inertia": link.joint.motor_inertia,
        "torque_bias.bias": 0,
    }
    return _float(keys[what]) if what in keys else None


def _float(value: Value | int) -> float:
    assert not isinstance(value, Affine)
    return float(value)


def strict(result: Identification) -> bool:
    """Whether the new description holds nothing that is physically doubtful."""
    try:
        read_text(result.model_text, strict=True)
    except RobodynError:
        return False
    return True


def _scaled(log: Log, constants: np.ndarray[Any, np.dtype[np.float64]]) -> Log:
    return replace(log, tau=log.tau * constants)


def _rms(x: np.ndarray[Any, np.dtype[np.float64]]) -> float:
    return float(np.sqrt(np.mean(x**2)))
