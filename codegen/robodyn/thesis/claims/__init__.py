"""What the thesis claims in its running text: ``data/claims.yaml`` has the claims, the modules here recompute
them, on arms, their task graphs and the case study's torques.

A function there is named by the claim that it belongs to (``by: tasks.parallel_cost``) and returns its
figures by name, with whether the claim holds by them.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Final

from robodyn.schedule import FLOPS_PER_TASK, TaskGraph, general_graph, robot_graph
from robodyn.thesis.judge import printed_graph, rule_graph
from robodyn.thesis.printed import TASK_MS, bundled

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

#: Figures by name, and whether the claim holds by them: None where figures do not decide.
Outcome = tuple[dict[str, Any], bool | None]

#: Joints of the arms that the thesis counts and schedules for: its six-link arm, PUMA 560, Stanford.
LINKS: Final = 6
#: The bundled arms of the thesis's tables, and the one of three joints on which formulations are held to each
#: other.
STANFORD: Final = "stanford"
PUMA: Final = "puma560"
SMALL_PUMA: Final = "puma560_3dof_d12"
#: Microseconds an operation on the thesis's processor, by Table 4.8.
FLOP_US: Final = 1e3 * TASK_MS / FLOPS_PER_TASK


class Arms:
    """The graphs of any six-joint arm and of the Stanford arm, by the rules and as printed."""

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
        return robot_graph(bundled(STANFORD))

    @cached_property
    def case_study(self) -> CaseTorques:
        """The case study's torques, bearings 0.2 m apart."""
        return case_torques(0.2)


@dataclass(frozen=True, slots=True, eq=False)
class CaseTorques:
    """Joint velocities [S, 3] (rad/s) at the moving samples of the case study, and torques [S, 3] (N m) of
    the rigid arm, with friction in the joints, and with that in the transmissions besides."""

    qd: NDArray[np.float64]
    rigid: NDArray[np.float64]
    joint: NDArray[np.float64]
    total: NDArray[np.float64]


def case_torques(span: float) -> CaseTorques:
    """The torques of the case study with bearings ``span`` [m] apart."""
    from robodyn.thesis.case_arm import led, robots
    from robodyn.thesis.case_study import Assumptions, motion_of
    from robodyn.verify.reference import Reference

    assumed = Assumptions(span=span)
    arms = robots(assumed.payload, assumed.span)
    motion = motion_of(assumed, led(assumed.arm)).sampled(0.01)
    moving = slice(1, -1)
    rigid, joint, total = (
        Reference(robot).inverse_dynamics(motion.q, motion.qd, motion.qdd)[moving]
        for robot in (arms.rigid, arms.with_bearings, arms.complete)
    )
    return CaseTorques(motion.qd[moving], rigid, joint, total)
