"""An arm as data: all that its page shows, as JSON has it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from robodyn.counts import beside, count
from robodyn.counts.peers import TITLES, operations_of_peers, versions_of_peers
from robodyn.draw.mathml import equation, of_expression, of_input, of_name
from robodyn.dynamics.functions import function_named
from robodyn.emit.statements import statements
from robodyn.errors import InputError
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.report.arm_effects import effects
from robodyn.report.arm_kernel import ArmKernel, Floats, arm_kernel
from robodyn.report.arm_parts import joints, links, reach
from robodyn.report.schedule_sources import Source, robot_source
from robodyn.report.schedules import to_dict
from robodyn.robot.identity import identity
from robodyn.robot.model import Robot
from robodyn.schedule import Machine, Solved, solve
from robodyn.simulate.limits import with_limits
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


_OURS: Final = "robodyn"


def counts(robot: Robot, *generated: Generated) -> dict[str, Any]:
    """A record for each function of ``generated``, each once, with the operations of others where there are
    any; and the inverse dynamics of all of them as bars, least first."""
    others = operations_of_peers(robot)
    rows: dict[str, dict[str, Any]] = {}
    for one in generated:
        for signature, program in one.unit.functions:
            counted = count(program)
            printed = beside(robot, signature.function, counted)
            rows.setdefault(
                signature.function,
                {
                    "function": signature.function,
                    "purpose": function_named(signature.function).purpose,
                    **counted.to_dict(),
                    "thesis": None if printed is None else {**printed.to_dict(), "total": printed.total},
                    "peers": others.get(signature.function, {}),
                },
            )
    peers = [tool for tool in TITLES if any(tool in row["peers"] for row in rows.values())]
    return {
        "functions": list(rows.values()),
        "peers": {tool: TITLES[tool] for tool in peers},
        "versions": versions_of_peers() if peers else None,
        "bars": _bars(next(iter(rows.values()))),
    }


def _bars(row: dict[str, Any]) -> list[dict[str, Any]]:
    bars = [{"title": _OURS, "total": row["total"], "ours": True}]
    if row["thesis"] is not None:
        title = f"the thesis, Table {row['thesis']['table']}"
        bars.append({"title": title, "total": row["thesis"]["total"], "ours": False})
    bars += [{"title": TITLES[tool], "total": total, "ours": False} for tool, total in row["peers"].items()]
    return sorted(bars, key=lambda bar: int(bar["total"]))


#: [Hz], harmonics, and the share of the limits that is used: one period takes eight seconds.
_FREQUENCY, _HARMONICS, _SHARE, _SEED = 0.125, 3, 0.6, 1
#: Samples of a period that are drawn.
SAMPLES: Final = 240


def motion(robot: Robot, kernel: ArmKernel) -> dict[str, Any]:
    """One period of the motion, as coefficients (position is ``mean + sines sin(k w t) + cosines cos(k w t)``
    [rad or m], a list a joint), and the torques [N m or N] at ``times`` [s]."""
    from robodyn.simulate.trajectories.fourier import fourier

    limited, assumed = with_limits(robot)
    period = 1 / _FREQUENCY
    path = fourier(limited, _FREQUENCY, _HARMONICS, _SEED, share=_SHARE, period=period / SAMPLES)
    arrays = {"q": path.q, "qd": path.qd, "qdd": path.qdd}
    torques = kernel.rows("inverse_dynamics", arrays, period / SAMPLES)["tau"]
    holding = kernel.rows("gravity", arrays)["tau"]
    return {
        "period": period,
        "step": period / SAMPLES,
        "mean": path.provenance["mean"],
        "sines": path.provenance["sines"],
        "cosines": path.provenance["cosines"],
        "assumed_limits": list(assumed),
        "times": path.t.tolist(),
        "position": _columns(path.q),
        "torque": _columns(torques),
        "gravity": _columns(holding),
    }


def _columns(values: Floats) -> list[list[float]]:
    """Of an array [K, n] a list for each joint, to six digits."""
    return [[float(f"{x:.6g}") for x in column] for column in np.asarray(values).T]


#: What is typeset, and what each is called.
_TITLES: Final = {"gravity": "Holding the arm", "inverse_dynamics": "Torques of a motion"}
#: Longer recursions are no reading matter: the emitted C has them.
MOST: Final = 700


def equations(robot: Robot) -> list[dict[str, Any]]:
    """By function the steps of the recursion, grouped under what they compute: MathML, an element a step."""
    options = Options(functions=tuple(_TITLES), readable=True, optimize="none", order="recursion")
    unit = generate(robot, options).unit
    records = []
    for signature, program in unit.functions:
        body = statements(program, readable=True)
        groups: list[dict[str, Any]] = []
        for statement in body.statements[:MOST]:
            if statement.heading is not None or not groups:
                groups.append({"heading": statement.heading or "", "steps": []})
            groups[-1]["steps"].append(equation(of_name(statement.name), of_expression(statement.expression)))
        results = [
            equation(of_input(array, index), of_expression(element))
            for array, elements in body.outputs
            if array != "state"
            for index, element in enumerate(elements)
        ]
        records.append(
            {
                "function": signature.function,
                "title": _TITLES[signature.function],
                "steps": len(body.statements),
                "left_out": max(0, len(body.statements) - MOST),
                "groups": groups,
                "results": results,
            }
        )
    return records
