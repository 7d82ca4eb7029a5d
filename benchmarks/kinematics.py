"""Operations of kinematics beside those of CasADi, into the tables of docs/functions.md.

    python -m benchmarks.kinematics

CasADi gets the book's formulas of the same function over its ``SX`` (which folds zeros and ones), each in
several ways where there are several, runs ``cse`` on each, and the smallest counts: transforms multiplied
from base and from tip; the Jacobian by cross products, and by CasADi's own differentiation; its rate by
CasADi's directional derivative, and by the recursion of velocities and accelerations; ``J M^-1 J^T`` with the
mass matrix of composite bodies, factored by ``L D L^T``. Offsets of joint angles by right angles cost nothing
there. Where CasADi is not installed its figures stay as they are in results/kinematics.json.
"""

from __future__ import annotations

import importlib.util
import json
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

from benchmarks.marked import with_part

from robodyn import Options, count, load, program
from robodyn.dynamics.arm import Arm, JointAngle, Motion, build_arm, build_motion
from robodyn.dynamics.functions import FUNCTIONS, NoSuchFunction
from robodyn.dynamics.kinematics import frames, jacobian
from robodyn.dynamics.lump import NO_LUMP
from robodyn.dynamics.mass_matrix import mass_matrix
from robodyn.dynamics.parallel import single_turns
from robodyn.dynamics.regroup import lumps_of
from robodyn.dynamics.state import Moving
from robodyn.dynamics.transforms import IDENTITY_4, applied, product, rotation, transform, transposed
from robodyn.dynamics.vectors import ZERO, Vector, cross, plus, scaled
from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input
from robodyn.robot import bundled_names
from robodyn.robot.model import Robot

ROOT = Path(__file__).parents[1]
PAGE, RESULTS = ROOT / "docs" / "functions.md", ROOT / "benchmarks" / "results" / "kinematics.json"
#: What CasADi is asked for as well.
NAMES = (
    "forward_kinematics",
    "link_poses",
    "jacobian",
    "tool_jacobian",
    "jacobian_dot_qd",
    "lambda_inverse",
)
#: How far a value may be off ours.
_AGREED = 1e-9
#: Columns of the table of all functions.
SHOWN = ("puma560", "ur10", "panda")
Counts = dict[str, dict[str, int]]


def ours(name: str, functions: Sequence[str]) -> dict[str, int]:
    """Operations of ``functions`` of a bundled robot, without those that it does not have."""
    robot, counts = load(name, warn=lambda _: None), {}
    for function in functions:
        try:
            counts[function] = count(robot, function, Options((function,))).total
        except NoSuchFunction:
            continue
    return counts


# --- CasADi -----------------------------------------------------------------------------------------------


def casadi_counts(robot: Robot) -> dict[str, int]:
    """Operations of :data:`NAMES` by CasADi: the fewest of several ways."""
    import casadi as ca

    q, qd = ca.SX.sym("q", robot.n), ca.SX.sym("qd", robot.n)
    rates = [qd[i] for i in range(robot.n)]

    def number(x: Fraction) -> Any:
        return int(x) if x.denominator == 1 else float(x)

    def trigonometry(angle: JointAngle) -> tuple[Any, Any]:
        ((joint, _),) = angle.terms
        at = q[joint] if angle.offset.quarter is not None else q[joint] + angle.offset.radians
        turns = (angle.offset.quarter or 0) % 4
        c, s = ca.cos(at), ca.sin(at)
        return ((c, s), (-s, c), (-c, -s), (s, -c))[turns]

    def counted(name: str, values: Sequence[Any]) -> int:
        function = ca.Function("f", [q, qd], [ca.cse(ca.vertcat(*values))])
        state = [[0.3 + 0.4 * i for i in range(robot.n)], [1.1 - 0.5 * i for i in range(robot.n)]]
        for x, y in zip(function(*state).full()[:, 0], _values(robot, name, *state), strict=True):
            if not abs(x - y) <= _AGREED:
                raise AssertionError(f"{robot.name}: CasADi's {name} is {x} where ours is {y}")
        operations = [function.instruction_id(k) for k in range(function.n_instructions())]
        known = (ca.OP_ADD, ca.OP_SUB, ca.OP_MUL, ca.OP_DIV, ca.OP_SQ, ca.OP_TWICE, ca.OP_INV, ca.OP_SQRT)
        return sum(operation in known for operation in operations)

    arm = build_arm(robot, number, lambda name: ca.SX.sym(name))
    motion = build_motion(arm, [q[i] for i in range(robot.n)], rates, [0] * robot.n, trigonometry, number)
    poses, tips = _poses(arm, motion), _from_the_tip(arm, motion)
    tool = poses[-1]
    J = jacobian(arm, frames(arm, motion, arm.base), arm.tool.origin)
    places = [[row[3] for row in T[:3]] for T in (tool, tips[0])]
    by_derivative = [ca.jacobian(ca.vertcat(*place), q) for place in places]
    jacobians = [[x for row in J for x in row]]
    jacobians += [[*ca.vertsplit(ca.vec(D.T)), *(x for row in J[3:] for x in row)] for D in by_derivative]
    rows = [ca.horzcat(*row) for row in J]
    matrices = [ca.vertcat(*rows), *(ca.vertcat(D, *rows[3:]) for D in by_derivative)]
    ways = {
        "forward_kinematics": [[x for row in T[:3] for x in row] for T in (tool, tips[0])],
        "link_poses": [_placed(poses[:-1])],
        "jacobian": jacobians,
        "tool_jacobian": [_tool_jacobian(arm, tips), _turned_back(tool, J)],
        "jacobian_dot_qd": [
            *([ca.jtimes(ca.mtimes(matrix, qd), q, qd)] for matrix in matrices),
            *_accelerations(arm, motion, tool),
            _acceleration_in_world(arm, motion),
        ],
    }
    if "lambda_inverse" in ours(robot.name, ["lambda_inverse"]):
        ways["lambda_inverse"] = [_lambda(arm, motion, J)]
    return {name: min(counted(name, way) for way in all_) for name, all_ in ways.items()}


