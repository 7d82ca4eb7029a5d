"""A robot from Python, in one call: its loaded kernel, its base parameters, the operations of a function."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from os import PathLike
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from robodyn.counts import Count
from robodyn.counts import count as count_of
from robodyn.dynamics.arm import build_arm
from robodyn.dynamics.base_set import BaseParameter, numbers_of
from robodyn.dynamics.regroup import lumps_of
from robodyn.emit import render
from robodyn.emit.batch import batch_files
from robodyn.formats.loading import robot_of
from robodyn.kernels.arrays import read_parameters
from robodyn.kernels.generate import Options, generate, program
from robodyn.kernels.kernel import Kernel, load
from robodyn.optimize.programs import base_set_of
from robodyn.robot.model import Robot


def compile(
    robot: Robot | str | PathLike[str],
    *,
    functions: Sequence[str] | None = None,
    scalar: str = "double",
    optimize: str = "record",
    regroup: bool = True,
    formulation: str = "modified_newton_euler",
    trig: str = "libm",
    engine: str = "graph",
    language: str = "c",
    **build: Any,
) -> Kernel:
    """Generate the kernels of ``robot`` (or of that path or name), compile and load them.

    ``functions`` (default: those that ``robodyn gen`` writes; ``["all"]``: all that the robot has) to
    ``engine`` are those of :class:`~robodyn.kernels.options.Options`; ``build`` goes to
    :func:`robodyn.kernels.kernel.load` (``cc``, ``flags``,
    ``cache``, ``mode``).

    Raises
    ------
    InputError: an option is unknown, or a number of the robot does not fit.
    ToolError: no compiler, or it refuses the files.
    """
    robot = robot_of(robot)
    options = Options(
        functions=None if functions is None else tuple(functions),
        formulation=formulation,
        optimize=optimize,  # type: ignore[arg-type]  # checked by Options
        regroup=regroup,
        scalar=scalar,  # type: ignore[arg-type]
        trig=trig,  # type: ignore[arg-type]
        engine=engine,  # type: ignore[arg-type]
    )
    generated = generate(robot, options)
    batch = partial(_batch, robot, options)
    return load(generated.signatures, generated.files((language,)), language=language, batch=batch, **build)


def _batch(robot: Robot, options: Options, function: str) -> dict[str, str]:
    """The files of a function's batch; generated when they are asked for."""
    unit = generate(robot, options).unit
    one = replace(unit, functions=tuple((s, p) for s, p in unit.functions if s.function == function))
    header = {path: text for path, text in render(one, ("c",)).items() if path.endswith(".h")}
    return {**header, **batch_files(one)}


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
