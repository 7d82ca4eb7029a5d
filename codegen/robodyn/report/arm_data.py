"""An arm as data: all that its page shows, as JSON has it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Final

import numpy as np
from markupsafe import Markup

from robodyn.arrays import Floats
from robodyn.counts import count
from robodyn.counts.peers import TITLES, operations_of_peers, versions_of_peers
from robodyn.counts.thesis import beside
from robodyn.draw.mathml import equation, of_expression, of_input, of_name
from robodyn.dynamics.functions import function_named
from robodyn.emit.statements import statements
from robodyn.errors import InputError
from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.report.arm_parts import effects, joints, links, reach
from robodyn.report.schedules import Source, robot_source, to_dict
from robodyn.robot.identity import identity
from robodyn.robot.model import Robot
from robodyn.schedule import Machine, Solved, solve
from robodyn.simulate.limits import with_limits
from robodyn.version import VERSION

#: What the page computes of the arm.
FUNCTIONS: Final = (
    "inverse_dynamics", "gravity", "mass_matrix", "link_poses", "forward_kinematics", "jacobian",
)  # fmt: skip
#: Processors of the schedule that is drawn: two hands count them, and every arm's tasks keep them busy.
_PROCESSORS: Final = 4


@dataclass(frozen=True, slots=True)
class Arm:
    """An arm with what its page is made of: the ``kernel`` of :data:`FUNCTIONS` that moves it, with sine and
    cosine of its own, all kernels in C (``generated``), and the ``data``."""

    robot: Robot
    kernel: Generated
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
    # Frames of links are those in which joints turn about z, whatever the description's convention.
    kernel = generate(replace(robot, standard_end=None), Options(functions=FUNCTIONS, trig="builtin"))
    generated, source = generate(robot), robot_source(robot)
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
        "home": _home(kernel, axes),
        "kernel": {"functions": {s.function: _interface(s) for s in kernel.signatures}},
        "motion": path,
        "counts": counts(robot, generated, kernel),
        "effects": effects(robot, axes, path),
        "schedule": to_dict(source, solved),
        "left_out": generated.left_out,
        "equations": equations(robot),
    }
    return Arm(robot, kernel, generated, source, solved, data)


def _interface(signature: Any) -> dict[str, Any]:
    """The symbol of a function in the module, and the lengths of its arrays."""
    return {
        "symbol": signature.symbol,
        "inputs": [length for _, length in signature.inputs],
        "outputs": [length for _, length in signature.outputs],
        "remembers": bool(signature.states),
    }


def _placement(frame: Any) -> dict[str, Any] | None:
    if frame is None:
        return None
    return {"xyz": [float(x) for x in frame.xyz], "rpy": [angle.radians for angle in frame.rpy]}


def _results(kernel: Generated, function: str, states: Mapping[str, Floats], dt: float = 0.0) -> Floats:
    """The first result [K, length] of ``function`` at ``states`` [K, length], one ``dt`` [s] after the other;
    what remembers begins at rest at the first."""
    signature, program = next((s, p) for s, p in kernel.unit.functions if s.function == function)
    memory: list[Any] = [0.0] * len(signature.states)
    rows = []
    count = len(next(iter(states.values())))
    for k, step in [(0, 0.0), *((k, dt) for k in range(count))]:
        inputs: dict[Input, Any] = {Input("state", i): x for i, x in enumerate(memory)}
        inputs |= {Input(a, i): float(x) for a, _ in signature.inputs for i, x in enumerate(states[a][k])}
        results = evaluate(program, inputs | {Input("dt", 0): step})
        memory = results.get("state", [])
        rows.append(results[signature.outputs[0][0]])
    return np.array(rows[1:], dtype=np.float64)


def _home(kernel: Generated, axes: list[dict[str, Any]]) -> dict[str, Any]:
    """The arm at rest where its page shows it first: positions [n], torques [n], pose of the tool [12]."""
    q = np.array([[joint["home"] for joint in axes]])
    states = {"q": q, "qd": np.zeros_like(q), "qdd": np.zeros_like(q)}
    names = {"torque": "inverse_dynamics", "gravity": "gravity", "pose": "forward_kinematics"}
    results = {key: _results(kernel, name, states)[0].tolist() for key, name in names.items()}
    return {"position": q[0].tolist(), **results}


def counts(robot: Robot, *generated: Generated) -> dict[str, Any]:
    """A record for each function of ``generated``, each once, with the operations of others where there are
    any; and the inverse dynamics of all of them as bars, least first."""
    others = operations_of_peers(robot)
    rows: dict[str, dict[str, Any]] = {}
    for signature, program in (pair for one in generated for pair in one.unit.functions):
        counted = count(program)
        printed = beside(robot, signature.function, counted)
        row = {
            "function": signature.function,
            "purpose": function_named(signature.function).purpose,
            **counted.to_dict(),
            "thesis": None if printed is None else {**printed.to_dict(), "total": printed.total},
            "peers": others.get(signature.function, {}),
        }
        rows.setdefault(signature.function, row)
    peers = {tool: title for tool, title in TITLES.items() if any(tool in r["peers"] for r in rows.values())}
    first = next(iter(rows.values()))
    totals = {"robodyn": first["total"]}
    if first["thesis"] is not None:
        totals[f"the thesis, Table {first['thesis']['table']}"] = first["thesis"]["total"]
    totals |= {TITLES[tool]: total for tool, total in first["peers"].items()}
    return {
        "functions": list(rows.values()),
        "peers": peers,
        "versions": versions_of_peers() if peers else None,
        "bars": [
            {"title": title, "total": total, "ours": title == "robodyn"}
            for title, total in sorted(totals.items(), key=lambda bar: bar[1])
        ],
    }


#: [Hz], harmonics, and the share of the limits that is used: one period takes eight seconds.
_FREQUENCY, _HARMONICS, _SHARE, _SEED = 0.125, 3, 0.6, 1
#: Samples of a period that are drawn.
SAMPLES: Final = 240


def motion(robot: Robot, kernel: Generated) -> dict[str, Any]:
    """One period of the motion, as coefficients (position is ``mean + sines sin(k w t) + cosines cos(k w t)``
    [rad or m], a list a joint), and the torques [N m or N] at ``times`` [s]."""
    from robodyn.simulate.trajectories.fourier import fourier

    limited, assumed = with_limits(robot)
    period = 1 / _FREQUENCY
    path = fourier(limited, _FREQUENCY, _HARMONICS, _SEED, share=_SHARE, period=period / SAMPLES)
    states = {"q": path.q, "qd": path.qd, "qdd": path.qdd}
    return {
        "period": period,
        "step": period / SAMPLES,
        **{key: path.provenance[key] for key in ("mean", "sines", "cosines")},
        "assumed_limits": list(assumed),
        "times": path.t.tolist(),
        "position": _columns(path.q),
        "torque": _columns(_results(kernel, "inverse_dynamics", states, period / SAMPLES)),
        "gravity": _columns(_results(kernel, "gravity", states)),
    }


def _columns(values: Floats) -> list[list[float]]:
    """Of an array [K, n] a list for each joint, to six digits."""
    return [[float(f"{x:.6g}") for x in column] for column in values.T]


#: What is typeset, and what each is called.
_TITLES: Final = {"gravity": "Holding the arm", "inverse_dynamics": "Torques of a motion"}
#: Longer recursions are no reading matter: the emitted C has them.
MOST: Final = 700


def equations(robot: Robot) -> list[dict[str, Any]]:
    """By function the steps of the recursion, grouped under what they compute: MathML, an element a step."""
    options = Options(functions=tuple(_TITLES), readable=True, optimize="none", order="recursion")
    records = []
    for signature, program in generate(robot, options).unit.functions:
        body = statements(program, readable=True)
        groups: list[dict[str, Any]] = []
        for statement in body.statements[:MOST]:
            if statement.heading is not None or not groups:
                groups.append({"heading": statement.heading or "", "steps": []})
            step = equation(of_name(statement.name), of_expression(statement.expression))
            groups[-1]["steps"].append(Markup(step))
        results = [
            Markup(equation(of_input(array, index), of_expression(element)))
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
