"""What the way from a robot to a straight-line program would cost through sympy: time, operations.

    python benchmarks/through_sympy.py [ROBOT ...] [-n RUNS]

Three ways to one recursion, the modified Newton-Euler recursion as the book has it: on the nodes of a graph;
on sympy expressions with a symbol for each named quantity, then ``sympy.cse``; on sympy expressions without
names, then ``sympy.cse``. Times [ms] of the wall clock, the smallest of RUNS; sympy's import is apart.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import time
from collections.abc import Callable
from fractions import Fraction
from functools import partial
from typing import Any

from robodyn.counts.count import count
from robodyn.dynamics.arm import build_arm
from robodyn.kernels.through_sympy import AS_IN_THE_BOOK, build_through_sympy
from robodyn.optimize.programs import build, outputs_of
from robodyn.robot import Robot, load

FUNCTION = "inverse_dynamics"


def unnamed(robot: Robot) -> int:
    """Operations of the torques as closed expressions after ``sympy.cse``."""
    import sympy

    inputs = {
        name: tuple(sympy.Symbol(f"{name}{i + 1}", real=True) for i in range(robot.n))
        for name in ("q", "qd", "qdd")
    }

    def rational(x: Fraction) -> Any:
        return sympy.Rational(x.numerator, x.denominator)

    def trigonometry(angle: Any) -> tuple[Any, Any]:
        total = sympy.Add(*(sign * inputs["q"][joint] for joint, sign in angle.terms))
        cosine, sine = rational(angle.offset.cos), rational(angle.offset.sin)
        c, s = sympy.cos(total), sympy.sin(total)
        return cosine * c - sine * s, cosine * s + sine * c

    names: dict[str, Any] = {}  # no run-time parameters
    arm = build_arm(robot, rational, names.__getitem__)
    results = outputs_of(
        FUNCTION, arm, AS_IN_THE_BOOK, inputs, trigonometry, rational, lambda value, label: value
    )
    replacements, reduced = sympy.cse([sympy.sympify(x) for x in results])
    expressions = [expression for _, expression in replacements] + list(reduced)
    return sum(_operations(expression) for expression in expressions)


def _operations(expression: Any) -> int:
    """Binary additions and multiplications, those of powers included, as robodyn counts."""
    count = sum(map(_operations, expression.args))
    if expression.is_Add or expression.is_Mul:
        count += len(expression.args) - 1 - (expression.is_Mul and expression.args[0] == -1)
    if expression.is_Pow and expression.exp.is_Integer:
        count += abs(int(expression.exp)) - 1
    return count


def smallest(run: Callable[[], Any], runs: int) -> tuple[Any, float]:
    """The result, and the smallest time [ms] of so many runs."""
    times = []
    result = None
    for _ in range(runs):
        began = time.perf_counter()
        result = run()
        times.append(time.perf_counter() - began)
    return result, 1000 * min(times)


def _total(build: Callable[..., Any], robot: Robot) -> int:
    return count(build(robot, FUNCTION, AS_IN_THE_BOOK)).total


def main() -> None:
    """Print a line for each robot and way."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("robots", nargs="*", default=["puma560", "stanford", "ur5", "iiwa"])
    parser.add_argument("-n", dest="runs", type=int, default=3)
    options = parser.parse_args()
    code = "import time; began = time.perf_counter(); import sympy; print(time.perf_counter() - began)"
    seconds = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    print(f"import sympy: {1000 * float(seconds):.0f} ms")
    for name in options.robots:
        robot = load(name, warn=lambda _: None)
        ways: dict[str, Callable[[], Any]] = {
            "graph": partial(_total, build, robot),
            "sympy, named": partial(_total, build_through_sympy, robot),
            "sympy, unnamed": partial(unnamed, robot),
        }
        for way, run in ways.items():
            operations, ms = smallest(run, options.runs)
            print(f"{name:12} {way:15} {ms:8.1f} ms  {operations} operations")


if __name__ == "__main__":
    main()
