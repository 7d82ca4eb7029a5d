"""Arms whose numbers are chosen against checks in finite fields: multiples of primes and of their powers,
denominators that are such multiples, numbers that are equal modulo a prime and not in truth, sums that cancel
there."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction
from typing import Any, Final

from robodyn.ir.field import drawn_prime
from robodyn.robot.model import Inertia, Link, Robot, Vector
from robodyn.robot.values import Value
from robodyn_testing.random_robots import random_robot

#: Primes that programs like this one are known to calculate with: Mersenne primes, those that the walk takes,
#: and others that fit a word.
PRIMES: Final = (
    2**61 - 1, 2**61 - 31, 2**61 - 45, 2**61 - 229, 2**31 - 1, 2**127 - 1, 2**89 - 1, 2**64 - 59, 998244353,
    10**9 + 7,
)  # fmt: skip
#: The prime in which passes are compared, whatever the robot: whoever reads the library knows it.
KNOWN: Final = drawn_prime(b"passes")


def hostile(seed: int, *, joints: int | None = None) -> Robot:
    """The arm number ``seed``: a random arm, some of whose numbers are replaced."""
    rng = random.Random(f"hostile {seed}")
    robot = random_robot(seed, joints=joints or rng.randint(1, 8), aside=0.3)
    prime = rng.choice(PRIMES) if seed % 3 else PRIMES[0]
    numbers = Numbers(rng, prime, rng.choice((0.1, 0.4, 1.0)))
    return replace(numbers.arm(robot), name=f"hostile{seed}")


class Numbers:
    """Swaps a ``share`` of the numbers of a description for others that play against ``prime``."""

    def __init__(self, rng: random.Random, prime: int, share: float) -> None:
        self.rng, self.prime, self.share = rng, prime, share
        self.chosen = [_number(rng, prime) for _ in range(3)]

    def swapped(self, value: Value, *, positive: bool = False) -> Value:
        """``value`` or another number; names stay."""
        if self.rng.random() > self.share or not isinstance(value, Fraction):
            return value
        return self._other(value, positive=positive)

    def _other(self, value: Fraction, *, positive: bool = False) -> Fraction:
        rng, how = self.rng, self.rng.randrange(4)
        if how == 0:  # equal to the old one modulo the prime
            new = value + Fraction(self.prime * rng.randint(1, 3), 1 << rng.randint(0, 70))
        else:  # with Fraction(prime) - x a sum with another chosen one cancels there
            chosen = rng.choice(self.chosen)
            new = {1: Fraction(self.prime) - chosen, 2: -chosen, 3: chosen}[how]
        return abs(new) if positive else new

    def arm(self, robot: Robot) -> Robot:
        """``robot`` with other links and gravity."""
        rng, (gx, gy, gz) = self.rng, robot.gravity
        links = tuple(map(self._link, robot.links))
        if rng.random() < self.share / 3:
            gz = self._other(gz)
        return replace(robot, links=links, gravity=(gx, gy, gz))

    def _link(self, old: Link) -> Link:
        j, swapped = old.joint, self.swapped
        x, y, z = old.com
        com: Vector = (swapped(x), swapped(y), swapped(z))
        mass, inertia = swapped(old.mass, positive=True), self.tensor(old.inertia)
        numbers: dict[str, Any] = {"a": swapped(j.a), "d": swapped(j.d), "b": swapped(j.b) if j.b else j.b}
        numbers |= {
            name: swapped(getattr(j, name), positive=True) for name in ("motor_inertia", "viscous", "coulomb")
        }
        return replace(old, mass=mass, com=com, inertia=inertia, joint=replace(j, **numbers))

    def tensor(self, old: Inertia) -> Inertia:
        """A tensor with other entries."""
        principal = [self.swapped(i, positive=True) for i in (old.xx, old.yy, old.zz)]
        return Inertia(*principal, *(self.swapped(i) for i in (old.xy, old.xz, old.yz)))


def _number(rng: random.Random, prime: int) -> Fraction:
    k = rng.randint(1, 9)
    size = 10 ** rng.randint(0, 2 * len(str(prime)))
    return rng.choice(
        (
            Fraction(k * prime, size),
            Fraction(k * prime**2, size * prime.bit_length()),
            Fraction(k * prime, 1 << prime.bit_length()),
            Fraction(k, prime),
            Fraction(k * size, prime**2),
            Fraction(k * prime + 1),
            Fraction(k) + Fraction(prime, 1 << (prime.bit_length() + 3)),
        )
    )
