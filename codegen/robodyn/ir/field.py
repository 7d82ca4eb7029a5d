"""Finite fields in which programs are compared, each drawn from a hash of what is compared in it, and their
elements as numbers, on which a recursion over any scalar runs.

A fixed prime can be played against: a constant that is a multiple of it is 0 there and not in truth. Here
the prime (120 bits, one of more than 2^111, or 240) and every point are drawn from a hash of all that is
compared: whoever chooses a constant changes the prime that it would have to be a multiple of. How likely a
false match is stands in ``docs/decisions/0017-proofs-against-intent.md``.
"""

from __future__ import annotations

import functools
import hashlib
import math
from collections.abc import Iterable
from fractions import Fraction

from robodyn.ir.program import Input

#: Primes have so many bits unless more are asked for: four digits of Python's integers, products fit eight.
BITS = 120
#: Those of the field in which a program is compared before it leaves: one comparison there is worth more than
#: two in fields of half as many, and takes little more than half their time.
FINAL_BITS = 240
_SMALL_PRIMES = tuple(p for p in range(3, 1000) if all(p % d for d in range(2, math.isqrt(p) + 1)))
_PRODUCT = math.prod(_SMALL_PRIMES)
#: Rounds of Miller and Rabin with bases of chance: a composite number of any kind passes one in four, a
#: random one of this size hardly ever.
_ROUNDS = 6

Number = int | Fraction


class Vanishes(ArithmeticError):
    """A constant that is not zero is zero in a field, or is divided by zero there."""


