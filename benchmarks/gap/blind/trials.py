"""The blind trials: which arm, what is hidden, how large, what is wrong with the model, how it moves."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, fields, replace
from fractions import Fraction
from typing import Any, Literal

import numpy as np
from benchmarks.blind_arms.arms import ARMS, FURTHER_ARMS, RANDOM, bare, index_of, misjudged, rubbing
from benchmarks.blind_arms.cases import INSIDE, OUTSIDE
from benchmarks.blind_arms.laws import Motion
from benchmarks.blind_arms.logs import Hidden, hidden_log
from benchmarks.blind_arms.sizes import form, joints, sized

from robodyn.robot.model import EffectEntry, Robot

#: What a description says of its inertial numbers: a share, nothing, or that they are a guess.
Stated = float | None | Literal["unknown"]

EFFECTS = (*INSIDE, "power_law_friction", "gas_spring")
#: Arms with names, which tests of the tool know; ``random`` stands for one of its own for each seed.
KNOWN_ARMS = (*ARMS, *FURTHER_ARMS)
ALL_ARMS = ("random",)
#: A second law of friction at a joint, or a limit of the drive, is not sought beside known friction.
_FRICTIONLESS = (
    "asymmetric_friction",
    "stribeck_friction",
    "presliding_hysteresis",
    "transmission_loss",
    "torque_saturation",
    "power_law_friction",
)
#: Laws that are easily taken for one another, alone or with a damping at the same joint.
_SIMILAR: tuple[tuple[str, str | None], ...] = (
    ("coulomb_friction", None), ("stribeck_friction", None), ("asymmetric_friction", None),
    ("load_dependent_friction", None), ("transmission_loss", None), ("power_law_friction", None),
    ("presliding_hysteresis", None), ("coulomb_friction", "viscous_friction"),
    ("stribeck_friction", "viscous_friction"), ("load_dependent_friction", "viscous_friction"),
    ("asymmetric_friction", "viscous_friction"), ("viscous_friction", None), ("torque_bias", None),
    ("torque_gain", None), ("time_delay", None), ("spring", None), ("gas_spring", None), ("payload", None),
    ("inertial_error", None),
)  # fmt: skip
#: What shows where no joint turns back.
_ONE_WAY = ("payload", "rotor_inertia", "spring", "viscous_friction", "coulomb_friction", "torque_ripple")
_CLEAR, _FAINT, _TWO = (3.0, 8.0), (1.5, 4.0), (3.0, 6.0)
#: How good logs are: noise as a share of RMS torque (logarithmically), bits of a turn, jitter in steps of the
#: encoder (standard deviation); duration [s] by sample rate [Hz].
_NOISE, _BITS, _JITTER = (0.006, 0.03), (18, 20, 22), (0.0, 0.3, 1.0)
_DURATION = {200.0: 12.0, 500.0: 10.0, 1000.0: 8.0}
#: Steps of the simulation [s], shorter ones of what is stiff, and how long a run that finds a size takes [s].
_STEP, _SHORT, _BRIEF = 1e-3, 5e-4, 6.0
_STIFF = ("joint_elasticity", "backlash", "presliding_hysteresis")


@dataclass(frozen=True, slots=True)
class Trial:
    """A blind trial of a ``kind``. ``effect`` is hidden at ``joint`` (from 1; None: all the robot), its gap
    ``ratio`` noise floors where it shows best, and an effect ``beside`` it at the same joint. ``friction``:
    the arm has friction, and the model knows it. ``off``: share by which the model's inertial numbers are
    wrong; ``stated``: what it says of them. The rest: how the logs are made. Dry friction sticks."""

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
    beside: str | None = None
    rate: float = 1000.0
    noise: float = 0.015
    jitter: float = 0.0

    @property
    def key(self) -> str:
        """Words for it, each trial its own."""
        return ":".join(str(getattr(self, field.name)) for field in fields(self))

    def make(self) -> Hidden:
        """Its logs and its answer; the same for the same trial."""
        hidden = entries(self)
        logs = hidden_log(
            self.arm, hidden, noise_share=self.noise, ratio=self.ratio if len(hidden) == 1 else None,
            rate=self.rate, encoder_bits=self.bits, jitter=self.jitter,
            duration=_DURATION[self.rate], **_alike(self),
        )  # fmt: skip
        return logs._replace(given=model_of(self, logs.given))


def _alike(trial: Trial) -> dict[str, Any]:
    """What logs and the trial runs for sizes have in common."""
    return {
        "seed": trial.seed, "friction": trial.friction, "motion": trial.motion, "sticks": True,
        "step": _SHORT if trial.effect in _STIFF else _STEP,
    }  # fmt: skip


def entries(trial: Trial) -> list[EffectEntry]:
    """What is hidden, as large as its ratio says beside the noise."""
    ids = [id for id in (trial.effect, trial.beside) if id]
    forms = [form(trial.arm, id, trial.joint, trial.seed) for id in ids]
    share = trial.ratio * trial.noise
    # A push may come late.
    lasts = _DURATION[trial.rate] if trial.effect == "external_contact" else _BRIEF
    return [sized(trial.arm, one, share, duration=lasts, **_alike(trial)) for one in forms]


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
    return np.random.default_rng((seed, index_of(arm), *kind.encode()))


def _size(rng: np.random.Generator, low: float, high: float) -> float:
    return round(float(np.exp(rng.uniform(np.log(low), np.log(high)))), 3)


def _how(rng: np.random.Generator, *motions: Motion) -> dict[str, Any]:
    """How logs are made, drawn."""
    return {
        "motion": str(rng.choice(motions or ("full", "stops"))), "rate": float(rng.choice(list(_DURATION))),
        "noise": _size(rng, *_NOISE), "bits": int(rng.choice(_BITS)), "jitter": float(rng.choice(_JITTER)),
    }  # fmt: skip


def _turn(ids: Sequence[Any], arm: str, seed: int, count: int) -> Iterator[Any]:
    """All ``ids``; of a random arm, ``count`` that show on it, others for the next seed."""
    if not arm.startswith(RANDOM):
        yield from ids
        return
    first = seed * count
    for k in range(first, first + len(ids)):
        id = ids[k % len(ids)]
        if count and joints(arm, id if isinstance(id, str) else id[0]):
            count -= 1
            yield id


def _hiding(
    ids: Sequence[str | tuple[str, str | None]], span: tuple[float, float], count: int, *motions: Motion
) -> Callable[[str, str, int], Iterator[Trial]]:
    """Trials that hide one of the ``ids``, or a pair of them, each in turn."""

    def trials(kind: str, arm: str, seed: int) -> Iterator[Trial]:
        rng = _draw(kind, arm, seed)
        for each in _turn(ids, arm, seed, count):
            id, beside = (each, None) if isinstance(each, str) else each
            places = joints(arm, id)
            joint = places[int(rng.integers(len(places)))]
            known = id not in _FRICTIONLESS and not beside and bool(rng.integers(2))
            size = _size(rng, *(_TWO if beside else span))
            yield Trial(
                kind, arm, seed, id, joint, size, known, beside=beside, **_how(rng, *motions),
            )  # fmt: skip

    return trials


_clear = _hiding(EFFECTS, _CLEAR, 3)


def _uncertain(kind: str, arm: str, seed: int) -> Iterator[Trial]:
    """One effect, large, the description being a tenth off and saying so. Of a link that is wrong among such
    nobody could say by how much."""
    rng = _draw(f"{kind}:sizes", arm, seed)
    for trial in _clear(kind, arm, seed):
        if trial.effect != "inertial_error":
            yield replace(trial, ratio=_size(rng, 8.0, 20.0), off=0.1, stated=0.1)


def _exact(kind: str, arm: str, seed: int) -> Iterator[Trial]:
    """One effect, the description being exact and saying so."""
    for trial in _clear(kind, arm, seed):
        yield replace(trial, stated=0.001)


def _null(kind: str, arm: str, seed: int) -> Iterator[Trial]:
    """Nothing hidden; inertial numbers right or wrong, and a confidence that says so."""
    rng = _draw(kind, arm, seed)
    models: tuple[tuple[float, Stated], ...] = (
        (0.0, None), (0.05, 0.05), (0.1, 0.1), (0.3, 0.3), (0.3, "unknown"), (0.1, None),
    )  # fmt: skip
    for off, stated in (models[seed % len(models)],) if arm.startswith(RANDOM) else models:
        how = _how(rng, "full", "stops", "stops", "one_way")
        yield Trial(kind, arm, seed, friction=rng.random() < 0.75, off=off, stated=stated, **how)


def _wrong(kind: str, arm: str, seed: int) -> Iterator[Trial]:
    """Inertial numbers 30 % off and friction unknown, the arm itself as it should be."""
    both: tuple[Stated, ...] = (0.3, "unknown")
    for stated in both:
        yield Trial(kind, arm, seed, friction=True, off=0.3, stated=stated)


def _after(kind: str, arm: str, seed: int) -> Iterator[Trial]:
    """The same, with one effect hidden once the arm is identified."""
    rng = _draw(kind, arm, seed)
    for id in _turn([id for id in EFFECTS if id not in _FRICTIONLESS], arm, seed, 2):
        places = joints(arm, id)
        joint = places[int(rng.integers(len(places)))]
        yield Trial(kind, arm, seed, id, joint, 3.0, friction=True, off=0.3, stated=0.3)


def _payload(kind: str, arm: str, seed: int) -> Iterator[Trial]:
    rng = _draw(kind, arm, seed)
    yield Trial(kind, arm, seed, "payload", None, _size(rng, 8.0, 20.0), friction=True, off=0.1, stated=0.1)


KINDS: dict[str, Callable[[str, str, int], Iterator[Trial]]] = {
    "clear": _clear,
    "near": _hiding(_SIMILAR, _FAINT, 2),
    "exact": _exact,
    "uncertain": _uncertain,
    "null": _null,
    "backlash": _hiding(("backlash",), _CLEAR, 1),
    "journal": _hiding(("journal",), _CLEAR, 1),
    "contact": _hiding(("external_contact",), _CLEAR, 1, "full", "stops", "rest"),
    "outside": _hiding(OUTSIDE, (4.0, 8.0), 1),
    "poor": _hiding(_ONE_WAY, _CLEAR, 1, "one_way", "narrow"),
    "identify": _wrong,
    "after": _after,
    "payload": _payload,
}


def trials(kind: str, arms: tuple[str, ...], seeds: range) -> Iterator[Trial]:
    """All trials of a kind, seed by seed, so that any first part of them is of all arms."""
    for seed in seeds:
        for arm in arms:
            yield from KINDS[kind](kind, f"{RANDOM}{seed}" if arm == "random" else arm, seed)
