"""Tables of doubles as text: the shortest that reads back as itself, as ``repr`` gives it, many at once.

Of a double ``x = m 2^e`` of ordinary size ``V = x 10^k`` has 17 digits before its point. Its nearest integer,
and what is left over, are found exactly in integers modulo 2^64: a first guess in doubles is off by a few
units, so that the rest ``m 5^k - I 2^s``, s = -(e + k), is small. A decimal reads back as x if it lies within
half a step of x, which is ``5^k / 2`` in units of ``2^-s``. If a multiple of ten does, the last digit is not
needed; if a multiple of a hundred does, and at all other numbers, ``repr`` is asked.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

#: Sizes between which a number is written here; repr gives all of them without an exponent.
SMALLEST, LARGEST = 1e-4, 1e5
#: Rows that are written at once.
ROWS = 1 << 11

# Places in a cell: sign, 0.000 before small numbers, 17 digits with room for a point after each of the first
# five, and what separates. What is not used stays NUL, and is deleted in the end.
_SIGN, _LEAD, _POINTS, _END = 0, 1, 5, 28
_DIGITS = (6, 8, 10, 12, 14, *range(16, 28))
_WIDTH = _END + 1

_DECADES = np.array([10.0**d for d in range(-3, 5)])
_FIVES = np.array([5**k for k in range(21)])
_TENS = np.array([10.0**k for k in range(21)])
_FOURS = np.array([list(b"%04d" % i) for i in range(10_000)], dtype=np.uint8)


def write_csv(names: Sequence[str], columns: Sequence[Floats]) -> str:
    """The text of a log: the header, and a line a sample; ``columns`` are ``[K]`` each.

    Every number is the shortest that reads back as the same double.
    """
    parts = [",".join(names).encode() + b"\n"]
    for start in range(0, len(columns[0]), ROWS):
        parts.append(table_text(np.column_stack([column[start : start + ROWS] for column in columns])))
    return b"".join(parts).decode()


def table_text(rows: Floats) -> bytes:
    """The table ``[K, C]`` as text: numbers separated by commas, rows that end in a newline."""
    x = np.ascontiguousarray(rows).reshape(-1)
    cells = np.zeros((len(x), _WIDTH), dtype=np.uint8)
    left = _fill(x, cells)
    texts = np.array(list(map(repr, x[left].tolist())), dtype=f"S{_END}")
    cells[left, :_END] = texts.view(np.uint8).reshape(-1, _END)
    ends = cells.reshape(*rows.shape, _WIDTH)[:, :, _END]
    ends[:, :-1], ends[:, -1] = ord(","), ord("\n")
    return cells.tobytes().translate(None, b"\0")


def _fill(x: Floats, cells: NDArray[np.uint8]) -> NDArray[np.intp]:
    """Write the numbers of 16 and 17 digits into their cells; the places of all others."""
    size = np.abs(x)
    usual = (size >= SMALLEST) & (size < LARGEST)
    size = np.where(usual, size, 1.0)
    fraction, exponent = np.frexp(size)
    m = (fraction * 2.0**53).astype(np.int64)
    d = np.searchsorted(_DECADES, size, side="right") - 4
    k = 16 - d
    s = 53 - exponent.astype(np.int64) - k
    near = np.rint(size * _TENS[k]).astype(np.int64)
    five = _FIVES[k]
    rest = m * five - (near << s)
    step = (rest + (np.int64(1) << (s - 1))) >> s
    near += step
    rest -= step << s

    def fits(past: NDArray[np.int64]) -> NDArray[np.bool_]:
        """Whether the decimal that lies ``past`` units below ``near`` reads back as x."""
        inside: NDArray[np.bool_] = np.abs((past << s) + rest) * 2 < five
        return inside

    ten = near % 10
    ten -= 10 * ((ten > 5) | ((ten == 5) & (rest > 0)))
    hundred = near % 100
    hundred -= 100 * (hundred > 50)
    short = fits(ten)
    digits = near - np.where(short, ten, 0)
    # Ties are for repr to settle. So are powers of two, about which steps are uneven, and what would carry to
    # one digit more, a power of ten: of these sizes all have few digits, and fit a multiple of a hundred.
    tie = (np.abs(ten) == 5) & (rest == 0) | (2 * np.abs(rest) == np.int64(1) << s)
    here = usual & ~tie & ~fits(hundred)
    digits = np.where(here, digits, 0)

    cells[:, _SIGN] = np.where(x < 0, ord("-"), 0)
    for i, mark in enumerate(b"0.000"):
        cells[:, _LEAD + i] = np.where(-d >= max(i, 1), mark, 0)
    for i in range(5):
        cells[:, _DIGITS[i] + 1] = np.where(d == i, ord("."), 0)
    high, low = np.divmod(digits, 10**8)
    for first, part in ((13, low), (9, low // 10**4), (5, high), (1, high // 10**4)):
        four = _FOURS[part % 10**4]
        for i in range(4):
            cells[:, _DIGITS[first + i]] = four[:, i]
    cells[:, _DIGITS[0]] = high // 10**8 + ord("0")
    cells[short, _DIGITS[16]] = 0
    left = np.flatnonzero(~here)
    cells[left] = 0
    return left
