"""Figures on tasks as the thesis prints them: data, slips included. Source: Dhanaraj 1990, chapter 4."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from robodyn.schedule.elimination import FIRST_LINK, LAST_LINK, PRISMATIC, Sparsity


@dataclass(frozen=True, slots=True)
class Misprinted:
    """What Table 4.1 prints of a task that cannot be meant: ``what`` it is (``step``, ``after`` or ``does``),
    as ``printed``, and how one knows."""

    what: str
    printed: str
    why: str


_S_FOR_G: Final = Misprinted("does", "products of lambda g", "step 4 of the text has lambda s")
_RANGE: Final = Misprinted(
    "after",
    "..., T40 to T40",
    "the sum needs p x f', s x F and n', which are T33 to T40",
)
_FROM_T0: Final = Misprinted(
    "after", "T_0 of the link before", "the table's footnote names T1, T2, T3 and T6 of it; alpha is T6"
)

#: Table 4.1: what is printed otherwise than it must be, by task.
TABLE_4_1_MISPRINTS: Final[dict[int, Misprinted]] = {
    3: Misprinted("step", "1", "it forms the vector c of step 2 as well"),
    4: _FROM_T0,
    5: _FROM_T0,
    10: Misprinted(
        "does",
        "lambda_21 = k_x + alpha_x, lambda_32 = k_z + alpha_z",
        "Eq 2.27 and step 2A of the text have x and z the other way round",
    ),
    **dict.fromkeys((20, 21, 22), _S_FOR_G),
    **dict.fromkeys((41, 42, 43), _RANGE),
}

#: Table 4.2: tasks that are eliminated, and the number of them that is printed beside.
TABLE_4_2: Final[dict[str, tuple[frozenset[int], int]]] = {
    "prismatic_joint": (PRISMATIC, 9),
    "first_link": (FIRST_LINK, 19),
    "last_link": (LAST_LINK, 8),
}

#: Table 4.4: components of the Stanford arm's s and p that are not zero, link by link; zeros, of so many.
TABLE_4_4: Final = Sparsity(s=("yz", "z", "z", "yz", "yz", "z"), p=("y", "y", "", "", "", ""))
TABLE_4_4_ZEROS: Final = (25, 36)


@dataclass(frozen=True, slots=True)
class PrintedRule:
    """A row of Table 4.5: the tasks of a step, and those still executed where the vector has 1, 2 or 3
    zeros (the table's caption says eliminated)."""

    step: str
    what: str
    tasks: tuple[int, ...]
    executed: tuple[tuple[int, ...], tuple[int, ...], tuple[int, ...]]


TABLE_4_5: Final = (
    PrintedRule("3", "a + lambda p", tuple(range(12, 18)), ((14, 15, 16, 17), (16, 17), ())),
    PrintedRule("4", "a + lambda s", tuple(range(20, 26)), ((22, 23, 24, 25), (24, 25), ())),
    PrintedRule("8", "p x f", (33, 34, 35), ((34, 35), (35,), ())),
    PrintedRule("8", "s x F", (36, 37, 38), ((37, 38), (38,), ())),
)

#: Table 4.6, the Stanford arm's links 1 to 6: zeros of s and p, tasks eliminated, and their printed number.
TABLE_4_6: Final[tuple[tuple[int, int, tuple[int, ...], int], ...]] = (
    (1, 2, (12, 13, 14, 15, 20, 21, 36, 33, 34), 9),
    (2, 2, (12, 13, 14, 15, 20, 21, 22, 23, 33, 34, 36, 37), 10),
    (2, 3, (12, 13, 14, 15, 16, 17, 20, 21, 22, 23, 33, 34, 35, 36, 37), 15),
    (1, 3, (12, 13, 14, 15, 16, 17, 20, 21, 33, 34, 35, 36), 12),
    (1, 3, (12, 13, 14, 15, 16, 17, 20, 21, 33, 34, 35, 36), 12),
    (2, 3, (12, 13, 14, 15, 16, 17, 20, 21, 22, 23, 33, 34, 35, 36, 37), 15),
)

#: Levels of Tables 4.3 and C.1 to C.8 (any six-joint arm), 4.7 and C.9 to C.15 (Stanford), by processors.
LEVELS_SIX_LINK: Final = {1: 231, 2: 116, 3: 78, 4: 58, 5: 47, 6: 39, 7: 34, 8: 31, 9: 30, 13: 27}
LEVELS_STANFORD: Final = {1: 156, 2: 79, 3: 52, 4: 39, 5: 32, 6: 29, 7: 27, 8: 27, 9: 27}

#: Table 4.8, the thesis's column: milliseconds of the Stanford arm's schedules, by processors.
TIMES_STANFORD: Final = {1: 21.06, 2: 10.67, 3: 7.02, 4: 5.26, 5: 4.32, 6: 3.92, 7: 3.65, 8: 3.65}

#: Table 4.8, the columns of others for the same arm: milliseconds by processors, where printed.
TIMES_OTHERS: Final[dict[str, dict[int, float]]] = {
    "Luh and Lin 1982": {1: 24.8, 6: 9.67},
    "Kasahara and Narita 1985": {1: 24.83, 2: 12.42, 3: 8.43, 4: 6.59, 5: 5.86, 6: 5.73, 7: 5.60},
    "Chen, Lee and Hou 1988": {1: 24.83, 2: 12.42, 3: 8.44, 4: 6.59, 5: 5.72, 6: 5.70},
}
