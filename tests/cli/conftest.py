"""Fixtures of this folder."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest

from cli.built import PROJECT
from cli.simulated import ELASTIC, PENDULUM, SLIDE, SOFT, STICKY, WEAK
from records.made import ELBOW
from robodyn.search.walk import library


@pytest.fixture
def elsewhere(
    tmp_path: Path, tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> Path:
    """A folder of the test's own, with a cache of compiled kernels."""
    folder = tmp_path / "here"
    folder.mkdir()
    monkeypatch.chdir(folder)
    monkeypatch.setenv("ROBODYN_CACHE", str(tmp_path_factory.getbasetemp() / "robodyn-cache"))
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.delenv("FC", raising=False)
    return folder


@pytest.fixture(scope="session")
def walk_entries() -> list[Path]:
    """Where the compiled walk lies; it is compiled but once."""
    library()
    found = [path.parent for path in Path(os.environ["ROBODYN_CACHE"]).glob("*/walk.so")]
    return sorted(found, key=lambda path: path.stat().st_mtime)


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, walk_entries: list[Path]) -> Path:
    """A folder with the elbow's file, and a cache with nothing but the compiled walk."""
    folder, cache = tmp_path / "here", tmp_path / "cache"
    folder.mkdir()
    cache.mkdir(mode=0o700)
    for entry in walk_entries[-1:]:
        shutil.copytree(entry, cache / entry.name)
    (folder / "elbow.yaml").write_text(ELBOW)
    monkeypatch.chdir(folder)
    monkeypatch.setenv("ROBODYN_CACHE", str(cache))
    return folder


@pytest.fixture
def among_robots(
    tmp_path: Path, tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> Path:
    """A folder of the test's own with the robots; what is compiled is shared."""
    for text in (SLIDE, PENDULUM, STICKY, WEAK, ELASTIC, SOFT):
        (tmp_path / f"{text.split()[1]}.yaml").write_text(text)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("ROBODYN_CACHE", str(tmp_path_factory.getbasetemp() / "robodyn-cache"))
    monkeypatch.delenv("CC", raising=False)
    return tmp_path


@pytest.fixture
def project(elsewhere: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a project of two robots, and an empty store."""
    (elsewhere / "elbow.yaml").write_text(ELBOW)
    (elsewhere / "other.yaml").write_text(ELBOW.replace("elbow", "other"))
    (elsewhere / "robodyn.toml").write_text(PROJECT)
    monkeypatch.setenv("ROBODYN_CACHE", str(tmp_path / "cache"))
    return elsewhere
