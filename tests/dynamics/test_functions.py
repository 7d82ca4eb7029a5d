"""The five kernels of an arm hang together exactly: M is symmetric, holds ID's columns, and FD undoes ID."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from operator import mul
from typing import Any

import pytest

from dynamics.direct import exact_arm
from ir.programs import Point, exactly
from robodyn import InputError, Options, load, program
from robodyn.counts import count
from robodyn.dynamics.functions import function_named
from robodyn.dynamics.mass_matrix import solve_symmetric
from robodyn.ir import Graph, Input, Program
from robodyn.kernels import rigid_programs
from robodyn.kernels.generate import SingularArm, generate
from robodyn.optimize.programs import Choice, build
from robodyn.passes import FRESH, run
from robodyn.robot import Robot, read_text
from robodyn_testing import sampled

ARMS = [
    replace(exact_arm(seed, joints=1 + seed % 7, motors=1), torque_side="motor") for seed in range(20, 32)
]
BUNDLED = ("puma560", "stanford", "ur5", "tx40", "panda", "stanford_3dof")
OPTIONS = (
    Options(),
    Options(regroup=False, optimize="none"),
    Options(formulation="newton_euler"),
)  # fmt: skip


def bundled(name: str) -> Robot:
    return load(name, warn=lambda _: None)


def values(
    robot: Robot, function: str, at: Point, options: Options | None = None, **given: list[Fraction]
) -> list[Fraction]:
    """The results of one kernel; arrays that are not ``given`` are the point's own."""
    made = program(robot, function, options)
    numbers = {Input(name, i): Fraction(x) for name, array in given.items() for i, x in enumerate(array)}
    ((_, found),) = exactly(made, at, numbers).items()
    return found


@pytest.mark.parametrize(
    "robot", sampled([*ARMS, *map(bundled, BUNDLED)], every=4), ids=lambda robot: robot.name
)
def test_kernels_hang_together(robot: Robot) -> None:
    n, at, zero = robot.n, Point(7), [Fraction(0)] * robot.n
    gravity = values(robot, "gravity", at)
    assert values(robot, "inverse_dynamics", at, qd=zero, qdd=zero) == gravity
    bias = values(robot, "bias", at)
    assert values(robot, "inverse_dynamics", at, qdd=zero) == bias
    matrix = values(robot, "mass_matrix", at)
    assert [matrix[j * n + i] for i in range(n) for j in range(n)] == matrix
    for j in range(n):
        unit = [Fraction(i == j) for i in range(n)]
        torque = values(robot, "inverse_dynamics", at, qd=zero, qdd=unit)
        assert [t - g for t, g in zip(torque, gravity, strict=True)] == matrix[j::n]


@pytest.mark.parametrize(
    "robot", sampled([*ARMS, *map(bundled, BUNDLED)], every=3), ids=lambda robot: robot.name
)
def test_forward_dynamics_undoes_inverse_dynamics(robot: Robot) -> None:
    at = Point(8)
    qdd = [at.number(Input("qdd", i)) for i in range(robot.n)]
    for options in OPTIONS:
        if robot.name == "tx40":
            with pytest.raises(SingularArm):
                program(robot, "forward_dynamics", options)
            continue
        tau = values(robot, "inverse_dynamics", at, options)
        assert values(robot, "forward_dynamics", at, options, tau=tau) == qdd


@pytest.mark.parametrize("function", ["mass_matrix", "gravity", "bias"])
def test_every_way_of_writing_gives_the_same(function: str) -> None:
    for robot in ARMS:
        one, *others = (values(robot, function, Point(9), options) for options in OPTIONS)
        assert all(other == one for other in others)


def test_an_arm_with_a_joint_without_inertia_has_no_forward_dynamics() -> None:
    robot = bundled("tx40")
    made = generate(robot)
    assert tuple(made.left_out) == ("forward_dynamics",)
    assert set(made.counts) == {"inverse_dynamics", "gravity", "bias", "mass_matrix"}
    with pytest.raises(SingularArm, match="tx40 has no forward dynamics; found a joint that moves without"):
        generate(robot, Options(functions=("gravity", "forward_dynamics")))
    assert issubclass(SingularArm, InputError)


@pytest.mark.parametrize("joints", [1, 3])
@pytest.mark.parametrize("engine", ["graph", "sympy"])
def test_an_arm_of_nothing(joints: int, engine: str) -> None:
    """Links without mass are allowed: every torque is 0, and accelerations there are none."""
    links = ", ".join(["{joint: revolute, alpha: pi/2, a: 0.3}"] * joints)
    robot = read_text(f"name: ghost\nlinks: [{links}]")
    made = generate(robot, Options(engine=engine))  # type: ignore[arg-type]
    assert tuple(made.left_out) == ("forward_dynamics",)
    assert all(found.total == 0 for found in made.counts.values())
    assert values(robot, "inverse_dynamics", Point(1)) == [0] * joints
    assert values(robot, "mass_matrix", Point(1)) == [0] * joints**2


