"""What the tests need beyond robodyn itself: programs and packages that may not be on this machine.

On a developer's machine a missing one skips the test (or the module of tests that imports it), and the run
ends with a list of what was missing. Where the environment says ``CI=true`` a missing one is a failure: the
job that installs every tool must never pass because it quietly tested nothing.

``tests/conftest.py`` hands pytest the two hooks below.
"""

from __future__ import annotations

import importlib
import importlib.metadata
import os
import shutil
from collections import Counter
from collections.abc import Generator
from pathlib import Path
from types import ModuleType
from typing import Final, NoReturn

import pytest

__all__ = [
    "OPTIONAL",
    "PACKAGES",
    "PREFIX",
    "ROOT",
    "require_distribution",
    "require_machine",
    "require_module",
    "require_npm_package",
    "require_tool",
    "skip_what_lacks_a_package",
    "summary",
]

ROOT: Final = Path(__file__).resolve().parents[2]
"""The repository."""

PREFIX: Final = "missing: "
"""How the reason of every skip made here begins; :func:`summary` lists those skips."""

PACKAGES: Final = {"SCons": "scons", "pinocchio": "pin", "yaml": "pyyaml"}
"""PyPI's name of a module, where the two names differ."""

OPTIONAL: Final = frozenset(
    {
        "SCons",
        "build",
        "casadi",
        "cryptography",
        "distributed",
        "fmpy",
        "fpm",
        "h5py",
        "hatchling",
        "hypothesis",
        "jsonschema",
        "kconfiglib",
        "mcap",
        "mujoco",
        "ortools",
        "pinocchio",
        "platformio",
        "pyarrow",
        "rosbags",
        "selenium",
        "xacro",
    }
)
"""Modules that tests may import at their head: what the extra ``test`` of pyproject.toml brings."""


def _in_ci() -> bool:
    return os.environ.get("CI", "").lower() in {"1", "true"}


def _missing(what: str, remedy: str) -> NoReturn:
    """End the test: fail it in CI, skip it anywhere else."""
    __tracebackhide__ = True
    reason = f"{PREFIX}{what}; {remedy}"
    if _in_ci():
        pytest.fail(f"{reason} (a failure because CI is set)", pytrace=False)
    pytest.skip(reason, allow_module_level=True)


def _package_remedy(module: str) -> str:
    package = PACKAGES.get(module, module.partition(".")[0])
    return f"to run this test, pip install {package}"


def require_tool(name: str) -> str:
    """Return the path of the program `name`; without it, skip the test (fail it in CI)."""
    __tracebackhide__ = True
    path = shutil.which(name)
    if path is None:
        _missing(f"program {name}", f"to run this test, {_how_to_get(name)} (or your system's like)")
    return path


def _how_to_get(program: str) -> str:
    """The command for Debian: of the program's record, or else with a package of the same name."""
    from robodyn.doctor import known
    from robodyn.tools import Tool

    packages = (tool.debian for tool in known() if isinstance(tool, Tool) and tool.name == program)
    return f"apt install {next(filter(None, packages), program)}"


def require_module(name: str) -> ModuleType:
    """Return the module `name`, imported; without it, skip the test (fail it in CI)."""
    __tracebackhide__ = True
    try:
        return importlib.import_module(name)
    except ImportError as error:
        reason = str(error)
    _missing(f"module {name} ({reason})", _package_remedy(name))


def require_distribution(name: str) -> None:
    """Without the installed distribution `name` (data, no module), skip the test (fail it in CI)."""
    __tracebackhide__ = True
    try:
        importlib.metadata.distribution(name)
        return
    except importlib.metadata.PackageNotFoundError:
        pass
    _missing(f"distribution {name}", f"to run this test, pip install {name}")


def require_npm_package(name: str) -> Path:
    """Return the folder of npm's package `name` as `make axe` installs it; without it, skip the test (fail it
    in CI)."""
    __tracebackhide__ = True
    folder = ROOT / "build" / "npm" / "node_modules" / name
    if not (folder / "package.json").is_file():
        _missing(f"npm package {name}", "to run this test, install npm, then: make axe")
    return folder


def require_machine(present: bool, what: str) -> None:
    """Without `what`, which no package brings (a processor, a system, a right), skip the test, in CI too."""
    __tracebackhide__ = True
    if not present:
        pytest.skip(f"{PREFIX}{what}")


def skip_what_lacks_a_package(
    collector: pytest.Collector,
) -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    """Skip a module of tests whose imports lack an optional package; in CI its collection stays an error.

    A wrapper of pytest's hook ``pytest_make_collect_report``. What else cannot be imported stays an error:
    only packages of :data:`OPTIONAL` are wanted, everything else is needed.
    """
    report = yield
    call = getattr(report, "call", None)
    cause = call.excinfo.value.__cause__ if call is not None and call.excinfo is not None else None
    if report.failed and isinstance(cause, ModuleNotFoundError) and not _in_ci():
        package = (cause.name or "").partition(".")[0]
        if package in OPTIONAL:
            report.outcome = "skipped"
            reason = f"Skipped: {PREFIX}module {package}, for all of this file; {_package_remedy(package)}"
            report.longrepr = (str(collector.path), 0, reason)
    return report


def _short(file: str) -> str:
    return Path(os.path.relpath(file)).as_posix()


def summary(terminalreporter: pytest.TerminalReporter) -> None:
    """List at the end of a run what was not tested because something is missing on this machine."""
    reasons: Counter[str] = Counter()
    for report in terminalreporter.getreports("skipped"):
        if isinstance(report.longrepr, tuple):  # (file, line, "Skipped: reason")
            file, _, text = report.longrepr
            reason = text.removeprefix("Skipped: ")
            if reason.startswith(PREFIX):
                in_file = isinstance(report, pytest.CollectReport)
                reason = reason.removeprefix(PREFIX)
                reasons[f"{_short(file)}: {reason}" if in_file else reason] += 1
    if reasons:
        terminalreporter.section("NOT TESTED, for want of tools", sep="!", red=True)
        for reason, count in sorted(reasons.items()):
            terminalreporter.write_line(f"{count} skipped: {reason}")
