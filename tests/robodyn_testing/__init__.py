"""What the test modules share: asking for tools that may not be on this machine.

Use it in a test, a fixture, or at the head of a test module (which then is skipped as a whole)::

    from robodyn_testing import require_module, require_tool

    gfortran = require_tool("gfortran")         # its path, a str
    pinocchio = require_module("pinocchio")     # the imported module

On a developer's machine a missing tool skips the test, and the run ends with a list of what was missing (see
``tests/conftest.py``). Where the environment says ``CI=true`` a missing tool fails the test: the job that
installs every tool must never pass because it quietly tested nothing.
"""

from __future__ import annotations

import importlib
import os
import shutil
from types import ModuleType
from typing import Final, NoReturn

import pytest

__all__ = ["require_module", "require_tool"]

PREFIX: Final = "missing: "
"""How the reason of every skip made here begins; ``tests/conftest.py`` lists those skips at the end."""

_TOOLS: Final = {
    "arm-none-eabi-gcc": "gcc-arm-none-eabi",
    "cc": "gcc",
    "chromedriver": "chromium-driver",
    "frama-c": "frama-c-base",
    "g++": "g++",
    "nm": "binutils",
}
"""Debian's package of a program, where the two names differ."""

_MODULES: Final = {"pinocchio": "pin", "yaml": "pyyaml"}
"""PyPI's name of a module, where the two names differ."""


def _missing(what: str, remedy: str) -> NoReturn:
    """End the test: fail it in CI, skip it anywhere else."""
    __tracebackhide__ = True
    reason = f"{PREFIX}{what}; {remedy}"
    if os.environ.get("CI", "").lower() in {"1", "true"}:
        pytest.fail(f"{reason} (a failure because CI is set)", pytrace=False)
    pytest.skip(reason, allow_module_level=True)


def require_tool(name: str) -> str:
    """Return the path of the program `name`; without it, skip the test (fail it in CI)."""
    __tracebackhide__ = True
    path = shutil.which(name)
    if path is None:
        package = _TOOLS.get(name, name)
        _missing(f"program {name}", f"to run this test, apt-get install {package} (or your system's like)")
    return path


def require_module(name: str) -> ModuleType:
    """Return the module `name`, imported; without it, skip the test (fail it in CI)."""
    __tracebackhide__ = True
    try:
        return importlib.import_module(name)
    except ImportError as error:
        reason = str(error)
    package = _MODULES.get(name, name.partition(".")[0])
    _missing(f"module {name} ({reason})", f"to run this test, pip install {package}")
