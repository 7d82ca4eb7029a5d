"""The blind trials: which arm, what is hidden in it, how large, and what is wrong with the model."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, fields, replace
from fractions import Fraction
from typing import Literal

import numpy as np
from benchmarks.blind_arms.arms import ARMS, FURTHER_ARMS, bare, misjudged, rubbing
from benchmarks.blind_arms.cases import INSIDE, OUTSIDE
from benchmarks.blind_arms.logs import Hidden, Motion, hidden_log
from benchmarks.blind_arms.sizes import form, joints, sized

from robodyn.robot.model import EffectEntry, Robot

#: What a description says of its inertial numbers: a share, nothing, or that they are a guess.
Stated = float | None | Literal["unknown"]

EFFECTS = (*INSIDE, "power_law_friction", "gas_spring")
ALL_ARMS = (*ARMS, *FURTHER_ARMS)
#: A second law of friction at a joint, or a limit of the drive, is not sought beside known friction.
_FRICTIONLESS = (
    "asymmetric_friction",
    "stribeck_friction",
    "presliding_hysteresis",
    "transmission_loss",
    "torque_saturation",
    "power_law_friction",
)
#: Noise of the torques where nothing is hidden, as a share of their RMS.
_NOISE = 0.015
_SIZES = {"near": (1.5, 3.0)}
_CLEAR = (3.0, 8.0)


@dataclass(frozen=True, slots=True)
class Trial:
    """A blind trial of a ``kind``. ``effect`` is hidden at ``joint`` (from 1; None: all the robot), its gap
    ``ratio`` noise floors where it shows best. ``friction``: the arm has friction, and the model knows it.
    ``off``: share by which the model's inertial numbers are wrong; ``stated``: what it says of them."""

    kind: str
    arm: str
    seed: int
    effect: str | None = None
    joint: int | None = None
    ratio: float = 1.0
    friction: bool = False
    off: float = 0.0
    stated: Stated = None
    bits: int = 20
    motion: Motion = "full"

    @property
    def key(self) -> str:
        """Words for it, each trial its own."""
        return ":".join(str(getattr(self, field.name)) for field in fields(self))

    def make(self) -> Hidden:
        """Its logs and its answer; the same for the same trial."""
        entries = [] if self.effect is None else [entry(self)]
        logs = hidden_log(
            self.arm, entries, seed=self.seed, noise_share=_NOISE, ratio=self.ratio if entries else None,
            encoder_bits=self.bits, friction=self.friction, motion=self.motion,
        )  # fmt: skip
        return logs._replace(given=model_of(self, logs.given))


def entry(trial: Trial) -> EffectEntry:
    """What is hidden, as large as its ratio says beside the usual noise."""
    assert trial.effect
    open_form = form(trial.arm, trial.effect, trial.joint, trial.seed)
    return sized(
        trial.arm, open_form, trial.ratio * _NOISE, seed=trial.seed, duration=10.0, friction=trial.friction
    )


def model_of(trial: Trial, robot: Robot) -> Robot:
    """``robot`` with inertial numbers as wrong as the trial has them, and a confidence that says so."""
    if trial.off:
        robot = misjudged(robot, trial.off, trial.seed)
    if trial.stated is None:
        return robot
    stated: Fraction | Literal["unknown"] = "unknown"
    if trial.stated != "unknown":
        stated = Fraction(str(trial.stated))
    return replace(robot, links=tuple(replace(link, confidence=stated) for link in robot.links))


def arm_of(trial: Trial) -> Robot:
    """The arm before anything is hidden in it or wrong with its model."""
    return rubbing(bare(trial.arm)) if trial.friction else bare(trial.arm)


def _draw(kind: str, arm: str, seed: int) -> np.random.Generator:
    return np.random.default_rng((seed, ALL_ARMS.index(arm), *kind.encode()))


def _size(rng: np.random.Generator, low: float, high: float) -> float:
    return round(float(np.exp(rng.uniform(np.log(low), np.log(high)))), 3)


