"""Days in words and on axes: round, few, within the axis, in any range."""

from __future__ import annotations

import pytest

from robodyn.draw.dates import DAY, date_ticks, day_text, range_text
from robodyn_testing import representative

MAY_3 = 1_746_230_400.0  # 2025-05-03T00:00:00Z


def test_days_are_utc() -> None:
    assert day_text(MAY_3) == "3 May 2025"
    assert day_text(MAY_3 - 1) == "2 May 2025"
    assert day_text(0.0) == "1 Jan 1970"


@pytest.mark.parametrize(
    ("days", "text"),
    [(0, "3 May 2025"), (9, "3 to 12 May 2025"), (30, "3 May to 2 Jun 2025"),
     (300, "3 May 2025 to 27 Feb 2026")],
)  # fmt: skip
def test_what_two_days_share_is_said_once(days: int, text: str) -> None:
    assert range_text(MAY_3, MAY_3 + days * DAY) == text


@pytest.mark.parametrize(
    ("days", "labels"),
    [
        (5, ["3 May", "4 May", "5 May", "6 May", "7 May", "8 May"]),
        (20, ["7 May", "12 May", "17 May", "22 May"]),
        (365, ["Jul 2025", "Sep", "Nov", "Jan 2026", "Mar", "May"]),
        (5 * 365, ["Jan 2026", "Jan 2027", "Jan 2028", "Jan 2029", "Jan 2030"]),
    ],
)
def test_ticks_are_firsts_of_months_or_days(days: int, labels: list[str]) -> None:
    assert [label for _, label in date_ticks(MAY_3, MAY_3 + days * DAY, 6)] == labels


@pytest.mark.parametrize(
    "days",
    representative([0.001, 0.9, 3, 31, 59, 90, 400, 3000, 30_000, 300_000, 2_900_000], 0.001, 3, 90, 3000),
)
def test_ticks_are_few_and_within(days: float) -> None:
    for most in (2, 4, 8):
        at = [moment for moment, _ in date_ticks(MAY_3, MAY_3 + days * DAY, most)]
        assert len(at) <= most
        assert all(MAY_3 <= moment <= MAY_3 + days * DAY for moment in at)
        assert len(at) >= 2 or days < 10 or most == 2
