"""``tables equations``: every slip that can be computed is, and a model that is broken shows in its row."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any

import pytest

from robodyn.dynamics import transforms
from robodyn.dynamics.transforms import IDENTITY_4
from robodyn.effects import thesis_friction
from robodyn.schedule import arithmetic
from robodyn.thesis import printed, steps
from robodyn.thesis.puma_inverse import PumaArm
from robodyn.thesis.slips import (
    frames,
    friction,
    lagrangian,
    printed_data,
    recursion,
    slips,
)
from robodyn.thesis.tables import equations, to_text
from thesis.recomputed import Patch, changed, table

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


def fails(*places: str) -> bool:
    """Whether the right forms of all ``places`` disagree with their references."""
    rows = (equations.slip_row(BY_PLACE[place]) for place in places)
    return all(row.reason.startswith("neither form") for row in rows)


def off_by(run: Callable[..., Any], factor: float = 1.5) -> Callable[..., Any]:
    """``run`` with its first number, or all numbers of a list or tuple, too large."""

    def changed(*arguments: Any, **keywords: Any) -> Any:
        value = run(*arguments, **keywords)
        return type(value)(factor * x for x in value) if isinstance(value, tuple | list) else factor * value

    return changed


RECURSION = tuple(
    slip.place for slip in slips() if getattr(slip.check, "func", None) is recursion.of_recursion
)


@pytest.mark.parametrize("step", ["moment", "inertial_force", "euler_I", "alpha_I", "omega"])
def test_a_broken_step_of_the_recursion_shows_in_all_its_rows(step: str, monkeypatch: Patch) -> None:
    monkeypatch.setattr(steps, step, off_by(getattr(steps, step)))
    assert len(RECURSION) > 20
    assert fails(*RECURSION)
    assert fails("Table 2.7, link 3", "D.2, rotors", "D.3.1, link 3", "D.3.2, link 1", "D.2, link 4")


@pytest.mark.parametrize(
    ("target", "name", "places"),
    [
        (thesis_friction, "journal_bearing", ["Eq 3.3"]),
        (thesis_friction, "thrust_bearing", ["Eq 3.5"]),
        (thesis_friction, "with_friction", ["Eq 3.7"]),
        (thesis_friction, "braking", ["Eqs 3.10, 3.11"]),
        (lagrangian, "weighed", ["A.1, first sum", "A.1, second sum", "A.1, gravity"]),
        (lagrangian, "trace", ["A.2, D_i", "A.2, T_(i+1)", "A.2, c_i", "A.2, pseudo-inertia"]),
        (lagrangian, "first_moment", ["A.3, R_(i+1)", "A.3, D_i", "A.3, e_i", "A.3, e_i, last term",
                                      "A.3, c_i"]),
        (PumaArm, "positions", ["D.1.3, comment", "D.1.3, offset", "D.1.3, line"]),
        (steps, "inertial_force", ["D.4, link 3", "D.4, inertia matrix"]),
        (arithmetic, "_cross", ["Table 4.1, T4, T5", "Table 4.1, T41 to T43"]),
        (printed_data, "moved_to_origin", ["Table 2.6, links 5, 6"]),
    ],
)  # fmt: skip
def test_a_broken_model_shows(target: Any, name: str, places: list[str], monkeypatch: Patch) -> None:
    assert not any(fails(place) for place in places)
    if name == "moved_to_origin":
        monkeypatch.setattr(target, name, lambda link: (link.motor, link.motor, link.motor))
    else:
        monkeypatch.setattr(target, name, off_by(getattr(target, name)))
    assert fails(*places)


def test_broken_rotations_show(monkeypatch: Patch) -> None:
    rotation = transforms.rotation

    def stretched(*arguments: Any) -> Any:
        return tuple((1.5 * row[0], row[1], row[2]) for row in rotation(*arguments))

    monkeypatch.setattr(frames, "rotation", stretched)
    assert fails("Eq 2.36", "Eq 4.4", "Eq 4.19", "B.7, B.9")
    monkeypatch.setattr(frames, "transform", lambda *arguments: IDENTITY_4)
    assert fails("Eqs 2.1, 2.2")
    assert frames.sign_of_a().right > 0.1
    monkeypatch.setattr(frames, "inertia_moment", lambda inertia, at: inertia.times(at.alpha))
    assert fails("Eq 2.41")


def test_sums_follow_the_printed_columns(monkeypatch: Patch) -> None:
    """With another column the sum is another, and the figure that was said to be right is wrong."""
    column = {**printed.TABLE_2_9["revolute_II"], "n": (21, 34)}
    monkeypatch.setitem(printed.TABLE_2_9, "revolute_II", column)
    assert equations.slip_row(BY_PLACE["Table 2.9, revolute II"]).verdict == "reproduced"
    cost = printed.TABLE_1_1["uicker_kahn"]
    monkeypatch.setitem(printed.TABLE_1_1, "uicker_kahn", replace(cost, mul=cost.mul[1:]))
    monkeypatch.setattr(printed_data, "journal", lambda: type("Counted", (), {"add": 9}))
    monkeypatch.setattr(printed_data, "flops", lambda tasks, zeros: 3)
    first, second, *others = printed.TABLE_4_6
    monkeypatch.setattr(printed_data, "TABLE_4_6", (first, (*second[:2], second[2][1:], second[3]), *others))
    assert fails("Table 1.1", "Table 3.3", "Table 4.5, caption", "Table 4.6, link 2")


def test_zeros_and_origins_follow_the_robot(monkeypatch: Patch) -> None:
    monkeypatch.setattr(printed_data, "bundled", changed("stanford", 5, com=(Fraction(1),) * 3))
    assert fails("Table 4.4")
    for axis in range(3):
        own_products = partial(arithmetic._products, axis, of_parent=False)
        monkeypatch.setitem(arithmetic._DO, 12 + axis, own_products)
    assert fails("Table 4.6, step 3")


def test_eq_3_7_would_subtract_twice_the_friction() -> None:
    """Link 3 brakes: the sum is off by twice its joint friction, 0.1241 N m as printed."""
    assert friction.sign_rule().printed == pytest.approx(2 * 0.1241, abs=2e-4)
