"""The model as sympy expressions: to be read, typeset, and to cross-check the graph.

The recursion is the one that everything else runs; here its scalars are sympy expressions and each
quantity of the recursion gets a symbol of its own, so that no expression grows beyond a line.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from os import PathLike
from typing import TYPE_CHECKING, Any

from robodyn.dynamics.arm import JointAngle, build_arm
from robodyn.dynamics.functions import function_named
from robodyn.errors import InputError
from robodyn.formats.loading import robot_of
from robodyn.ir import Graph, Label, Program
from robodyn.ir.graph import Scalar
from robodyn.ir.lowering import lower
from robodyn.optimize.coupled import mapped
from robodyn.optimize.programs import Choice, outputs_of, signature
from robodyn.robot.coupling import no_couplings, transmission_of
from robodyn.robot.model import Robot
from robodyn.robot.values import angle

if TYPE_CHECKING:
    import sympy


AS_IN_THE_BOOK = Choice(regroup=False, chains=False)


@dataclass(frozen=True)
class Symbolic:
    """A function of a robot in sympy.

    ``steps`` are the recursion's quantities in order, ``(symbol, expression in earlier symbols)``;
    ``results`` the outputs in those symbols, ``outputs`` in the inputs alone (large from about four
    joints on). ``inputs`` holds the symbols of each argument, ``parameters`` those of run-time
    parameters; a symbol that would bear the name of an earlier one has a number after it.
    """

    robot: str
    function: str
    inputs: dict[str, tuple[sympy.Symbol, ...]]
    parameters: dict[str, sympy.Symbol]
    steps: tuple[tuple[sympy.Symbol, sympy.Expr], ...]
    results: tuple[sympy.Expr, ...]
    labels: dict[sympy.Symbol, Label]

    @cached_property
    def outputs(self) -> tuple[sympy.Expr, ...]:
        """The outputs, all steps put in: tau [n], M [n * n] row by row, or qdd [n]."""
        import sympy

        known: dict[sympy.Symbol, sympy.Expr] = {}
        for symbol, expression in self.steps:
            known[symbol] = expression.xreplace(known)
        return tuple(sympy.sympify(result).xreplace(known) for result in self.results)

    @property
    def tau(self) -> tuple[sympy.Expr, ...]:
        """The joint torques [n]: :attr:`outputs` of a function that returns torques."""
        return self.outputs

    def latex(self) -> str:
        """The recursion as LaTeX, one line of an ``align*`` a quantity."""
        import sympy

        names = {symbol: _latex_name(label) for symbol, label in self.labels.items()}
        for array, symbols in self.inputs.items():
            names.update({s: f"{_ACCENTS[array]}_{{{i}}}" for i, s in enumerate(symbols, 1)})

        def line(left: str, expression: sympy.Expr) -> str:
            return f"{left} &= {sympy.latex(expression, symbol_names=names)} " + r"\\"

        array = function_named(self.function).results[0].name
        result = _ACCENTS.get(array, array)
        lines = [line(names[symbol], expression) for symbol, expression in self.steps]
        lines += [line(f"{result}_{{{i}}}", x) for i, x in enumerate(self.results, 1)]
        return "\n".join([r"\begin{align*}", *lines, r"\end{align*}"]) + "\n"


_ACCENTS = {"q": "q", "qd": r"\dot q", "qdd": r"\ddot q", "tau": r"\tau"}
_LATEX = {
    "w": r"\omega", "alpha": r"\alpha", "lam": r"\lambda", "ww": r"(\omega\omega)", "fc": "F", "nc": "N",
    "tau": r"\tau", "ac": "a_c", "qdd": r"\ddot q", "m": "M",
}  # fmt: skip


def _latex_name(label: Label) -> str:
    symbol = _LATEX.get(label.quantity, label.quantity)
    index = f"{label.link},{label.axis}" if label.axis else str(label.link)
    return f"{{{symbol}}}_{{{index}}}"


def symbolic(
    robot: Robot | str | PathLike[str],
    function: str = "inverse_dynamics",
    choice: Choice = AS_IN_THE_BOOK,
) -> Symbolic:
    """The model of ``robot`` (or of that path or name) as sympy expressions: by default the modified
    Newton-Euler recursion as the book has it, without regrouping.

    >>> symbolic(load("puma560_3dof")).steps[:3]                     # doctest: +SKIP

    Raises
    ------
    InputError: an unknown function or formulation, or a function of poses, whose geometry is exact.
    """
    import sympy

    if function_named(function).of_pose:
        raise InputError(
            f"{function} is not written through sympy",
            found="a function of a pose",
            expected="a function of joint positions",
            remedy="use the engine graph",
        )
    robot = robot_of(robot)
    if robot.couplings and function_named(function).in_coordinates is not None:
        no_couplings(robot, f"{function} through sympy")
    interface = signature(robot, function)
    inputs = {
        name: tuple(sympy.Symbol(f"{name}{i + 1}", real=True) for i in range(size))
        for name, size in interface.inputs
    }
    taken = {symbol.name for symbols in inputs.values() for symbol in symbols}
    steps: list[tuple[sympy.Symbol, sympy.Expr]] = []
    labels: dict[sympy.Symbol, Label] = {}

    def rational(x: Fraction) -> Any:
        return sympy.Rational(x.numerator, x.denominator)

    def fresh(wanted: str) -> Any:
        name, k = wanted, 2
        while name in taken:
            name, k = f"{wanted}_{k}", k + 1
        taken.add(name)
        return sympy.Symbol(name, real=True)

    parameters = {name: fresh(name) for name in robot.parameters}

    def mark(value: Any, label: Label) -> Any:
        if not isinstance(value, sympy.Expr) or value.is_Number or value.is_Symbol or (-value).is_Symbol:
            return value
        symbol = fresh(str(label))
        steps.append((symbol, value))
        labels[symbol] = label
        return symbol

    of_joints = _of_joints(robot, inputs, rational) if robot.couplings else inputs

    def trigonometry(angle: JointAngle) -> tuple[Any, Any]:
        total = sympy.Add(*(sign * of_joints["q"][joint] for joint, sign in angle.terms))
        cosine, sine = rational(angle.offset.cos), rational(angle.offset.sin)
        if angle.offset.quarter is None:
            total, cosine, sine = total + rational(Fraction(angle.offset.radians)), 1, 0
        c, s = mark(sympy.cos(total), angle.label("c")), mark(sympy.sin(total), angle.label("s"))
        return cosine * c - sine * s, cosine * s + sine * c

    arm = build_arm(robot.free, rational, parameters.__getitem__)
    results = outputs_of(function, arm, choice, of_joints, trigonometry, rational, mark)
    if robot.couplings:
        pieces = function_named(function).split(results, robot.n)
        shapes = {array.name: array.shape for array in function_named(function).results}
        at = transmission_of(robot)
        results = [x for name, piece in pieces for x in mapped(at, piece, shapes[name], rational)]
    expressions = tuple(map(sympy.sympify, results))
    return Symbolic(robot.name, function, inputs, parameters, tuple(steps), expressions, labels)


def _of_joints(
    robot: Robot, inputs: Mapping[str, Sequence[Any]], rational: Callable[[Fraction], Any]
) -> dict[str, Sequence[Any]]:
    """The inputs of all joints, of those of the coordinates that they follow."""
    import sympy

    at, turned = transmission_of(robot), [link.joint.kind == "revolute" for link in robot.links]
    of_joints = {
        name: at.spread(array, rational) if name in ("q", "qd", "qdd") else array
        for name, array in inputs.items()
    }
    starts: list[Any] = []
    for i, offset in enumerate(at.offsets):
        quarter = angle(offset).quarter if turned[i] else None
        starts.append(rational(offset) if quarter is None else sympy.pi * quarter / 2)
    return of_joints | {"q": [q + start for q, start in zip(of_joints["q"], starts, strict=True)]}


def build_through_sympy(robot: Robot, function: str, choice: Choice) -> Program:
    """The program of ``function`` with sympy in the graph's place: named intermediates, ``sympy.cse``."""
    import sympy

    model = symbolic(robot, function, choice)
    expressions = [expression for _, expression in model.steps] + list(model.results)
    symbols = sympy.numbered_symbols("cse:", real=True)  # no name of a robot or a quantity has a colon
    replacements, reduced = sympy.cse(expressions, symbols=symbols, optimizations=None, order="none")
    graph = Graph(fold=False)
    values: dict[sympy.Symbol, Scalar] = {}
    for name, bound in model.inputs.items():
        values.update((symbol, graph.input(name, i)) for i, symbol in enumerate(bound))
    values.update((symbol, graph.input(name)) for name, symbol in model.parameters.items())
    # cse puts its symbols first although they may use the model's own: take each when it is reached.
    waiting: dict[sympy.Symbol, sympy.Expr] = dict(replacements)
    waiting.update((symbol, e) for (symbol, _), e in zip(model.steps, reduced, strict=False))
    converter = _Converter(graph, values, waiting)
    for symbol, _ in model.steps:
        graph.label(converter.symbol(symbol), model.labels[symbol])
    results = [converter.convert(expression) for expression in reduced[len(model.steps) :]]
    return lower(graph, function_named(function).split(results, robot.n))


