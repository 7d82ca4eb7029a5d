"""All functions but the default ones against Pinocchio: bundled arms, and random ones with frames at base and
tool. Friction is left out; its part in derivatives is in tests/independent."""

from __future__ import annotations

import random
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Final

import numpy as np
import pinocchio as pin
import pytest

from peers.compared import worst_condition
from peers.numbers import Array
from peers.pinocchio_peer import mass_matrix, pinocchio_model
from robodyn import Options, program
from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input
from robodyn.robot.bundled import bundled_names, load
from robodyn.robot.model import Placement, Robot
from robodyn.robot.values import PI, Angle, angle
from robodyn_testing import representative, sampled
from robodyn_testing.random_robots import random_robot, random_states

pytestmark = pytest.mark.filterwarnings("ignore:Please update your 'hppfcl'")  # Pinocchio 3.3, on import
STATES: Final = 6
TOLERANCE: Final = 1e-10
#: Of the mass matrix scaled to a unit diagonal: beyond it two ways to divide by it need not agree as closely.
CONDITION: Final = 1e4
NUMPY: Final = {"sin": np.sin, "cos": np.cos, "sqrt": np.sqrt, "abs": np.abs, "sign": np.sign}
OF_THE_MATRIX: Final = ("lambda_inverse", "inverse_mass_matrix", "forward_dynamics_derivatives")


def results(robot: Robot, function: str, at: Mapping[str, Array]) -> Array:
    """All results ``[N, size]`` of the program of ``function``, in doubles."""
    made = program(robot, function, Options((function,), optimize="fast"))
    inputs = {Input(name, i): column for name, x in at.items() for i, column in enumerate(x.T)}
    rows = [x for row in evaluate(made, inputs, functions=NUMPY).values() for x in row]
    return np.stack([np.broadcast_to(x, STATES) for x in rows], axis=1)


def se3(frame: Placement | None) -> pin.SE3:
    if frame is None:
        return pin.SE3.Identity()
    return pin.SE3(np.array(frame.rotation, dtype=float), np.array(frame.xyz, dtype=float))


def by_pinocchio(robot: Robot, at: Mapping[str, Array]) -> dict[str, Array]:
    """What the functions give, ``[N, size]`` each; those of :data:`OF_THE_MATRIX` where it has an inverse."""
    model, in_base = pinocchio_model(robot), pinocchio_model(robot)
    model.jointPlacements[1] = se3(robot.base) * model.jointPlacements[1]
    model.gravity = pin.Motion(np.array([float(g) for g in robot.gravity]), np.zeros(3))
    tool = model.addFrame(pin.Frame("tool", robot.n, 0, se3(robot.tool), pin.FrameType.OP_FRAME))
    matrices = mass_matrix(model, robot, at["q"])
    regular = worst_condition(matrices) <= CONDITION
    rows = []
    for k, M in enumerate(matrices):
        q, qd, qdd, tau, w = (at[name][k] for name in ("q", "qd", "qdd", "tau", "w"))
        row = {**kinematics(model, tool, q, qd), **dynamics(model, tool, M, q, qd, qdd, w)}
        row["potential_energy"] = [pin.computePotentialEnergy(in_base, in_base.createData(), q)]
        if regular:
            data = model.createData()
            accelerations = np.linalg.solve(M, tau - pin.nonLinearEffects(model, data, q, qd))
            by_q, by_qd, _ = pin.computeRNEADerivatives(model, data, q, qd, accelerations)
            jacobian = row["jacobian"][0]
            row["lambda_inverse"] = [jacobian @ np.linalg.solve(M, jacobian.T)]
            row["inverse_mass_matrix"] = [np.linalg.inv(M)]
            row["forward_dynamics_derivatives"] = [
                np.linalg.solve(M, x) for x in (-by_q, -by_qd, np.eye(robot.n))
            ]
        rows.append({name: np.concatenate([np.ravel(x) for x in parts]) for name, parts in row.items()})
    return {name: np.array([row[name] for row in rows]) for name in rows[0]}


def kinematics(model: pin.Model, tool: int, q: Array, qd: Array) -> dict[str, list[Array]]:
    data = model.createData()
    pin.forwardKinematics(model, data, q, qd, np.zeros(model.nv))
    pin.updateFramePlacements(model, data)
    frame, links = data.oMf[tool], [data.oMi[i] for i in range(1, model.njoints)]
    world, own = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED, pin.ReferenceFrame.LOCAL
    drift = pin.getFrameClassicalAcceleration(model, data, tool, world).vector
    return {
        "forward_kinematics": [np.column_stack([frame.rotation, frame.translation])],
        "link_poses": [*(x.translation for x in links), *(x.rotation for x in links)],
        "jacobian_dot_qd": [np.array(drift)],
        "jacobian": [pin.computeFrameJacobian(model, data, q, tool, world)],
        "tool_jacobian": [pin.computeFrameJacobian(model, data, q, tool, own)],
    }


