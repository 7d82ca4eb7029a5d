"""Where a residual is: the joint, the quantity that shows it, and what the motion lacks."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from report.made_up import made
from robodyn.diagnose.result import Estimate, Finding, Gap, Series
from robodyn.report.diagnosis_summary import advice, tiles
from robodyn.report.diagnosis_where import best_of, localised, shown_over, travelled
from robodyn.robot import Robot, load

Floats = NDArray[np.float64]


@pytest.fixture(scope="module")
def robot() -> Robot:
    return load("puma560_3dof", warn=lambda _: None)


def motion(residual: Callable[[Floats, Floats, Floats, Floats, Floats], Floats]) -> Series:
    """A rich motion of three joints, the residual at the second, a tenth of it noise everywhere."""
    t = np.linspace(0, 10, 3000)
    turns = np.outer(t, [1.3, 2.1, 3.7])
    slow = np.outer(t, [0.31, 0.43, 0.17])
    q = np.sin(turns) + np.sin(slow + 1)
    qd, qdd = np.gradient(q, t, axis=0), np.gradient(np.gradient(q, t, axis=0), t, axis=0)
    load_ = 20 * np.cos(q[:, [1, 2, 0]] + 0.4 * q[:, [2, 0, 1]])
    noise = 0.1 * np.random.default_rng(3).standard_normal(q.shape)
    before = noise.copy()
    before[:, 1] += residual(q[:, 1], qd[:, 1], qdd[:, 1], load_[:, 1], t)
    return Series("train", t, q, qd, qdd, load_, load_ + before, before, noise)


def gap(one: Series) -> Gap:
    before, after = (np.sqrt(np.mean(x**2, axis=0)) for x in (one.before, one.after))
    return Gap(before, after, before, after, np.full(3, 0.1))


@pytest.mark.parametrize(
    ("residual", "quantity"),
    [
        (lambda q, qd, qdd, load, t: np.full(len(t), 0.7), "constant"),
        (lambda q, qd, qdd, load, t: np.sign(qd), "direction"),
        (lambda q, qd, qdd, load, t: 0.4 * qd, "velocity"),
        (lambda q, qd, qdd, load, t: np.sin(3 * q), "position"),
        (lambda q, qd, qdd, load, t: 0.2 * qdd, "acceleration"),
        (lambda q, qd, qdd, load, t: 0.05 * load, "load"),
        (lambda q, qd, qdd, load, t: 0.05 * np.abs(load) * np.sign(qd), "load, each way"),
        (lambda q, qd, qdd, load, t: 3.0 * ((t > 4) & (t < 5)), "a short time"),
    ],
)
def test_the_quantity_that_shows_it(robot: Robot, residual: Callable[..., Floats], quantity: str) -> None:
    one = motion(residual)
    found = made(robot, series=(one, one), gap=gap(one))
    first, second, third = localised(found)
    assert second.best == quantity
    assert second.share > 0.99
    assert max(second.shown) > 0.7
    assert first.shown == third.shown == ()


def test_noise_is_shown_by_nothing() -> None:
    one = motion(lambda q, qd, qdd, load, t: 0 * t)
    shown = shown_over(one, 0)
    assert max(shown) < 0.05
    assert best_of(shown) is None
    assert best_of(()) is None


def test_what_is_not_known_does_no_harm(robot: Robot) -> None:
    one = motion(lambda q, qd, qdd, load, t: np.sign(qd))
    gone = replace(one, qdd=np.full_like(one.qdd, np.nan), before=np.full_like(one.before, np.inf))
    assert set(shown_over(gone, 1)) == {0.0}
    nan = np.full(3, np.nan)
    rows = localised(made(robot, series=(gone,), gap=Gap(nan, nan, nan, nan, nan), left=nan))
    assert [row.share for row in rows] == [0, 0, 0]


def test_what_the_motion_lacks(robot: Robot) -> None:
    one = motion(lambda q, qd, qdd, load, t: 0 * t)
    t = one.times
    q, qd, load_ = one.q.copy(), one.qd.copy(), one.load.copy()
    q[:, 0], qd[:, 0] = t, 1.0  # one way only
    load_[:, 1] = np.abs(load_[:, 1]) + 1
    qd[:, 2] = 0.0
    rows = travelled(robot, replace(one, q=q, qd=qd, load=load_))
    assert [row.wants for row in rows] == ["hardly reverses", "the load keeps its sign", "does not move"]
    found = made(robot, verdict="consistent", findings=(), series=(one,))
    (step,) = advice(found, localised(found), rows)
    assert step["text"].startswith(
        "Joint 1: hardly reverses; joint 2: the load keeps its sign; joint 3: does not move."
    )
    assert all(row.limits == (-np.pi, np.pi) for row in rows) or rows[0].limits is None


def answers(found: object, *, validated: bool = True) -> dict[str, tuple[str, str]]:
    return {
        question: (answer, remark)
        for question, answer, remark in tiles(found, validated, localised(found))  # type: ignore[arg-type]
    }


def test_answers_at_a_glance(robot: Robot) -> None:
    told = answers(made(robot))
    assert told["What is missing"] == ("Coulomb friction", "and nothing else")
    assert told["At which joint"][0] == "Joint 3"
    assert told["How sure"] == ("97 %", "not told from Stribeck friction")
    assert told["How much better"][0] == "15 → 3.75 N m"
    assert told["Cost of the kernel"][0] == "80 → 83"
    assert told["What to record next"] == ("One motion", "Slow reversals of joint 3")
    fitted = answers(made(robot), validated=False)
    assert fitted["How much better (on the logs fitted)"][0] == "12 → 3.3 N m"


def test_answers_where_nothing_was_named(robot: Robot) -> None:
    same = np.full(3, 1.01)
    even = Gap(same, same, same, same, np.ones(3))
    told = answers(made(robot, verdict="consistent", findings=(), gap=even))
    assert told["What is missing"][0] == "Nothing"
    assert told["At which joint"] == ("None", "no joint stands out of its noise")
    assert told["How much is left"] == ("1.01 N m", "RMS at joint 1, 1.01 times its noise")
    seen = answers(
        made(robot, verdict="consistent", findings=(), gap=even, detectable=np.array([0.1, 0.3, 0.2]))
    )
    assert seen["How sure"][0] == "down to 0.3 N m"
    one = motion(lambda q, qd, qdd, load, t: np.sin(3 * q))
    found = made(
        robot, verdict="unexplained", findings=(), gap=gap(one), series=(one,), left=np.array([0.1, 7, 0.2])
    )
    told = answers(found)
    assert told["At which joint"] == (
        "Joint 2", "7 times what would matter is left there; seen best over the position",
    )  # fmt: skip
    (step,) = advice(found, localised(found), ())
    assert step["title"] == "Joint 2: seen best over the position"


def test_a_contact_is_no_lack(robot: Robot) -> None:
    parameters = {
        "start": Estimate(5.8, 0.0, "s"), "end": Estimate(6.3, 0.0, "s"), "link": Estimate(2.0, 0.0, "1"),
    }  # fmt: skip
    contact = Finding("external_contact", None, parameters, 0.9, (), "a burst", None, 9.0, 9.0)
    told = answers(made(robot, findings=(contact,)))
    assert told["What is missing"] == ("Nothing", "but something outside touched the arm")
    assert told["Where and when"] == ("Link 2", "from 5.80 to 6.30 s")
    assert "contact is not added to a model" in told["How much is left"][1]
