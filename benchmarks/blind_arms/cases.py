"""The blind tests, listed: which arm, what is hidden, how large."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np
from benchmarks.blind_arms.arms import ARMS, index_of
from benchmarks.blind_arms.logs import Hidden, Motion, Rates, hidden_log
from benchmarks.blind_arms.sizes import form, joints, sized

__all__ = ["Case", "Level", "cases"]

Level = Literal["clear", "faint", "nothing", "pairs", "outside", "poor"]

#: Effects of the catalogue, and some that are in none.
INSIDE = (
    "viscous_friction", "coulomb_friction", "asymmetric_friction", "stribeck_friction",
    "presliding_hysteresis", "load_dependent_friction", "transmission_loss", "spring", "joint_elasticity",
    "backlash", "rotor_inertia", "torque_ripple", "motor_coupling", "payload", "inertial_error", "base_tilt",
    "external_contact", "torque_bias", "torque_gain", "time_delay", "encoder_offset", "torque_saturation",
)  # fmt: skip
OUTSIDE = ("swinging_tool", "random_offset", "acceleration_friction")

#: Not with friction in the given model: another law at the same joint would be two laws at one joint, and
#: the torque at which a drive clips is sought without.
_WITHOUT_FRICTION = (
    "asymmetric_friction",
    "stribeck_friction",
    "presliding_hysteresis",
    "transmission_loss",
    "torque_saturation",
)
_PAIRS = (
    ("viscous_friction", "spring"),
    ("coulomb_friction", "payload"),
    ("stribeck_friction", "viscous_friction"),
    ("torque_bias", "coulomb_friction"),
    ("rotor_inertia", "viscous_friction"),
    ("spring", "torque_ripple"),
    ("payload", "viscous_friction"),
    ("time_delay", "coulomb_friction"),
    ("viscous_friction", "coulomb_friction"),
    ("load_dependent_friction", "viscous_friction"),
)
#: At one joint they are exactly a third effect.
_ONE_LAW = {"torque_bias", "coulomb_friction"}
#: Noise of the torques, as a share of their RMS.
_NOISE = 0.015


@dataclass(frozen=True, slots=True)
class Case:
    """A blind test: ``hidden`` are the ids and joints (from 1, None: the whole robot) of what is hidden;
    ``ratio``: the gap of each in noise floors, at the joint where it shows best."""

    arm: str
    hidden: tuple[tuple[str, int | None], ...]
    seed: int
    ratio: float
    friction: bool = False
    inertia_error: float = 0.0
    encoder_bits: int = 20
    rates: Rates = "none"
    motion: Motion = "full"
    duration: float = 10.0

    @property
    def name(self) -> str:
        """Words for it, for a list of results."""
        what = "+".join(f"{id}@{joint or 'all'}" for id, joint in self.hidden) or "nothing"
        return f"{self.arm}:{what}:{self.seed}"

    def make(self) -> Hidden:
        """Its logs; the same for the same case."""
        entries = [
            sized(
                self.arm, form(self.arm, id, joint, self.seed), self.ratio * _NOISE,
                seed=self.seed, duration=self.duration, friction=self.friction,
            )
            for id, joint in self.hidden
        ]  # fmt: skip
        return hidden_log(
            self.arm, entries, seed=self.seed, duration=self.duration, noise_share=_NOISE,
            ratio=self.ratio if len(entries) == 1 else None, encoder_bits=self.encoder_bits, rates=self.rates,
            friction=self.friction, inertia_error=self.inertia_error, motion=self.motion,
        )  # fmt: skip


def cases(level: Level, *, seeds: int = 1, first: int = 1, arms: tuple[str, ...] = ARMS) -> Iterator[Case]:
    """The tests of a level, ``seeds`` for each arm and effect (each with a joint of its own), from ``first``.

    ``clear``: one effect, 3 to 8 times the noise floor; ``faint``: 1.5 to 3 times; ``nothing``: none, with
    and without rates, friction, coarse encoders, wrong inertias; ``pairs``: two effects, 4 to 8 times the
    floor each; ``outside``: an effect of no catalogue, 4 to 8 times; ``poor``: one effect and too little
    motion.
    """
    for arm in arms:
        for seed in range(first, first + seeds):
            yield from _of_arm(arm, level, seed)


def _of_arm(arm: str, level: Level, seed: int) -> Iterator[Case]:
    rng = np.random.default_rng((seed, index_of(arm), len(level)))

    def place(id: str) -> tuple[str, int | None]:
        found = joints(arm, id)
        return id, found[int(rng.integers(len(found)))]

    def ratio(low: float, high: float) -> float:
        return round(float(np.exp(rng.uniform(np.log(low), np.log(high)))), 3)

    match level:
        case "clear" | "faint":
            for id in INSIDE:
                span = (3.0, 8.0) if level == "clear" else (1.5, 3.0)
                known = id not in _WITHOUT_FRICTION and bool(rng.integers(2))
                yield Case(arm, (place(id),), seed, ratio(*span), friction=known)
        case "nothing":
            for k in range(5):
                yield Case(
                    arm, (), 10 * seed + k, 1.0, friction=k in (1, 3, 4),
                    inertia_error=0.03 if k == 3 else 0.0, encoder_bits=17 if k in (2, 4) else 20,
                    rates="both" if k == 4 else "none",
                )  # fmt: skip
        case "pairs":
            for one, other in _PAIRS:
                pair = place(one), place(other)
                while pair[0][1] == pair[1][1] and {one, other} == _ONE_LAW:
                    pair = place(one), place(other)
                yield Case(arm, pair, seed, ratio(4.0, 8.0))
        case "outside":
            for id in OUTSIDE:
                yield Case(arm, (place(id),), seed, ratio(4.0, 8.0), friction=bool(rng.integers(2)))
        case "poor":
            for id in ("viscous_friction", "coulomb_friction", "payload", "spring", "torque_bias"):
                way: Motion = "one_way" if rng.integers(2) else "narrow"
                yield Case(arm, (place(id),), seed, ratio(3.0, 8.0), motion=way)
