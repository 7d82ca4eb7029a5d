"""Operations of energies, momentum, inverse mass matrix and regressor beside CasADi's, for docs/functions.md.

    python -m benchmarks.dynamics

CasADi gets the book's formulas over its ``SX`` (which folds zeros and ones), in several ways where there
are several, runs ``cse`` on each, and the smallest counts: energies link by link; momentum and the
observer's term by CasADi's own differentiation of them, momentum by Newton-Euler as well; the mass matrix
of composite bodies, inverted by CasADi and by ``L D L^T`` from either end. For the regressor it
differentiates our own recursion by the base parameters, which are handed to it. Where CasADi is not
installed its figures stay as they are in results/dynamics.json.
"""

from __future__ import annotations

import importlib.util
import json
from collections.abc import Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

from benchmarks.kinematics import PAGE, ours
from benchmarks.marked import with_part

from robodyn import Options, load, program
from robodyn.dynamics.arm import JointAngle, Motion, build_arm, build_motion, inertial
from robodyn.dynamics.lump import NO_LUMP
from robodyn.dynamics.mass_matrix import mass_matrix
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.dynamics.parallel import single_turns
from robodyn.dynamics.reference import energies
from robodyn.dynamics.regressor import torques_from
from robodyn.dynamics.regroup import lumps_of
from robodyn.dynamics.state import Moving, Posture
from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input
from robodyn.optimize.programs import base_set_of
from robodyn.robot import bundled_names
from robodyn.robot.model import Robot

RESULTS = Path(__file__).parent / "results" / "dynamics.json"
#: What CasADi is asked for as well.
NAMES = (
    "kinetic_energy",
    "potential_energy",
    "momentum",
    "coriolis",
    "momentum_observer_term",
    "inverse_mass_matrix",
    "regressor",
    "inverse_dynamics_from_parameters",
)
#: How far a value may be off ours, beside the largest.
_AGREED = 1e-9


def casadi_counts(robot: Robot) -> dict[str, int]:
    """Operations of :data:`NAMES` by CasADi: the fewest of several ways."""
    import casadi as ca

    n, columns = robot.n, base_set_of(robot)
    symbols = {name: ca.SX.sym(name, n) for name in ("q", "qd", "qdd")}
    symbols["pi"] = ca.SX.sym("pi", len(columns))
    q, qd, qdd = ([symbols[name][i] for i in range(n)] for name in ("q", "qd", "qdd"))

    def number(x: Fraction) -> Any:
        return int(x) if x.denominator == 1 else float(x)

    def trigonometry(angle: JointAngle) -> tuple[Any, Any]:
        ((joint, _),) = angle.terms
        at = q[joint] if angle.offset.quarter is not None else q[joint] + angle.offset.radians
        c, s = ca.cos(at), ca.sin(at)
        return ((c, s), (-s, c), (-c, -s), (s, -c))[(angle.offset.quarter or 0) % 4]

    arm, rest = build_arm(robot, number, ca.SX.sym), [0] * n

    def motion(rates: Sequence[Any], accelerations: Sequence[Any]) -> Motion:
        return build_motion(arm, q, rates, accelerations, trigonometry, number)

    def counted(name: str, values: Sequence[Any]) -> int:
        state = {
            array: [0.3 + 0.41 * ((7 * k) % 11) for k in range(x.numel())] for array, x in symbols.items()
        }
        function = ca.Function("f", list(symbols.values()), [ca.cse(ca.vertcat(*values))])
        mine = _values(robot, name, state)
        for x, y in zip(function(*state.values()).full()[:, 0], mine, strict=True):
            if not abs(x - y) <= _AGREED * max(1.0, *map(abs, mine)):
                raise AssertionError(f"{robot.name}: CasADi's {name} is {x} where ours is {y}")
        operations = [function.instruction_id(k) for k in range(function.n_instructions())]
        known = (ca.OP_ADD, ca.OP_SUB, ca.OP_MUL, ca.OP_DIV, ca.OP_SQ, ca.OP_TWICE, ca.OP_INV, ca.OP_SQRT)
        return sum(operation in known for operation in operations)

    kinetic, _ = energies(arm, motion(qd, rest))
    _, potential = energies(arm, motion(rest, rest))
    gravity = newton_euler(arm, motion(rest, rest))
    slope = ca.vertsplit(ca.gradient(kinetic, symbols["q"]))
    owns: list[tuple[str, int]] = [column.own for column in columns]
    numbers = {own: symbols["pi"][k] for k, own in enumerate(owns)}
    torques = torques_from(Posture(arm, motion(qd, qdd), single_turns(motion(qd, qdd))), numbers)
    ways = {
        "kinetic_energy": [[kinetic]],
        "potential_energy": [[potential]],
        "momentum": [
            ca.vertsplit(ca.gradient(kinetic, symbols["qd"])),
            newton_euler(inertial(arm), motion(rest, qd)),
        ],
        "coriolis": [newton_euler(inertial(arm), motion(qd, rest))],
        "momentum_observer_term": [[x - g for x, g in zip(slope, gravity, strict=True)]],
        "regressor": [ca.vertsplit(ca.vec(ca.jacobian(ca.vertcat(*torques), symbols["pi"]).T))],
        "inverse_dynamics_from_parameters": [torques],
    }
    if "inverse_mass_matrix" in ours(robot.name, ["inverse_mass_matrix"]):
        matrix = mass_matrix(
            Moving(arm, motion(rest, rest), single_turns(motion(rest, rest)), lumps_of(arm), NO_LUMP)
        )
        whole = ca.vertcat(*(ca.horzcat(*row) for row in matrix))
        ways["inverse_mass_matrix"] = [
            ca.vertsplit(ca.vec(ca.inv(whole))),
            *(_inverted(matrix, order) for order in (range(n), range(n - 1, -1, -1))),
        ]
    return {name: min(counted(name, way) for way in ways[name]) for name in NAMES if name in ways}


