"""A project of two robots for the tests of ``robodyn build``."""

from __future__ import annotations

from pathlib import Path

from cli.generated import tree
from robodyn_cli.main import main

PROJECT = """\
[options]
functions = ["inverse_dynamics", "gravity"]
lang = "c"

[robots.one]
robot = "elbow.yaml"

[robots.two]
robot = "other.yaml"
output = "firmware/two"
scalar = "float"
"""
FILES = {
    "generated/one/elbow.h", "generated/one/elbow.c", "firmware/two/other.h", "firmware/two/other.c",
    "robodyn.lock",
}  # fmt: skip


def build(*arguments: str, code: int = 0) -> None:
    assert main(["build", "--workers", "1", *arguments]) == code


def outputs(folder: Path) -> dict[str, str]:
    """What was written, by path."""
    return {name: text for name, text in tree(folder).items() if name in FILES}
