"""What is missing skips tests loudly, and in CI fails them; which cases stay in ``make test``."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tomllib
from collections.abc import Callable
from pathlib import Path

import pytest

from robodyn_testing import (
    require_module,
    require_npm_package,
    require_tool,
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
