"""The kernel that moves an arm on its page: the program emitted as JavaScript, and evaluated here."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.emit.languages import language_of_browsers
from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input, Program
from robodyn.ir.signature import Signature
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]

#: What the page computes of the arm.
FUNCTIONS: Final = (
    "inverse_dynamics",
    "gravity",
    "mass_matrix",
    "link_poses",
    "forward_kinematics",
    "jacobian",
)
_NUMPY: Final = {
    "sin": np.sin, "cos": np.cos, "sqrt": np.sqrt, "tanh": np.tanh, "sign": np.sign, "abs": np.abs,
    "exp": np.exp, "pow": np.power,
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class ArmKernel:
    """The programs of :data:`FUNCTIONS` of an arm without run-time parameters, sine and cosine built in."""

    generated: Generated

    @property
    def module(self) -> str:
        """The text of the module in the language of browsers."""
        (text,) = self.generated.files((language_of_browsers().name,)).values()
        return text

    @property
    def functions(self) -> dict[str, dict[str, Any]]:
        """By function: its symbol in the module, and the lengths of its arrays."""
        return {
            s.function: {
                "symbol": s.symbol,
                "inputs": [length for _, length in s.inputs],
                "outputs": [length for _, length in s.outputs],
                "remembers": bool(s.states),
            }
            for s in self.generated.signatures
        }

    def rows(self, function: str, arrays: Mapping[str, Floats], dt: float | None = None) -> dict[str, Floats]:
        """The results of ``function`` by name [K, length] at the states ``arrays`` [K, length].

        What remembers begins at rest at the first state; from then on a state is ``dt`` [s] after the one
        before, or each at rest without it.
        """
        signature, program = next((s, p) for s, p in self.generated.unit.functions if s.function == function)
        inputs = {Input(a, i): arrays[a][:, i] for a, length in signature.inputs for i in range(length)}
        count = len(next(iter(arrays.values())))
        if not signature.states or dt is None:
            resting = {Input("state", i): np.zeros(count) for i in range(len(signature.states))}
            resting |= {Input("dt", 0): np.zeros(count)}
            columns = evaluate(program, inputs | resting, functions=_NUMPY)
            return {a: _stacked(columns[a], count) for a, _ in signature.outputs}
        return _through_time(signature, program, inputs, count, dt)


def _through_time(
    signature: Signature, program: Program, inputs: Mapping[Input, Floats], count: int, dt: float
) -> dict[str, Floats]:
    """Results of a function that remembers, state after state; the first call is one at rest."""
    memory = [0.0] * len(signature.states)
    rows: dict[str, list[list[float]]] = {a: [] for a, _ in signature.outputs}
    for k, step in [(0, 0.0), *((k, dt) for k in range(count))]:
        state = {name: float(x[k]) for name, x in inputs.items()} | {Input("dt", 0): step}
        results = evaluate(program, state | {Input("state", i): x for i, x in enumerate(memory)})
        memory = [float(x) for x in results["state"]]
        for a, elements in rows.items():
            elements.append([float(x) for x in results[a]])
    return {a: np.array(elements[1:]) for a, elements in rows.items()}


def _stacked(columns: list[Any], count: int) -> Floats:
    return np.stack([np.broadcast_to(np.asarray(x, float), (count,)) for x in columns], axis=1)


def arm_kernel(robot: Robot) -> ArmKernel:
    """The kernel of ``robot``, which has no run-time parameters, with the fewest operations known; frames of
    links are those in which joints turn about z, whatever the description's convention."""
    turning = replace(robot, standard_end=None)
    return ArmKernel(generate(turning, Options(functions=FUNCTIONS, trig="builtin")))
