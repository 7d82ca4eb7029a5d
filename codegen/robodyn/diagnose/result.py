"""What a diagnosis says: verdict, findings, the gap before and after, and the evidence for the report."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.diagnose.limits import ABOVE_NOISE, HALF_WIDTH
from robodyn.robot.account import account_to_dict
from robodyn.robot.model import Robot

Verdict = Literal["missing_effect", "consistent", "unexplained"]


#: The ends of a 95 % interval; None where a side is open.
Bounds = tuple[float | None, float | None]


@dataclass(frozen=True, slots=True)
class Estimate:
    """A parameter of a finding: what is added to the model that was given, SI; its standard error, None where
    the logs do not tell it; ``bounds``: its 95 % interval where that is not as wide to either side as the
    standard error has it."""

    value: float | str
    stderr: float | None
    unit: str
    bounds: Bounds | None = None

    @property
    def interval(self) -> Bounds | None:
        """The interval that holds the true value in 95 of 100 cases; None where nothing is known of it, and
        at a side on which it is open."""
        if isinstance(self.value, str):
            return None
        if self.bounds is not None:
            return None if self.bounds == (None, None) else self.bounds
        if self.stderr is None or not 0 < self.stderr < np.inf:
            return None
        return self.value - HALF_WIDTH * self.stderr, self.value + HALF_WIDTH * self.stderr

    @property
    def is_identifiable(self) -> bool:
        """Whether the logs bound it, as far as that was asked."""
        return self.bounds is None or None not in self.bounds

    def to_dict(self) -> dict[str, Any]:
        """As ``diagnosis.json`` has it."""
        return {
            "value": self.value,
            "stderr": self.stderr,
            "unit": self.unit.replace(" ", "*"),
            "interval": None if self.interval is None else list(self.interval),
            "identifiable": self.is_identifiable,
        }


@dataclass(frozen=True, slots=True)
class Rival:
    """Another candidate for a finding's place: ``gain`` in units of log-likelihood on parts of the log that
    were not fitted, beside that of the finding; ``parts``: the gain in each of those parts; ``why`` it is not
    the name, in words."""

    effect: str
    joint: int | None
    gain: float
    parts: tuple[float, ...] = ()
    why: str = ""


@dataclass(frozen=True, slots=True)
class Tried:
    """A candidate that was not named: its ``gain`` and ``t`` over the parts of the log, and why not."""

    effect: str
    joint: int | None
    gain: float
    t: float
    reason: str


@dataclass(frozen=True, slots=True)
class Window:
    """A stretch of time, ``start`` to ``end`` [s], that the fit left out or that a flag is about; ``name`` is
    that of the log's :class:`Series`, ``what`` says in a word or two why."""

    name: str
    start: float
    end: float
    what: str


@dataclass(frozen=True, slots=True)
class Finding:
    """An effect that the model lacks. ``where`` says which part of the motion shows it, ``experiment`` what
    to record to tell it from ``confounded_with``; ``gain``, ``t`` and ``rivals`` are the evidence for the
    name, ``parts`` the gain in each part of the log that was not fitted; ``together``: products and ratios
    of numbers that are known although neither number is."""

    effect: str
    joint: int | None
    parameters: Mapping[str, Estimate]
    confidence: float
    confounded_with: tuple[str, ...]
    where: str
    experiment: str | None
    gain: float
    t: float
    rivals: tuple[Rival, ...] = ()
    parts: tuple[float, ...] = ()
    together: Mapping[str, Estimate] = field(default_factory=dict)

    def to_dict(self) -> dict[str, Any]:
        """As ``diagnosis.json`` has it."""
        return {
            "effect": self.effect,
            "joint": self.joint,
            "parameters": {name: p.to_dict() for name, p in self.parameters.items()},
            "combinations": {name: p.to_dict() for name, p in self.together.items()},
            "confidence": self.confidence,
            "confounded_with": list(self.confounded_with),
            "where": self.where,
            "experiment": self.experiment,
        }


@dataclass(frozen=True, slots=True, eq=False)
class Series:
    """A log as the report draws it, [K, n] thinned: torque as logged, and what the model leaves of it
    ``before`` and ``after`` the findings; positions, velocities, accelerations and ``load`` (rigid torque);
    ``times`` [K]."""

    name: str
    times: Floats
    q: Floats
    qd: Floats
    qdd: Floats
    load: Floats
    tau: Floats
    before: Floats
    after: Floats


def gap_closed(before: Floats, after: Floats, floor: Floats) -> float | None:
    """The share of the gap that is closed, of RMS [n] ``before`` and ``after`` and of the noise ``floor``
    [n]: a gap is what the RMS has beyond the noise (the root of the difference of the squares). Joints count
    each by what it left before, joints that never stand out of their noise do not; None where none stands
    out, negative where the gap has grown."""
    with np.errstate(all="ignore"):
        counts = np.maximum(before, after) > ABOVE_NOISE * np.nan_to_num(floor)
        weight = np.where(counts & (before > 0), 1 / np.square(before), 0.0)
        removable, left = (
            float(np.nansum(weight * np.maximum(np.square(x) - np.square(np.nan_to_num(floor)), 0)))
            for x in (before, after)
        )
    if not removable > 1e-9:
        return None
    return 1 - float(np.sqrt(left / removable))


