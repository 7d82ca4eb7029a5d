"""robodyn: from the description of a robot arm to small, counted, verified C and Fortran.

    >>> import robodyn
    >>> robot = robodyn.load("puma560")                              # a bundled name or a YAML file
    >>> robodyn.generate(robot).counts["inverse_dynamics"].total     # operations
    >>> kernel = robodyn.compile("puma560")                          # needs a C compiler
    >>> kernel.inverse_dynamics(q, qd, qdd)                          # [n] or [N, n], N m
    >>> robodyn.symbolic(robot).tau                                  # the model as sympy expressions

Names are imported when they are first used, so that a program pays only for what it calls.
"""

from __future__ import annotations

import sys

if (sys.argv or [""])[0] == "-m" and "robodyn" in sys.orig_argv:  # python -m robodyn: a command begins here
    try:
        from robodyn.process import begin

        begin()
    except KeyboardInterrupt:
        sys.exit(130)

TYPE_CHECKING = False  # as typing has it, whose import takes longer than all the rest here
if TYPE_CHECKING:
    from typing import Any

    from robodyn.diagnose.excite import excite
    from robodyn.diagnose.run import diagnose
    from robodyn.errors import CheckError, InputError, RobodynError, ToolError
    from robodyn.formats.loading import load
    from robodyn.identify.run import identify
    from robodyn.kernels.generate import Generated, Options, generate, program
    from robodyn.kernels.robot_kernel import base_parameters, compile, count
    from robodyn.kernels.through_sympy import symbolic
    from robodyn.robot import Robot
    from robodyn.simulate.simulation import simulate

_HOMES = {
    "CheckError": "robodyn.errors",
    "Generated": "robodyn.kernels.generate",
    "InputError": "robodyn.errors",
    "Options": "robodyn.kernels.generate",
    "RobodynError": "robodyn.errors",
    "Robot": "robodyn.robot",
    "ToolError": "robodyn.errors",
    "base_parameters": "robodyn.kernels.robot_kernel",
    "compile": "robodyn.kernels.robot_kernel",
    "count": "robodyn.kernels.robot_kernel",
    "excite": "robodyn.diagnose.excite",
    "generate": "robodyn.kernels.generate",
    "load": "robodyn.formats.loading",
    "program": "robodyn.kernels.generate",
    "symbolic": "robodyn.kernels.through_sympy",
}

__all__ = [
    "CheckError",
    "Generated",
    "InputError",
    "Options",
    "RobodynError",
    "Robot",
    "ToolError",
    "base_parameters",
    "compile",
    "count",
    "diagnose",
    "excite",
    "generate",
    "identify",
    "load",
    "program",
    "simulate",
    "symbolic",
]


_PACKAGES = ("diagnose", "identify", "simulate")  # packages that can be called


def __getattr__(name: str) -> Any:
    if name in _PACKAGES:
        import importlib

        return importlib.import_module(f"robodyn.{name}")
    if name in _HOMES:
        import importlib

        value = getattr(importlib.import_module(_HOMES[name]), name)
        globals()[name] = value  # not asked for again; and a module of the same name must not win
        return value
    if name == "__version__":
        from robodyn.version import VERSION

        return VERSION
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    """What completion offers: the names that people use."""
    return [*__all__, "__version__"]
