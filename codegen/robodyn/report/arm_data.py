"""An arm as data: all that its page shows, as JSON has it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from robodyn.errors import InputError
from robodyn.kernels.generate import Generated, generate
from robodyn.report.arm_counts import counts
from robodyn.report.arm_effects import effects
from robodyn.report.arm_equations import equations
from robodyn.report.arm_kernel import ArmKernel, arm_kernel
from robodyn.report.arm_motion import motion
from robodyn.report.arm_parts import joints, links, reach
from robodyn.report.schedule_sources import Source, robot_source
from robodyn.report.schedules import to_dict
from robodyn.robot.identity import identity
from robodyn.robot.model import Robot
from robodyn.schedule import Machine, Solved, solve
from robodyn.version import VERSION

#: Processors of the schedule that is drawn: two hands count them, and every arm's tasks keep them busy.
_PROCESSORS: Final = 4


@dataclass(frozen=True, slots=True)
class Arm:
    """An arm with what its page is made of: the kernel that moves it, the kernels in C, and the ``data``."""

    robot: Robot
    kernel: ArmKernel
    generated: Generated
    source: Source
    solved: Solved
    data: dict[str, Any]


def arm_of(robot: Robot) -> Arm:
    """What is to be shown of ``robot``.

    Raises
    ------
    InputError: it has run-time parameters, and so no numbers.
    """
    if robot.parameters:
        raise InputError(
            f"{robot.name} has run-time parameters, and a page shows an arm with numbers",
            found=", ".join(robot.parameters),
            expected="a number for each",
            remedy=" ".join(f"--param {name}=VALUE" for name in robot.parameters),
        )
    kernel, generated = arm_kernel(robot), generate(robot)
    source = robot_source(robot)
    solved = solve(source.graph, Machine(_PROCESSORS))
    axes, path = joints(robot), motion(robot, kernel)
    data = {
        "robot": robot.name,
        "title": robot.title,
        "source": robot.source,
        "identity": identity(robot),
        "version": VERSION,
        "gravity": [float(x) for x in robot.base_gravity],
        "base": _placement(robot.base),
        "tool": _placement(robot.tool),
        "torque_side": robot.torque_side,
        "reach": reach(robot),
        "joints": axes,
        "links": links(robot),
        "home": home(kernel, axes),
        "kernel": {"functions": kernel.functions},
        "motion": path,
        "counts": counts(robot, generated, kernel.generated),
        "effects": effects(robot, axes, path),
        "schedule": to_dict(source, solved),
        "left_out": generated.left_out,
        "equations": equations(robot),
    }
    return Arm(robot, kernel, generated, source, solved, data)


def home(kernel: ArmKernel, axes: list[dict[str, Any]]) -> dict[str, Any]:
    """The arm at rest where its page shows it first: positions [n], torques [n], pose of the tool [12]."""
    q = np.array([[joint["home"] for joint in axes]])
    still = np.zeros_like(q)
    torques = kernel.rows("inverse_dynamics", {"q": q, "qd": still, "qdd": still})["tau"]
    return {
        "position": q[0].tolist(),
        "torque": torques[0].tolist(),
        "gravity": kernel.rows("gravity", {"q": q})["tau"][0].tolist(),
        "pose": kernel.rows("forward_kinematics", {"q": q})["T"][0].tolist(),
    }


def _placement(frame: Any) -> dict[str, Any] | None:
    if frame is None:
        return None
    return {"xyz": [float(x) for x in frame.xyz], "rpy": [angle.radians for angle in frame.rpy]}
