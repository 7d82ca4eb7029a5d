"""Skips loudly what a machine lacks the tools for, and ends every run with the list of it; one browser for
the tests of all pages."""

from __future__ import annotations

import os
from collections.abc import Generator
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


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report(
    collector: pytest.Collector,
) -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    return (yield from wanted.skip_what_lacks_a_package(collector))


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    wanted.summary(terminalreporter)
