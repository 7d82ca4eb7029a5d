"""External functions of CasADi: their values, and Jacobians beside those that CasADi makes of the plain
recursion; in an optimal control problem, and in C that CasADi generates."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import pytest
from benchmarks.optimal_control import expression

from documents.blocks import blocks
from packages.consumers import Consumer, consumer, run, write
from robodyn.dynamics.functions import FUNCTIONS, function_named
from robodyn.kernels.generate import Options, generate
from robodyn.packages import package
from robodyn.robot import load
from robodyn.simulate.poses import PoseSolver
from robodyn_testing import representative, require_tool
from robodyn_testing.wanted import ROOT

pytestmark = pytest.mark.thorough

#: All functions that have derivatives, and some that have none.
WANTED = (
    *(name for name, function in FUNCTIONS.items() if function.derivatives),
    "link_poses",
    "kinetic_energy",
    "coriolis_matrix",
)
OPTIONS = Options(WANTED, derivatives=True)
ARMS = ("puma560", "stanford", "panda", "puma560_full")


def library(folder: Path, user: Consumer) -> Path:
    """The library of a package, compiled as the package says, with every warning an error."""
    write(folder, user.package.files())
    run(require_tool("make"), f"CC={require_tool('cc')}", "CFLAGS=-O1 -Wall -Wextra -Werror", cwd=folder)
    return folder / f"lib{user.package.name}.so"


def external(user: Consumer, file: Path, function: str) -> Any:
    """The external function."""
    return ca.external(f"{user.package.robot.name}_casadi_{function}", str(file))


def near(one: Any, other: Any, tolerance: float = 1e-10) -> bool:
    one, other = np.array(ca.DM(one)), np.array(ca.DM(other))
    return one.shape == other.shape and bool(abs(one - other).max() <= tolerance * max(1, abs(other).max()))


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], tuple[Consumer, Path]]:
    @cache
    def of(robot: str) -> tuple[Consumer, Path]:
        user = consumer(robot, "casadi", OPTIONS)
        return user, library(tmp_path_factory.mktemp("casadi"), user)

    return of


@pytest.mark.parametrize("robot", representative(ARMS, "stanford", rest="slow"))
def test_values_and_jacobians(robot: str, built: Callable[[str], tuple[Consumer, Path]]) -> None:
    user, file = built(robot)
    random = np.random.default_rng(0)
    for name in WANTED:
        ours, theirs = external(user, file, name), expression(user.package.robot, name)
        assert (ours.name_in(), ours.name_out()) == (theirs.name_in(), theirs.name_out())
        state = [ca.DM(random.uniform(-1, 1, (user.package.robot.n, 1))) for _ in range(theirs.n_in())]
        for one, other in zip(ours.call(state), theirs.call(state), strict=True):
            assert near(one, other), name
        symbols = [ca.MX.sym(slot, user.package.robot.n) for slot in theirs.name_in()]
        if not function_named(name).derivatives:
            with pytest.raises(RuntimeError, match="Derivatives cannot be calculated"):
                ours.jacobian()
            continue
        exact = [f(*state) for f in derivatives(theirs, symbols)]
        for one, other in zip([f(*state) for f in derivatives(ours, symbols)], exact, strict=True):
            assert near(one, other, 1e-9), name
        blocks = ours.jacobian()
        assert all(blocks.nnz_out(k) <= blocks.numel_out(k) for k in range(blocks.n_out()))


def derivatives(f: Any, symbols: list[Any]) -> list[Any]:
    """Functions of the state: the Jacobian by each input; a product with it, forwards and backwards."""
    (result, *_) = f.call(symbols)
    result = ca.vec(result)
    weights = ca.DM(np.linspace(-1, 1, result.numel()))
    last = symbols[-1]
    terms = [ca.jacobian(result, symbol) for symbol in symbols]
    terms += [
        ca.jtimes(result, last, ca.DM(np.linspace(1, 2, last.numel()))),
        ca.gradient(ca.dot(weights, result), symbols[0]),
    ]
    return [ca.Function("f", symbols, [term]) for term in terms]


EFFECTS = """\
name: arm
links:
- {joint: revolute, alpha: pi/2, mass: 3, com: [0.1, 0.2, 0], inertia: {xx: 0.1, yy: 0.2, zz: 0.3}}
- joint: revolute
  a: 0.4
  mass: 2
  com: [0.1, 0, 0.2]
  inertia: {xx: 0.1, yy: 0.2, zz: 0.3}
  effects: [%s]
