"""Optimal control with IPOPT through CasADi: forward dynamics by our external function, and by CasADi's own.

python -m benchmarks.optimal_control [ROBOT ...]

The least torque that takes an arm from one place to another, by multiple shooting. CasADi's own function is
the plain recursion on its symbols, run by its virtual machine, and as the C that CasADi generates of it and
of its Jacobian, compiled with the flags of ours. Each solves the same problem in turn; what counts is the
least processor time of a solution, and a Jacobian's.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, Final

import casadi as ca
import numpy as np

from robodyn.dynamics.functions import function_named
from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input
from robodyn.kernels.generate import Options, generate, program
from robodyn.packages import package
from robodyn.robot import Robot, load

FUNCTION: Final = "forward_dynamics"
_FLAGS: Final = ("-O3", "-march=native", "-ffp-contract=off", "-fno-math-errno", "-fPIC", "-shared")
#: The functions of programs on CasADi's symbols.
_OF_SX: Final = {
    "sin": ca.sin, "cos": ca.cos, "tanh": ca.tanh, "sqrt": ca.sqrt, "exp": ca.exp,
    "sign": ca.sign, "abs": ca.fabs, "pow": ca.power,
}  # fmt: skip
_ROUNDS: Final = 3
_CALLS: Final = 2000


def expression(robot: Robot, function: str) -> Any:
    """CasADi's own function: the recursion of the book, not optimised, on its symbols."""
    record = function_named(function)
    inputs = {array.name: ca.SX.sym(array.name, robot.n) for array in record.inputs}
    at = {Input(name, i): symbol[i] for name, symbol in inputs.items() for i in range(robot.n)}
    plain = program(robot, function, Options(optimize="none"))
    results = []
    for array, elements in zip(record.results, evaluate(plain, at, functions=_OF_SX).values(), strict=True):
        rows = (array.shape_of(len(elements), robot.n) or (1,))[0]
        results.append(
            ca.reshape(ca.vertcat(*elements), len(elements) // rows, rows).T
        )  # by rows, not by columns
    names = [array.name for array in record.results]
    return ca.Function(function, [*inputs.values()], results, [*inputs], names)


def least_torque(f: Any, n: int, steps: int = 12) -> tuple[float, Any]:
    """Least torque that takes an arm from one place to another, at rest in both, within a second: the cost
    and the torques, by multiple shooting."""
    problem = ca.Opti()
    q, qd = problem.variable(n, steps + 1), problem.variable(n, steps + 1)
    tau = problem.variable(n, steps)
    h = 1 / steps
    for k in range(steps):
        x = [q[:, k], qd[:, k]]

        def rate(at: list[Any], k: int = k) -> list[Any]:
            return [at[1], f(at[0], at[1], tau[:, k])]

        slopes = [rate(x)]
        for share in (h / 2, h / 2, h):
            slopes.append(rate([a + share * b for a, b in zip(x, slopes[-1], strict=True)]))
        for state, index in ((q, 0), (qd, 1)):
            a, b, c, d = (slope[index] for slope in slopes)
            problem.subject_to(state[:, k + 1] == x[index] + h / 6 * (a + 2 * b + 2 * c + d))
    ends = ((q[:, 0], 0), (qd[:, 0], 0), (q[:, -1], np.linspace(0.5, 0.2, n)), (qd[:, -1], 0))
    for state, value in ends:
        problem.subject_to(state == value)
    problem.minimize(ca.sumsqr(tau) * h)
    quiet = {
        "print_level": 0,
        "sb": "yes",
        "hessian_approximation": "limited-memory",
        "tol": 1e-8,
        "max_iter": 3000,
    }
    problem.solver("ipopt", {"print_time": False, "ipopt": quiet})
    solution = problem.solve()
    return float(solution.value(problem.f)), solution.value(tau)


def ways(robot: Robot, folder: Path) -> dict[str, Any]:
    """The function by name of the way it is computed; libraries are built in ``folder``."""
    own = expression(robot, FUNCTION)
    code = ca.CodeGenerator("own.c", {"with_header": False})
    code.add(own)
    code.add(own.jacobian())
    code.generate(f"{folder}/")
    packed = package(generate(robot, Options((FUNCTION,), derivatives=True)), "casadi")
    for path, text in packed.files().items():
        if path.endswith((".c", ".h")):
            (folder / path).write_text(str(text), encoding="utf-8")
    ours = [path for path in packed.files() if path.endswith(".c")]
    for library, sources in (("ours.so", ours), ("own.so", ["own.c"])):
        subprocess.run(["cc", *_FLAGS, "-o", library, *sources, "-lm"], cwd=folder, check=True)
    return {
        "robodyn": ca.external(f"{robot.name}_casadi_{FUNCTION}", str(folder / "ours.so")),
        "CasADi's C": ca.external(FUNCTION, str(folder / "own.so")),
        "CasADi": own,
    }


def least(rounds: int, tasks: Mapping[str, Callable[[], Any]]) -> dict[str, float]:
    """The least processor time of each task [s], done in turn."""
    times: dict[str, list[float]] = {name: [] for name in tasks}
    for _ in range(rounds):
        for name, task in tasks.items():
            start = time.process_time()
            task()
            times[name].append(time.process_time() - start)
    return {name: min(each) for name, each in times.items()}


def calling(function: Any, state: list[Any]) -> Callable[[], Any]:
    """What calls ``function`` many times, without Python in between; all its results are wanted."""
    buffer, run = function.buffer()
    arguments = [np.array(x) for x in state]
    results = [np.zeros(max(1, function.nnz_out(k))) for k in range(function.n_out())]
    for k, x in enumerate(arguments):
        buffer.set_arg(k, memoryview(x.data))
    for k, x in enumerate(results):
        buffer.set_res(k, memoryview(x.data))

    def calls(_kept: Any = (buffer, arguments, results)) -> None:
        for _ in range(_CALLS):
            run()

    return calls


def main(names: list[str]) -> int:
    """Measure, and print a table."""
    print(f"{'robot':<12}{'by':<16}{'solution':>10}{'ratio':>8}{'Jacobian':>12}{'ratio':>8}{'cost':>14}")
    for name in names or ["puma560", "panda"]:
        robot = load(name, warn=lambda _: None)
        with tempfile.TemporaryDirectory() as folder:
            functions = ways(robot, Path(folder))
            costs: dict[str, float] = {}

            def solve(way: str, functions: Any = functions, costs: Any = costs, n: int = robot.n) -> None:
                costs[way] = least_torque(functions[way], n)[0]

            solutions = least(_ROUNDS, {way: lambda way=way: solve(way) for way in functions})  # type: ignore[misc]
            calls = {}
            state = [np.linspace(-1, 1, robot.n)] * 3
            for way, function in functions.items():
                calls[way] = calling(function.jacobian(), state)
            jacobians = least(_ROUNDS, calls)
        for way in functions:
            ratio, of_jacobian = (x[way] / x["robodyn"] for x in (solutions, jacobians))
            print(
                f"{name:<12}{way:<16}{solutions[way]:>8.2f} s{ratio:>8.1f}"
                f"{1e6 * jacobians[way] / _CALLS:>9.2f} us{of_jacobian:>8.1f}{costs[way]:>14.8g}"
            )
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