def _values(robot: Robot, name: str, q: Sequence[float], qd: Sequence[float]) -> list[float]:
    """Our results, one after another."""
    inputs = {Input(array, i): x for array, row in (("q", q), ("qd", qd)) for i, x in enumerate(row)}
    arrays = evaluate(program(robot, name, Options((name,))), inputs)
    return [float(x) for elements in arrays.values() for x in elements]


def _placed(poses: Sequence[Any]) -> list[Any]:
    """Positions, then rotations row by row."""
    return [*(row[3] for T in poses for row in T[:3]), *(x for T in poses for row in T[:3] for x in row[:3])]


def _frame(frame: Any) -> Any:
    rows = zip(frame.rotation(), frame.origin, strict=True)
    return (*((*row, p) for row, p in rows), (0, 0, 0, 1))


def _poses(arm: Arm, motion: Motion) -> list[Any]:
    """Transforms of the links and of the tool, multiplied up from the base."""
    poses, last = [], product(_frame(arm.base), IDENTITY_4)
    for body, c, s, d in zip(arm.bodies, motion.c, motion.s, motion.d, strict=True):
        last = product(last, transform(body, c, s, d))
        poses.append(last)
    return [*poses, product(last, _frame(arm.tool))]


def _from_the_tip(arm: Arm, motion: Motion) -> list[Any]:
    """The tool in the world, and in each link, multiplied up from the tip."""
    last = _frame(arm.tool)
    poses = [last]
    for body, c, s, d in reversed(list(zip(arm.bodies, motion.c, motion.s, motion.d, strict=True))):
        last = product(transform(body, c, s, d), last)
        poses.insert(0, last)
    return [product(_frame(arm.base), last), *poses[1:]]


def _tool_jacobian(arm: Arm, tips: Sequence[Any]) -> list[Any]:
    """Columns ``R^T (z x p)`` and ``R^T z`` of the tool as it stands in each link."""
    columns: list[tuple[Any, ...]] = []
    for body, T in zip(arm.bodies, tips[1:], strict=True):
        R = tuple(row[:3] for row in T[:3])
        if body.revolute:
            columns.append((*applied(transposed(R), cross((0, 0, 1), (T[0][3], T[1][3], T[2][3]))), *R[2]))
        else:
            columns.append((*R[2], 0, 0, 0))
    return [x for row in zip(*columns, strict=True) for x in row]


def _turned_back(tool: Any, J: Sequence[Sequence[Any]]) -> list[Any]:
    """``R^T`` times the halves of the columns."""
    R = transposed(tuple(row[:3] for row in tool[:3]))
    columns = [(*applied(R, column[:3]), *applied(R, column[3:])) for column in zip(*J, strict=True)]
    return [x for row in zip(*columns, strict=True) for x in row]


def _accelerations(arm: Arm, motion: Motion, tool: Any) -> list[list[Any]]:
    """Craig, 6.45 to 6.47, without joint accelerations; turned into the world at the end, at once and link by
    link."""
    w, alpha, a = ZERO, ZERO, ZERO
    for i, body in enumerate(arm.bodies):
        R = transposed(rotation(body, motion.c[i], motion.s[i]))
        a, alpha = _down(R, plus(a, _relative(w, alpha, _offset(body, motion.d[i])))), _down(R, alpha)
        w = _down(R, w)
        along = (0, 0, motion.qd[i])
        if body.revolute:
            alpha, w = plus(alpha, cross(w, along)), plus(w, along)
        else:
            a = plus(a, scaled(2, cross(w, along)))
    a = plus(a, _relative(w, alpha, arm.tool.origin))
    last = transposed(tuple(arm.tool.rotation()))
    R = tuple(row[:3] for row in product(tuple(row[:3] for row in tool[:3]), last))
    at_once = [*applied(R, a), *applied(R, alpha)]
    for body, c, s in reversed(list(zip(arm.bodies, motion.c, motion.s, strict=True))):
        a, alpha = (_down(rotation(body, c, s), u) for u in (a, alpha))
    return [at_once, [*arm.base.turned(a), *arm.base.turned(alpha)]]


