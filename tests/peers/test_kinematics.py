"""Poses and Jacobians against Pinocchio: bundled robots, and random ones with frames at base and tool."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction
from typing import Any, Final

import numpy as np
import pinocchio as pin
import pytest

from peers.compared import worst_condition
from peers.numbers import Array
from peers.pinocchio_peer import mass_matrix, pinocchio_model
from robodyn.dynamics.functions import FUNCTIONS
from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input
from robodyn.kernels.generate import Options, generate
from robodyn.robot.bundled import bundled_names, load
from robodyn.robot.model import Placement, Robot
from robodyn.robot.values import PI, Angle, angle
from robodyn_testing import representative, sampled
from robodyn_testing.random_robots import random_robot, random_states

pytestmark = pytest.mark.filterwarnings("ignore:Please update your 'hppfcl'")  # Pinocchio 3.3, on import
STATES: Final = 12
CHUNK: Final = 10
RANDOM: Final = 200
DOUBLE: Final = 1e-10
#: Of the mass matrix scaled to a unit diagonal: beyond it two ways to divide by it need not agree as closely.
CONDITION: Final = 1e4
NUMPY: Final = {"sin": np.sin, "cos": np.cos, "sqrt": np.sqrt, "abs": np.abs, "sign": np.sign}


def results(robot: Robot, function: str, **inputs: Array) -> dict[str, Array]:
    """The results ``[N, ...]`` of the program of ``function``, in doubles."""
    ((_, program),) = generate(robot, Options(functions=(function,), optimize="fast")).unit.functions
    count = len(inputs["q"])
    columns = {Input(name, i): x[:, i] for name, x in inputs.items() for i in range(robot.n)}
    arrays = evaluate(program, columns, functions=NUMPY)
    shapes = {array.name: array.shape_at(robot.n) for array in FUNCTIONS[function].results}
    return {
        name: np.stack([np.broadcast_to(x, count) for x in elements], axis=1).reshape(count, *shapes[name])
        for name, elements in arrays.items()
    }


def se3(frame: Placement | None) -> pin.SE3:
    if frame is None:
        return pin.SE3.Identity()
    return pin.SE3(np.array(frame.rotation, dtype=float), np.array(frame.xyz, dtype=float))


def model_in_world(robot: Robot) -> tuple[pin.Model, int]:
    """The arm on its base, with a frame for the tool; the frame's number."""
    model = pinocchio_model(robot)
    model.jointPlacements[1] = se3(robot.base) * model.jointPlacements[1]
    return model, model.addFrame(pin.Frame("tool", robot.n, 0, se3(robot.tool), pin.FrameType.OP_FRAME))


def by_pinocchio(robot: Robot, q: Array, qd: Array) -> dict[str, Array]:
    """Every result of the kinematics, by its name."""
    model, tool = model_in_world(robot)
    data = model.createData()
    rest = np.zeros(robot.n)
    world, own = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED, pin.ReferenceFrame.LOCAL
    rows: list[dict[str, Any]] = []
    for state, rate in zip(q, qd, strict=True):
        pin.forwardKinematics(model, data, state, rate, rest)
        pin.updateFramePlacements(model, data)
        frame, links = data.oMf[tool], [data.oMi[i] for i in range(1, robot.n + 1)]
        row = {
            "T": np.column_stack([frame.rotation, frame.translation]),
            "link_positions": [link.translation for link in links],
            "link_rotations": [link.rotation for link in links],
            "drift": pin.getFrameClassicalAcceleration(model, data, tool, world).vector,
            "jac": pin.computeFrameJacobian(model, data, state, tool, world),
            "jac_tool": pin.computeFrameJacobian(model, data, state, tool, own),
        }
        rows.append({name: np.array(x) for name, x in row.items()})
    return {name: np.array([row[name] for row in rows]) for name in rows[0]}


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


def framed_robot(seed: int) -> Robot:
    """Random arm number ``seed`` with frames at base and tool."""
    rng = random.Random(seed)
    base, tool = random_frame(rng), random_frame(rng)
    return replace(random_robot(seed, aside=0.3), base=base, tool=tool)


def complaints(robot: Robot, seed: int) -> list[str]:
    """In what the kinematics of ``robot`` differ from Pinocchio's."""
    q, qd, _ = random_states(robot, STATES, seed)
    expected = by_pinocchio(robot, q, qd)
    given = {"q": q, "qd": qd}
    functions = [name for name, f in FUNCTIONS.items() if f.geometric and set(f.input_names) <= set(given)]
    assert len(functions) >= 5
    M = mass_matrix(pinocchio_model(robot), robot, q)
    if worst_condition(M) <= CONDITION:
        J = expected["jac"].reshape(STATES, 6, robot.n)
        expected["lambda_inv"] = J @ np.linalg.solve(M, J.swapaxes(1, 2))
        functions.append("lambda_inverse")
    wrong = []
    for function in functions:
        inputs = {name: given[name] for name in FUNCTIONS[function].input_names}
        for name, x in results(robot, function, **inputs).items():
            scale = max(1.0, float(np.abs(expected[name]).max()))
            off = float(np.abs(x - expected[name].reshape(x.shape)).max())  # one column comes as none
            if not off <= DOUBLE * scale:
                wrong.append(f"{robot.name} {function} {name}: off by {off:.2e}")
    return wrong


@pytest.mark.parametrize(
    "name", representative(bundled_names(), "puma560", "stanford", "panda", "ur10", rest="slow")
)
def test_bundled_robots(name: str) -> None:
    assert complaints(load(name, warn=lambda _: None), 1) == []


@pytest.mark.parametrize("chunk", sampled(range(RANDOM // CHUNK), every=5, rest="slow"))
def test_random_robots(chunk: int) -> None:
    wrong = []
    for seed in range(CHUNK * chunk, CHUNK * (chunk + 1)):
        wrong += complaints(framed_robot(seed), seed)
    assert wrong == []