@dataclass(frozen=True, slots=True, eq=False)
class Gap:
    """RMS [n] of logged torque less the model's, over all samples but 2 % at either end; ``torque``: of the
    logged torque itself, in the logs that were fitted and in those that names are held against (None: not
    known)."""

    train_before: Floats
    train_after: Floats
    validate_before: Floats
    validate_after: Floats
    noise_floor: Floats
    torque: tuple[Floats, Floats] | None = None

    def left_share(self, *, validated: bool) -> float | None:
        """RMS that is left after the findings, by that of the torque, the mean over joints that
        carry some; None where that is not known."""
        if self.torque is None:
            return None
        after = self.validate_after if validated else self.train_after
        with np.errstate(all="ignore"):
            shares = after / self.torque[validated]
        shares = shares[np.isfinite(shares)]
        return float(np.mean(shares)) if len(shares) else None

    def closed(self, *, validated: bool) -> float | None:
        """:func:`gap_closed` on the validation log, or on the logs that were fitted."""
        if validated:
            return gap_closed(self.validate_before, self.validate_after, self.noise_floor)
        return gap_closed(self.train_before, self.train_after, self.noise_floor)

    def unexplained_share(self) -> tuple[float | None, ...]:
        """Of each joint's mean square beyond the noise floor, in the logs that were fitted, the share
        (0 to 1) that remains after the findings; None where nothing stands out of the noise, or a figure is
        missing."""
        with np.errstate(all="ignore"):
            noise = self.noise_floor**2
            shares = (self.train_after**2 - noise) / (self.train_before**2 - noise)
        return tuple(
            float(min(max(share, 0.0), 1.0)) if above and np.isfinite(share) else None
            for share, above in zip(shares, self._stands_out(), strict=True)
        )

    def unexplained_share_reason(self) -> str | None:
        """Why some of :meth:`unexplained_share` is None; None where it has no gap."""
        if None not in self.unexplained_share():
            return None
        return (
            f"null: without findings, the RMS of that joint is below {ABOVE_NOISE} times its noise floor "
            "(or not known): there is nothing to explain"
        )

    def _stands_out(self) -> NDArray[np.bool_]:
        """Joints [n] whose torque shows more than noise before any finding."""
        return np.asarray(self.train_before > ABOVE_NOISE * self.noise_floor)

    def to_dict(self) -> dict[str, Any]:
        """As ``diagnosis.json`` has it."""
        return {
            "train": {"before": self.train_before.tolist(), "after": self.train_after.tolist()},
            "validate": {"before": self.validate_before.tolist(), "after": self.validate_after.tolist()},
            "noise_floor": self.noise_floor.tolist(),
            "torque": None
            if self.torque is None
            else dict(zip(("train", "validate"), map(np.ndarray.tolist, self.torque), strict=True)),
            "closed": {"train": self.closed(validated=False), "validate": self.closed(validated=True)},
        }


@dataclass(frozen=True, slots=True, eq=False)
class Diagnosis:
    """The whole: ``robot`` as given, ``model`` amended and ``model_text`` its description, ``diff`` between
    the two texts; ``flags``: what the data gate said, a line each; ``left`` [n]: RMS that nothing explains,
    as a multiple of the RMS that would matter (a figure above 1 matters); ``words``: remarks for people;
    ``rest`` [n]: speeds below which a joint may rest, and dry friction may have any size up to its level;
    ``operations``: of the inverse dynamics before and after.

    For the report, and empty where they are not known: ``windows`` of time to shade; ``tried``: the best
    candidates that were not named; ``detectable`` [n]: the RMS that an effect must explain at a joint to
    be worth a name; ``agreement``: of the compiled kernel with the same equations on arrays; ``counts``:
    the operations by kind (``mul``, ``add``, ...) before and after; ``record``: what to record where the
    motion shows too little. A log of ``logs`` may have
    ``samples``, ``rate`` and ``duration`` besides ``name`` and ``sha256``."""

    verdict: Verdict
    findings: tuple[Finding, ...]
    gap: Gap
    robot: Robot
    model: Robot
    model_text: str
    diff: str
    flags: tuple[str, ...]
    left: Floats
    words: tuple[str, ...]
    logs: tuple[Mapping[str, str], ...]
    rest: Floats
    series: tuple[Series, ...] = ()
    operations: tuple[int, int] = (0, 0)
    windows: tuple[Window, ...] = ()
    tried: tuple[Tried, ...] = ()
    detectable: Floats | None = None
    counts: tuple[Mapping[str, int], Mapping[str, int]] | None = None
    agreement: float | None = None
    record: str | None = None
    extra: Mapping[str, Any] = field(default_factory=dict)

    def to_dict(self) -> dict[str, Any]:
        """As ``diagnosis.json`` has it."""
        return {
            "verdict": self.verdict,
            "findings": [finding.to_dict() for finding in self.findings],
            "gap": self.gap.to_dict(),
            "unexplained_share": list(self.gap.unexplained_share()),
            "unexplained_share_reason": self.gap.unexplained_share_reason(),
            "left_over_threshold": self.left.tolist(),
            "remarks": list(self.words),
            "rest": self.rest.tolist(),
            "record": self.record,
            "flags": list(self.flags),
            "logs": [dict(log) for log in self.logs],
            **({"kernel_against_arrays": self.agreement} if self.agreement is not None else {}),
            "operations": {"before": self.operations[0], "after": self.operations[1]},
            "account": [account_to_dict(self.robot)],
        }
