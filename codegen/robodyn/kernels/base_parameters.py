"""Base parameters of a robot, and the operations of its functions, for those who call from Python."""

from __future__ import annotations

from collections.abc import Mapping
from os import PathLike
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from robodyn.counts import Count
from robodyn.counts import count as count_of
from robodyn.dynamics.arm import build_arm
from robodyn.dynamics.base_parameter import BaseParameter, numbers_of
from robodyn.dynamics.regroup import lumps_of
from robodyn.formats.loading import robot_of
from robodyn.kernels.arrays import read_parameters
from robodyn.kernels.generate import Options, program
from robodyn.optimize.programs import base_set_of
from robodyn.robot.model import Robot


class BaseParameters(NamedTuple):
    """The base parameters of a robot in the order of the regressor's columns: what each is made of, and its
    value in SI units ``[p]``."""

    columns: tuple[BaseParameter, ...]
    values: NDArray[np.float64]


def base_parameters(
    robot: Robot | str | PathLike[str], params: Mapping[str, float] | None = None
) -> BaseParameters:
    """The base parameters of ``robot`` (or of that path or name), ``params`` being its run-time parameters.

    Raises
    ------
    InputError: its drives have effects, a length is a run-time parameter, or ``params`` do not fit.
    """
    robot = robot_of(robot)
    columns = base_set_of(robot)
    entries = read_parameters(robot.name, robot.parameters, params, np.dtype(np.float64))
    known = dict(zip(robot.parameters, entries.tolist(), strict=True))
    arm = build_arm(robot, lambda x: x, lambda name: known[name])
    numbers: dict[Any, Any] = numbers_of(arm, lumps_of(arm))
    return BaseParameters(columns, np.array([float(column.value(numbers)) for column in columns]))


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
