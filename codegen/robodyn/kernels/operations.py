"""Operations of a function of a robot, in one call."""

from __future__ import annotations

from os import PathLike

from robodyn.counts import Count
from robodyn.counts import count as count_of
from robodyn.kernels.generate import Options, program
from robodyn.robot.model import Robot


def count(
    robot: Robot | str | PathLike[str], function: str = "inverse_dynamics", options: Options | None = None
) -> Count:
    """The operations of one call of ``function``, by the thesis's convention: ``mul``, ``add``, ``total`` ...

    ``robot`` is a robot, a path or the name of a bundled one.

    Raises
    ------
    InputError: there is no such robot or function.
    """
    return count_of(program(robot, function, options))
