"""A small arm written by hand, as C, in place of emitted files.

Two joints; ``tau = inertia * qdd + bend * sin(q) + q0 * qd1`` and a mass matrix that tells rows from columns.
In the variant with run-time parameters inertia and bend are read from ``NAME_params``, else they are 2 and 3.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn.ir.signature import Signature
from robodyn.kernels.kernel import Kernel, load

Scalar = Literal["double", "float"]


@dataclass(frozen=True)
class Toy:
    """Signatures and files, as an emitter hands them over."""

    signatures: tuple[Signature, ...]
    files: dict[str, str]


def make_toy(name: str = "toy", scalar: Scalar = "double", parameters: bool = False) -> Toy:
    """The arm by hand."""
    names = ("inertia", "bend") if parameters else ()
    last = f", const {name}_params *p" if parameters else ""
    state = f"const {name}_real q[2], const {name}_real qd[2], const {name}_real qdd[2]"
    prototypes = [
        f"void {name}_inverse_dynamics({state}, {name}_real tau[2]{last})",
        f"void {name}_gravity(const {name}_real q[2], {name}_real tau[2]{last})",
        f"void {name}_mass_matrix(const {name}_real q[2], {name}_real M[4]{last})",
    ]
    header = [f"#ifndef {name}_H", f"#define {name}_H", f"typedef {scalar} {name}_real;"]
    if parameters:
        header.append(f"typedef struct {{ {name}_real inertia; {name}_real bend; }} {name}_params;")
    header += [f"{prototype};" for prototype in prototypes] + ["#endif", ""]
    inertia, bend = ("p->inertia", "p->bend") if parameters else ("2", "3")
    sine = "sinf" if scalar == "float" else "sin"
    unused = "(void)p;" if parameters else ""
    source = f"""#include "{name}.h"
#include <math.h>
{prototypes[0]}
{{
    tau[0] = {inertia} * qdd[0] + {bend} * {sine}(q[0]) + q[0] * qd[1];
    tau[1] = {inertia} * qdd[1] + {bend} * {sine}(q[1]) + q[0] * qd[1];
}}
{prototypes[1]}
{{
    tau[0] = {bend} * {sine}(q[0]);
    tau[1] = {bend} * {sine}(q[1]);
}}
{prototypes[2]}
{{
    {unused}
    M[0] = 1;
    M[1] = q[0];
    M[2] = q[1];
    M[3] = 4;
}}
"""

    def signature(function: str, inputs: tuple[str, ...], output: tuple[str, int]) -> Signature:
        return Signature(name, function, tuple((i, 2) for i in inputs), (output,), names, scalar)

    signatures = (
        signature("inverse_dynamics", ("q", "qd", "qdd"), ("tau", 2)),
        signature("gravity", ("q",), ("tau", 2)),
        signature("mass_matrix", ("q",), ("M", 4)),
    )
    return Toy(signatures, {f"{name}.h": "\n".join(header), f"{name}.c": source})


@dataclass(frozen=True)
class Expected:
    """What the arm must give, in numpy; [N, 2] in, [N, ...] out."""

    inertia: float = 2.0
    bend: float = 3.0

    def inverse_dynamics(self, q: NDArray[Any], qd: NDArray[Any], qdd: NDArray[Any]) -> NDArray[np.float64]:
        coupling = q[..., :1] * qd[..., 1:]
        result: NDArray[np.float64] = self.inertia * qdd + self.bend * np.sin(q) + coupling
        return result

    def mass_matrix(self, q: NDArray[Any]) -> NDArray[np.float64]:
        M = np.empty((*q.shape[:-1], 2, 2))
        M[..., 0, 0], M[..., 0, 1], M[..., 1, 0], M[..., 1, 1] = 1, q[..., 0], q[..., 1], 4
        return M


@pytest.fixture(autouse=True)
def own_cache(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Compiled kernels of these tests stay out of the user's cache; one folder for the whole run."""
    folder = tmp_path_factory.getbasetemp() / "robodyn-cache"
    monkeypatch.setenv("ROBODYN_CACHE", str(folder))
    return folder


@pytest.fixture
def toy() -> Callable[..., Toy]:
    """:func:`make_toy`."""
    return make_toy


@pytest.fixture
def kernel(toy: Callable[..., Toy]) -> Kernel:
    """The arm with numbers."""
    arm = toy()
    return load(arm.signatures, arm.files)


@pytest.fixture
def tunable(toy: Callable[..., Toy]) -> Kernel:
    """The arm with run-time parameters."""
    arm = toy(parameters=True)
    return load(arm.signatures, arm.files)


@pytest.fixture
def expected() -> type[Expected]:
    """:class:`Expected`."""
    return Expected
