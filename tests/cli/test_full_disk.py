"""Where the disk is full or fails while something is written: exit code 74, and nothing is left behind."""

from __future__ import annotations

import errno
import os
import re
import subprocess
from pathlib import Path

import pytest

import robodyn_cli
from cli.command import Capture, python, run
from fleet.small_fleet import NAME, write_log
from robodyn import outputs
from robodyn.errors import InputError, OutputError
from robodyn.files import cannot_write
from robodyn_testing import representative, require_module

FULL = ("ENOSPC", "EDQUOT", "EFBIG", "EIO")
WRONG = ("EACCES", "EPERM", "EROFS", "ENOTDIR", "EISDIR", "ENAMETOOLONG", "ELOOP", "ENOENT")
COMMANDS = [
    "gen stanford_3dof -o out",
    "gen stanford_3dof -o out --batch",
    "gen stanford_3dof --firmware -o out",
    "new arm -o out/arm.yaml",
    "schedule stanford_3dof -p 2 -o out",
    "schedule stanford_3dof -p 2 --picture out.svg",
    "tables 2.9 --picture out.svg",
    "simulate stanford_3dof --duration 0.01 -o out.csv",
    "simulate stanford_3dof --duration 0.01 -o out.csv --picture out.svg",
    "excite stanford_3dof --tries 1 --duration 4 -o out/motion.csv",
    "hide stanford_3dof --random 0 --duration 0.2 -o out",
]


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_whose_fault_it_is() -> None:
    for name in FULL + WRONG:
        code = getattr(errno, name)
        error = cannot_write("out/a.c", OSError(code, os.strerror(code), "out/a.c"), "make room there")
        assert isinstance(error, OutputError if name in FULL else InputError)
        assert error.exit_code == (74 if name in FULL else 2)
        assert str(error) == f"cannot write out/a.c: {os.strerror(code)}; make room there"


def full_after(monkeypatch: pytest.MonkeyPatch, files: int, code: int) -> None:
    """Let so many of the files that a command writes go well, and the next one half."""
    create = outputs._create
    written: list[Path] = []

    def write(path: Path, content: bytes) -> None:
        if len(written) == files:
            create(path, content[: len(content) // 2])
            raise OSError(code, os.strerror(code), str(path))
        written.append(path)
        create(path, content)

    monkeypatch.setattr(outputs, "_create", write)


@pytest.mark.parametrize("command", representative(COMMANDS, *COMMANDS[:2], *COMMANDS[3:6], COMMANDS[7]))
def test_every_command_that_writes(
    command: str, here: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    full_after(monkeypatch, 0, errno.ENOSPC)
    _, err = run(capsys, command, code=74)
    said = re.escape(os.strerror(errno.ENOSPC))
    assert re.search(rf"robodyn: error: cannot write out\S*: {said}; [^\n]*free some space there\n\Z", err)
    assert list(here.iterdir()) == []


def test_a_disk_that_is_full_on_the_way(here: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture) -> None:
    """The second file does not fit: the first is not there either, and what was there stays."""
    (here / "arm.yaml").write_text("precious")
    full_after(monkeypatch, 1, errno.EIO)
    run(capsys, "gen stanford_3dof -o new/folder", code=74)
    full_after(monkeypatch, 0, errno.EDQUOT)
    run(capsys, "new arm --force", code=74)
    assert [path.name for path in here.iterdir()] == ["arm.yaml"]
    assert Path("arm.yaml").read_text() == "precious"


def limited(command: str, size: int) -> subprocess.CompletedProcess[str]:
    """A process of its own whose files may have so many bytes; Python lets that be an error (EFBIG)."""
    begin = f"import resource, sys; resource.setrlimit(resource.RLIMIT_FSIZE, ({size}, {size}))"
    end = "from robodyn_cli.main import main; sys.exit(main(sys.argv[1:]))"
    return python("-B", "-c", f"{begin}; {end}", *command.split())


def test_a_limit_of_the_system(here: Path) -> None:
    require_module("resource")
    done = limited("gen stanford_3dof -o out", 1000)
    assert (done.returncode, done.stdout) == (74, ""), done.stderr
    assert done.stderr.startswith("robodyn: error: cannot write out/")
    assert "File too large" in done.stderr
    assert list(here.iterdir()) == []
    assert limited("gen stanford_3dof -o out", 1 << 20).returncode == 0


@pytest.mark.parametrize(
    "size", [pytest.param(3_000, marks=pytest.mark.thorough), pytest.param(30_000, marks=pytest.mark.slow)]
)
def test_a_fleet_goes_on_when_there_is_room_again(size: int, here: Path) -> None:
    """Where there is no room for results, and where there is none for pages."""
    require_module("resource")
    for unit in range(2):
        log = here / "plant" / NAME / f"unit {unit}" / "2025-01-03.csv"
        log.parent.mkdir(parents=True)
        write_log(log, unit)
    command = "fleet plant -o out --on here --diagnose none --no-parquet"
    done = limited(command, size)
    assert (done.returncode, done.stdout) == (74, ""), done.stderr
    assert re.search(
        r"robodyn: error: (out/store.sqlite: results cannot be kept|cannot write out/)", done.stderr
    )
    assert not (here / "out" / "index.html").exists()
    assert not list(here.rglob(".robodyn.*"))
    done = limited(command, 1 << 24)
    assert done.returncode == 0, done.stderr
    assert (here / "out" / "index.html").is_file()


def test_a_place_that_is_wrong_is_bad_input(capsys: Capture) -> None:
    Path("file").write_text("")
    for place in ("file/out", "x" * 300, "/proc/robodyn"):
        _, err = run(capsys, f"gen stanford_3dof -o {place}", code=2)
        assert err.startswith("robodyn: error: "), place
    assert [path.name for path in Path().iterdir()] == ["file"]


def test_one_place_writes_for_all_commands() -> None:
    """So that one place decides whose fault it is."""
    folder = Path(robodyn_cli.__file__).parent
    writes = re.compile(r"write_text|write_bytes|savefig|\.open\(\s*[\"'][wax]|open\([^)]*[\"'][wax]b?[\"']")
    found = {path.name for path in folder.glob("*.py") if writes.search(path.read_text(encoding="utf-8"))}
    assert found <= {"common.py", "main.py"}
