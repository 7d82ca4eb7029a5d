"""Rows of the stack's proof on machines where nothing could be measured."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from certify.test_prove import OPTIONS, PUMA, finding
from robodyn.certify import stack
from robodyn.certify.plan import subject
from robodyn_testing import require_tool


def test_machines_without_a_compiler_have_rows_like_the_others(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "path").mkdir()
    for tool in ("gcc", "as"):
        (tmp_path / "path" / tool).symlink_to(require_tool(tool))
    monkeypatch.setenv("PATH", str(tmp_path / "path"))
    host, *others = finding(stack.prove_stack, subject(PUMA, PUMA, OPTIONS), tmp_path).data["stack"]
    assert others
    assert host["bytes"] > 0
    for row in others:
        assert row.keys() == host.keys()
        assert row["function"] is row["bytes"] is None
        assert row["reason"].startswith("needs ")


def test_a_kernel_that_does_not_compile_somewhere_has_no_proof(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whatever its stack is on the other machines."""
    require_tool("gcc")
    machine = stack.machines()[0]
    broken = replace(machine, name="broken", flags=(*machine.flags, "-fno-such-flag"))
    monkeypatch.setattr(stack, "machines", lambda **_: (machine, broken))
    found = finding(stack.prove_stack, subject(PUMA, PUMA, OPTIONS), tmp_path)
    assert found.status == "failed"
    assert found.data["stack"][0].keys() == found.data["stack"][1].keys()
    assert "-fno-such-flag" in found.data["stack"][1]["reason"]
