"""What the claims are recomputed on: arms, their task graphs, the case study's torques."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Final

from robodyn.robot import Robot
from robodyn.schedule import FLOPS_PER_TASK, TaskGraph, general_graph, robot_graph
from robodyn.thesis.judge import printed_graph, rule_graph
from robodyn.thesis.printed_tasks import LEVELS_STANFORD, TIMES_STANFORD

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

#: Joints of the arms that the thesis counts and schedules for: its six-link arm, PUMA 560, Stanford.
LINKS: Final = 6
#: The bundled arms of the thesis's tables.
STANFORD: Final = "stanford"
PUMA: Final = "puma560"
#: Milliseconds a task on the thesis's processor, by Table 4.8, and microseconds an operation.
TASK_MS: Final = TIMES_STANFORD[1] / LEVELS_STANFORD[1]
FLOP_US: Final = 1e3 * TASK_MS / FLOPS_PER_TASK


@dataclass(frozen=True)
class Arms:
    """The graphs of any six-joint arm and of the Stanford arm, by the rules and as printed."""

    load_robot: Callable[[str], Robot]

    @cached_property
    def six(self) -> TaskGraph:
        """Any arm of six revolute joints: 231 tasks."""
        return general_graph(LINKS)

    @cached_property
    def stanford_printed(self) -> TaskGraph:
        """The 156 tasks of Table 4.7."""
        return printed_graph("stanford")

    @cached_property
    def stanford_by_rule(self) -> TaskGraph:
        """The 154 tasks that the rules of Tables 4.2, 4.4 and 4.5 leave."""
        return rule_graph("stanford")

    @cached_property
    def stanford_by_robot(self) -> TaskGraph:
        """The tasks that the zeros of the bundled arm leave."""
        return robot_graph(self.load_robot(STANFORD))

    @cached_property
    def case_study(self) -> CaseTorques:
        """The case study's torques, bearings 0.2 m apart."""
        return case_torques()


@dataclass(frozen=True, slots=True, eq=False)
class CaseTorques:
    """Joint velocities [S, 3] (rad/s) at the moving samples of the case study, and torques [S, 3] (N m) of
    the rigid arm, with friction in the joints, and with that in the transmissions besides."""

    qd: NDArray[np.float64]
    rigid: NDArray[np.float64]
    joint: NDArray[np.float64]
    total: NDArray[np.float64]


def case_torques(span: Fraction | None = None) -> CaseTorques:
    """The torques of the case study with bearings ``span`` [m] apart, its own span where that is None."""
    from robodyn.thesis.case_arm import led, robots
    from robodyn.thesis.case_study import DURATION, SAMPLES, Assumptions, motion_of
    from robodyn.verify.reference import Reference

    assumed = Assumptions()
    arms = robots(assumed.payload, assumed.span if span is None else float(span))
    motion = motion_of(assumed, led(assumed.arm)).sampled(DURATION / (SAMPLES - 1))
    moving = slice(1, -1)
    rigid, joint, total = (
        Reference(robot).inverse_dynamics(motion.q, motion.qd, motion.qdd)[moving]
        for robot in (arms.rigid, arms.with_bearings, arms.complete)
    )
    return CaseTorques(motion.qd[moving], rigid, joint, total)
