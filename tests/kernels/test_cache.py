"""The cache of compiled kernels: whole or absent, safe to race for, and not trusted blindly."""

from __future__ import annotations

import json
import logging
import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from typing import Any

import pytest

import robodyn
from robodyn.kernels.kernel import load
from robodyn.toolchain.cache import Cache, content_key, default_root

PACKAGES = Path(robodyn.__file__).parents[1]

CHILD = """
import json, sys
from robodyn.kernels.kernel import load
from robodyn.ir.signature import Signature
told = json.load(sys.stdin)
for s in told["signatures"]:
    s["inputs"], s["outputs"] = ([tuple(x) for x in s[k]] for k in ("inputs", "outputs"))
signatures = [Signature(**{**s, "inputs": tuple(s["inputs"]), "outputs": tuple(s["outputs"])})
              for s in told["signatures"]]
kernel = load(signatures, told["files"], mode=told["mode"])
print(json.dumps([kernel.mass_matrix([2.0, 3.0]).tolist(), kernel.mode, str(kernel.path)]))
"""


def child(
    arm: Any, environment: dict[str, str], mode: str = "api", before: str = ""
) -> subprocess.Popen[str]:
    """Another Python that loads ``arm``; it reads standard input first."""
    process = subprocess.Popen(
        [sys.executable, "-c", before + CHILD],
        env={**os.environ, "PYTHONPATH": str(PACKAGES), **environment},
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stdin is not None
    told = {"signatures": [asdict(s) for s in arm.signatures], "files": arm.files, "mode": mode}
    process.stdin.write(json.dumps(told))
    process.stdin.flush()
    return process


def answer(process: subprocess.Popen[str]) -> tuple[list[list[float]], str, str]:
    out, err = process.communicate(timeout=120)
    assert process.returncode == 0, err
    matrix, mode, path = json.loads(out)  # so nothing else was printed
    return matrix, mode, path


def build_text(folder: Path) -> str:
    (folder / "lib").write_text("finished", encoding="utf-8")
    return "lib"


def test_processes_that_race_all_get_the_same_entry(tmp_path: Path, toy: Callable[..., Any]) -> None:
    racers = [child(toy(), {"ROBODYN_CACHE": str(tmp_path)}) for _ in range(4)]
    answers = [answer(racer) for racer in racers]
    assert {json.dumps(a[0]) for a in answers} == {"[[1.0, 2.0], [3.0, 4.0]]"}
    assert len({a[2] for a in answers}) == 1
    (entry,) = tmp_path.iterdir()
    assert (entry / "entry.json").is_file()


def test_second_load_compiles_nothing(
    tmp_path: Path, toy: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    arm = toy()
    _, _, first = answer(child(arm, {"ROBODYN_CACHE": str(tmp_path)}))
    stamp = Path(first).stat().st_mtime_ns
    _, _, second = answer(child(arm, {"ROBODYN_CACHE": str(tmp_path)}))
    assert second == first
    assert Path(second).stat().st_mtime_ns == stamp


def test_no_setuptools_is_needed(tmp_path: Path, toy: Callable[..., Any]) -> None:
    block = "import sys\nfor name in ('setuptools', 'distutils'): sys.modules[name] = None\n"
    _, mode, _ = answer(child(toy(), {"ROBODYN_CACHE": str(tmp_path)}, "auto", block))
    assert mode in {"api", "abi"}


def test_a_damaged_entry_is_made_again(tmp_path: Path) -> None:
    library = Cache(tmp_path).fetch("k", build_text)
    library.write_text("fini", encoding="utf-8")
    again = Cache(tmp_path).fetch("k", build_text)
    assert again == library
    assert again.read_text(encoding="utf-8") == "finished"
    (again.parent / "entry.json").write_text("{", encoding="utf-8")
    assert Cache(tmp_path).fetch("k", build_text).read_text(encoding="utf-8") == "finished"
    assert [p.name for p in tmp_path.iterdir()] == ["k"]


def test_a_build_that_fails_leaves_nothing(tmp_path: Path) -> None:
    def half(folder: Path) -> str:
        (folder / "lib").write_text("half", encoding="utf-8")
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        Cache(tmp_path).fetch("k", half)
    assert list(tmp_path.iterdir()) == []
    assert Cache(tmp_path).fetch("k", build_text).read_text(encoding="utf-8") == "finished"


def test_the_first_to_finish_wins(tmp_path: Path) -> None:
    def slow(folder: Path) -> str:
        Cache(tmp_path).fetch("k", build_text)  # another process, meanwhile
        (folder / "lib").write_text("finished too late", encoding="utf-8")
        return "lib"

    assert Cache(tmp_path).fetch("k", slow).read_text(encoding="utf-8") == "finished"


def test_found_entry_needs_no_right_to_write(tmp_path: Path) -> None:
    Cache(tmp_path).fetch("k", build_text)

    def never(folder: Path) -> str:
        raise AssertionError(folder)

    tmp_path.chmod(0o500)
    try:
        assert Cache(tmp_path).fetch("k", never).parent.parent == tmp_path
    finally:
        tmp_path.chmod(0o700)


@pytest.mark.parametrize("mode", [0o777, 0o770])
def test_a_folder_that_others_may_write_is_not_used(
    tmp_path: Path, mode: int, caplog: pytest.LogCaptureFixture
) -> None:
    open_to_all = tmp_path / "cache"
    open_to_all.mkdir()
    open_to_all.chmod(mode)
    with caplog.at_level(logging.WARNING, "robodyn.toolchain"):
        cache = Cache(open_to_all)
    assert cache.root != open_to_all
    assert "chmod go-w" in caplog.text
    assert cache.fetch("k", build_text).read_text(encoding="utf-8") == "finished"
    assert list(open_to_all.iterdir()) == []


def test_a_folder_below_one_that_anybody_may_replace_is_not_used(tmp_path: Path) -> None:
    above = tmp_path / "above"
    (above / "cache").mkdir(parents=True)
    above.chmod(0o777)
    reason = Cache(above / "cache").reason
    assert reason is not None
    assert "anybody may write to" in reason
    above.chmod(0o1777)
    assert Cache(above / "cache").reason is None


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="missing: os.geteuid; only POSIX has it")
def test_a_folder_of_another_user_is_not_used(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    if os.geteuid() == 0:
        os.chown(tmp_path, 12345, -1)
    else:
        monkeypatch.setattr(os, "geteuid", lambda: 12345)
    reason = Cache(tmp_path).reason
    assert reason is not None
    assert "another user" in reason


def test_a_folder_that_cannot_be_made(tmp_path: Path, toy: Callable[..., Any]) -> None:
    (tmp_path / "file").write_text("", encoding="utf-8")
    cache = Cache(tmp_path / "file" / "cache")
    assert cache.reason is not None
    assert cache.fetch("k", build_text).read_text(encoding="utf-8") == "finished"
    arm = toy(name="elsewhere")
    kernel = load(arm.signatures, arm.files, cache=tmp_path / "file" / "cache")
    assert kernel.gravity([0.0, 0.0]).tolist() == [0.0, 0.0]
    assert tmp_path not in kernel.path.parents


def test_a_folder_that_became_read_only(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import tempfile

    cache = Cache(tmp_path)
    made: Callable[..., str] = tempfile.mkdtemp

    def refuse(*args: Any, **named: Any) -> str:
        if named.get("dir") == tmp_path:
            raise PermissionError(13, "Permission denied")
        return made(*args, **named)

    monkeypatch.setattr(tempfile, "mkdtemp", refuse)
    assert tmp_path not in cache.fetch("k", build_text).parents
    assert cache.reason is not None
    assert "cannot be written" in cache.reason


def test_where_the_cache_lies(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("ROBODYN_CACHE", str(tmp_path / "own"))
    assert default_root() == tmp_path / "own"
    monkeypatch.setenv("ROBODYN_CACHE", "")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "xdg"))
    assert default_root() == tmp_path / "xdg" / "robodyn"
    monkeypatch.setenv("XDG_CACHE_HOME", "relative/is/ignored")
    monkeypatch.setenv("HOME", str(tmp_path))
    assert default_root() == tmp_path / ".cache" / "robodyn"


def test_a_cache_in_the_home_of_nobody(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setenv("ROBODYN_CACHE", "~no-such-user/x")
    assert default_root() is None
    cache = Cache()
    assert "compiled kernels are not kept: ROBODYN_CACHE=~no-such-user/x" in caplog.text
    assert cache.fetch("nobody", build_text).is_file()


def test_a_relative_cache_in_a_folder_that_is_gone(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def gone() -> str:
        raise FileNotFoundError(2, "No such file or directory")

    monkeypatch.setenv("ROBODYN_CACHE", "relative")
    monkeypatch.setattr(os, "getcwd", gone)
    assert default_root() is None
    cache = Cache()
    assert "ROBODYN_CACHE=relative is relative to a folder that is gone (No such" in caplog.text
    assert cache.fetch("gone", build_text).is_file()


def test_a_new_folder_is_private(tmp_path: Path) -> None:
    Cache(tmp_path / "new").fetch("k", build_text)
    assert (tmp_path / "new").stat().st_mode & 0o777 == 0o700


def test_everything_that_matters_is_in_the_key(toy: Callable[..., Any]) -> None:
    arm, other = toy(), toy()
    other.files["toy.c"] += "/* changed */\n"
    kernels = [
        load(arm.signatures, arm.files),
        load(arm.signatures, other.files),
        load(arm.signatures, arm.files, flags="-std=c99 -O1"),
        load(arm.signatures[:2], arm.files),
        load(arm.signatures, arm.files, mode="abi"),
    ]
    assert len({k.path for k in kernels}) == len(kernels)
    assert load(arm.signatures, arm.files).path == kernels[0].path
    assert content_key({"a": 1, "b": 2}) == content_key({"b": 2, "a": 1})
