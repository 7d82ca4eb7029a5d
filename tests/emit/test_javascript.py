"""The module of JavaScript: the bits of the C, the operations that are counted, tests of its own."""

from __future__ import annotations

import ast
import re
import subprocess
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

from emit.kernels import made, robots
from emit.modules import Module
from emit.test_bits import DT, arrays, own_cache, parameters, run, same_bits
from robodyn import compile as compile_robot
from robodyn.counts import Count
from robodyn.firmware.language_tests import language_tests
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.robot import read_text
from robodyn_cli.main import main
from robodyn_testing import representative, require_tool, sampled

__all__ = ["own_cache"]


@pytest.mark.parametrize(
    "name", representative(["puma560", "stanford", "tool", "rubbing", "effects_remembering"], "tool")
)
def test_javascript_gives_the_bits_of_the_c(name: str, tmp_path: Path) -> None:
    """1,000 states a function; run-time parameters, the sign of a velocity and memory included. Functions of
    Math (in effects_remembering) are right to a few last bits."""
    generated = made(name, "builtin")
    module = Module(generated, tmp_path)
    c = compile_robot(robots()[name], trig="builtin", cc=require_tool("gcc"), mode="abi")
    inputs = arrays(name)
    exact = "Functions of Math" not in "".join(generated.files(("javascript",)).values())
    assert exact == (name != "effects_remembering")
    for function in c.functions:
        expected = run(c, function, inputs, name)
        results = module.run(function, inputs, parameters(name) or {}, DT).reshape(expected.shape)
        assert np.isfinite(results).all()
        if exact:
            assert same_bits(results, expected), function
        else:
            np.testing.assert_allclose(results, expected, rtol=1e-12, atol=1e-12 * np.abs(expected).max())


def test_sines_of_any_angle_have_the_bits_of_the_c(tmp_path: Path) -> None:
    """Up to where they are NaN, negative zero included; of a pendulum gravity is a multiple of the sine."""
    text = "name: arm\ngravity: [0, -1, 0]\nlinks: [{joint: revolute, mass: 1, com: [1, 1, 0]}]"
    generated = generate(read_text(text), Options(trig="builtin", functions=("gravity",)))
    rng = np.random.default_rng(4)
    angles = np.concatenate(
        [
            rng.uniform(-1, 1, 2000) * 10.0 ** rng.integers(-300, 6, 2000),
            np.arange(-400, 400) * (np.pi / 4),
            [0.0, -0.0, 411773.0, -411773.0, 1e6, -1e300, np.inf, -np.inf, np.nan],
        ]
    )
    results = Module(generated, tmp_path).run("gravity", {"q": angles[:, None]}, {}, DT)
    kernel = compile_robot(
        generated.unit.robot, trig="builtin", functions=("gravity",), cc=require_tool("gcc"), mode="abi"
    )
    expected = kernel.gravity(angles[:, None])
    np.testing.assert_array_equal(np.isnan(results), np.isnan(expected))
    assert np.isnan(results).sum() == 5
    assert same_bits(results[~np.isnan(results)], expected[~np.isnan(expected)])


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["puma560", "confusing"])
def test_math_has_its_sines_too(name: str, tmp_path: Path) -> None:
    """``--trig libm``: Math's, whose last bits are node's own."""
    module = Module(made(name, "libm"), tmp_path)
    c = compile_robot(robots()[name], cc=require_tool("gcc"), mode="abi")
    inputs = arrays(name, 50)
    for function in c.functions:
        expected = run(c, function, inputs, name)
        results = module.run(function, inputs, parameters(name) or {}, DT).reshape(expected.shape)
        np.testing.assert_allclose(results, expected, rtol=1e-9, atol=1e-11 * np.abs(expected).max())


# --- counts ---------------------------------------------------------------------------------------------

_CALLS = {"sqrt": "sqrt", "sin": "sincos", "cos": "sincos"}
_BINARY = {ast.Mult: "mul", ast.Add: "add", ast.Sub: "add", ast.Div: "div"}
_SIGN = re.compile(r"\((-?[\w.\[\]]+) > 0\.0 \? 1\.0 : \1 < 0\.0 \? -1\.0 : 0\.0\)")


