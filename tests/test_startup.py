"""What a command pays for before it works: nothing is imported that it does not use."""

from __future__ import annotations

import importlib.metadata
import subprocess
import sys
from pathlib import Path

import pytest

import robodyn

HEAVY = {"numpy", "sympy", "scipy", "matplotlib", "cffi", "pycparser", "hypothesis", "pytest"}


def modules(code: str, folder: Path) -> set[str]:
    """The modules that a fresh interpreter has loaded after ``code``, run in ``folder``."""
    script = f"import sys\n{code}\nprint(*sys.modules, file=sys.stderr)"
    done = subprocess.run(
        [sys.executable, "-c", script], cwd=folder, capture_output=True, text=True, check=True
    )
    return set(done.stderr.splitlines()[-1].split())


def loaded(code: str, folder: Path) -> set[str]:
    """The top-level ones among them."""
    return {name.partition(".")[0] for name in modules(code, folder)}


def command(*arguments: str) -> str:
    return f"from robodyn_cli.main import main\nassert main({list(arguments)!r}) == 0"


def test_counting_and_writing_take_neither_numpy_nor_sympy(tmp_path: Path) -> None:
    """Nor does counting take what writes. The order in which joints of an arm of no class by name follow from
    a pose is looked for in numpy: such an arm is not among these."""
    counting = [
        command("flops", "stanford_3dof", "--functions", "all", "--budget", "total=9999"),
        command("flops", "stanford", "--json"),
    ]
    writing = [
        command("gen", "stanford_3dof", "--json"),
        command("gen", "stanford", "--scalar", "float", "--trig", "given", "--lang", "c"),
        command("gen", "tx40", "--no-regroup", "--formulation", "newton_euler"),
        command("gen", "stanford_3dof", "--check"),
    ]
    until = "assert 'jinja2' not in sys.modules"
    found = loaded("\n".join([*counting, until, *writing]), tmp_path)
    assert not found & HEAVY
    assert {"robodyn", "jinja2"} <= found
    assert list(tmp_path.rglob("*.c"))


def test_a_build_that_has_nothing_to_do_imports_nothing_to_do_it_with(tmp_path: Path) -> None:
    """Not even what reads a robot: twenty of them take no longer than the start of Python."""
    text = "[robots.stanford_3dof]\nfunctions = 'gravity'\nbudgets.gravity.total = 99\n"
    (tmp_path / "robodyn.toml").write_text(text)
    own_store = f"import os\nos.environ['ROBODYN_CACHE'] = {str(tmp_path / 'cache')!r}\n"
    first, second = (modules(own_store + command("build"), tmp_path) for _ in range(2))
    heavy = {
        "yaml",
        "jinja2",
        "robodyn.kernels.generate",
        "robodyn.robot.reader",
        "robodyn.dynamics.functions",
    }
    assert heavy <= first
    assert not second & (heavy | HEAVY)


def test_the_library_itself_is_light(tmp_path: Path) -> None:
    found = loaded("import robodyn\nrobodyn.load('stanford')\nrobodyn.program", tmp_path)
    assert not found & (HEAVY | {"click", "jinja2"})


FACADE = """
import robodyn
first = robodyn.{first}
assert callable(robodyn.generate), "robodyn.generate is the function, not the module of its name"
robot = robodyn.load("stanford_3dof")
assert robodyn.generate(robot, robodyn.Options(functions=("gravity",))).counts["gravity"].total
"""


@pytest.mark.parametrize(
    "before",
    [
        "",
        pytest.param("import robodyn.kernels.generate", marks=pytest.mark.thorough),
        pytest.param("from robodyn.kernels.generate import Options", marks=pytest.mark.thorough),
    ],
)
def test_generate_is_the_function_whatever_was_imported_before(before: str, tmp_path: Path) -> None:
    loaded(before + FACADE.format(first="compile"), tmp_path)


def test_every_name_of_the_library_is_there() -> None:
    for name in robodyn.__all__:
        assert getattr(robodyn, name).__name__.endswith(name)


@pytest.mark.thorough
def test_the_benchmark_of_generation_measures(tmp_path: Path) -> None:
    """Its figures are not looked at here: a machine that is busy with tests proves nothing."""
    script = Path(__file__).parents[1] / "benchmarks" / "generation.py"
    run = [sys.executable, str(script), "stanford_3dof", "-n", "1"]
    done = subprocess.run(run, cwd=tmp_path, capture_output=True, text=True, check=True)
    rows = [line.split("  ") for line in done.stdout.splitlines()]
    assert rows[1][0] == "robodyn gen stanford_3dof, the whole process"
    assert len(rows) == 6
    assert list(tmp_path.iterdir()) == []
    done = subprocess.run([*run, "--runs", "0"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 2


def test_the_version_is_that_of_the_installation_and_costs_no_start_up(tmp_path: Path) -> None:
    assert robodyn.__version__ == importlib.metadata.version("robodyn")
    assert "importlib.metadata" not in modules("import robodyn\nrobodyn.load", tmp_path)
    done = subprocess.run(
        [sys.executable, "-m", "robodyn", "--version"], capture_output=True, text=True, check=True
    )
    assert done.stdout == f"robodyn {robodyn.__version__}\n"


def test_completion_offers_names_that_are_imported_when_they_are_first_used(tmp_path: Path) -> None:
    code = (
        "import robodyn\nassert {'load', 'compile', 'diagnose', 'Robot', '__version__'} <= set(dir(robodyn))"
    )
    assert not loaded(code, tmp_path) & HEAVY
    assert [name for name in dir(robodyn) if not hasattr(robodyn, name)] == []
