"""The crate of Rust: the bits of the C, no warning, no unsafe, nothing to format."""

from __future__ import annotations

import subprocess
from pathlib import Path

import numpy as np
import pytest

from emit.crates import Crate, rustc, write_crate
from emit.kernels import ODD, in_single, made, robots
from emit.test_bits import DT, arrays, own_cache, parameters, run, same_bits
from robodyn import compile as compile_robot
from robodyn.emit.languages.rust import uses_libm
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.robot import read_text
from robodyn_testing import covering, representative, require_tool, sampled

__all__ = ["own_cache"]


def crate_of(name: str, scalar: str = "double", trig: str = "builtin") -> Generated:
    generated = made(name, trig)
    return in_single(generated) if scalar == "float" else generated


@pytest.mark.parametrize(
    ("name", "scalar"),
    covering(
        representative(["puma560", "stanford", "tool", "rubbing"], "tool", "rubbing"),
        ["double", "float"],
    ),
)
def test_rust_gives_the_bits_of_the_c(name: str, scalar: str, tmp_path: Path) -> None:
    """1,000 states a function, run-time parameters and the sign of a velocity included."""
    crate = Crate(crate_of(name, scalar), tmp_path)
    c = compile_robot(robots()[name], scalar=scalar, trig="builtin", cc=require_tool("gcc"), mode="abi")
    inputs = arrays(name)
    assert len(inputs["q"]) == 1000
    for function in c.functions:
        expected = run(c, function, inputs, name)
        found = crate.run(function, inputs, parameters(name) or {}, DT)
        assert np.isfinite(found).all()
        assert same_bits(found.reshape(expected.shape).astype(expected.dtype), expected), function


@pytest.mark.parametrize(
    ("name", "trig"), covering(sampled([*ODD, "puma560", "iiwa"], every=4), ["builtin", "libm", "given"])
)
def test_no_warning_and_nothing_to_format(name: str, trig: str, tmp_path: Path) -> None:
    """What rustc and rustfmt say; the functions of libm are those of a crate of that name."""
    rustfmt = require_tool("rustfmt")
    scalar = "float" if len(name) % 2 and name != "huge_and_tiny" else "double"
    generated = crate_of(name, scalar, trig)
    folder = write_crate(generated, tmp_path)
    extern: tuple[str, ...] = ()
    if uses_libm(generated.unit):
        assert 'libm = "0.2"' in (folder / "Cargo.toml").read_text()
        stubs = [
            f"pub fn {f}{s}(x: {t}{', _: ' + t if f == 'pow' else ''}) -> {t} {{ x }}"
            for f in ("sin", "cos", "exp", "tanh", "sqrt", "pow")
            for s, t in (("", "f64"), ("f", "f32"))
        ]
        (folder / "libm.rs").write_text("\n".join(stubs))
        rustc("--crate-type", "rlib", "--emit", "metadata", "libm.rs", folder=folder)
        extern = ("--extern", "libm=liblibm.rmeta")
    else:
        assert "libm" not in (folder / "Cargo.toml").read_text()
    rustc("--crate-type", "rlib", "--emit", "metadata", *extern, "src/lib.rs", folder=folder)
    command = [rustfmt, "--check", "--edition", "2021", "src/lib.rs"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (0, "")


@pytest.mark.parametrize("name", ["core", "std", "Arm", "crate", "move"])
def test_names_that_rust_has_itself(name: str, tmp_path: Path) -> None:
    """Of the robot, whose crate is called otherwise then, and of run-time parameters."""
    link = "{joint: revolute, mass: match, com: [r_x, sign, 0], friction: {coulomb: q}}"
    generated = generate(read_text(f"name: {name}\nlinks: [{link}]"), Options(trig="builtin"))
    crate = Crate(generated, tmp_path)
    parameters = dict.fromkeys(generated.signatures[0].parameters, 0.5)
    torques = crate.run("inverse_dynamics", {a: np.ones((1, 1)) for a in ("q", "qd", "qdd")}, parameters, DT)
    friction, inertia = 0.5, 0.5 * (0.5**2 + 0.5**2)
    np.testing.assert_allclose(torques, [[friction + inertia]])


def test_no_std_and_no_unsafe() -> None:
    text = made("puma560", "builtin").files(("rust",))["src/lib.rs"]
    assert "#![no_std]\n#![forbid(unsafe_code)]\n" in text
    assert "std::" not in text.replace("no_std", "")
