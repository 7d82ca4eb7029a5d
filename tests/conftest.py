"""Skips loudly what a machine lacks the tools for, and ends every run with the list of it; one browser for
the tests of all pages."""

from __future__ import annotations

import gc
import json
import os
from collections.abc import Generator, Iterator
from pathlib import Path

import pytest

from robodyn_testing import wanted
from robodyn_testing.browser import browser

__all__ = ["browser"]  # a fixture for all folders

try:
    from hypothesis import HealthCheck, settings
except ModuleNotFoundError:  # then the modules of tests that use it are skipped
    pass
else:
    # The same examples everywhere, however slow the machine is: a check that fails does so for everybody.
    settings.register_profile(
        "robodyn", derandomize=True, deadline=None, suppress_health_check=[HealthCheck.too_slow]
    )
    settings.load_profile("robodyn")

# What the tests compile stays out of the user's own cache.
os.environ.setdefault("ROBODYN_CACHE", str(Path(__file__).parents[1] / ".pytest_cache" / "kernels"))


@pytest.fixture
def uncollected() -> Iterator[None]:
    """No garbage is collected while a test exhausts the stack: finalizers in Python, of what other tests have
    left, would fail there, and the test with them."""
    gc.collect()
    gc.disable()
    yield
    gc.enable()


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report(
    collector: pytest.Collector,
) -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    return (yield from wanted.skip_what_lacks_a_package(collector))


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--update", action="store_true", help="write the golden files anew (with -n0)")
    parser.addoption(
        "--except-passed",
        type=Path,
        metavar="FILE",
        help="leave out the tests that passed in another run: a copy of its .pytest_cache/v/robodyn/passed",
    )


def pytest_configure(config: pytest.Config) -> None:
    if not hasattr(config, "workerinput"):
        config.pluginmanager.register(_Recorder())


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    file = config.getoption("--except-passed")
    if file is not None:
        passed = set(json.loads(file.read_text(encoding="utf-8")))
        config.hook.pytest_deselected(items=[item for item in items if item.nodeid in passed])
        items[:] = [item for item in items if item.nodeid not in passed]


class _Recorder:
    """Notes which tests pass, for a later run's ``--except-passed``; runs where all workers report to."""

    def __init__(self) -> None:
        self.passed: set[str] = set()
        self.not_passed: set[str] = set()

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        (self.passed if report.passed else self.not_passed).add(report.nodeid)

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        cache = getattr(session.config, "cache", None)  # none with -p no:cacheprovider
        if cache is not None:
            cache.set("robodyn/passed", sorted(self.passed - self.not_passed))


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    wanted.summary(terminalreporter)