class _Converter:
    """Sympy expressions into nodes."""

    def __init__(self, graph: Graph, values: dict[Any, Scalar], waiting: dict[Any, Any]) -> None:
        self.graph, self.values, self.waiting = graph, values, waiting

    def symbol(self, symbol: Any) -> Scalar:
        """The node of a symbol; what it stands for is converted first."""
        if symbol not in self.values:
            self.values[symbol] = self.convert(self.waiting[symbol])
        return self.values[symbol]

    def convert(self, expression: Any) -> Scalar:
        """The node of an expression."""
        import sympy

        if expression.is_Symbol:
            return self.symbol(expression)
        if expression.is_Rational:
            return Fraction(int(expression.p), int(expression.q))
        if expression.is_Add or expression.is_Mul:
            first, *rest = [self.convert(arg) for arg in expression.args]
            for value in rest:
                first = first + value if expression.is_Add else first * value
            return first
        if expression.is_Pow and expression.exp.is_Integer:
            base = self.convert(expression.base)
            power = base
            for _ in range(abs(int(expression.exp)) - 1):
                power = power * base
            return power if expression.exp > 0 else self.graph.div(1, power)
        if expression in (sympy.zoo, sympy.nan):
            raise ZeroDivisionError("division by zero in the model")
        if isinstance(expression, sympy.Piecewise):
            (chosen, relation), (other, _) = expression.args
            condition = self.convert(relation.gts - relation.lts)
            return self.graph.select(condition, self.convert(chosen), self.convert(other))
        functions = {
            sympy.sin: "sin", sympy.cos: "cos", sympy.tanh: "tanh", sympy.sign: "sign", sympy.atan2: "atan2",
        }  # fmt: skip
        return self.graph.apply(functions[expression.func], [self.convert(arg) for arg in expression.args])
