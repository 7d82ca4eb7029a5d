"""What is committed at the top of the repository: no folder that somebody's run has left there."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

from robodyn_testing import require_tool

ROOT = Path(__file__).parents[1]
#: Beside what docs/architecture.md draws: what tools look for at the top, by these names.
OF_TOOLS = frozenset(
    {
        ".ci", ".editorconfig", ".github", ".gitignore", ".pre-commit-config.yaml", ".pre-commit-hooks.yaml",
        "CHANGELOG.md", "CONTRIBUTING.md", "LICENSE", "Makefile", "NOTICE", "README.md", "action.yml",
        "mkdocs.yml", "pyproject.toml", "robodyn.lock", "robodyn.toml",
    }
)  # fmt: skip


def drawn() -> set[str]:
    """The folders at the top, as docs/architecture.md draws them."""
    text = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    return set(re.findall(r"(?m)^(\w+)/ +\S", text.split("```")[1]))


def committed() -> set[str]:
    """What git has at the top, committed or about to be (``git add``)."""
    if not (ROOT / ".git").exists():
        pytest.skip("missing: git's folder; only a checkout has it, and this is none")
    run = subprocess.run(
        [require_tool("git"), "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    if run.returncode:  # a checkout of another user, for one
        pytest.skip(f"missing: a checkout that git reads; it says: {run.stderr.strip()}")
    return {path.partition("/")[0] for path in run.stdout.split("\0") if path}


def test_only_what_is_known_lies_at_the_top() -> None:
    assert committed() - drawn() - OF_TOOLS == set()


def test_all_that_is_known_is_there() -> None:
    """A name that nothing has any more would let something else of that name pass."""
    assert drawn() | OF_TOOLS <= committed()
