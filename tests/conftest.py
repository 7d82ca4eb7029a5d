"""Ends every run with the list of what was not tested because something is missing on this machine."""

from __future__ import annotations

import os
from collections import Counter
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from robodyn_testing import PREFIX

# The same examples everywhere, however slow the machine is: a check that fails does so for everybody.
settings.register_profile(
    "robodyn", derandomize=True, deadline=None, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("robodyn")

# What the tests compile stays out of the user's own cache.
os.environ.setdefault("ROBODYN_CACHE", str(Path(__file__).parents[1] / ".pytest_cache" / "kernels"))


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    reasons: Counter[str] = Counter()
    for report in terminalreporter.getreports("skipped"):
        if isinstance(report.longrepr, tuple):  # (file, line, "Skipped: reason")
            reason = report.longrepr[2].removeprefix("Skipped: ")
            if reason.startswith(PREFIX):
                reasons[reason.removeprefix(PREFIX)] += 1
    if reasons:
        terminalreporter.section("NOT TESTED, for want of tools", sep="!", red=True)
        for reason, count in sorted(reasons.items()):
            terminalreporter.write_line(f"{count} skipped: {reason}")