"""
SMOOTH = "{effect: torque_ripple, amplitude: 0.3, cycles_per_rev: 7}, {effect: rotor_inertia, inertia: 0.2}"
BY_LOAD = "{effect: load_dependent_friction, bearing: journal, mu: 0.1, radius: 0.08, span: 0.2}"


def test_an_arm_with_effects(tmp_path: Path) -> None:
    """Their derivatives as well; but torques with load-dependent friction have none by accelerations."""
    names = ("inverse_dynamics", "gravity", "bias")
    for effects, smooth in ((SMOOTH, True), (BY_LOAD, False)):
        file = tmp_path / "arm.yaml"
        file.write_text(EFFECTS % effects)
        packed = package(generate(load(str(file)), Options(names, derivatives=True)), "casadi")
        user = Consumer(packed)
        built = library(tmp_path / f"smooth {smooth}", user)
        symbols = [ca.MX.sym(name, 2) for name in ("q", "qd", "qdd")]
        state = [ca.DM([0.3, -0.4]), ca.DM([1.0, 2.0]), ca.DM([-3.0, 4.0])]
        ours, theirs = external(user, built, names[0]), expression(packed.robot, names[0])
        assert near(ours(*state), theirs(*state))
        if smooth:
            pairs = zip(derivatives(ours, symbols), derivatives(theirs, symbols), strict=True)
            assert all(near(one(*state), other(*state)) for one, other in pairs)
        else:
            with pytest.raises(RuntimeError, match="Derivatives cannot be calculated"):
                ours.jacobian()
            assert external(user, built, names[1]).jacobian().n_out() == 1


def test_what_is_always_zero_is_left_out(built: Callable[[str], tuple[Consumer, Path]]) -> None:
    """Nothing depends on where the first joint of the PUMA is, whose axis is vertical."""
    user, file = built("puma560")
    pattern = external(user, file, "inverse_dynamics").jacobian().sparsity_out(0)
    assert pattern.shape == (6, 6)
    assert 0 not in pattern.get_triplet()[1]


def test_in_c_that_casadi_generates(built: Callable[[str], tuple[Consumer, Path]], tmp_path: Path) -> None:
    """As acados and CasADi's own code for controllers take it: by the functions' names."""
    user, file = built("puma560")
    robot = user.package.robot
    f = external(user, file, "forward_dynamics")
    q, qd, tau = (ca.MX.sym(name, robot.n) for name in ("q", "qd", "tau"))
    qdd = f(q, qd, tau)
    step = ca.Function("step", [q, qd, tau], [qd + 1e-3 * qdd, ca.jacobian(qdd, qd)])
    code = ca.CodeGenerator("step.c")
    code.add(step)
    code.generate(f"{tmp_path}/")
    names = [f"{robot.name}.c", f"{robot.name}_casadi.c"]
    run(
        require_tool("cc"), "-O1", "-fPIC", "-shared", "-o", "step.so", "step.c",
        *(file.parent / name for name in names), "-lm", cwd=tmp_path,
    )  # fmt: skip
    compiled = ca.external("step", str(tmp_path / "step.so"))
    state = [np.linspace(-1, 1, robot.n), np.linspace(0, 1, robot.n), np.linspace(2, 3, robot.n)]
    for one, other in zip(compiled(*state), step(*state), strict=True):
        assert near(one, other, 1e-13)


def test_the_example_of_the_documents(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Beside differences: torques move the tool by ``t^2 / 2`` of accelerations at first."""
    page = (ROOT / "docs" / "packages.md").read_text(encoding="utf-8")
    (example,) = (block for block in blocks(page) if "import casadi" in block.text)
    user = Consumer(
        package(
            generate(load("puma560"), Options(("forward_dynamics", "forward_kinematics"), derivatives=True)),
            "casadi",
        )
    )
    library(tmp_path / "packages" / "puma560" / "casadi", user)
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    exec(compile(example.text, "packages.md", "exec"), names)
    by_torque, tau = names["by_torque"], ca.DM.ones(6)
    position = ca.Function("position", [names["tau"]], [names["position"]])
    columns = [
        (position(tau + 1e-4 * axis) - position(tau - 1e-4 * axis)) / 2e-4
        for axis in ca.horzsplit(ca.DM.eye(6))
    ]
    assert near(by_torque(tau), ca.horzcat(*columns), 1e-6)


def test_a_frame_goes_in_by_columns(tmp_path: Path) -> None:
    """CasADi has matrices by columns, the kernel by rows."""
    q = np.array([0.3, -1.2, 1.5, -0.4, 0.8, 0.1])
    user = Consumer(package(generate(load("ur5"), Options(("inverse_kinematics",))), "casadi"))
    inverse = external(user, library(tmp_path, user), "inverse_kinematics")
    solutions, exists, *_ = inverse(PoseSolver(load("ur5")).pose(q), np.zeros(6))
    rows = np.array(solutions)[np.array(exists).ravel() > 0]
    assert np.abs(rows - q).max(axis=1).min() < 1e-12
