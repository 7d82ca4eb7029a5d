"""What commands print, write and exit with, message by message: the golden files have it."""

from __future__ import annotations

from pathlib import Path

import pytest

from robodyn_testing.golden import Session, sessions


@pytest.mark.parametrize("session", sessions(Path(__file__).parent / "golden"), ids=lambda each: each.name)
def test_commands_do_as_their_golden_files_say(
    session: Session, elsewhere: Path, pytestconfig: pytest.Config, capsys: pytest.CaptureFixture[str]
) -> None:
    session.check(elsewhere, capsys, update=pytestconfig.getoption("--update"))
