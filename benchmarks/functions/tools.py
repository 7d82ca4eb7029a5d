"""The tools: each is given a function as :mod:`.natural` writes it, and says its operations and values."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.functions.counting import of_casadi, of_python
from benchmarks.functions.natural import NATURAL, Writing
from benchmarks.functions.state import Rows, State, Values
from numpy.typing import NDArray

from robodyn.bench.peers.numbers import Numbers
from robodyn.counts import Count

Floats = NDArray[np.float64]
#: What a tool has made of one way to write a function: its operations, and its values [N, m] at states
#: [3][N, n].
Result = tuple[Count, Floats]
_NAMES = ("q", "qd", "third")


def casadi(arm: Numbers, function: str, states: Floats, folder: Path) -> Iterator[Result]:
    """CasADi's SX, equal nodes merged."""
    import casadi as ca

    symbols = [ca.SX.sym(name, arm.n) for name in _NAMES]

    class SX:
        def sin(self, x: Any) -> Any:
            return ca.sin(x)

        def cos(self, x: Any) -> Any:
            return ca.cos(x)

        def jacobian(self, values: Sequence[Any], by: Sequence[Any]) -> Rows:
            return _rows(ca.jacobian(ca.vertcat(*values), ca.vertcat(*by)))

        def substituted(self, values: Sequence[Any], symbols: Sequence[Any], by: Sequence[Any]) -> Values:
            replaced = ca.substitute(ca.vertcat(*values), ca.vertcat(*symbols), ca.vertcat(*by))
            return list(ca.vertsplit(replaced))

        def solved(self, matrix: Rows, right: Rows) -> Rows:
            left, other = (ca.vertcat(*(ca.horzcat(*row) for row in rows)) for rows in (matrix, right))
            return _rows(ca.solve(ca.SX(left), ca.SX(other)))

    def _rows(matrix: Any) -> Rows:
        return [[matrix[i, j] for j in range(matrix.shape[1])] for i in range(matrix.shape[0])]

    for write in NATURAL[function]:
        values = write(State(arm, SX(), *(ca.vertsplit(x) for x in symbols)))
        if values is not None:
            traced = ca.Function("f", symbols, [ca.cse(ca.densify(ca.vertcat(*map(ca.SX, values))))])
            yield of_casadi(traced), _values_of_casadi(traced, states)


def pinocchio(arm: Numbers, function: str, states: Floats, folder: Path) -> Iterator[Result]:
    """Pinocchio's algorithms as CasADi has traced them, equal nodes merged; in ``folder`` they lie."""
    import casadi as ca

    for path in sorted(folder.glob(f"pinocchio_{function}*.casadi")):
        if path.stem.removeprefix(f"pinocchio_{function}") in ("", "_world"):
            traced = ca.Function.load(str(path))
            yield of_casadi(traced), _values_of_casadi(traced, states)


def _values_of_casadi(function: Any, states: Floats) -> Floats:
    return np.array([np.array(function(*state)).ravel() for state in states.swapaxes(0, 1)])


def symforce(arm: Numbers, function: str, states: Floats, folder: Path) -> Iterator[Result]:
    """SymForce's code generator, with Python as its language."""
    import symforce as package

    package.set_epsilon_to_number()
    import symforce.symbolic as sf
    from symforce import codegen
    from symforce.values import Values as Named

    class SymForce:
        def sin(self, x: Any) -> Any:
            return sf.sin(x)

        def cos(self, x: Any) -> Any:
            return sf.cos(x)

        def jacobian(self, values: Sequence[Any], by: Sequence[Any]) -> Rows:
            return [[sf.S(value).diff(x) for x in by] for value in values]

        def substituted(self, values: Sequence[Any], symbols: Sequence[Any], by: Sequence[Any]) -> Values:
            pairs = dict(zip(symbols, by, strict=True))
            return [sf.S(value).subs(pairs) for value in values]

        def solved(self, matrix: Rows, right: Rows) -> None:
            return None

    arrays = {name: [sf.Symbol(f"{name}{i}") for i in range(arm.n)] for name in _NAMES}
    for write in NATURAL[function]:
        values = write(State(arm, SymForce(), *arrays.values()))
        if values is None:
            continue
        with tempfile.TemporaryDirectory() as name:
            generated = codegen.Codegen(
                inputs=Named(**{key: sf.Matrix([[x] for x in symbols]) for key, symbols in arrays.items()}),
                outputs=Named(out=sf.Matrix([[x] for x in values])),
                config=codegen.PythonConfig(),
                name="f",
                return_key="out",
            ).generate_function(output_dir=Path(name), skip_directory_nesting=True)
            text = Path(generated.generated_files[0]).read_text(encoding="utf-8")
        yield of_python(text), _values_of_python(text, states)


def wrenfold(arm: Numbers, function: str, states: Floats, folder: Path) -> Iterator[Result]:
    """wrenfold's code generator, with Python as its language."""
    from typing import Annotated

    from wrenfold import code_generation, sym
    from wrenfold.type_annotations import Shape

    class Wrenfold:
        def sin(self, x: Any) -> Any:
            return sym.sin(x)

        def cos(self, x: Any) -> Any:
            return sym.cos(x)

        def jacobian(self, values: Sequence[Any], by: Sequence[Any]) -> Rows:
            matrix = sym.jacobian(sym.vector(*values), sym.vector(*by))
            return [[matrix[i, j] for j in range(len(by))] for i in range(len(values))]

        def substituted(self, values: Sequence[Any], symbols: Sequence[Any], by: Sequence[Any]) -> Values:
            fresh = [sym.symbols(f"in_place_of_{i}") for i in range(len(by))]  # one pair goes after the other
            matrix = sym.subs(sym.vector(*values), list(zip(symbols, fresh, strict=True)))
            matrix = sym.subs(matrix, list(zip(fresh, by, strict=True)))
            return [matrix[i] for i in range(len(values))]

        def solved(self, matrix: Rows, right: Rows) -> None:
            return None

    column = Annotated[sym.MatrixExpr, Shape(rows=arm.n, cols=1)]

    def emitted(write: Writing) -> str | None:
        lacking = False

        def f(q, qd, third):  # type: ignore[no-untyped-def]
            nonlocal lacking
            values = write(State(arm, Wrenfold(), *([x[i] for i in range(arm.n)] for x in (q, qd, third))))
            lacking = values is None
            return [code_generation.OutputArg(sym.vector(*(values or [sym.zero])), name="out")]

        f.__annotations__ = dict.fromkeys(_NAMES, column)
        code = code_generation.generate_function(f, generator=code_generation.PythonGenerator(), name="f")
        return None if lacking else str(code)

    for write in NATURAL[function]:
        text = emitted(write)
        if text is not None:
            yield of_python(text), _values_of_python(text, states)


def _values_of_python(text: str, states: Floats) -> Floats:
    """What the function that ``text`` defines computes: it is run, as any peer's code is that we race."""
    import math

    source = "\n".join(line for line in text.splitlines() if line.strip() != "import sym")
    names: dict[str, Any] = {"np": np, "numpy": np, "math": math}
    exec(compile(source, "generated", "exec"), names)
    return np.array([np.array(names["f"](*state)).ravel() for state in states.swapaxes(0, 1)])


TOOLS: dict[str, Callable[[Numbers, str, Floats, Path], Iterator[Result]]] = {
    "casadi": casadi,
    "symforce": symforce,
    "wrenfold": wrenfold,
    "pinocchio": pinocchio,
}
