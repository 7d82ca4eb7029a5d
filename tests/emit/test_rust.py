"""The crate of Rust: no warning, no unsafe, nothing to format, and lists of solutions."""

from __future__ import annotations

import subprocess
from pathlib import Path

import numpy as np
import pytest

from emit.crates import Crate, rustc, write_crate
from emit.kernels import ODD, in_single, made
from robodyn.emit.languages.rust import uses_libm
from robodyn.errors import InputError
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.robot import load, read_text
from robodyn_testing import covering, require_tool, sampled


def crate_of(name: str, scalar: str = "double", trig: str = "builtin") -> Generated:
    generated = made(name, trig)
    return in_single(generated) if scalar == "float" else generated


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
    torques = crate.run("inverse_dynamics", {a: np.ones((1, 1)) for a in ("q", "qd", "qdd")}, parameters, 0.0)
    friction, inertia = 0.5, 0.5 * (0.5**2 + 0.5**2)
    np.testing.assert_allclose(torques, [[friction + inertia]])


def test_no_std_and_no_unsafe() -> None:
    text = made("puma560", "builtin").files(("rust",))["src/lib.rs"]
    assert "#![no_std]\n#![forbid(unsafe_code)]\n" in text
    assert "std::" not in text.replace("no_std", "")


def test_a_parameter_that_rust_keeps_for_itself_is_refused() -> None:
    robot = read_text("name: arm\nlinks: [{joint: revolute, mass: super, com: [1, 0, 0]}]")
    with pytest.raises(InputError, match="super cannot be a name in Rust"):
        generate(robot, Options(trig="builtin")).files(("rust",))


def test_rust_lists_them_as_well(tmp_path: Path) -> None:
    generated = generate(
        load("puma560", warn=lambda _: None),
        Options(("forward_kinematics", "inverse_kinematics"), trig="builtin"),
    )
    text = next(iter(write_crate(generated, tmp_path).glob("src/*.rs"))).read_text(encoding="utf-8")
    assert (
        "pub fn inverse_kinematics(T: &[Real; 12], Q: &mut [Real; 48], flags: &mut [i32; 8]) -> i32 {" in text
    )
    (tmp_path / "libm.rs").write_text("pub fn sqrt(x: f64) -> f64 { x.sqrt() }\n", encoding="utf-8")
    rustc("--crate-type", "rlib", "--crate-name", "libm", "-o", "liblibm.rlib", "libm.rs", folder=tmp_path)
    main = """
fn main() {
    let mut T = [0.0; 12];
    puma560::forward_kinematics(&[0.1, -0.5, 0.4, 0.2, 0.9, 0.3], &mut T);
    let (mut Q, mut flags) = ([0.0; 48], [0; 8]);
    assert_eq!(puma560::inverse_kinematics(&T, &mut Q, &mut flags), 8);
    assert_eq!(flags, [3, 11, 19, 27, 35, 43, 51, 59]);
    T[3] += 5.0;
    assert_eq!(puma560::puma560_inverse_kinematics(&T, &mut Q, &mut flags), 0);
    assert!(flags.iter().all(|bits| bits % 2 == 0));
}
"""
    (tmp_path / "main.rs").write_text("#![allow(non_snake_case)]" + main, encoding="utf-8")
    known = ("--extern", "libm=liblibm.rlib", "-L", ".")
    rustc("--crate-type", "rlib", "--crate-name", "puma560", *known, "src/lib.rs", folder=tmp_path)
    rustc("--extern", "puma560=libpuma560.rlib", *known, "main.rs", "-o", "main", folder=tmp_path)
    subprocess.run([str(tmp_path / "main")], check=True)
