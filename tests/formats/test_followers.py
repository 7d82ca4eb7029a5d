"""Joints that follow others, out of URDF, MJCF and SDF files: every function beside Pinocchio's, and files
that are written."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from robodyn.dynamics.functions import FUNCTIONS
from robodyn.errors import InputError
from robodyn.formats.arm import import_arm
from robodyn.formats.exporting import export_arm
from robodyn.ir.evaluate import REAL_FUNCTIONS, evaluate
from robodyn.ir.program import Input
from robodyn.kernels.generate import maker
from robodyn.kernels.options import Options
from robodyn.robot.coupling import transmission_of
from robodyn.robot.model import Robot
from robodyn.robot.reader import read_text
from robodyn_testing import require_module
from robodyn_testing.coupled_files import (
    PALLETIZER,
    WRITTEN,
    Array,
    Part,
    mjcf,
    random_parts,
    transmission,
    urdf,
)

pin: Any = require_module("pinocchio")
TOLERANCE = 1e-9
#: What the kernels of every file are compared in; files of the long run are in all that Pinocchio has.
SOME = ("inverse_dynamics", "mass_matrix", "forward_dynamics", "forward_kinematics", "jacobian")
GRAVITY = 9.81


class Pinocchio:
    """The joints of a chain, each moving by itself, as Pinocchio reads the URDF; mapped by ``G`` here."""

    def __init__(self, parts: list[Part], seed: int) -> None:
        self.parts, self.model = parts, pin.buildModelFromXML(urdf(parts))
        self.data = self.model.createData()
        self.G, self.o, self.free = transmission(parts)
        rng = np.random.default_rng(seed)
        m = self.G.shape[1]
        self.u, self.ud, self.udd, self.tau = rng.uniform(-1.5, 1.5, (4, m))
        self.w: Array = rng.uniform(-9, 9, 6)
        self.q, self.v, self.a = self.G @ self.u + self.o, self.G @ self.ud, self.G @ self.udd
        self.damping = np.diag([p.damping for p in parts])
        self.levels = np.array([p.friction for p in parts])
        self.frame = self.model.getFrameId(f"l{len(parts)}")

    def joints(self, v: Array, a: Array) -> Array:
        """Torques of all joints, friction included."""
        rigid = pin.rnea(self.model, self.data, self.q, v, a)
        return np.asarray(rigid + self.damping @ v + self.levels * np.sign(v))

    def mass(self) -> Array:
        upper = np.triu(pin.crba(self.model, self.data, self.q))
        return np.asarray(self.G.T @ (upper + np.triu(upper, 1).T) @ self.G)

    def jacobian(self) -> Array:
        where = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        return np.asarray(pin.computeFrameJacobian(self.model, self.data, self.q, self.frame, where) @ self.G)

    def pose(self) -> Array:
        pin.framesForwardKinematics(self.model, self.data, self.q)
        return np.asarray(self.data.oMf[self.frame].homogeneous[:3])

    def slopes(self, a: Array) -> tuple[Array, Array]:
        by_q, by_v, _ = pin.computeRNEADerivatives(self.model, self.data, self.q, self.v, a)
        return self.G.T @ by_q @ self.G, self.G.T @ (by_v + self.damping) @ self.G

    def results(self) -> dict[str, list[Array]]:
        """By function its results at this state."""
        G, M, J, zero = self.G, self.mass(), self.jacobian(), np.zeros_like(self.v)
        inverse: Array = np.array(np.linalg.inv(M), np.float64)
        h, g = G.T @ self.joints(self.v, zero), G.T @ self.joints(zero, zero)
        coriolis = G.T @ (pin.nonLinearEffects(self.model, self.data, self.q, self.v)) - g
        push, tau = J.T @ self.w, G.T @ self.joints(self.v, self.a)
        qdd = inverse @ (self.tau - h)
        by_q, by_v = self.slopes(G @ qdd)
        fd = [-inverse @ by_q, -inverse @ by_v, inverse]
        pin.forwardKinematics(self.model, self.data, self.q, self.v, zero)
        drift = pin.getFrameClassicalAcceleration(
            self.model, self.data, self.frame, pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        )
        R = self.pose()[:, :3]
        turned = np.kron(np.eye(2), R.T)
        C = pin.computeCoriolisMatrix(self.model, self.data, self.q, self.v)
        observer = G.T @ C.T @ self.v - g
        return {
            "inverse_dynamics": [tau],
            "gravity": [g],
            "bias": [h],
            "mass_matrix": [M],
            "forward_dynamics": [qdd],
            "inverse_mass_matrix": [inverse],
            "forward_kinematics": [self.pose()],
            "jacobian": [J],
            "tool_jacobian": [turned @ J],
            "jacobian_dot_qd": [np.array(drift)],
            "lambda_inverse": [J @ inverse @ J.T],
            "kinetic_energy": [np.array([self.ud @ M @ self.ud / 2], np.float64)],
            "momentum": [M @ self.ud],
            "coriolis": [coriolis],
            "coriolis_matrix": [G.T @ C @ G],
            "momentum_observer_term": [observer],
            "inverse_dynamics_derivatives": [*self.slopes(self.a)],
            "forward_dynamics_derivatives": fd,
            "wrench_torques": [push],
            "inverse_dynamics_with_wrench": [tau - push],
            "forward_dynamics_with_wrench": [inverse @ (self.tau + push - h)],
            "controller": [self.pose(), J, h, M],
        }

    def check_mimic(self) -> None:
        """What is mapped here is what Pinocchio makes of ``mimic`` itself, where it reads it: not of joints
        that follow others, or joints behind them, that follow."""
        leaders = [(i, p.follows.leader) for i, p in enumerate(self.parts) if p.follows]
        if any(leader > i or self.parts[leader].follows for i, leader in leaders):
            return
        model = pin.buildModelFromXML(urdf(self.parts), True)
        tau = pin.rnea(model, model.createData(), self.u, self.ud, self.udd)
        rigid = self.G.T @ pin.rnea(self.model, self.data, self.q, self.v, self.a)
        assert np.abs(tau - rigid).max() < TOLERANCE * max(1.0, np.abs(rigid).max())

    def inputs(self) -> dict[Input, float]:
        arrays: dict[str, Array] = {"q": self.u, "qd": self.ud, "qdd": self.udd, "tau": self.tau, "w": self.w}
        return {Input(name, k): float(x) for name, array in arrays.items() for k, x in enumerate(array)}


def robot_of(folder: Path, ending: str, parts: list[Part]) -> Robot:
    path = folder / f"arm.{ending}"
    path.write_text(WRITTEN[ending](parts))
    return import_arm(path).robot


def errors(robot: Robot, reference: Pinocchio, functions: tuple[str, ...]) -> dict[str, float]:
    """By function the largest difference, as a share of the largest element of its result or of 1."""
    programs, wanted, inputs = maker(robot, Options(optimize="fast")), reference.results(), reference.inputs()
    found = {}
    for name in functions:
        results = evaluate(programs.program(name), inputs, functions=REAL_FUNCTIONS)
        pairs = zip(results.values(), wanted[name], strict=True)
        found[name] = max(
            float(np.abs(np.array(own) - other.ravel()).max() / max(1.0, np.abs(other).max()))
            for own, other in pairs
        )
    return found


def check(folder: Path, seed: int, functions: tuple[str, ...]) -> dict[str, float]:
    parts, ending = random_parts(seed), ("urdf", "xml", "sdf")[seed % 3]
    if ending == "xml":
        require_module("mujoco")
    robot = robot_of(folder, ending, parts)
    reference = Pinocchio(parts, seed)
    at = transmission_of(robot)
    assert list(at.commanded) == reference.free
    found = errors(robot, reference, functions)
    reference.check_mimic()
    assert max(found.values()) < TOLERANCE, (seed, found)
    return found


@pytest.mark.parametrize("seed", range(12))
def test_kernels_are_those_of_joints_that_follow(tmp_path: Path, seed: int) -> None:
    check(tmp_path, seed, SOME)


def everything(seed: int) -> tuple[str, ...]:
    return tuple(Pinocchio(random_parts(seed), seed).results())


@pytest.mark.thorough
@pytest.mark.parametrize("seed", range(3))
def test_so_is_every_function(tmp_path: Path, seed: int) -> None:
    assert len(everything(seed)) > 20
    assert set(everything(seed)) <= set(FUNCTIONS)
    check(tmp_path, seed, everything(seed))


@pytest.mark.slow
def test_two_hundred_files(tmp_path: Path) -> None:
    worst: dict[str, float] = {}
    for seed in range(200):
        for name, error in check(tmp_path, seed, everything(seed)).items():
            worst[name] = max(worst.get(name, 0.0), error)
    print("\n".join(f"{name} {error:.1e}" for name, error in worst.items()))


@pytest.mark.parametrize("to", ["urdf", "mjcf", "sdf"])
def test_followers_are_written_and_read_back(tmp_path: Path, to: str) -> None:
    parts = random_parts(4)
    robot = robot_of(tmp_path, "urdf", parts)
    path = tmp_path / f"written.{'xml' if to == 'mjcf' else to}"
    path.write_text(export_arm(robot, to).text)
    before, after = transmission_of(robot), transmission_of(import_arm(path).robot)
    assert after.commanded == before.commanded
    for one, other in zip(before.rows, after.rows, strict=True):
        assert other == pytest.approx(one)
    assert list(map(float, after.offsets)) == pytest.approx(list(map(float, before.offsets)))


def refusal(folder: Path, text: str, ending: str = "urdf") -> str:
    path = folder / f"arm.{ending}"
    path.write_text(text)
    with pytest.raises(InputError) as caught:
        import_arm(path)
    return str(caught.value)


def following(**leaders: str) -> str:
    """Three joints in a row, with what some follow."""
    joints = "".join(
        f'<link name="l{i}"/><joint name="j{i}" type="continuous"><parent link="l{i - 1}"/>\n'
        f'<child link="l{i}"/>{leaders.get(f"j{i}", "")}</joint>'
        for i in (1, 2, 3)
    )
    return f'<robot name="arm"><link name="l0"/>{joints}</robot>'


def test_circles_are_refused_with_their_line(tmp_path: Path) -> None:
    circle = following(j1='<mimic joint="j3"/>', j3='<mimic joint="j1"/>')
    message = refusal(tmp_path, circle)
    assert "arm.urdf:3:44: joint 'j3' follows a joint that follows it; found 'j1'" in message
    assert "follows a joint that follows it" in refusal(tmp_path, following(j2='<mimic joint="j2"/>'))
    assert "follows a joint that is not there" in refusal(tmp_path, following(j2='<mimic joint="j9"/>'))


def test_what_has_no_ratio_is_refused(tmp_path: Path) -> None:
    require_module("mujoco")
    parts = next(parts for parts in map(random_parts, range(9)) if parts[-1].follows)
    curved = mjcf(parts).replace(' 0 0 0"', ' 0.5 0 0"')
    assert "no constant ratio" in refusal(tmp_path, curved, "xml")


def test_a_joint_that_follows_by_nothing_stands(tmp_path: Path) -> None:
    path = tmp_path / "arm.urdf"
    path.write_text(following(j2='<mimic joint="j1" multiplier="0" offset="0.25"/>'))
    arm = import_arm(path)
    assert [link.name for link in arm.robot.links] == ["j1", "j3"]
    assert any("j2 at 0.25" in remark for remark in arm.remarks)


def test_what_is_followed_beside_the_chain_is_refused(tmp_path: Path) -> None:
    text = following(j2='<mimic joint="beside"/>').replace(
        "</robot>",
        '<link name="b"/><joint name="beside" type="continuous"><parent link="l0"/><child link="b"/></joint>'
        "</robot>",
    )
    path = tmp_path / "arm.urdf"
    path.write_text(text)
    with pytest.raises(InputError, match="'beside' beside the chain"):
        import_arm(path, tip="l3")


def test_a_sum_of_joints_is_in_no_other_format() -> None:
    with pytest.raises(InputError, match="'level' follows lower, upper"):
        export_arm(read_text(PALLETIZER), "urdf")
