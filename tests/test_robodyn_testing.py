"""What is missing skips tests loudly, and in CI fails them; which cases stay in ``make test``."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tomllib
from collections.abc import Callable
from pathlib import Path

import pytest

from robodyn_testing import (
    commit_seeds,
    covering,
    representative,
    require_machine,
    require_module,
    require_npm_package,
    require_tool,
    sampled,
    seeds,
    wanted,
)

TESTS = Path(__file__).parent
HIDING = """
import sys
import pytest

class Hiding:
    @staticmethod
    @pytest.hookimpl(tryfirst=True)
    def pytest_load_initial_conftests():  # when pytest has put its own finder in place
        sys.modules.update(dict.fromkeys({packages}))  # None: cannot be imported

sys.exit(pytest.main(sys.argv[1:], plugins=[Hiding]))
"""


def test_what_is_there_is_returned() -> None:
    assert require_module("sys") is sys
    assert require_tool("sh") == shutil.which("sh")


@pytest.mark.parametrize("require", [require_tool, require_module, require_npm_package])
@pytest.mark.parametrize(
    ("ci", "outcome"),
    [(None, pytest.skip.Exception), ("", pytest.skip.Exception), ("true", pytest.fail.Exception)],
)
def test_what_is_missing_is_named(
    require: Callable[[str], object],
    ci: str | None,
    outcome: type[BaseException],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.delenv("CI", raising=False)
    if ci is not None:
        monkeypatch.setenv("CI", ci)
    with pytest.raises(outcome, match=r"^missing: (program|module|npm package) no_such_thing.*; .*install"):
        require("no_such_thing")


@pytest.mark.parametrize("ci", ["", "true"])
def test_what_no_package_brings_is_named_and_no_failure(ci: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CI", ci)
    require_machine(True, "a processor")
    with pytest.raises(pytest.skip.Exception, match=r"^missing: a processor with three sines$"):
        require_machine(False, "a processor with three sines")


def test_seeds_turn_with_the_commit_or_start_where_they_are_told(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.delenv(seeds.REPEAT, raising=False)
    drawn = [*commit_seeds(3)]
    assert drawn == [*commit_seeds(3)] == [*range(drawn[0], drawn[0] + 3)]
    monkeypatch.setenv(seeds.REPEAT, "7")
    capsys.readouterr()
    assert [*commit_seeds(2)] == [7, 8]
    assert capsys.readouterr().out.splitlines()[-1] == "seed 8 (ROBODYN_SEED=8 starts with it)"


def test_seeds_need_no_git(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(seeds.REPEAT, raising=False)
    monkeypatch.setenv("PATH", "")
    seeds._of_commit.cache_clear()
    try:
        assert next(commit_seeds(1)) == seeds.WITHOUT_GIT
    finally:
        seeds._of_commit.cache_clear()


# --- collecting on a machine that lacks packages ------------------------------------------------------------


def collected(paths: list[Path], packages: frozenset[str], ci: str = "") -> subprocess.CompletedProcess[str]:
    """Collect tests in a process that cannot import `packages`."""
    program = HIDING.format(packages=sorted(packages))
    options = ["-p", "no:cacheprovider", "-p", "no:hypothesispytest", "--collect-only", "-q", "-m", ""]
    return subprocess.run(
        [
            sys.executable,
            "-c",
            program,
            *options,
            "-c",
            str(TESTS.parent / "pyproject.toml"),
            *map(str, paths),
        ],
        cwd=TESTS.parent,
        env={**os.environ, "CI": ci, "PYTEST_ADDOPTS": "", "PYTHONDONTWRITEBYTECODE": "1"},
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.fixture
def small_suite(tmp_path: Path) -> Path:
    """One test that needs nothing, and one for each optional package, beside the suite's own conftest."""
    (tmp_path / "conftest.py").write_text((TESTS / "conftest.py").read_text(encoding="utf-8"))
    (tmp_path / "test_plain.py").write_text("def test_plain() -> None: ...\n")
    for package in wanted.OPTIONAL:
        text = f"import {package}\n\n\ndef test_with_{package}() -> None: ...\n"
        (tmp_path / f"test_with_{package}.py").write_text(text)
    return tmp_path


