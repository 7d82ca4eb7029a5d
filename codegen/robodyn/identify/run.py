"""The whole identification: gate, fit, the arm with its new numbers, what it leaves of the logs."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from functools import reduce
from operator import add
from os import PathLike
from typing import Any

import numpy as np

from robodyn.arrays import Floats
from robodyn.errors import InputError
from robodyn.formats.loading import robot_of, text_of
from robodyn.gate.gate import Gate, inspect
from robodyn.identify.fit import Fit, Options, evidence, fit_arm, still_joints, sure
from robodyn.identify.known import covariance_to_dict, with_covariance
from robodyn.identify.limits import (
    COMPARING_COST,
    FITTING_COST,
    LEAST_NOISE,
    LOOKING_COST,
    POOR_CONDITION,
)
from robodyn.identify.outcome import Combined, Estimate, Identified, identified
from robodyn.identify.residual import Squares, squares_of
from robodyn.logs.log import Log, LogSource, log_of
from robodyn.robot.account import account_to_dict
from robodyn.robot.coupling import no_couplings
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True, eq=False)
class Residual:
    """RMS [n] of the raw torque less the model's, of samples at which the joint is not at rest: of the
    description (``before``), of the new numbers (``after``) and of unconstrained least squares (``plain``),
    on all rows that were fitted (``train``), and on rows that the model had not seen (``validate``): those of
    another log, or 30 % of the logs that were held out from a first fit. ``torque``: the RMS of what is
    logged; ``noise_floor``: what no model removes; ``rest_share``: of the samples at which a joint rests, so
    that its torque says no more than that it lies within its dry friction."""

    train_before: Floats
    train_after: Floats
    train_plain: Floats
    train_torque: Floats
    validate_before: Floats
    validate_after: Floats
    validate_plain: Floats
    validate_torque: Floats
    noise_floor: Floats
    rest_share: Floats

    def to_dict(self) -> dict[str, Any]:
        """As ``identify.json`` has it."""
        parts = {
            name: {
                "before": getattr(self, f"{name}_before").tolist(),
                "after": getattr(self, f"{name}_after").tolist(),
                "plain": getattr(self, f"{name}_plain").tolist(),
                "torque": getattr(self, f"{name}_torque").tolist(),
            }
            for name in ("train", "validate")
        }
        more = {name: getattr(self, name).tolist() for name in ("noise_floor", "rest_share")}
        return {**parts, **more}


@dataclass(frozen=True, slots=True)
class Delay:
    """By how much the torques of a ``log`` are read late, and the standard error [s]."""

    log: str
    value: float
    stderr: float
    unit: str = "s"


@dataclass(frozen=True, slots=True, eq=False)
class Identification:
    """What logs say of an arm: ``robot`` as described, ``model`` with its new numbers and ``model_text`` its
    description; ``parameters`` by name, ``combinations`` of them that the logs show, ``not_identifiable``
    those that they do not; ``torque_delay``: logs whose torques are read late; ``condition`` of the base
    regressor; ``held_out``: whether :attr:`residual` was validated on parts of the logs themselves; ``flags``
    of the data gate, ``words`` for people, ``logs`` by name and hash; ``fit``: all the rest."""

    robot: Robot
    model: Robot
    model_text: str
    parameters: Mapping[str, Estimate]
    combinations: tuple[Combined, ...]
    torque_delay: tuple[Delay, ...]
    not_identifiable: tuple[str, ...]
    residual: Residual
    condition: float
    held_out: bool
    flags: tuple[str, ...]
    words: tuple[str, ...]
    logs: tuple[Mapping[str, str], ...]
    fit: Fit

    def to_dict(self) -> dict[str, Any]:
        """As ``identify.json`` has it."""
        return {
            "robot": self.robot.name,
            "parameters": {
                name: {
                    "value": one.value,
                    "stderr": one.stderr,
                    "unit": one.unit.replace(" ", "*"),
                    "described": one.described,
                    "only_in_combination": one.only_in_combination,
                }
                for name, one in self.parameters.items()
            },
            "combinations": [
                {**asdict(one), "unit": one.unit.replace(" ", "*")} for one in self.combinations
            ],
            "torque_delay": [asdict(one) for one in self.torque_delay],
            "not_identifiable": list(self.not_identifiable),
            "residual": self.residual.to_dict(),
            "rest": self.fit.rest.speeds.tolist(),
            "validated_on": "held-out blocks of the logs" if self.held_out else "a log of its own",
            "condition": self.condition,
            "remarks": list(self.words),
            "flags": list(self.flags),
            "logs": [dict(log) for log in self.logs],
            "account": [account_to_dict(self.robot)],
            "covariance": covariance_to_dict(self.model),
        }


def identify(
    robot: Robot | str | PathLike[str],
    logs: Sequence[LogSource],
    validate: LogSource | None = None,
    *,
    options: Options | None = None,
    text: str | None = None,
    names: Sequence[str] = (),
    hashes: Sequence[str] = (),
    parameters: Mapping[str, float] | None = None,
    progress: Callable[[str], object] | None = None,
) -> Identification:
    """The numbers of ``robot`` from ``logs``: links, friction, rotors; ``validate`` is a log that is not
    fitted.

    A robot may be a path or a name, a log the path of a file, or what hands it over
    (:data:`robodyn.logs.log.LogSource`). ``text`` is the robot's description, to be
    amended; ``names`` and ``hashes`` are those of the logs, the validation's last.

    Raises
    ------
    InputError: there is no such robot or file, a log cannot be used, or ``parameters`` do not fit the
    robot (:meth:`Robot.at`).
    """
    from robodyn.robot.rewriting import rewritten
    from robodyn.robot.writer import to_yaml

    tell = progress or (lambda _: None)
    if text is None and not isinstance(robot, Robot):
        text = text_of(robot)
    robot = robot_of(robot)
    robot = robot.at(parameters or {})
    no_couplings(robot, "an identification")
    tell("looking at the logs")
    labels = [names[k] if k < len(names) else f"log {k + 1}" for k in range(len(logs) + 1)]
    gates = [inspect(log_of(log, robot.n), robot, source=labels[k]) for k, log in enumerate(logs)]
    seen = None if validate is None else inspect(log_of(validate, robot.n), robot, source=labels[len(logs)])
    if all(np.abs(gate.log.tau).max() <= LEAST_NOISE for gate in gates):
        raise _nothing_shows(robot, f"no torque beyond {LEAST_NOISE:g} N m or N")
    tell("fitting the arm")
    fit = fit_arm(robot, gates, _without_contacts(robot, options or Options(), hashes[: len(logs)]))
    if np.isnan(fit.condition):
        raise _nothing_shows(
            robot, "no joint that moves, and no gravity that turns or pushes one that stands"
        )
    tell("comparing the torques")
    outcome, late = identified(fit), _delays(fit, labels)
    arm = with_covariance(outcome.robot, fit)
    old = text if text is not None and parameters is None else to_yaml(robot)
    new = rewritten(old, robot, arm, outcome.origins, _notes(robot, outcome, hashes[: len(logs)]))
    every = [*gates, *([] if seen is None else [seen])]
    return Identification(
        robot, arm, new, outcome.parameters, outcome.combinations,
        late, outcome.not_identifiable,
        _residual(fit, gates, seen), fit.condition, seen is None,
        tuple(str(flag) for gate in every for flag in gate.flags), remarks(fit, outcome, gates, late),
        tuple(
            {"name": labels[k], "sha256": hashes[k] if k < len(hashes) else ""} for k in range(len(every))
        ),
        fit,
    )  # fmt: skip


def _delays(fit: Fit, labels: Sequence[str]) -> tuple[Delay, ...]:
    """The logs whose torques are late by more than rows have it by chance."""
    found = zip(labels, *(x.tolist() for x in fit.late), fit.shift.tolist(), strict=False)
    return tuple(Delay(label, value, error) for label, value, error, shift in found if shift)


def _nothing_shows(robot: Robot, reason: str) -> InputError:
    """Nothing of ``robot`` is observed, and why."""
    return InputError(
        f"none of {robot.name}'s numbers shows in the logs",
        found=reason,
        expected="torques in which a link, a rotor or friction has a part",
        remedy="record a motion of the joints whose numbers are wanted, with their torques",
    )


def _without_contacts(robot: Robot, options: Options, hashes: Sequence[str]) -> Options:
    """``options`` that leave out where the description knows of contacts in these logs."""
    windows = tuple(
        (list(hashes).index(entry.text("log")), entry.number("start"), entry.number("end"))
        for entry in robot.effects
        if entry.definition.place == "outside" and "log" in entry and entry.text("log") in hashes
    )
    return replace(options, left_out=(*options.left_out, *windows))


def _notes(robot: Robot, outcome: Identified, hashes: Sequence[str]) -> list[Any]:
    """A comment above the first thing that is new."""
    places = {
        (j, key)
        for j, (old, new) in enumerate(zip(robot.links, outcome.robot.links, strict=True), 1)
        if old != new
        for key in ("mass", "com", "inertia", "motor_inertia", "viscous", "coulomb")
    }
    notes: list[Any] = [(frozenset(places), [f"robodyn identify: {', '.join(hashes) or 'from a log'}"])]
    if robot.torque_side != outcome.robot.torque_side:
        note = "was link: yet friction shows in this torque, and is in the model now (rotors are not)"
        notes.append((frozenset({(None, "torque_side")}), [note]))
    return notes


def _residual(fit: Fit, gates: Sequence[Gate], seen: Gate | None) -> Residual:
    """What the models leave: the first fit's of rows that were held out, the last one's of all."""
    layout = fit.layout
    sums: list[Squares] = []
    shift = [*fit.shift.tolist(), float(fit.shift.mean())]
    for k, gate in enumerate([*gates, *([] if seen is None else [seen])]):
        log = k if k < len(gates) else -1
        models, scales = [fit.prior.mean, fit.plain, fit.plain_first], [np.ones(layout.n)] * 3
        for solution in (fit.solution, fit.first):
            z = solution.z
            models.append(fit.unknowns.parameters(z, log) if log >= 0 else z[: layout.size])
            scales.append(fit.unknowns.scales(z))
        sums.append(
            squares_of(fit.robot, layout, gate, fit.rest, np.stack(models), np.stack(scales), shift[k])
        )
    whole = reduce(add, sums[: len(gates)])
    rms, unseen = whole.rms(), whole.rms(held_out=True) if seen is None else sums[-1].rms()
    plain, after = (2, 4) if seen is None else (1, 3)  # the first fit's, of what it has not seen
    noise = np.sqrt(np.mean([gate.torque_noise**2 for gate in gates], axis=0))
    share = whole.resting / np.maximum(whole.count.sum(axis=0) + whole.resting, 1)
    return Residual(
        rms[0], rms[3], rms[1], rms[5], unseen[0], unseen[after], unseen[plain], unseen[5], noise, share
    )


def remarks(fit: Fit, outcome: Identified, gates: Sequence[Gate], late: Sequence[Delay]) -> tuple[str, ...]:
    """Remarks for people, most important first."""
    words = []
    still = [j + 1 for j in still_joints(gates)]
    if still:
        verb = "does" if len(still) == 1 else "do"
        words.append(f"{_named('joint', still)} {verb} not move in these logs: friction and rotor stay")
    if fit.condition > POOR_CONDITION:
        words.append(
            f"the motion excites the arm poorly (condition {fit.condition:.3g}; below {POOR_CONDITION:g} is "
            f"good): record one of `robodyn excite {fit.robot.name}`"
        )
    for one in late:
        size = f"{1e3 * abs(one.value):.3g} +- {1e3 * one.stderr:.2g} ms"
        words.append(f"{one.log}: torques are read {size} {'late' if one.value > 0 else 'early'}")
    offsets = fit.layout.joint("offset") if "offset" in fit.layout.own else np.zeros(0, dtype=np.intp)
    shown = [j + 1 for j, at in enumerate(offsets.tolist()) if fit.unknowns.free[at]]
    if shown:
        words.append(f"the torque of {_named('joint', shown)} is off by a constant, also on held-out samples")
    wide = [
        k + 1
        for k in range(fit.robot.n)
        if fit.solution.prior[fit.layout.link(k)[0]] * fit.unknowns.sd[fit.layout.link(k)[0]] ** 2 < 0.5
    ]
    if wide:
        words.append(
            f"{_named('link', wide)}: farther from the description than its confidence says; a spring, load "
            "or a coupling may be behind that: `robodyn diagnose` looks for it"
        )
    if outcome.robot.torque_side != fit.robot.torque_side:
        words.append(
            "the torque is described as measured behind the gear, and has friction in it all the same: "
            f"identified.yaml says torque_side: {outcome.robot.torque_side}"
        )
    if "rotor" in fit.layout.own:
        weak = [j + 1 for j in np.flatnonzero(evidence(fit.worth["rotor"]) < -sure(fit.robot.n)).tolist()]
        if weak:
            words.append(f"the rotor of {_named('joint', weak)} does not help on held-out samples")
    return tuple(words)


def _named(what: str, places: Sequence[int]) -> str:
    """``joint 2``, ``joints 2, 3 and 5``."""
    *several, last = map(str, places)
    return f"{what}s {', '.join(several)} and {last}" if several else f"{what} {last}"


def stages(n: int, logs: Sequence[Log]) -> dict[str, float]:
    """The stages of the identification of ``n`` joints from ``logs`` in their order, as ``progress`` is told
    of them, and about how long each takes [s]."""
    numbers = n * sum(log.samples for log in logs)
    costs = {
        "looking at the logs": LOOKING_COST,
        "fitting the arm": FITTING_COST,
        "comparing the torques": COMPARING_COST,
    }
    return {name: base + each * numbers for name, (base, each) in costs.items()}