def _inverted(matrix: Sequence[Sequence[Any]], order: Sequence[int]) -> list[Any]:
    """The inverse row by row, by ``L D L^T`` of rows and columns in ``order``."""
    n = len(order)
    L: list[list[Any]] = [[0] * n for _ in range(n)]
    LD: list[list[Any]] = [[0] * n for _ in range(n)]
    D: list[Any] = []
    for j in range(n):
        D.append(1 / (matrix[order[j]][order[j]] - sum(L[j][k] * LD[j][k] for k in range(j))))
        for i in range(j + 1, n):
            LD[i][j] = matrix[order[i]][order[j]] - sum(L[i][k] * LD[j][k] for k in range(j))
            L[i][j] = LD[i][j] * D[j]
    inverse: list[list[Any]] = [[0] * n for _ in range(n)]
    for i in reversed(range(n)):
        for j in reversed(range(i, n)):
            terms = sum(L[k][i] * inverse[k][j] for k in range(i + 1, n))
            inverse[i][j] = inverse[j][i] = (D[i] if i == j else 0) - terms
    place = {row: k for k, row in enumerate(order)}
    return [inverse[place[i]][place[j]] for i in range(n) for j in range(n)]


def _values(robot: Robot, name: str, state: Mapping[str, Sequence[float]]) -> list[float]:
    """Our results, one after another."""
    inputs = {Input(array, i): x for array, row in state.items() for i, x in enumerate(row)}
    arrays = evaluate(program(robot, name, Options((name,))), inputs)
    return [float(x) for elements in arrays.values() for x in elements]


def table(theirs: Mapping[str, Mapping[str, int]]) -> str:
    """Ours and CasADi's, robot by robot."""
    lines = ["| robot | " + " | ".join(f"`{name}`" for name in NAMES) + " |", "|---" * (1 + len(NAMES)) + "|"]
    for robot, figures in theirs.items():
        own = ours(robot, NAMES)
        cells = (f"{own[name]:,} / {figures[name]:,}" if name in figures else "" for name in NAMES)
        lines.append(f"| {robot} | {' | '.join(cells)} |")
    return "\n".join(lines)


def main() -> None:
    """Count, and write results and the table."""
    if importlib.util.find_spec("casadi"):
        theirs = {name: casadi_counts(load(name, warn=lambda _: None)) for name in bundled_names()}
        RESULTS.write_text(json.dumps(theirs, indent=1) + "\n", encoding="utf-8")
    theirs = json.loads(RESULTS.read_text(encoding="utf-8"))
    text = PAGE.read_text(encoding="utf-8")
    PAGE.write_text(with_part(text, "casadi dynamics", table(theirs)), encoding="utf-8")


if __name__ == "__main__":
    main()