def _one(kind: str, arm: str, seed: int) -> Iterator[Trial]:
    """One effect, each of the catalogue in turn."""
    rng = _draw(kind, arm, seed)
    for id in EFFECTS:
        places = joints(arm, id)
        joint = places[int(rng.integers(len(places)))]
        known = id not in _FRICTIONLESS and bool(rng.integers(2))
        yield Trial(kind, arm, seed, id, joint, _size(rng, *_SIZES.get(kind, _CLEAR)), known)


def _uncertain(kind: str, arm: str, seed: int) -> Iterator[Trial]:
    """One effect, large, the description being a tenth off and saying so. Of a link that is wrong among such
    nobody could say by how much."""
    rng = _draw(f"{kind}:sizes", arm, seed)
    for trial in _one(kind, arm, seed):
        if trial.effect != "inertial_error":
            yield replace(trial, ratio=_size(rng, 8.0, 20.0), off=0.1, stated=0.1)


def _exact(kind: str, arm: str, seed: int) -> Iterator[Trial]:
    """One effect, the description being exact and saying so."""
    for trial in _one(kind, arm, seed):
        yield replace(trial, stated=0.001)


def _null(kind: str, arm: str, seed: int) -> Iterator[Trial]:
    """Nothing hidden; inertial numbers right or wrong, and a confidence that says so."""
    rng = _draw(kind, arm, seed)
    for off, stated in ((0.0, None), (0.05, 0.05), (0.1, 0.1), (0.3, 0.3), (0.3, "unknown"), (0.1, None)):
        bits = int(rng.choice([17, 20]))
        known = bool(rng.integers(2))
        yield Trial(kind, arm, seed, friction=known, off=off, stated=stated, bits=bits)  # type: ignore[arg-type]


def _wrong(kind: str, arm: str, seed: int) -> Iterator[Trial]:
    """Inertial numbers 30 % off and friction unknown, the arm itself as it should be."""
    both: tuple[Stated, ...] = (0.3, "unknown")
    for stated in both:
        yield Trial(kind, arm, seed, friction=True, off=0.3, stated=stated)


def _after(kind: str, arm: str, seed: int) -> Iterator[Trial]:
    """The same, with one effect hidden once the arm is identified."""
    rng = _draw(kind, arm, seed)
    for id in EFFECTS:
        places = joints(arm, id)
        joint = places[int(rng.integers(len(places)))]
        if id not in _FRICTIONLESS:
            yield Trial(kind, arm, seed, id, joint, 3.0, friction=True, off=0.3, stated=0.3)


def _payload(kind: str, arm: str, seed: int) -> Iterator[Trial]:
    rng = _draw(kind, arm, seed)
    yield Trial(kind, arm, seed, "payload", None, _size(rng, 8.0, 20.0), friction=True, off=0.1, stated=0.1)


def _of(*effects: str, motions: tuple[Motion, ...] = ("full",)) -> Callable[[str, str, int], Iterator[Trial]]:
    def trials(kind: str, arm: str, seed: int) -> Iterator[Trial]:
        rng = _draw(kind, arm, seed)
        for id in effects:
            places = joints(arm, id)
            for motion in motions:
                joint = places[int(rng.integers(len(places)))]
                yield Trial(kind, arm, seed, id, joint, _size(rng, *_CLEAR), motion=motion)

    return trials


KINDS: dict[str, Callable[[str, str, int], Iterator[Trial]]] = {
    "clear": _one,
    "near": _one,
    "exact": _exact,
    "uncertain": _uncertain,
    "null": _null,
    "backlash": _of("backlash"),
    "load": _of("load_dependent_friction"),
    "contact": _of("external_contact", motions=("full", "rest")),
    "outside": _of(*OUTSIDE),
    "identify": _wrong,
    "after": _after,
    "payload": _payload,
}


def trials(kind: str, arms: tuple[str, ...], seeds: range) -> Iterator[Trial]:
    """All trials of a kind, seed by seed, so that any first part of them is of all arms."""
    for seed in seeds:
        for arm in arms:
            yield from KINDS[kind](kind, arm, seed)
