"""Arms with effects whose numbers, effects' included, are chosen against checks in finite fields.

The robots are as described: what a reader folds into links (:func:`robodyn.robot.folding.folded`) is
among their effects.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from fractions import Fraction
from typing import Any, Final

import pytest

from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Parameter
from robodyn.ir import field
from robodyn.robot.model import EffectEntry, Inertia, Robot
from robodyn.robot.values import PI, Affine, Value, parameter
from robodyn_testing.hostile_numbers import KNOWN, PRIMES, Numbers
from robodyn_testing.random_effects import with_random_effects
from robodyn_testing.random_robots import random_robot

#: Names that kernels have for things of their own.
NAMES: Final = ("c1", "s1", "qd1", "tau1", "e", "x", "t0", "state1", "dt1", "lambda_", "n", "abs1")
REST: Final = ("exact", "smooth", "banded")
#: Effects that leave no forward dynamics.
_FEEL_LOAD: Final = ("load_dependent_friction", "transmission_loss")


def hostile_drives(seed: int, *, joints: int) -> Robot:
    """The arm number ``seed`` with random effects, whose numbers play against a prime."""
    rng = random.Random(f"hostile drives {seed}")
    robot = replace(random_robot(seed, joints=joints), name=f"driven{seed}", rest_velocity=None)
    share = rng.choice((0.6, 0.8)) if joints <= 3 else rng.choice((0.1, 0.25))
    ids = [id for id in CATALOGUE if id not in _FEEL_LOAD] if seed % 4 == 3 else list(CATALOGUE)
    robot = with_random_effects(robot, seed, ids=ids, share=share, names=rng.choice((0, 0, 0.3)))
    prime = rng.choice((PRIMES[0], KNOWN, rng.choice(PRIMES)))
    numbers = Numbers(rng, prime, rng.choice((0.1, 0.4, 1.0)))
    if rng.random() < 0.8:  # most friction is of motors
        robot = replace(robot, torque_side="motor")
    robot = replace(robot, effects=(*robot.effects, *_folding(rng, robot)))
    robot = swapped_effects(numbers.arm(robot), numbers)
    rest = REST[seed % 3]
    speed = abs(numbers.swapped(Fraction(rng.randint(1, 99), 100), positive=True))  # type: ignore[arg-type]
    return replace(
        robot,
        rest_velocity=speed if rest == "smooth" else None,
        dead_band=speed if rest == "banded" else None,
    )


def near_copy(seed: int, robot: Robot, primes: Sequence[int], *, effects: bool) -> Robot:
    """``robot`` with numbers of its effects, or else of its links, swapped for such as play against one of
    ``primes``: those that were drawn for the robot."""
    rng = random.Random(f"near copy {seed}")
    numbers = Numbers(rng, rng.choice(primes), rng.choice((0.1, 0.5)))
    return swapped_effects(robot, numbers) if effects else numbers.arm(robot)


@contextmanager
def primes_drawn() -> Iterator[list[int]]:
    """The primes that the library draws meanwhile."""
    drawn: dict[int, None] = {}
    primes: list[int] = []
    draw = field.drawn_prime

    def noted(seed: bytes, bits: int = field.BITS) -> int:
        prime = draw(seed, bits)
        if prime not in drawn:
            drawn[prime] = None
            primes.append(prime)
        return prime

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(field, "drawn_prime", noted)
        yield primes


def _folding(rng: random.Random, robot: Robot) -> list[EffectEntry]:
    """Effects that reading puts into links and gravity."""
    effects = []
    for joint in range(1, robot.n + 1):
        for id in ("viscous_friction", "coulomb_friction", "rotor_inertia", "inertial_error"):
            if rng.random() < 0.2:
                settings: list[tuple[str, Any]] = []
                for p in CATALOGUE[id].parameters:
                    share = Fraction(rng.randint(0, 99), 100)
                    value: Value = share
                    if rng.random() < 0.1:
                        value = parameter(rng.choice(NAMES)) * share + Fraction(rng.randint(1, 9))
                    settings.append((p.name, value))
                effects.append(EffectEntry(id, joint, tuple(settings)))
    if rng.random() < 0.2:
        tilt = [PI / 2 * rng.randint(-2, 2) if rng.random() < 0.5 else Fraction(1, 3) for _ in range(2)]
        effects.append(EffectEntry("base_tilt", None, (("tilt_x", tilt[0]), ("tilt_y", tilt[1]))))
    return effects


def swapped_effects(robot: Robot, numbers: Numbers) -> Robot:
    """``robot`` with other numbers in its effects; what its catalogue would refuse stays."""
    return replace(robot, effects=tuple(_swapped_entry(robot, entry, numbers) for entry in robot.effects))


def _swapped_entry(robot: Robot, entry: EffectEntry, numbers: Numbers) -> EffectEntry:
    if entry.effect in ("base_tilt", "external_contact"):
        return entry
    effect = CATALOGUE[entry.effect]
    by_name = {p.name: p for p in effect.parameters}
    values = {name: _swapped_setting(by_name[name], x, numbers) for name, x in entry.settings}
    if entry.effect == "stribeck_friction":
        low, high = values["level"], values["static"]
        if isinstance(low, Fraction) and isinstance(high, Fraction):
            values["level"], values["static"] = sorted((low, high))
    revolute = entry.joint is None or robot.links[entry.joint - 1].joint.kind == "revolute"
    if entry.effect == "gas_spring":  # its shape and its angle are bounded
        values |= {name: entry[name] for name in ("dead_center", "ratio")}
    assert effect.check(values, revolute) is None
    return replace(entry, settings=tuple(values.items()))


def _swapped_setting(p: Parameter, old: Any, numbers: Numbers) -> Any:
    rng, positive = numbers.rng, p.sign != "any"
    if p.kind == "vector":
        return tuple(numbers.swapped(x) for x in old)
    if p.kind == "inertia":
        return numbers.tensor(old) if isinstance(old, Inertia) else old
    if p.kind == "efficiency":
        if isinstance(old, Fraction):
            return _shared(numbers, old)
        loads = sorted({_nonzero(numbers, x, positive=True) for x, _ in old})
        return tuple((x, _shared(numbers, y)) for x, (_, y) in zip(loads, old, strict=False))
    if p.kind != "number":
        return old
    if isinstance(old, Affine):
        factor, constant = (_nonzero(numbers, Fraction(1), positive=positive) for _ in range(2))
        name = rng.choice((*NAMES, old.terms[0][0]))
        return old if rng.random() > numbers.share else parameter(name) * factor + constant
    if p.name == "exponent":  # nearly the same, lest powers grow beyond all digits
        return old + Fraction(numbers.prime, 1 << (numbers.prime.bit_length() + rng.randint(0, 70)))
    if p.name == "phase":  # more is refused; a multiple of the prime stays one
        new = _nonzero(numbers, old, positive=False)
        while abs(new) > 9999:
            new /= 10
        return new
    if rng.random() < 0.05 and p.sign in ("any", "nonnegative"):
        return Fraction(0)
    return _nonzero(numbers, old, positive=positive)


def _nonzero(numbers: Numbers, old: Fraction, *, positive: bool) -> Fraction:
    new = numbers.swapped(old, positive=positive)
    assert isinstance(new, Fraction)
    return new or old or Fraction(numbers.prime)


def _shared(numbers: Numbers, old: Fraction) -> Fraction:
    """Above 0, at most 1."""
    new = _nonzero(numbers, old, positive=True)
    return new if new <= 1 else 1 / new
