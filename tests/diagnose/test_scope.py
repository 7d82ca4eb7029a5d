"""What is asked for is what is looked for: effects, joints, and how many are named."""

from __future__ import annotations

import pytest

from robodyn.diagnose.amend.amend import Amendment
from robodyn.diagnose.blind.hide import Blind, Setup, hide
from robodyn.diagnose.run import diagnose
from robodyn.diagnose.select.library import candidates, context_of
from robodyn.diagnose.select.scope import EVERYTHING, Scope, scope_of
from robodyn.errors import InputError
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.signals import signals_of
from robodyn.robot import load


@pytest.fixture(scope="module")
def blind() -> Blind:
    robot = load("puma560_3dof", warn=lambda _: None)
    hidden = [Amendment("viscous_friction", 1, {}), Amendment("torque_bias", 3, {})]
    return hide(robot, hidden, setup=Setup(rate=250.0, seed=4))


def test_candidates_are_those_in_scope(blind: Blind) -> None:
    context = context_of(Model(blind.model), signals_of(blind.train))
    every = [(one.effect, one.joint) for one in candidates(context)]
    for scope in (
        Scope(frozenset({"coulomb_friction"})),
        Scope(frozenset({"payload", "motor_coupling"})),
        Scope(joints=frozenset({2})),
        Scope(without=frozenset({"joint_elasticity", "backlash", "time_delay"}), joints=frozenset({1, 3})),
    ):
        allowed = [key for key in every if scope.allows(*key)]
        assert [(one.effect, one.joint) for one in candidates(context, scope)] == allowed
        assert 0 < len(allowed) < len(every)
    assert [key for key in every if EVERYTHING.allows(*key)] == every


def test_only_what_is_asked_for_is_named_and_said(blind: Blind) -> None:
    result = diagnose(blind.model, [blind.train], only=["torque_bias", "coulomb_friction"], joints=[3])
    assert {(f.effect, f.joint) for f in result.findings} == {("torque_bias", 3)}
    assert result.words[-1] == "looked for on request: only coulomb_friction, torque_bias; at joints 3 only"


@pytest.mark.thorough
def test_so_many_are_named_at_most(blind: Blind) -> None:
    assert len(diagnose(blind.model, [blind.train]).findings) > 1
    assert len(diagnose(blind.model, [blind.train], most=1).findings) == 1


def test_nothing_in_scope_is_no_error(blind: Blind) -> None:
    """Joint 1 turns about the vertical: no spring can take gravity off it."""
    assert diagnose(blind.model, [blind.train], only=["gas_spring"], joints=[1]).findings == ()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"only": ["coulomb"]}, "unknown effect 'coulomb'.*did you mean 'coulomb_friction'"),
        ({"without": ["bakclash"]}, "did you mean 'backlash'"),
        ({"joints": [4]}, "no such joint; found 4; expected 1 to 3"),
        ({"joints": [0]}, "no such joint; found 0"),
        ({"only": ["spring"], "without": ["spring"]}, "no effect is left to look for"),
        ({"most": 0}, "not positive; found 0"),
    ],
)
def test_what_cannot_be_asked_for_is_refused(arguments: dict[str, object], message: str) -> None:
    with pytest.raises(InputError, match=message):
        scope_of(3, **arguments)  # type: ignore[arg-type]