class Field:
    """The integers modulo a prime of so many ``bits``. Random values are drawn from ``seed``, and so is the
    prime, unless ``prime_seed`` is there for it; or it is ``prime``, 3 modulo 4 and of any length.

    The prime is 3 modulo 4: ``1 + t * t`` is never 0, and every ``t`` gives a point of the circle.
    """

    __slots__ = ("_circles", "_divisions", "_inverses", "_key", "prime")

    def __init__(
        self,
        seed: str | bytes,
        prime_seed: bytes | None = None,
        prime: int | None = None,
        bits: int = BITS,
    ) -> None:
        text = seed.encode() if isinstance(seed, str) else seed
        self._key = hashlib.blake2b(text, digest_size=32).digest()
        self.prime = prime or drawn_prime(text if prime_seed is None else prime_seed, bits)
        self._divisions: dict[Input, int] = {}
        self._circles: dict[str, tuple[int, int]] = {}
        self._inverses: dict[int, int] = {1: 1}

    def random(self, name: str) -> int:
        """An element of the field, the same for the same ``name``."""
        return _drawn(self._key, name) % self.prime

    def variable(self, x: Input) -> int:
        """The value of an input, where it is no angle."""
        return self.random(f"{x.array} {x.index}")

    def angle(self, x: Input, parts: int = 1) -> tuple[int, int]:
        """A random point (cos, sin) of the unit circle for an input that is an angle, or for a part of it."""
        whole = self._divisions.get(x, 0)
        if whole and whole % parts == 0:
            return self.multiple(self.circle(f"{x.array} {x.index} / {whole}"), whole // parts)
        return self.circle(f"{x.array} {x.index} / {parts}")

    def divide(self, x: Input, parts: int) -> None:
        """Make the angles ``x / k`` multiples of one, ``x / parts``, wherever ``k`` divides ``parts``: the
        angles of joints that follow another are then the multiples of its own that they are."""
        self._divisions[x] = parts

    def circle(self, name: str) -> tuple[int, int]:
        """A random point (cos, sin) of the unit circle, the same for the same ``name``."""
        point = self._circles.get(name)
        if point is None:
            p = self.prime
            t = self.random(f"circle {name}")
            inverse = pow(1 + t * t, -1, p)
            point = self._circles[name] = ((1 - t * t) * inverse % p, 2 * t * inverse % p)
        return point

    def turn(self, first: tuple[int, int], second: tuple[int, int]) -> tuple[int, int]:
        """The point of the circle whose angle is the sum of two angles."""
        (c, s), (e, f) = first, second
        return (c * e - s * f) % self.prime, (s * e + c * f) % self.prime

    def multiple(self, point: tuple[int, int], times: int) -> tuple[int, int]:
        """The point of the circle whose angle is a whole multiple of an angle."""
        total = (1, 0)
        if times < 0:
            point, times = (point[0], -point[1]), -times
        while times:
            if times & 1:
                total = self.turn(total, point)
            point = self.turn(point, point)
            times >>= 1
        return total

    def number(self, x: Fraction | int) -> int:
        """The place of a rational number.

        Raises
        ------
        Vanishes: it is not 0 and has the place of 0, or has no place.
        """
        p = self.prime
        if isinstance(x, int):
            place = x % p
        else:
            numerator, denominator = x.as_integer_ratio()
            inverse = self._inverses.get(denominator)
            if inverse is None:
                self.prepare((denominator,))
                inverse = self._inverses[denominator]
            place = numerator * inverse % p
        if not place and x:
            raise Vanishes(f"a constant is a multiple of the prime {p}")
        return place

    def opaque(self, op: str, x: int, *others: int) -> int:
        """``op`` of ``x`` (and ``others``) as a random function: odd or even as it is, with its own value at
        zero.

        ``select`` is linear in what is chosen from, with a random function of the condition as the factor:
        programs that agree there agree for either choice.
        """
        p = self.prime
        x %= p
        if op == "select":
            a, b = others
            return (b + self.random(f"select {x}") * (a - b)) % p if x else b % p
        if op == "atan2":
            y, of_x = min(x, p - x), others[0] % p
            drawn = self.random(f"atan2 {y} {of_x}") if y or of_x else 0
            return drawn if y == x else p - drawn
        if not x:
            return int(op in ("exp", "cos"))
        if op == "pow":
            return self.random(f"pow {x} {others[0]}")
        if op in ("sqrt", "exp"):
            return self.random(f"{op} {x}")
        y = min(x, p - x)
        drawn = self.random(f"{op} {y}")
        return drawn if op in ("abs", "cos") or y == x else p - drawn

    def prepare(self, denominators: Iterable[int]) -> None:
        """Invert ``denominators`` together: one inversion and three products each (P. Montgomery 1987).

        Raises
        ------
        Vanishes: one is a multiple of the prime.
        """
        p, known = self.prime, self._inverses
        new = [d for d in dict.fromkeys(denominators) if d not in known]
        products = [1]
        for d in new:
            products.append(products[-1] * d % p)
        if not products[-1]:
            raise Vanishes(f"a denominator is a multiple of the prime {p}")
        inverse = pow(products[-1], -1, p)
        for d, before in zip(reversed(new), reversed(products[:-1]), strict=True):
            known[d] = inverse * before % p
            inverse = inverse * d % p


class Residue:
    """An element of ``field``: ``+ - * /`` with elements, integers and fractions; functions that arithmetic
    alone does not have are random ones, as in :func:`~robodyn.ir.fingerprint.fingerprint`."""

    __slots__ = ("field", "value")

    def __init__(self, field: Field, value: int) -> None:
        self.field = field
        self.value = value

    def _of(self, other: Residue | Number) -> int | None:
        """``other`` as an element of the field; None: it knows better what to do with one."""
        if other.__class__ is Residue:
            return other.value
        return self.field.number(other) if isinstance(other, (int, Fraction)) else None

    def __add__(self, other: Residue | Number) -> Residue:
        if other.__class__ is int and not other:
            return self
        value = other.value if other.__class__ is Residue else self._of(other)
        if value is None:
            return NotImplemented
        return Residue(self.field, (self.value + value) % self.field.prime)

    __radd__ = __add__

    def __sub__(self, other: Residue | Number) -> Residue:
        value = other.value if other.__class__ is Residue else self._of(other)
        if value is None:
            return NotImplemented
        return Residue(self.field, (self.value - value) % self.field.prime)

    def __rsub__(self, other: Number) -> Residue:
        value = self._of(other)
        if value is None:
            return NotImplemented
        return Residue(self.field, (value - self.value) % self.field.prime)

    def __mul__(self, other: Residue | Number) -> Residue:
        if other.__class__ is int and other == 1:
            return self
        value = other.value if other.__class__ is Residue else self._of(other)
        if value is None:
            return NotImplemented
        return Residue(self.field, self.value * value % self.field.prime)

    __rmul__ = __mul__

    def __truediv__(self, other: Residue | Number) -> Residue:
        value = self._of(other)
        if value is None:
            return NotImplemented
        return Residue(self.field, self.value * self._inverse(value) % self.field.prime)

    def __rtruediv__(self, other: Number) -> Residue:
        value = self._of(other)
        if value is None:
            return NotImplemented
        return Residue(self.field, value * self._inverse(self.value) % self.field.prime)

    def _inverse(self, value: int) -> int:
        if not value:
            raise ZeroDivisionError("division by what is zero at a random point")
        return pow(value, -1, self.field.prime)

    def __neg__(self) -> Residue:
        return Residue(self.field, -self.value % self.field.prime)

    def __abs__(self) -> Residue:
        return self._call("abs")

    def __eq__(self, other: object) -> bool:
        return isinstance(other, (Residue, int, Fraction)) and self.value == self._of(other)

    def __hash__(self) -> int:
        return hash(self.value)

    def sign(self) -> Residue:
        """Sign; odd."""
        return self._call("sign")

    def tanh(self) -> Residue:
        """Hyperbolic tangent; odd."""
        return self._call("tanh")

    def sqrt(self) -> Residue:
        """Square root."""
        return self._call("sqrt")

    def exp(self) -> Residue:
        """Exponential function."""
        return self._call("exp")

    def atan2(self, x: Residue | Number) -> Residue:
        """The angle of the point (``x``, this)."""
        return self._call("atan2", x)

    def select(self, a: Residue | Number, b: Residue | Number) -> Residue:
        """``a`` where this is more than 0, else ``b``."""
        return self._call("select", a, b)

    def _call(self, op: str, *others: Residue | Number) -> Residue:
        values = [x.value if isinstance(x, Residue) else self.field.number(x) for x in others]
        return Residue(self.field, self.field.opaque(op, self.value, *values))

    def __repr__(self) -> str:
        return f"{self.value:x} mod {self.field.prime:x}"


def _drawn(key: bytes, name: str) -> int:
    """256 bits, the same for the same key and name."""
    return int.from_bytes(hashlib.blake2b(name.encode(), digest_size=32, key=key).digest(), "little")


@functools.lru_cache(maxsize=256)
def drawn_prime(seed: bytes, bits: int = BITS) -> int:
    """The prime of so many ``bits`` (255 at most), 3 modulo 4, that belongs to ``seed``."""
    key = hashlib.blake2b(seed, digest_size=32, person=b"robodyn prime").digest()
    top = 1 << (bits - 1)
    # Every number that is 3 modulo 4 is as likely as any other: no walk from a starting point, which would
    # favour primes behind long gaps.
    k = 0
    while True:
        candidate = _drawn(key, f"prime {k}") % top | top | 3
        if math.gcd(candidate, _PRODUCT) == 1 and is_prime(candidate, key):
            return candidate
        k += 1


def is_prime(candidate: int, key: bytes) -> bool:
    """Miller's and Rabin's test of a number that is 3 modulo 4: ``a ^ ((n - 1) / 2)`` is 1 or -1."""
    half = candidate >> 1
    return all(
        pow(base, half, candidate) in (1, candidate - 1)
        for base in (2, *(_drawn(key, f"base {k}") % candidate for k in range(_ROUNDS)))
        if base
    )