def test_solving_takes_as_many_divisions_as_there_are_joints() -> None:
    """``U D U^T``: n divisions, no square root, and the solution on fractions."""
    n = 4
    half = [[Fraction(1, 1 + i + j) for j in range(n)] for i in range(n)]  # Hilbert: positive definite
    right = [Fraction(i + 1, 7) for i in range(n)]
    x = solve_symmetric(half, right)
    assert [sum(a * b for a, b in zip(row, x, strict=True)) for row in half] == right
    lower = [[half[i][j] if j <= i else Fraction(99) for j in range(n)] for i in range(n)]
    assert solve_symmetric(lower, right) == x  # nothing above the diagonal is read
    graph = Graph()
    matrix = [[graph.input("M", n * max(i, j) + min(i, j)) for j in range(n)] for i in range(n)]
    solve_symmetric(matrix, [graph.input("b", i) for i in range(n)])
    assert [key[0] for key in graph.keys].count("div") == n
    assert "sqrt" not in {key[0] for key in graph.keys}


@pytest.mark.parametrize(
    "robot", sampled([*ARMS, *map(bundled, BUNDLED)], every=4), ids=lambda robot: robot.name
)
def test_the_inverse_mass_matrix_is_one(robot: Robot) -> None:
    """Exactly: the mass matrix times it is the identity, and it is symmetric."""
    if robot.name == "tx40":
        with pytest.raises(SingularArm, match="tx40 has no inverse mass matrix"):
            program(robot, "inverse_mass_matrix")
        return
    n, at = robot.n, Point(10)
    matrix, inverse = (values(robot, name, at) for name in ("mass_matrix", "inverse_mass_matrix"))
    assert [inverse[j * n + i] for i in range(n) for j in range(n)] == inverse
    rows = [matrix[n * i : n * (i + 1)] for i in range(n)]
    assert [[sum(map(mul, row, inverse[j::n])) for j in range(n)] for row in rows] == [
        [int(i == j) for j in range(n)] for i in range(n)
    ]


@pytest.mark.thorough
def test_long_arms_have_forward_dynamics_by_articulated_bodies() -> None:
    """Operations grow with the joints and not with their cube."""
    arm = exact_arm(3, joints=24, prismatic=0.2, parallel=0.3)
    record = function_named("forward_dynamics")
    by_matrix, by_bodies = (
        count(run(build(arm, "forward_dynamics", Choice(), writing), FRESH)).total
        for writing in (record.outputs, *record.of_rigid_arms)
    )
    assert by_bodies < 0.7 * by_matrix
    assert count(program(arm, "forward_dynamics", Options(optimize="fast"))).total <= by_bodies


@pytest.mark.parametrize("slides", [False, True])
def test_of_a_long_arm_what_cannot_win_is_not_built(slides: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where each joint carries much, its mass matrix alone takes more than articulated bodies; that of joints
    that all slide is made of numbers."""
    ways = []

    def counted(robot: Robot, function: str, *how: Any, **options: Any) -> Program:
        ways.append((function, how[1] if len(how) > 1 else None))
        return build(robot, function, *how, **options)

    monkeypatch.setattr(rigid_programs, "build", counted)
    arm = exact_arm(4, joints=16, prismatic=1 if slides else 0, parallel=0.2)
    best = program(arm, "forward_dynamics", Options(optimize="fast"))
    record = function_named("forward_dynamics")
    built = [writing for function, writing in ways if function == record.name]
    assert (record.outputs in built) == slides
    assert set(record.of_rigid_arms) <= set(built)
    assert count(best).total <= count(build(arm, record.name, Choice(), record.outputs)).total


@pytest.mark.parametrize("robot", [*ARMS[:4], bundled("stanford"), bundled("puma560")], ids=lambda r: r.name)
def test_articulated_bodies_undo_inverse_dynamics(robot: Robot) -> None:
    """Exactly, on the links as described and regrouped."""
    record = function_named("forward_dynamics")
    at = Point(9)
    for choice in (Choice(), Choice(regroup=False, chains=False)):
        try:
            written = build(robot, "forward_dynamics", choice, record.of_rigid_arms[0])
        except ZeroDivisionError:  # a joint moves without inertia
            continue
        qdd = exactly(written, at)["qdd"]
        tau = values(robot, "inverse_dynamics", at, qdd=qdd)
        assert tau == [at.number(Input("tau", i)) for i in range(robot.n)]
