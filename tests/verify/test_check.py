"""A right kernel passes, a wrong one does not: whichever number is wrong, the comparison finds it."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any

import numpy as np
import pytest

import robodyn
from robodyn.dynamics.functions import FUNCTIONS, function_named
from robodyn.effects.scalars import root
from robodyn.errors import InputError
from robodyn.robot import read_text
from robodyn.robot.model import Link, Robot
from robodyn.robot.values import angle, parameter
from robodyn.verify import Reference
from robodyn.verify.sample import draw
from robodyn_testing import covering, representative
from verify.checked import INPUTS, Stand, check


def test_a_right_kernel_passes(arm: Robot) -> None:
    seen: list[tuple[int, int]] = []
    report = check(arm, Stand(arm), progress=lambda done, total: seen.append((done, total)))
    assert report.passed
    assert {(c.function, c.against) for c in report.comparisons} == {
        (f, a) for f in INPUTS for a in ("reference", "exact", "lagrangian")
    }
    assert seen == [(k, 15) for k in range(1, 16)]
    assert report.skipped == {}
    for c in report.comparisons:
        assert c.error < 1e-14
        assert (c.ulps is not None) == (c.against == "exact" and c.function != "forward_dynamics")
        assert c.ulps is None or c.ulps < 64
        assert c.states == (2 if c.against == "exact" else 40)


def test_single_precision_has_its_own_tolerance(arm: Robot) -> None:
    report = check(arm, Stand(arm, "float"))
    assert report.passed
    assert 1e-10 < max(c.error for c in report.comparisons) < 1e-6
    assert {c.tolerance for c in report.comparisons} == {1e-5}


def test_what_has_no_exact_value_is_not_compared_exactly(arm: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    """A function with a root, as somebody may add one."""
    lengths = replace(
        function_named("gravity"), expected=lambda at: [root(x * x) for x in at.torques(at.rest, at.rest)]
    )
    monkeypatch.setitem(FUNCTIONS, "gravity", lengths)
    report = check(arm, Stand(arm))
    reason = "roots, exponentials and the like have no exact values"
    assert report.skipped == {"gravity with exact": reason}
    assert {c.against for c in report.comparisons if c.function == "gravity"} == {"reference", "lagrangian"}


def test_a_regressor_beside_smooth_friction_has_no_exact_value() -> None:
    robot = read_text(
        "name: a\nfriction_at_rest: {smooth: {velocity: 0.01}}\n"
        "links: [{joint: revolute, a: 0.2, mass: 1, com: [0.3, 0, 0], friction: {coulomb: 1}}]"
    )
    report = check(robot, robodyn.compile(robot, functions=["regressor"]), lagrangian=False)
    assert report.skipped == {"regressor with exact": "roots, exponentials and the like have no exact values"}
    assert [c.against for c in report.comparisons] == ["reference"]
    assert report.passed


def scaled(x: Any) -> Any:
    return x * Fraction(10001, 10000)


def com_scaled(link: Link, k: int) -> Link:
    com: Any = tuple(scaled(x) if j == k else x for j, x in enumerate(link.com))
    return replace(link, com=com)


def inertia_scaled(link: Link, name: str) -> Link:
    return replace(link, inertia=replace(link.inertia, **{name: scaled(getattr(link.inertia, name))}))


def joint_scaled(link: Link, name: str) -> Link:
    return replace(link, joint=replace(link.joint, **{name: scaled(getattr(link.joint, name))}))


def turned(link: Link, name: str) -> Link:
    new: Any = angle(Fraction(getattr(link.joint, name).radians) + Fraction(1, 10**5))
    return replace(link, joint=replace(link.joint, **{name: new}))


LINK: dict[str, Callable[[Link], Link]] = {
    "mass": lambda link: replace(link, mass=scaled(link.mass)),
    **{f"com {'xyz'[k]}": partial(com_scaled, k=k) for k in range(3)},
    **{
        f"inertia {name}": partial(inertia_scaled, name=name) for name in ("xx", "yy", "zz", "xy", "xz", "yz")
    },
    **{name: partial(joint_scaled, name=name) for name in ("a", "d", "motor_inertia", "viscous", "coulomb")},
    **{name: partial(turned, name=name) for name in ("alpha", "theta")},
}


@pytest.mark.parametrize("number", representative(LINK, "mass", "alpha", "inertia xy", "coulomb"))
def test_any_wrong_number_is_found(number: str, arm: Robot) -> None:
    """One number of the last link is wrong by a ten-thousandth (an angle by 1e-5) in the kernel."""
    wrong = replace(arm, links=(*arm.links[:-1], LINK[number](arm.links[-1])))
    report = check(arm, Stand(wrong, functions=("inverse_dynamics",)))
    assert not report.passed
    assert [c.passed for c in report.comparisons] == [False, False, False]


@pytest.mark.parametrize(("function", "axis"), covering(INPUTS, range(3)))
def test_wrong_gravity_is_found_where_it_matters(function: str, axis: int, arm: Robot) -> None:
    x, y, z = (g + Fraction(int(k == axis), 10**4) for k, g in enumerate(arm.gravity))
    wrong = replace(arm, gravity=(x, y, z))
    report = check(arm, Stand(wrong, functions=(function,)), lagrangian=False)
    assert report.passed == (function == "mass_matrix")


def test_the_wrong_side_of_the_gear_is_found(arm: Robot) -> None:
    report = check(arm, Stand(replace(arm, torque_side="link")))
    failed = {c.function for c in report.comparisons if not c.passed}
    assert failed == set(INPUTS) - {"gravity"}


class Spoilt(Stand):
    """Spoils one number of one result."""

    value: float = np.nan

    def __getattr__(self, name: str) -> Callable[..., Any]:
        right = super().__getattr__(name)

        def call(*arrays: Any, params: Any = None) -> Any:
            result = right(*arrays, params=params)
            result[7, 2] += self.value
            return result

        return call


@pytest.mark.parametrize(("function", "value"), covering(INPUTS, [np.nan, np.inf, -np.inf]))
def test_what_is_not_a_number_is_infinitely_wrong(function: str, value: float, arm: Robot) -> None:
    kernel = Spoilt(arm, functions=(function,))
    kernel.value = value
    report = check(arm, kernel, states=8, exact_states=8)
    assert not report.passed
    by_reference = {c.against: c for c in report.comparisons}
    assert by_reference["reference"].error == np.inf
    assert by_reference["reference"].state == 7
    assert by_reference["lagrangian"].error == np.inf
    if function != "mass_matrix":
        assert by_reference["exact"].error == np.inf
    told = json.dumps(report.to_dict(), allow_nan=False)
    assert json.loads(told)["comparisons"][0]["error"] is None


def test_place_and_size_of_the_error_are_told(arm: Robot) -> None:
    kernel = Spoilt(arm, functions=("inverse_dynamics",))
    kernel.value = 1e-3
    report = check(arm, kernel)
    worst = report.worst
    assert worst is not None
    assert (worst.joint, worst.state, worst.column) == (3, 7, None)
    assert worst.error == pytest.approx(1e-3 / report.largest_torque, rel=1e-6)
    sample = draw(arm, 40, 0, np.dtype(np.float64))
    assert worst.inputs["qdd"] == tuple(sample.qdd[7])
    text = report.to_text()
    assert "inverse_dynamics  reference" in text
    assert "FAILED: 2 of 3" in text
    assert "worst: inverse_dynamics against" in text
    assert f"qdd = [{', '.join(repr(x) for x in worst.inputs['qdd'])}]" in text


def test_a_matrix_tells_row_and_column(arm: Robot) -> None:
    class Crooked(Stand):
        def __getattr__(self, name: str) -> Callable[..., Any]:
            def call(q: Any, params: Any = None) -> Any:
                M = Reference(self.model).mass_matrix(q)
                M[5, 1, 2] *= 1.001
                return M

            return call

    report = check(arm, Crooked(arm, functions=("mass_matrix",)))
    worst = report.worst
    assert worst is not None
    assert (worst.state, worst.joint, worst.column) == (5, 2, 3)
    assert "2,3" in report.to_text()


def test_the_same_seed_gives_the_same_report(arm: Robot) -> None:
    kernel = Stand(arm, functions=("gravity", "bias"))
    first, again = (check(arm, kernel, seed=3) for _ in range(2))
    assert first.to_dict() == again.to_dict()
    assert first.to_text() == again.to_text()
    assert check(arm, kernel, seed=4).to_dict() != first.to_dict()


def test_run_time_parameters(arm: Robot) -> None:
    last = replace(arm.links[-1], mass=parameter("m_tool"))
    robot = replace(arm, links=(*arm.links[:-1], last))
    report = check(robot, Stand(robot))
    assert report.passed
    assert 0.1 <= report.parameters["m_tool"] <= 1.0
    report = check(robot, Stand(robot, "float", ("bias",)), parameters={"m_tool": 1 / 3})
    assert report.passed
    assert report.parameters == {"m_tool": float(np.float32(1 / 3))}
    wrong = Stand(arm, functions=("gravity",))
    wrong.signatures = Stand(robot, functions=("gravity",)).signatures
    assert not check(robot, wrong).passed
    with pytest.raises(InputError, match="no such run-time parameter; found mass; expected m_tool"):
        check(robot, wrong, parameters={"mass": 1.0})


def test_a_function_that_was_compared_with_nothing_fails(arm: Robot) -> None:
    kernel = Stand(arm, functions=("gravity",))
    kernel.functions = ("gravity", "unheard_of")
    report = check(arm, kernel)
    assert not report.passed
    assert report.uncompared == ("unheard_of",)
    assert report.skipped == {"unheard_of": "no reference knows it"}
    assert "not compared: unheard_of: no reference knows it" in report.to_text()
    assert report.to_text().endswith("COMPARED WITH NOTHING: unheard_of")
    assert report.to_dict()["uncompared"] == ["unheard_of"]
    kernel.functions = ("unheard_of",)
    report = check(arm, kernel)
    assert not report.passed
    assert report.worst is None


def test_another_robots_kernel(arm: Robot) -> None:
    with pytest.raises(InputError, match="another robot's; found other"):
        check(arm, Stand(replace(arm, name="other")))
