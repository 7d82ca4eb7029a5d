"""Functions are records: nothing but their own folder asks which function it has by a name, and no program of
one leaves that is something else; and what arms have of them."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from dynamics.direct import exact_arm
from robodyn import InputError, Options, compile, load, program
from robodyn.counts import count
from robodyn.dynamics.equality import same_in_field
from robodyn.dynamics.functions import FUNCTIONS, INPUTS, array_named, function_named, torques_at
from robodyn.dynamics.functions.record import Array
from robodyn.dynamics.mass_matrix import solve_symmetric
from robodyn.ir import Graph, Program
from robodyn.kernels import rigid_programs
from robodyn.kernels.generate import SingularArm, generate
from robodyn.optimize.programs import Choice, build
from robodyn.robot import Robot, read_text

ROOT = Path(__file__).parents[2]
OWN = ROOT / "codegen" / "robodyn" / "dynamics" / "functions"
#: But for the rooms in which gravity is a key of YAML.
FILES = sorted(
    path
    for place in ("codegen", "cli")
    for path in (ROOT / place).rglob("*.py")
    if OWN not in path.parents and not {"robot", "diagnose"} & set(path.parts)
)


def names_asked_for(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """Names of functions that something is compared with, by line."""
    for node in ast.walk(tree):
        compared: list[ast.AST] = []
        if isinstance(node, ast.Compare):
            compared = [node.left, *node.comparators]
        elif isinstance(node, ast.match_case):
            compared = [node.pattern]
        for inner in (part for side in compared for part in ast.walk(side)):
            if isinstance(inner, ast.Constant) and inner.value in FUNCTIONS:
                yield inner.lineno, inner.value


@pytest.mark.thorough
def test_nobody_asks_for_a_name() -> None:
    places = [
        f"{file.relative_to(ROOT)}:{line}: {name}: ask its record (robodyn.dynamics.functions) instead"
        for file in FILES
        for line, name in names_asked_for(ast.parse(file.read_text(encoding="utf-8")))
    ]
    assert not places, "\n".join(places)
    assert len(FILES) > 400


def test_what_is_unknown_is_an_error_that_says_what_there_is() -> None:
    with pytest.raises(InputError, match=r"unknown function 'bais'; expected one of .*mean 'bias'\?"):
        function_named("bais")
    with pytest.raises(InputError, match="unknown array 'Z'; expected one of q, qd, qdd, tau, w, pi"):
        array_named("Z")


def test_torques_by_what_is_zero() -> None:
    rest, moving = [0, 0], [0, 1]
    assert torques_at(moving, moving).name == "inverse_dynamics"
    assert torques_at(moving, rest).name == "bias"
    assert torques_at(rest, rest).name == "gravity"
    assert torques_at(rest, moving).name == "inverse_dynamics"


@pytest.mark.parametrize("array", [*INPUTS, *(a for f in FUNCTIONS.values() for a in f.results)], ids=str)
def test_shapes_come_back_from_sizes(array: Array) -> None:
    for n in (1, 2, 6, 30):
        assert array.shape_of(array.size_at(n, 7, 8), n) == array.shape_at(n, 7, 8)
        if not {"p", "b"} & set(array.shape):
            assert array.shape_of(array.size_at(n)) == array.shape_at(n)


def test_shapes_of_other_kinds() -> None:
    assert Array("J", "Jacobian", "m, 1", shape=(6, "n")).shape_of(42) == (6, 7)
    assert Array("T", "tool frame", "m", shape=(3, 4)).shape_of(12) == (3, 4)
    assert Array("E", "energy", "J", shape=()).shape_of(1) == ()
    with pytest.raises(ValueError, match=r"M is \['n', 'n'\], and not of 5 numbers"):
        array_named("M").shape_of(5)


# --- what is right ----------------------------------------------------------------------------------------

GEARED = """
name: geared
torque_side: {side}
links:
  - {{joint: revolute, alpha: pi/2, mass: 3, com: [0.1, 0.2, 0.3], inertia: {{xx: 1, yy: 1}},
      motor_inertia: 0.5, friction: {{viscous: 1.2}}, gear: {{ratio: 100, torque_constant: 0.12}}}}
  - {{joint: revolute, alpha: pi/2, a: 0.3, mass: 2, com: [0.2, 0.1, 0.3], inertia: {{zz: 0.1}},
      gear: {{ratio: 80, torque_constant: 0.1}}}}
  - {{joint: prismatic, alpha: pi/2, a: 0.2, mass: 2, com: [0.1, 0.2, 0.3], gear: {{ratio: 250{constant}}}}}
"""
WHOLE = read_text(GEARED.format(side="motor", constant=", torque_constant: 0.05"), warn=lambda _: None)


@pytest.mark.parametrize("name", [name for name, function in FUNCTIONS.items() if not function.of_pose])
def test_a_wrong_element_is_no_program(name: str) -> None:
    """One element a little off: the comparison that every program goes through before it leaves."""
    right = build(WHOLE, name, Choice())
    assert same_in_field(WHOLE, name, right)
    for k in {0, len(right.results()) // 2, len(right.results()) - 1}:

        def wrong(at: Any, k: int = k) -> Any:
            elements = list(FUNCTIONS[name].outputs(at))
            elements[k] = elements[k] + Fraction(1, 10**9) * at.inputs["q"][1]
            return elements

        assert not same_in_field(WHOLE, name, build(WHOLE, name, Choice(), wrong))


def test_torques_and_currents_of_the_motors() -> None:
    kernel = compile(WHOLE, functions=["inverse_dynamics", "motor_torque", "motor_current"])
    states = np.random.default_rng(2).uniform(-1, 1, (3, 20, 3))
    tau, ratios = kernel.inverse_dynamics(*states), np.array([100, 80, 250])
    np.testing.assert_allclose(kernel.motor_torque(*states), tau / ratios, rtol=1e-13)
    np.testing.assert_allclose(kernel.motor_current(*states), tau / (ratios * [0.12, 0.1, 0.05]), rtol=1e-13)


@pytest.mark.parametrize(
    ("side", "function", "message"),
    [
        ("motor", "motor_current", "no torque constant at joint 3; "),
        ("link", "motor_torque", r"no gear at joint 1, 2, 3; .* torque_side: mo"),
    ],
)
def test_what_is_not_known_of_motors(side: str, function: str, message: str) -> None:
    robot = read_text(GEARED.format(side=side, constant=""), warn=lambda _: None)
    with pytest.raises(InputError, match=message):
        program(robot, function, Options(optimize="fast"))


def test_an_arm_with_a_joint_without_inertia_has_no_forward_dynamics() -> None:
    robot = load("tx40", warn=lambda _: None)
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
    assert not any(program(robot, "inverse_dynamics").results())


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
