"""Emitted crates of Rust, compiled by rustc alone and run on states from Python."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from robodyn.emit.languages.rust import crate_name, identifier
from robodyn.ir.signature import Signature
from robodyn.kernels.generate import Generated
from robodyn_testing import require_tool

STRICT: Final = ("--edition", "2021", "-D", "warnings")
#: Where Debian puts the sources of crates (librust-libm-dev).
REGISTRY: Final = Path("/usr/share/cargo/registry")
_NUMBERS: Final = {"double": "<f8", "float": "<f4"}


def write_crate(generated: Generated, folder: Path) -> Path:
    """The crate in ``folder``."""
    for name, text in generated.files(("rust",)).items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8", newline="\n")
    return folder


def rustc(*arguments: str, folder: Path, compiler: str = "rustc") -> None:
    """Run rustc, which must have nothing to say."""
    command = [require_tool(compiler), *STRICT, *arguments]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=120)
    assert (done.returncode, done.stderr) == (0, ""), done.stderr


def without_network(manifest: str) -> dict[str, str]:
    """The file that gives cargo Debian's folder of crates in place of the network, if the ``manifest`` of a
    crate has dependencies."""
    if "[dependencies]" not in manifest:
        return {}
    if not REGISTRY.is_dir():
        require_tool("librust-libm-dev")  # no program: it says what is missing
    source = f'replace-with = "debian"\n[source.debian]\ndirectory = "{REGISTRY}"\n'
    return {".cargo/config.toml": f"[source.crates-io]\n{source}"}


def _libm(folder: Path) -> tuple[str, ...]:
    """Debian's crate libm, compiled; what tells rustc where it is."""
    sources = sorted(REGISTRY.glob("libm-*/src/lib.rs"))
    if not sources:
        require_tool("librust-libm-dev")  # no program: it says what is missing
    kind = ("--crate-type", "rlib", "--crate-name", "libm", "-C", "opt-level=2", "--cap-lints", "allow")
    rustc(*kind, str(sources[-1]), folder=folder)
    return "--extern", "libm=liblibm.rlib", "-L", "."


class Crate:
    """A crate, compiled with the crate libm if it needs that, and a program that runs its functions."""

    def __init__(self, generated: Generated, folder: Path, level: str = "2") -> None:
        self.signatures = {s.function: s for s in generated.signatures}
        self.dtype = np.dtype(_NUMBERS[generated.options.scalar])
        self.folder = write_crate(generated, folder)
        name = crate_name(generated.unit.robot.name)
        optimised: tuple[str, ...] = ("-C", f"opt-level={level}")
        if "[dependencies]" in (folder / "Cargo.toml").read_text(encoding="utf-8"):
            optimised += _libm(folder)
        rustc("--crate-type", "rlib", "--crate-name", name, *optimised, "src/lib.rs", folder=folder)
        (folder / "main.rs").write_text(_driver(name, list(self.signatures.values())), encoding="utf-8")
        rustc(*optimised, "--extern", f"{name}=lib{name}.rlib", "main.rs", folder=folder)

    def run(
        self, function: str, arrays: dict[str, NDArray[Any]], parameters: dict[str, float], dt: float
    ) -> NDArray[Any]:
        """Row after row of ``arrays`` through ``function``, memory kept from one to the next."""
        signature = self.signatures[function]
        rows = np.hstack([arrays[array].astype(self.dtype) for array, _ in signature.inputs])
        head = np.array([*(parameters[name] for name in signature.parameters), dt], self.dtype)
        done = subprocess.run(
            [str(self.folder / "main"), function],
            input=head.tobytes() + np.ascontiguousarray(rows).tobytes(),
            capture_output=True,
            check=True,
            timeout=60,
        )
        return np.frombuffer(done.stdout, self.dtype).reshape(len(rows), -1)


def _driver(crate: str, signatures: list[Signature]) -> str:
    parameters = signatures[0].parameters
    arms = []
    for s in signatures:
        size = sum(length for _, length in s.inputs)
        lines = []
        place = 0
        for array, length in s.inputs:
            lines.append(
                f"let {array}: [Real; {length}] = row[{place}..{place + length}].try_into().unwrap();"
            )
            place += length
        lines += [f"let mut {array} = [0.0; {length}];" for array, length in s.outputs]
        call = [f"&{array}" for array, _ in s.inputs] + [f"&mut {array}" for array, _ in s.outputs]
        call += ["&p"] if s.parameters else []
        call += ["&mut state", "dt"] if s.states else []
        lines.append(f"{crate}::{s.symbol}({', '.join(call)});")
        lines += [f"put(&{array});" for array, _ in s.outputs]
        memory = f"let mut state = {crate}::State::default();" if s.states else ""
        arms.append(
            f'"{s.function}" => {{ {memory} for row in x.chunks_exact({size}) {{ {" ".join(lines)} }} }}'
        )
    fields = ", ".join(f"{identifier(name)}: head[{k}]" for k, name in enumerate(parameters))
    return f"""
#![allow(unused, non_snake_case)]
use std::io::{{Read, Write}};
use {crate}::Real;
fn put(values: &[Real]) {{
    for x in values {{
        std::io::stdout().write_all(&x.to_le_bytes()).unwrap();
    }}
}}
fn main() {{
    let mut bytes = Vec::new();
    std::io::stdin().read_to_end(&mut bytes).unwrap();
    let size = std::mem::size_of::<Real>();
    let number = |b: &[u8]| Real::from_le_bytes(b.try_into().unwrap());
    let all: Vec<Real> = bytes.chunks_exact(size).map(number).collect();
    let (head, x) = all.split_at({len(parameters) + 1});
    let dt = head[{len(parameters)}];
    {f"let p = {crate}::Params {{ {fields} }};" if parameters else ""}
    match std::env::args().nth(1).unwrap().as_str() {{
        {" ".join(arms)}
        _ => panic!(),
    }}
}}
"""
