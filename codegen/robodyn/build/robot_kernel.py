"""From a robot to a loaded kernel in one call."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from robodyn.build.kernel import Kernel, load
from robodyn.generation import Options, generate
from robodyn.robot.model import Robot

if TYPE_CHECKING:
    from robodyn.build.compiler import Language


def compile(
    robot: Robot,
    *,
    functions: Sequence[str] | None = None,
    scalar: str = "double",
    optimize: str = "record",
    regroup: bool = True,
    formulation: str = "modified_newton_euler",
    trig: str = "libm",
    engine: str = "graph",
    language: Language = "c",
    **build: Any,
) -> Kernel:
    """Generate the kernels of ``robot``, compile and load them.

    ``functions`` (default: all that the robot has) to ``engine`` are those of
    :class:`~robodyn.generation.Options`; ``build`` goes to :func:`robodyn.build.load` (``cc``, ``flags``,
    ``cache``, ``mode``).

    Raises
    ------
    InputError: an option is unknown, or a number of the robot does not fit.
    ToolError: no compiler, or it refuses the files.
    """
    options = Options(
        functions=None if functions is None else tuple(functions),
        formulation=formulation,
        optimize=optimize,  # type: ignore[arg-type]  # checked by Options
        regroup=regroup,
        scalar=scalar,  # type: ignore[arg-type]
        trig=trig,  # type: ignore[arg-type]
        engine=engine,  # type: ignore[arg-type]
    )
    made = generate(robot, options)
    return load(made.signatures, made.files((language,)), language=language, **build)
