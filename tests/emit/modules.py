"""Emitted modules of JavaScript, run by node on states from Python."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.kernels.generate import Generated
from robodyn_testing import require_tool

#: Numbers go in and out as bits: -0 is not 0, and no digit is lost.
_MAIN = """
import {{ readFileSync, writeSync }} from "node:fs";
import * as arm from "./{name}.mjs";
const bytes = readFileSync(0);
const all = new Float64Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
const p = Object.fromEntries((arm.parameters ?? []).map((name, k) => [name, all[k]]));
const dt = all[{parameters}];
const [run, inputs, outputs] = {{ {functions} }}[process.argv[2]];
const given = {parameters} ? [p] : [];
const state = run.length > inputs.length + outputs.length + given.length ? arm.initial_state() : null;
const rest = state ? [...given, state] : given;
let at = {parameters} + 1;
const results = [];
for (let first = true; at < all.length; first = false) {{
    const rows = inputs.map((size) => all.subarray(at, (at += size)));
    const written = outputs.map((size) => new Float64Array(size));
    if (state && first) run(...rows, ...written, ...rest, 0.0);
    run(...rows, ...written, ...rest, ...(state ? [dt] : []));
    for (const array of written) results.push(...array);
}}
let left = new Uint8Array(new Float64Array(results).buffer);
while (left.length) left = left.subarray(writeSync(1, left));
"""


class Module:
    """A module in ``folder`` and a program that runs its functions."""

    def __init__(self, generated: Generated, folder: Path) -> None:
        self.node = require_tool("node")
        self.folder = folder
        self.signatures = {s.function: s for s in generated.signatures}
        for name, text in generated.files(("javascript",)).items():
            (folder / name).write_text(text, encoding="ascii", newline="\n")
        functions = ", ".join(
            f"{s.function}: [arm.{s.symbol}, {[n for _, n in s.inputs]}, {[n for _, n in s.outputs]}]"
            for s in generated.signatures
        )
        robot = generated.unit.robot
        main = _MAIN.format(name=robot.name, parameters=len(robot.parameters), functions=functions)
        (folder / "main.mjs").write_text(main, encoding="ascii")

    def run(
        self, function: str, arrays: dict[str, NDArray[Any]], parameters: dict[str, float], dt: float
    ) -> NDArray[np.float64]:
        """Row after row of ``arrays`` through ``function``, memory kept from one to the next."""
        signature = self.signatures[function]
        rows = np.hstack([arrays[array] for array, _ in signature.inputs])
        head = np.array([*(parameters[name] for name in signature.parameters), dt])
        done = subprocess.run(
            [self.node, "main.mjs", function],
            cwd=self.folder,
            input=head.tobytes() + np.ascontiguousarray(rows).tobytes(),
            capture_output=True,
            timeout=60,
        )
        assert (done.returncode, done.stderr) == (0, b""), done.stderr.decode()
        return np.frombuffer(done.stdout).reshape(len(rows), -1)
