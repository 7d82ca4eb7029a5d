"""A missing tool skips a test loudly, and in CI fails it."""

from __future__ import annotations

import shutil
import sys
from collections.abc import Callable

import pytest

from robodyn_testing import require_module, require_tool


def test_what_is_there_is_returned() -> None:
    assert require_module("sys") is sys
    assert require_tool("sh") == shutil.which("sh")


@pytest.mark.parametrize("require", [require_tool, require_module])
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
    with pytest.raises(outcome, match=r"^missing: (program|module) no_such_thing.*; .*install"):
        require("no_such_thing")