def dynamics(
    model: pin.Model, tool: int, M: Array, q: Array, qd: Array, qdd: Array, w: Array
) -> dict[str, list[Array]]:
    """Of the arm whose mass matrix is ``M``, with the wrench ``w`` on its tool."""
    data = model.createData()
    C = pin.computeCoriolisMatrix(model, data, q, qd).copy()
    gravity = pin.computeGeneralizedGravity(model, data, q).copy()
    by_q, by_qd, _ = (np.array(x) for x in pin.computeRNEADerivatives(model, data, q, qd, qdd))
    free = pin.rnea(model, data, q, qd, qdd).copy()
    reactions = [np.array(data.f[i].vector) for i in range(1, model.njoints)]
    pin.framesForwardKinematics(model, data, q)
    # Along the tool's axes, then along the last link's.
    turned = pin.SE3(data.oMf[tool].rotation.T, np.zeros(3))
    forces = pin.StdVec_Force()
    for _ in range(model.nv):
        forces.append(pin.Force.Zero())
    forces.append(model.frames[tool].placement.act(turned.act(pin.Force(w))))
    pushed = pin.rnea(model, data, q, qd, qdd, forces).copy()
    return {
        "kinetic_energy": [qd @ M @ qd / 2],
        "momentum": [M @ qd],
        "coriolis": [C @ qd],
        "momentum_observer_term": [C.T @ qd - gravity],
        "coriolis_matrix": [by_qd / 2],
        "inverse_dynamics_derivatives": [by_q, by_qd],
        "joint_reactions": reactions,
        "joint_reactions_with_wrench": [np.array(data.f[i].vector) for i in range(1, model.njoints)],
        "inverse_dynamics_with_wrench": [pushed],
        "wrench_torques": [free - pushed],
    }


def without_friction(robot: Robot) -> Robot:
    smooth = (replace(x.joint, viscous=Fraction(0), coulomb=Fraction(0)) for x in robot.links)
    links = (replace(link, joint=joint) for link, joint in zip(robot.links, smooth, strict=True))
    return replace(robot, links=tuple(links))


def random_frame(rng: random.Random) -> Placement | None:
    """No frame, one that is only shifted, one turned by right angles or about z, or any."""

    def turn(generic: float) -> Angle:
        return angle(
            Fraction(rng.randint(-3000, 3000), 1000)
            if rng.random() < generic
            else rng.choice((0, 0, 1, 2, -1)) * PI / 2
        )

    x, y, z = (
        Fraction(rng.randint(-500, 500), 1000) if rng.random() < 0.7 else Fraction(0) for _ in range(3)
    )
    none = angle(Fraction(0))
    rotations = (
        (none, none, none),
        (none, none, turn(0.7)),
        (turn(0), turn(0), turn(0)),
        (turn(1), turn(1), turn(1)),
    )
    return None if rng.random() < 0.25 else Placement((x, y, z), rng.choice(rotations))


def complaints(robot: Robot, seed: int) -> list[str]:
    """In what the functions of ``robot`` differ from Pinocchio's."""
    q, qd, qdd = random_states(robot, STATES, seed)
    rng = np.random.default_rng(seed)
    at = {"q": q, "qd": qd, "qdd": qdd, "tau": rng.uniform(-50, 50, q.shape)}
    at["w"] = rng.uniform(-5, 5, (STATES, 6))
    wrong = []
    for function, expected in by_pinocchio(robot, at).items():
        tolerance = TOLERANCE * (1e3 if function in OF_THE_MATRIX else 1)
        off = float(np.abs(results(robot, function, at) - expected).max())
        if not off <= tolerance * max(1.0, float(np.abs(expected).max())):
            wrong.append(f"{robot.name} {function}: off by {off:.2e}")
    return wrong


@pytest.mark.parametrize("name", representative(bundled_names(), "stanford", "panda", rest="slow"))
def test_bundled_robots(name: str) -> None:
    assert complaints(without_friction(load(name, warn=lambda _: None)), 1) == []


@pytest.mark.parametrize("seed", sampled(sampled(range(200), every=12, rest="slow"), every=5))
def test_random_robots(seed: int) -> None:
    rng = random.Random(seed)
    base, tool = random_frame(rng), random_frame(rng)
    robot = without_friction(random_robot(seed, aside=0.3))
    assert complaints(replace(robot, base=base, tool=tool), seed) == []
