"""How long exact constants may grow before nobody waits for them."""

from __future__ import annotations

from fractions import Fraction

from robodyn.errors import InputError

#: Bits of a constant at most, some 20,000 digits: products and sums of larger ones take for ever.
_MOST_BITS = 1 << 16


class TooManyDigits(InputError):
    """Constants that are exact, and so long that nobody waits for their products."""


def check_digits(constant: Fraction | int) -> None:
    """Refuse a ``constant`` whose products would take for ever.

    Raises
    ------
    TooManyDigits: numerator and denominator have more than some 20,000 digits together.
    """
    if constant.denominator.bit_length() + constant.numerator.bit_length() > _MOST_BITS:
        raise TooManyDigits(
            "the products of constants have more than 20,000 digits",
            remedy="give the numbers fewer digits, or the arm fewer joints",
        )
