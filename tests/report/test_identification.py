"""An identification in words."""

from __future__ import annotations

import pytest

from robodyn.report.figures import with_error


@pytest.mark.parametrize(
    ("value", "error", "text"),
    [
        (1874.55, 97.6, "1870 +- 100"),
        (12.6958, 0.404, "12.7 +- 0.4"),
        (0.28431, 0.0521, "0.28 +- 0.05"),
        (-9e-9, 0.05, "0.00 +- 0.05"),
        (2.9239, 1.21, "2.9 +- 1.2"),
        (243.7, 33.0, "240 +- 30"),
        (1.5e-9, 2e-10, "1.5e-09 +- 2e-10"),
        (5.0, 0.0, "5"),
    ],
)
def test_numbers_have_the_digits_that_their_errors_allow(value: float, error: float, text: str) -> None:
    assert with_error(value, error) == text