def operations(text: str) -> dict[str, Count]:
    """The operations of each function: its expressions, but for signs, are expressions of Python too."""
    counts = {}
    for name, body in re.findall(r"^export function (\w+)\(.*?\) \{\n(.*?)^\}", text, re.S | re.M):
        tally: Counter[str] = Counter()
        for statement in re.sub(r"//.*", "", body).split(";"):
            if not statement.strip():
                continue
            target, _, value = " ".join(statement.split()).partition(" = ")
            assert re.fullmatch(r"(const )?[\w.\[\]]+", target), statement
            for node in ast.walk(ast.parse(_SIGN.sub(r"sign(\1)", value), mode="eval")):
                if isinstance(node, ast.BinOp):
                    tally[_BINARY[type(node.op)]] += 1
                elif isinstance(node, ast.UnaryOp):
                    tally["neg"] += not isinstance(node.operand, ast.Constant)
                elif isinstance(node, ast.Call):
                    called = node.func.attr if isinstance(node.func, ast.Attribute) else "sign"
                    tally[_CALLS.get(called, "other")] += 1
        counts[name] = Count(**tally)
    return counts


@pytest.mark.parametrize("name", sampled(list(robots()), every=20))
def test_the_text_has_the_operations_that_are_counted(name: str) -> None:
    generated = made(name, "libm")
    expected = {s.symbol: generated.counts[s.function] for s in generated.signatures}
    assert operations(text_of(generated)) == expected


def text_of(generated: Generated) -> str:
    (text,) = generated.files(("javascript",)).values()
    return text


# --- beside the kernel ----------------------------------------------------------------------------------


def write_tested(generated: Generated, folder: Path) -> None:
    for name, text in {
        **generated.files(("javascript",)),
        **language_tests(generated, ("javascript",)),
    }.items():
        (folder / name).write_text(text, encoding="ascii", newline="\n")


def node_test(folder: Path) -> subprocess.CompletedProcess[str]:
    command = [require_tool("node"), "--test"]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=120)


@pytest.mark.parametrize("name", representative(["puma560", "effects_remembering"], "effects_remembering"))
def test_its_tests_pass(name: str, tmp_path: Path) -> None:
    """With memory and run-time parameters, and functions of Math."""
    generated = made(name, "builtin")
    write_tested(generated, tmp_path)
    done = node_test(tmp_path)
    assert done.returncode == 0, done.stdout
    assert f"# pass {len(generated.counts)}" in done.stdout


def test_a_wrong_module_fails_its_tests(tmp_path: Path) -> None:
    """One constant's last digits, beyond what rounding can do."""
    write_tested(made("stanford_3dof", "builtin"), tmp_path)
    source = tmp_path / "stanford_3dof.mjs"
    head, start, rest = source.read_text().partition("export function stanford_3dof_inverse_dynamics(")
    wrong = re.sub(r"(const t\d+ = )(?=.* \* )", r"\g<1>0.99999999 * ", rest, count=1)
    assert wrong != rest
    source.write_text(head + start + wrong)
    done = node_test(tmp_path)
    assert done.returncode != 0
    assert "# fail 1" in done.stdout
    assert "is not" in done.stdout


def test_gen_writes_the_module_and_checks_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    arguments = ["gen", "stanford_3dof", "--lang", "js", "-o", str(tmp_path / "arm")]
    assert main(arguments) == 0
    assert {p.name for p in (tmp_path / "arm").iterdir()} == {"stanford_3dof.mjs", "stanford_3dof.test.mjs"}
    assert "Math." not in (tmp_path / "arm/stanford_3dof.mjs").read_text()
    assert main([*arguments, "--check"]) == 0
    assert main([*arguments, "--trig", "libm"]) == 0
    assert "Math.sin(q[1])" in (tmp_path / "arm/stanford_3dof.mjs").read_text()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--scalar", "float"], "JavaScript is not written with --scalar float; expected --scalar double"),
        (["--batch"], "batches are in C only"),
        (["--firmware"], "a firmware folder is not written in JavaScript"),
        (["--compile"], "JavaScript is written, and cannot be called from Python"),
    ],
)
def test_what_javascript_has_not_is_refused(
    options: list[str], message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = ["gen", "stanford_3dof", "--lang", "js", "-o", str(tmp_path / "arm"), *options]
    assert main(arguments) == 2
    assert message in capsys.readouterr().err
    assert not (tmp_path / "arm").exists()