def test_missing_packages_skip_what_imports_them(small_suite: Path) -> None:
    run = collected([small_suite], wanted.OPTIONAL)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "test_plain.py::test_plain" in run.stdout
    assert "::test_with_" not in run.stdout
    for package in wanted.OPTIONAL:
        assert f"test_with_{package}.py: module {package}, for all of this file; to run this" in run.stdout


@pytest.mark.thorough
def test_missing_packages_fail_in_ci(small_suite: Path) -> None:
    run = collected([small_suite], wanted.OPTIONAL, ci="true")
    assert run.returncode != 0
    for package in wanted.OPTIONAL:
        assert f"ModuleNotFoundError: import of {package} halted" in run.stdout, run.stdout


@pytest.mark.thorough
def test_what_nobody_offers_is_no_skip(small_suite: Path) -> None:
    """A typing error in an import, or a file of the tests that is gone, is an error on every machine."""
    (small_suite / "test_misspelt.py").write_text("import hypothesys\n")
    run = collected([small_suite / "test_misspelt.py"], frozenset())
    assert run.returncode != 0
    assert "No module named 'hypothesys'" in run.stdout


@pytest.mark.slow
def test_the_whole_suite_is_collected_without_optional_packages() -> None:
    run = collected([TESTS], wanted.OPTIONAL)
    assert run.returncode == 0, run.stdout[-3000:] + run.stderr[-3000:]
    files = {line.partition("::")[0] for line in run.stdout.splitlines() if "::" in line}
    skipped = set(re.findall(r"\d skipped: (\S+): module", run.stdout))
    assert files | skipped == {str(path.relative_to(TESTS.parent)) for path in TESTS.rglob("test_*.py")}
    assert len(files) > 3 * len(skipped) > 0


def test_optional_packages_are_those_of_the_extra() -> None:
    project = tomllib.loads((TESTS.parent / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    extra = {line.split(">")[0] for line in project["optional-dependencies"]["test"]}
    packages = {wanted.PACKAGES.get(module, module) for module in wanted.OPTIONAL}
    assert packages == extra - {"pytest", "pytest-xdist"}


# --- representative cases -----------------------------------------------------------------------------------


def test_all_cases_but_a_few_are_thorough() -> None:
    cases = representative([("ur5", 1), ("tx40", 2), pytest.param("panda", 3, id="long")], "ur5", "long")
    assert [case.values for case in cases] == [("ur5", 1), ("tx40", 2), ("panda", 3)]
    assert [[mark.name for mark in case.marks] for case in cases] == [[], ["thorough"], []]
    assert [case.id for case in cases] == [None, None, "long"]


def test_a_case_may_be_chosen_as_a_whole() -> None:
    cases = representative([("ur5", 1), ("ur5", 2)], ("ur5", 2))
    assert [[mark.name for mark in case.marks] for case in cases] == [["thorough"], []]
    assert [bool(case.marks) for case in representative(range(4), 0, 3)] == [False, True, True, False]


def test_one_of_so_many_stays() -> None:
    cases = sampled([("a", 1), "b", "c", pytest.param("d", marks=pytest.mark.slow)], every=2)
    assert [case.values for case in cases] == [("a", 1), ("b",), ("c",), ("d",)]
    names = [[mark.name for mark in case.marks] for case in cases]
    assert names == [[], ["thorough"], [], ["slow", "thorough"]]


def test_the_few_of_a_product_have_every_value() -> None:
    cases = covering(representative("abcd", "a", "b", "d"), [1, 2], [("x", "y")])
    assert [case.values for case in cases] == [(a, b, "x", "y") for a in "abcd" for b in (1, 2)]
    few = {case.values[:2] for case in cases if not case.marks}
    assert few == {("a", 1), ("b", 2), ("d", 1)}
    assert {mark.name for case in cases for mark in case.marks} == {"thorough"}


def test_a_case_that_is_not_there_is_refused() -> None:
    with pytest.raises(ValueError, match="no such case: 'ur6'"):
        representative(["ur5", "ur10"], "ur5", "ur6")
