"""Fixtures of this folder."""

from __future__ import annotations

import pytest

from robodyn.thesis.tables import (
    Table,
    make,
)
from thesis.recomputed import IDS


@pytest.fixture(scope="session")
def tables() -> dict[str, Table]:
    """All tables but that of all robots, made once."""
    return {name: make(name) for name in IDS}
