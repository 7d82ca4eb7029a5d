"""A search for the worst rounding error: the compiled kernel beside its program in longer numbers."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input, Program
from robodyn.ir.signature import Signature
from robodyn.optimize.prune.box import Box
from robodyn.optimize.prune.sampling import largest

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from robodyn.kernels.kernel import Kernel

    Array = NDArray[np.longdouble]

#: States drawn first.
STATES = 20_000


def worst_errors(
    program: Program, kernel: Kernel, signature: Signature, box: Box, states: int = STATES, seed: int = 1
) -> list[float] | None:
    """The worst error of the compiled ``kernel`` against ``program``, output by output, that random states of
    ``box``, half of them corners, and ascent from the worst of them find: lower bounds of the true ones.

    None where numpy's longdouble has fewer than 64 digits, which is too few to judge a double.
    """
    import numpy as np

    if signature.scalar == "double" and np.finfo(np.longdouble).nmant < 63:
        return None

    def errors(drawn: Any) -> Any:
        inputs = _arrays(drawn, box, kernel.dtype.type)
        return np.abs(_called(kernel, signature, inputs, drawn.shape[1]) - _exact(program, inputs)).astype(
            float
        )

    return [float(x) for x in largest(errors, box, seed, first=states)]


def peaks(program: Program, box: Box, seed: int = 1) -> list[float]:
    """The largest output of ``program`` in ``box``, each, that a search finds: at most the true one."""
    import numpy as np

    def sizes(drawn: Any) -> Any:
        return _exact(program, _arrays(drawn, box, np.float64)).astype(float)

    return [float(x) * (1 - 1e-9) for x in largest(sizes, box, seed)]


def _arrays(drawn: Any, box: Box, real: Any) -> dict[Input, Any]:
    return {x: _inside(row, box.interval(x), real) for x, row in zip(box.inputs, drawn, strict=True)}


def _inside(row: Any, interval: tuple[Fraction, Fraction], real: Any) -> Any:
    """``row`` rounded to the type, nothing outside the interval."""
    import numpy as np

    low, high = (_edge(limit, real, side) for limit, side in zip(interval, (1, -1), strict=True))
    return np.clip(row.astype(real), low, high)


def _edge(limit: Fraction, real: Any, side: int) -> Any:
    import numpy as np

    near = real(float(limit))
    outside = Fraction(float(near)) < limit if side > 0 else Fraction(float(near)) > limit
    return np.nextafter(near, real(side * np.inf)) if outside else near


def _called(kernel: Kernel, signature: Signature, arguments: dict[Input, Any], count: int) -> Any:
    """The kernel's outputs ``[m, N]``."""
    import numpy as np

    inputs = []
    for name, size in signature.inputs:
        array = np.zeros((count, size), kernel.dtype)
        for i in range(size):
            array[:, i] = arguments[Input(name, i)]
        inputs.append(array)
    return getattr(kernel, signature.function)(*inputs).astype(np.longdouble).T


def _exact(program: Program, inputs: dict[Input, Any]) -> Any:
    """The program's outputs ``[m, N]`` in longdouble."""
    import numpy as np

    functions = {"sin": np.sin, "cos": np.cos, "sign": np.sign, "abs": np.abs}
    wide = {x: row.astype(np.longdouble) for x, row in inputs.items()}
    count = len(next(iter(wide.values())))
    values = evaluate(program, wide, constant=_wide, functions=functions)
    rows: Sequence[Any] = [row for elements in values.values() for row in elements]
    return np.stack([np.broadcast_to(np.asarray(row, dtype=np.longdouble), (count,)) for row in rows])


def _wide(value: Fraction) -> Any:
    """``value`` with the digits of two doubles."""
    import numpy as np

    high = float(value)
    return np.longdouble(high) + np.longdouble(float(value - Fraction(high)))
