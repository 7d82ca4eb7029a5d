"""From a robot to a loaded kernel in one call."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from os import PathLike
from typing import Any

from robodyn.emit import render
from robodyn.emit.batch import batch_files
from robodyn.formats.loading import robot_of
from robodyn.kernels.generate import Options, generate
from robodyn.kernels.kernel import Kernel, load
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
    batch = _Batches(robot, options)
    return load(generated.signatures, generated.files((language,)), language=language, batch=batch, **build)


@dataclass(frozen=True)
class _Batches:
    """Hands over the files of a function's batch; generated when they are asked for."""

    robot: Robot
    options: Options

    def __call__(self, function: str) -> dict[str, str]:
        unit = generate(self.robot, self.options).unit
        one = replace(unit, functions=tuple((s, p) for s, p in unit.functions if s.function == function))
        header = {path: text for path, text in render(one, ("c",)).items() if path.endswith(".h")}
        return {**header, **batch_files(one)}