def _acceleration_in_world(arm: Arm, motion: Motion) -> list[Any]:
    """The same, all along the world's axes."""
    w, alpha, a = ZERO, ZERO, ZERO
    before = arm.base.origin
    links = frames(arm, motion, arm.base)
    for body, frame, rate in zip(arm.bodies, links, motion.qd, strict=True):
        a = plus(a, _relative(w, alpha, plus(frame.origin, scaled(-1, before))))
        along, before = scaled(rate, frame.z), frame.origin
        if body.revolute:
            alpha, w = plus(alpha, cross(w, along)), plus(w, along)
        else:
            a = plus(a, scaled(2, cross(w, along)))
    return [*plus(a, _relative(w, alpha, links[-1].turned(arm.tool.origin))), *alpha]


def _offset(body: Any, d: Any) -> Vector:
    c, s = body.cos_alpha, body.sin_alpha
    return body.a, c * body.b - s * d, s * body.b + c * d


def _down(R: Any, u: Vector) -> Vector:
    x, y, z = applied(R, u)
    return x, y, z


def _relative(w: Vector, alpha: Vector, r: Vector) -> Vector:
    return plus(cross(alpha, r), cross(w, cross(w, r)))


def _lambda(arm: Arm, motion: Motion, J: Sequence[Sequence[Any]]) -> list[Any]:
    """The mass matrix of composite bodies as ``L D L^T``, six solutions half way, and products."""
    M = mass_matrix(Moving(arm, motion, single_turns(motion), lumps_of(arm), NO_LUMP))
    n = len(M)
    L: list[list[Any]] = [[0] * n for _ in range(n)]
    LD: list[list[Any]] = [[0] * n for _ in range(n)]
    D: list[Any] = []
    for j in range(n):
        D.append(1 / (M[j][j] - sum(L[j][k] * LD[j][k] for k in range(j))))
        for i in range(j + 1, n):
            LD[i][j] = M[i][j] - sum(L[i][k] * LD[j][k] for k in range(j))
            L[i][j] = LD[i][j] * D[j]
    halves: list[list[Any]] = []
    for row in J:
        half: list[Any] = []
        for i in range(n):
            half.append(row[i] - sum(L[i][k] * half[k] for k in range(i)))
        halves.append(half)
    divided = [[x * d for x, d in zip(half, D, strict=True)] for half in halves]
    pairs = ((min(r, s), max(r, s)) for r in range(6) for s in range(6))
    return [sum(x * y for x, y in zip(halves[r], divided[s], strict=True)) for r, s in pairs]


# --- tables -----------------------------------------------------------------------------------------------


def functions_table(counts: Counts) -> str:
    """All functions: arguments, results with units, operations."""
    lines = [f"| function | gives | {' | '.join(SHOWN)} |", f"|---|---|{'---:|' * len(SHOWN)}"]
    for name, function in FUNCTIONS.items():
        results = "; ".join(
            f"`{array.name}{''.join(f'[{length}]' for length in array.shape)}` {array.words}"
            for array in function.results
        )
        figures = (f"{counts[robot][name]:,}" if name in counts[robot] else "" for robot in SHOWN)
        arguments = ", ".join(function.input_names)
        lines.append(f"| `{name}({arguments})` | {results} | {' | '.join(figures)} |")
    return "\n".join(lines)


def casadi_table(counts: Counts, theirs: Counts) -> str:
    """Ours and CasADi's, robot by robot."""
    lines = ["| robot | " + " | ".join(f"`{name}`" for name in NAMES) + " |", "|---" * (1 + len(NAMES)) + "|"]
    for robot, figures in theirs.items():
        cells = (f"{counts[robot][n]:,} / {figures[n]:,}" if n in figures else "" for n in NAMES)
        lines.append(f"| {robot} | {' | '.join(cells)} |")
    return "\n".join(lines)


def main() -> None:
    """Count, and write results and tables."""
    if importlib.util.find_spec("casadi"):
        theirs = {name: casadi_counts(load(name, warn=lambda _: None)) for name in bundled_names()}
        RESULTS.write_text(json.dumps(theirs, indent=1) + "\n", encoding="utf-8")
    theirs = json.loads(RESULTS.read_text(encoding="utf-8"))
    text = PAGE.read_text(encoding="utf-8")
    text = with_part(
        text, "functions", functions_table({name: ours(name, tuple(FUNCTIONS)) for name in SHOWN})
    )
    text = with_part(text, "casadi", casadi_table({name: ours(name, NAMES) for name in theirs}, theirs))
    PAGE.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
