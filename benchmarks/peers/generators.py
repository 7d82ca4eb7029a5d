"""Have a tool write its inverse dynamics of an arm: ``python -m benchmarks.peers.generators TOOL FOLDER``.

The arm's numbers come on stdin. What is written stays in the working folder, never in the repository.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
from benchmarks.peers.textbook import casadi_function, inverse_dynamics

from robodyn.bench.peers.calls import mujoco_model
from robodyn.bench.peers.numbers import LinkNumbers, Numbers


def parsed(text: str) -> Numbers:
    """The arm that :func:`benchmarks.peers.numbers_in_c.text_of` spells."""
    rows = [[float(x) for x in line.split()] for line in text.splitlines()]
    links = []
    for r in rows[1:]:
        alpha, theta = (r[1], r[2], r[3]), (r[6], r[7], r[8])
        com, inertia = np.array(r[10:13]), np.array(r[13:22]).reshape(3, 3)
        links.append(LinkNumbers(bool(r[0]), alpha, r[4], r[5], theta, r[9], com, inertia, r[22]))
    return Numbers("arm", np.array(rows[0][1:4]), tuple(links))


def _casadi(arm: Numbers, folder: Path) -> None:
    import os

    os.chdir(folder)  # it writes where it runs
    casadi_function(arm, "casadi_sx").generate("casadi_sx.c")


def _mujoco(arm: Numbers, folder: Path) -> None:
    import mujoco

    mujoco.mj_saveModel(mujoco_model(arm), str(folder / "arm.mjb"), None)


def _symforce(arm: Numbers, folder: Path) -> None:
    import symforce

    symforce.set_epsilon_to_number()
    import symforce.symbolic as sf
    from symforce import codegen
    from symforce.values import Values

    q, qd, qdd = (sf.Matrix([[sf.Symbol(f"{name}{i}")] for i in range(arm.n)]) for name in ("q", "qd", "qdd"))
    tau = inverse_dynamics(arm, list(q), list(qd), list(qdd), sf.sin, sf.cos)
    generated = codegen.Codegen(
        inputs=Values(q=q, qd=qd, qdd=qdd),
        outputs=Values(tau=sf.Matrix([[x] for x in tau])),
        config=codegen.CppConfig(),
        name="inverse_dynamics",
        return_key="tau",
    ).generate_function(output_dir=folder / "out", skip_directory_nesting=True)
    (folder / "generated.h").write_text(Path(generated.generated_files[0]).read_text())


def _wrenfold(arm: Numbers, folder: Path) -> None:
    from typing import Annotated

    from wrenfold import code_generation, sym
    from wrenfold.type_annotations import Shape

    column = Annotated[sym.MatrixExpr, Shape(rows=arm.n, cols=1)]

    def function(q, qd, qdd):  # type: ignore[no-untyped-def]
        y, yd, ydd = ([x[i] for i in range(arm.n)] for x in (q, qd, qdd))
        tau = inverse_dynamics(arm, y, yd, ydd, sym.sin, sym.cos)
        return [code_generation.OutputArg(sym.vector(*tau), name="tau")]

    function.__annotations__ = {"q": column, "qd": column, "qdd": column}
    code = code_generation.generate_function(
        function, generator=code_generation.CppGenerator(), name="inverse_dynamics"
    )
    (folder / "generated.h").write_text(str(code))


TOOLS: dict[str, Callable[[Numbers, Path], None]] = {
    "casadi": _casadi,
    "mujoco": _mujoco,
    "symforce": _symforce,
    "wrenfold": _wrenfold,
}


if __name__ == "__main__":
    TOOLS[sys.argv[1]](parsed(sys.stdin.read()), Path(sys.argv[2]))
