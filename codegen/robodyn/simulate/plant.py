"""A robot compiled for simulation: the system's programs as C, together with the engine."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from robodyn.arrays import Floats
from robodyn.emit.c_syntax import static_function
from robodyn.errors import InputError
from robodyn.ir.program import Program
from robodyn.kernels.generate import Options, maker
from robodyn.robot.model import EffectEntry, Robot
from robodyn.simulate.engine import Engine, build_engine
from robodyn.simulate.sensors import acting_on
from robodyn.simulate.system import System, system_of

#: Arguments of the programs, in the order of the engine's functions; outputs by the engine's names.
_ARGUMENTS = {
    "mass": ("y",),
    "bias": ("y", "v", "s", "z"),
    "force": ("y", "v", "a", "s", "z"),
    "jacobian": ("y", "v", "a", "s", "z"),
    "rates": ("y", "v", "z"),
    "conserved": ("y", "v"),
}


@dataclass(frozen=True, slots=True)
class Plant:
    """A robot ready to be simulated; ``model`` is what controllers take it for."""

    robot: Robot
    system: System
    engine: Engine
    model: Robot


def build_plant(
    robot: Robot,
    *,
    model: Robot | None = None,
    energy: bool = True,
    cache: Path | None = None,
) -> Plant:
    """``robot`` compiled with the engine.

    ``model`` is what controllers take the robot for (default: the robot itself, effects
    with a state at their steady values); ``energy`` integrates work and loss along.

    Raises
    ------
    InputError: the robot cannot be simulated, or ``model`` does not fit.
    ToolError: no C compiler.
    """
    system = system_of(robot)
    model = model or robot
    if model.n != robot.n or not set(model.parameters) <= set(robot.parameters):
        raise InputError(
            "the controller's model does not fit the robot",
            found=f"{model.name}: {model.n} joints, run-time parameters "
            f"{', '.join(model.parameters) or 'none'}",
            expected=f"{robot.n} joints, run-time parameters among {', '.join(robot.parameters) or 'none'}",
        )
    program = maker(steady(model), Options()).program("inverse_dynamics")
    glue = system_glue(system, program, energy=energy)
    return Plant(robot, system, build_engine(glue, cache=cache), model)


def steady(model: Robot) -> Robot:
    """``model`` without memory: bristles slide, couplers are rigid."""
    kept: list[EffectEntry] = []
    for entry in model.effects:
        known = entry.definition
        if known.traits.steady is not None:
            id, names = known.traits.steady
            kept.append(EffectEntry(id, entry.joint, tuple((name, entry[name]) for name in names)))
        elif known.coupler is None:
            kept.append(entry)
    return replace(model, effects=tuple(kept))


def system_glue(system: System, model: Program | None = None, *, energy: bool = False) -> str:
    """The C by which the engine calls ``system``; with ``model``, the torques of computed-torque control."""
    n, elements = system.coordinates, len(system.elements)
    lines = [
        f"/* The system of {system.robot.name}. */",
        "#include <math.h>",
        f"#define SYSTEM_N {n}",
        f"#define SYSTEM_ELEMENTS {elements}",
        f"#define SYSTEM_STATES {len(system.states)}",
        f"#define SYSTEM_PARAMETERS {len(system.parameters)}",
        f"#define SYSTEM_AFFINE {int(system.affine)}",
        f"#define SYSTEM_CONSERVED {int(energy)}",
        f"#define SYSTEM_EXTERNAL {int(bool(system.contacts))}",
        f"#define SYSTEM_MODEL {int(model is not None)}",
    ]
    if elements:
        rows = ", ".join("{" + ", ".join(repr(float(x)) for x in e.row) + "}" for e in system.elements)
        lines.append(f"static const double system_w[{elements}][{n}] = {{{rows}}};")
    for name, program in system.programs.items():
        if not energy and (name == "conserved" or (name == "mass" and not system.affine)):
            continue
        inputs = _ARGUMENTS.get(name, ("y",))
        ((output, _),) = program.outputs
        lines.append(static_function(f"system_{name}", inputs, {output: output}, program, system.parameters))
    if model is not None:
        lines.append(
            static_function("system_model", ("q", "qd", "qdd"), {"tau": "tau"}, model, system.parameters)
        )
    if system.contacts:
        lines += _external(system)
    return "\n".join(lines) + "\n"


def _external(system: System) -> list[str]:
    n = system.coordinates
    lines = [
        "static void system_external(double t, const double *y, double *f, const double *p)",
        "{",
        f"    double one[{n}];",
        f"    for (int i = 0; i < {n}; ++i) f[i] = 0.0;",
    ]
    for k, entry in enumerate(system.contacts):
        start, end = (repr(entry.number(name)) for name in ("start", "end"))
        lines += [
            f"    if (t >= {start} && t < {end}) {{",
            f"        system_contact_{k}(y, one, p);",
            f"        for (int i = 0; i < {n}; ++i) f[i] += one[i];",
            "    }",
        ]
    return [*lines, "}"]


def drive_limits(robot: Robot, values: Mapping[str, float]) -> Floats | None:
    """What the drives give at most [n] (N m or N), infinity where there is no limit; None: none at all."""
    limits = np.full(robot.n, np.inf)
    for entry, channel in acting_on(robot.effects, "limit"):
        if entry.text(channel.who) == "drive":
            places = slice(None) if entry.joint is None else slice(entry.joint - 1, entry.joint)
            limits[places] = np.minimum(limits[places], entry.number(channel.parameter, values))
    return limits if np.isfinite(limits).any() else None
