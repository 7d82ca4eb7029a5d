"""`cargo test` in the emitted crate: its vectors pass, and a crate that is wrong fails them."""

from __future__ import annotations

import itertools
import os
import subprocess
from pathlib import Path

import pytest

from emit.crates import rustc, without_network
from emit.kernels import in_single, made
from robodyn.errors import InputError
from robodyn.firmware.language_tests import language_tests
from robodyn.kernels.generate import Generated
from robodyn_cli.main import main
from robodyn_testing import representative, require_tool


def write_tested(generated: Generated, folder: Path) -> Path:
    """The crate with its tests, and Debian's folder of crates in place of the network."""
    files = {**generated.files(("rust",)), **language_tests(generated, ("rust",))}
    files |= without_network(files["Cargo.toml"])
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8", newline="\n")
    return folder


def cargo_test(folder: Path) -> subprocess.CompletedProcess[str]:
    command = [require_tool("cargo"), "test", "--offline", "--quiet"]
    environment = {**os.environ, "RUSTFLAGS": "-D warnings", "CARGO_TARGET_DIR": str(folder / "target")}
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=300)


@pytest.mark.parametrize(
    ("name", "scalar"),
    representative(
        itertools.product(["puma560", "effects_remembering", "effects_smooth"], ["double", "float"]),
        ("puma560", "double"),
        ("effects_remembering", "float"),
    ),
)
def test_the_tests_of_a_crate_pass(name: str, scalar: str, tmp_path: Path) -> None:
    """Rigid, with memory and run-time parameters, with functions of libm."""
    generated = made(name, "builtin")
    generated = in_single(generated) if scalar == "float" else generated
    folder = write_tested(generated, tmp_path)
    done = cargo_test(folder)
    assert done.returncode == 0, done.stdout + done.stderr
    text = (folder / "tests/vectors.rs").read_text()
    assert [f for f in generated.counts if f"fn {f}_is_right()" not in text] == []
    assert text.count("check(") > 8 * len(generated.counts)
    command = [require_tool("rustfmt"), "--check", "--edition", "2021", "tests/vectors.rs"]
    assert subprocess.run(command, cwd=folder, capture_output=True, text=True).stdout == ""


def test_a_wrong_crate_fails_its_tests(tmp_path: Path) -> None:
    """One constant's last digits, beyond what rounding can do."""
    folder = write_tested(made("stanford_3dof", "builtin"), tmp_path)
    source = folder / "src/lib.rs"
    lines = source.read_text().splitlines(keepends=True)
    start = next(k for k, line in enumerate(lines) if line.startswith("pub fn inverse_dynamics("))
    place = next(k for k in range(start, len(lines)) if " * " in lines[k] and "let t" in lines[k])
    lines[place] = lines[place].replace(" = ", " = 0.99999999 * ", 1)
    source.write_text("".join(lines))
    done = cargo_test(folder)
    assert done.returncode != 0
    assert "inverse_dynamics_is_right" in done.stdout
    assert "is not" in done.stdout


def test_gen_writes_the_crate_and_checks_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Sines are built in unless --trig says otherwise, in every language that is asked for with Rust."""
    arguments = ["gen", "stanford_3dof", "--lang", "c,rs", "-o", str(tmp_path / "arm")]
    assert main(arguments) == 0
    names = {str(p.relative_to(tmp_path / "arm")) for p in (tmp_path / "arm").rglob("*") if p.is_file()}
    assert names == {"stanford_3dof.c", "stanford_3dof.h", "Cargo.toml", "src/lib.rs", "tests/vectors.rs"}
    assert "libm" not in (tmp_path / "arm/Cargo.toml").read_text()
    assert "<math.h>" not in (tmp_path / "arm/stanford_3dof.c").read_text()
    assert main([*arguments, "--check"]) == 0
    with (tmp_path / "arm/tests/vectors.rs").open("a") as file:
        file.write("// edited\n")
    assert main([*arguments, "--check"]) == 1
    assert main([*arguments, "--trig", "libm"]) == 0
    assert 'libm = "0.2"' in (tmp_path / "arm/Cargo.toml").read_text()
    assert "<math.h>" in (tmp_path / "arm/stanford_3dof.c").read_text()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--batch"], "batches are in C only"),
        (["--misra"], "MISRA C:2012 is in C only"),
        (["--firmware"], "a firmware folder is not written in Rust"),
        (["--compile"], "cannot be called from Python"),
    ],
)
def test_what_rust_has_not_is_refused(
    options: list[str], message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = ["gen", "stanford_3dof", "--lang", "rust", "-o", str(tmp_path / "arm"), *options]
    assert main(arguments) == 2
    assert message in capsys.readouterr().err
    assert not (tmp_path / "arm").exists()


def test_a_parameter_that_rust_keeps_for_itself_is_refused() -> None:
    from robodyn.kernels.generate import Options, generate
    from robodyn.robot import read_text

    robot = read_text("name: arm\nlinks: [{joint: revolute, mass: super, com: [1, 0, 0]}]")
    with pytest.raises(InputError, match="super cannot be a name in Rust"):
        generate(robot, Options(trig="builtin")).files(("rust",))


@pytest.mark.thorough
@pytest.mark.parametrize("scalar", ["double", "float"])
def test_a_crate_is_compiled_for_a_cortex_m(scalar: str, cortex_m: Path, tmp_path: Path) -> None:
    """With the core library for it, compiled from Debian's source: nothing but arithmetic is called."""
    generated = made("puma560", "builtin")
    generated = in_single(generated) if scalar == "float" else generated
    folder = write_tested(generated, tmp_path)
    options = ("--crate-type", "rlib", "--crate-name", "puma560", "-C", "opt-level=2", "-C", "panic=abort")
    found = ("--extern", f"core={cortex_m / 'libcore.rlib'}", "-L", str(cortex_m))
    arguments = ("--target", TARGET, *options, *found, "--emit", "obj", "-o", "arm.o", "src/lib.rs")
    rustc(*arguments, folder=folder, compiler=DEBIANS)
    command = [require_tool("arm-none-eabi-nm"), "arm.o"]
    symbols = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True).stdout
    for function in generated.counts:
        assert function in symbols
    called = {line.split()[-1] for line in symbols.splitlines() if " U " in line}
    assert all(name.startswith("__aeabi_") for name in called), called
    assert bool(called) == (scalar == "double")  # this processor computes in float by itself


TARGET = "thumbv7em-none-eabihf"
#: The compiler whose source rust-src is; another may come before it on the PATH.
DEBIANS = "/usr/bin/rustc"


@pytest.fixture(scope="module")
def cortex_m(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The core library for a Cortex-M4F, compiled from rust-src, whose version must be the compiler's."""
    core = sorted(Path("/usr/src").glob("rustc-*/library/core/src/lib.rs"))
    if not core or not Path(DEBIANS).exists():
        require_tool("rust-src")
    folder = tmp_path_factory.mktemp("core")
    (folder / "none.rs").write_text(
        "#![feature(compiler_builtins, no_core)]\n#![compiler_builtins]\n#![no_core]\n"
    )
    environment = {**os.environ, "RUSTC_BOOTSTRAP": "1"}
    for name, source in (("compiler_builtins", folder / "none.rs"), ("core", core[-1])):
        command = [DEBIANS, "--edition", "2021", "--crate-type", "rlib", "--crate-name", name]
        command += ["--target", TARGET, "-O", "-A", "warnings", str(source)]
        subprocess.run(command, cwd=folder, env=environment, check=True, capture_output=True, timeout=600)
    return folder
