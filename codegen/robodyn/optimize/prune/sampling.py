"""Torques at many states at once, and the largest that can be found; numpy comes when it is called."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input, Program
from robodyn.optimize.prune.box import Box

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

#: States looked at before the best of them are improved, and how many of them for each output.
_FIRST, _STARTS = 4096, 6
#: Rounds of coordinate ascent: each looks half as far as the one before.
_ROUNDS = 14


def functions() -> dict[str, Callable[[Any], Any]]:
    """The functions of a program over arrays."""
    import numpy as np

    return {"sin": np.sin, "cos": np.cos, "sqrt": np.sqrt, "tanh": np.tanh, "sign": np.sign}


def values(program: Program, box: Box, states: Floats) -> Floats:
    """Outputs ``[m, N]`` of ``program`` at ``states`` ``[d, N]``, in the order of ``box.inputs``."""
    import numpy as np

    inputs: dict[Input, Floats] = dict(zip(box.inputs, states, strict=True))
    outputs = evaluate(program, inputs, functions=functions())
    rows = [row for elements in outputs.values() for row in elements]
    return np.stack([np.broadcast_to(np.asarray(row, dtype=np.float64), states.shape[1:]) for row in rows])


def draw(box: Box, count: int, seed: int) -> Floats:
    """``count`` states ``[d, N]`` of the box. In every other one all but the angles are at one of their
    limits: torques are largest there."""
    import numpy as np

    random = np.random.RandomState(seed)  # its stream is the same in every version of numpy
    low, high = edges(box)
    share = random.random_sample((count, len(low)))
    angles = len(box.angles)
    share[::2, angles:] = np.round(share[::2, angles:])
    drawn: Floats = np.ascontiguousarray((low + (high - low) * share).T)
    return drawn


def edges(box: Box) -> tuple[Floats, Floats]:
    """The smallest and largest values of the inputs, rounded to double inwards."""
    import numpy as np

    low = np.array([float(box.interval(x)[0]) for x in box.inputs])
    high = np.array([float(box.interval(x)[1]) for x in box.inputs])
    return low, high


def largest(of: Callable[[Floats], Floats], box: Box, seed: int, first: int = _FIRST) -> Floats:
    """The largest sizes ``[m]`` of the outputs of ``of`` (states ``[d, N]`` to ``[m, N]``) that random states
    and coordinate ascent from the best of them find: lower bounds of the true ones."""
    import numpy as np

    states = draw(box, first, seed)
    magnitudes = np.abs(of(states))
    outputs = len(magnitudes)
    low, high = edges(box)
    starts = np.argsort(-magnitudes, axis=1, kind="stable")[:, :_STARTS]
    here = states[:, starts.ravel()]  # [d, outputs * starts]
    own = np.repeat(np.arange(outputs), starts.shape[1])
    best = magnitudes[own, starts.ravel()]
    steps = np.linspace(-1.0, 1.0, 9)
    for k in range(_ROUNDS):
        for d in range(len(low)):
            if low[d] == high[d]:
                continue
            width = (high[d] - low[d]) * 0.5**k
            tried = np.clip(here[d][:, None] + width * steps, low[d], high[d])  # [starts, 9]
            many = np.repeat(here, len(steps), axis=1)
            many[d] = tried.ravel()
            sizes = np.abs(of(many))[np.repeat(own, len(steps)), np.arange(many.shape[1])].reshape(
                tried.shape
            )
            pick = np.argmax(sizes, axis=1)
            gain = sizes[np.arange(len(own)), pick]
            better = gain > best
            here[d] = np.where(better, tried[np.arange(len(own)), pick], here[d])
            best = np.maximum(best, gain)
    peaks: Floats = np.maximum(magnitudes.max(axis=1), best.reshape(outputs, -1).max(axis=1))
    return peaks
