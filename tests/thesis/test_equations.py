"""``tables equations``: every slip that can be computed is."""

from __future__ import annotations

import pytest

from robodyn.thesis.slips import (
    friction,
    slips,
)
from robodyn.thesis.tables import to_text
from thesis.recomputed import table

BY_PLACE = {slip.place: slip for slip in slips()}

#: What can be computed, and what cannot.
COMPUTED = [place for place, slip in BY_PLACE.items() if not isinstance(slip.check, str)]
IN_WORDS = [place for place in BY_PLACE if place not in COMPUTED]
#: Figures that the review measured: exact ones, and of torques the largest over 1,000 states of its own.
EXACT = {
    "Table 1.1": 872, "Table 2.9, revolute II": 10, "Table 3.3": 2, "Table 4.4": 1, "Table 4.6, link 2": 2,
    "1.1": 1800, "Eq 4.19": 2, "Eq 2.4": 2 * 0.4318, "Table 2.6, links 5, 6": 0.0036,
    "Eqs 3.10, 3.11": 0.454 - 0.232, "D.4, row of the torque": 365, "D.4, last step": 2,
}  # fmt: skip
MEASURED = {
    "D.2, LAM1": 5.46, "D.2, inertias": 0.47, "D.2, rotors": 6.77, "D.2, links 2, 3": 1.18,
    "D.2, link 2": 23.2, "D.1": 19.8, "D.4, link 3": 5.3e-3,
}  # fmt: skip


def test_every_slip_of_the_review_is_there() -> None:
    assert [row.name for row in table("equations").rows] == [slip.place for slip in slips()]
    assert (len(COMPUTED), len(IN_WORDS), len(slips())) == (74, 17, 91)
    text = to_text(table("equations"))
    assert "Newton-Euler" in text
    assert "nothing to compute: a reference in the text" in text


def test_what_is_computed_confirms_the_slip_and_the_right_form() -> None:
    for name in COMPUTED:
        row = table("equations").row(name)
        assert row.verdict == ("reproduced" if name == "Eq 2.41" else "differs"), name
        assert "neither" not in row.reason, name
        assert row.ours["against"] in row.reason
        exact = row.ours["unit"] in ("N m", "entry", "m", "1/s^2", "rad/s^2", "N") and name != "Eq 3.7"
        assert row.ours["right_off"] < 1e-12 or not exact, name


def test_what_is_not_computed_says_so_and_has_no_figure() -> None:
    for row in map(table("equations").row, IN_WORDS):
        assert row.verdict == "differs"
        assert row.reason.startswith("nothing to compute: ")
        assert set(row.ours) == {"right"}


@pytest.mark.parametrize(
    ("name", "figure", "within"),
    [*((*one, 3e-3) for one in EXACT.items()), *((*one, 0.25) for one in MEASURED.items())],
)
def test_figures_are_those_of_the_review(name: str, figure: float, within: float) -> None:
    """Torques at other random states: the largest of 1,000 is no property of the slip."""
    assert table("equations").row(name).ours["printed_off"] == pytest.approx(figure, rel=within)


# --- each check can fail ----------------------------------------------------------------------------------


def test_eq_3_7_would_subtract_twice_the_friction() -> None:
    """Link 3 brakes: the sum is off by twice its joint friction, 0.1241 N m as printed."""
    assert friction.sign_rule().printed == pytest.approx(2 * 0.1241, abs=2e-4)
