"""What a ``fleet.toml`` may not say: every refusal names the file, the place and the remedy."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from robodyn.errors import InputError
from robodyn.fleet.sources.reading import read_fleet

LOGS = "[[logs]]\nfiles = 'logs/{unit}/{date}.csv'\n"


def test_places_are_not_looked_for_without_end(tmp_path: Path) -> None:
    for text, words in (
        (f"name = {'9' * 5000}\n", "this is not TOML"),
        ("name = '''\n" + "x = 1\n" * 300 + "'''\nbad = 1\n" + LOGS, "unknown key 'bad'"),
    ):
        (tmp_path / "fleet.toml").write_text(text, encoding="utf-8")
        with pytest.raises(InputError, match=f"fleet.toml: {words}"):
            read_fleet(tmp_path)


def test_what_is_no_file_is_named(tmp_path: Path) -> None:
    (tmp_path / "fleet.toml").write_text(
        "[types.ur5]\n[[logs]]\nfiles = '{unit}_{date}.csv'\n", encoding="utf-8"
    )
    for make in (os.mkfifo, Path.mkdir, lambda path: path.symlink_to(tmp_path / "gone")):
        path = tmp_path / "7_2026-05-03.csv"
        make(path)
        with pytest.raises(InputError, match=r"7_2026-05-03\.csv: what the pattern names is .*exclude"):
            read_fleet(tmp_path)
        path.rmdir() if path.is_dir() else path.unlink()


def test_many_with_one_fault_are_counted(tmp_path: Path) -> None:
    (tmp_path / "fleet.toml").write_text(
        "[types.ur5]\n[[logs]]\nfiles = '{unit}_{date}.csv'\n", encoding="utf-8"
    )
    for k in range(9):
        (tmp_path / f"7_2026-05-3{k}.csv").touch()
    with pytest.raises(InputError, match=r"7_2026-05-32\.csv: .* and 4 more\)"):
        read_fleet(tmp_path)


def test_neither_file_nor_folder(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="there is no fleet of this name"):
        read_fleet(tmp_path / "gone")
    (tmp_path / "fleet.toml").touch()
    (tmp_path / "FLEET.toml").touch()
    with pytest.raises(InputError, match=r"FLEET\.toml, fleet\.toml"):
        read_fleet(tmp_path)


def described(folder: Path, logs: str) -> Path:
    """A fleet in ``folder`` with one log and these entries of ``logs``."""
    log = folder / "logs" / "a" / "2026-01-01.csv"
    log.parent.mkdir(parents=True)
    log.touch()
    path = folder / "fleet.toml"
    path.write_text(f"[types.ur5]\n{logs}", encoding="utf-8")
    return path


def test_a_link_that_leads_to_itself_is_no_folder(tmp_path: Path) -> None:
    fleet = described(tmp_path, LOGS)
    (tmp_path / "logs" / "self").symlink_to("self")
    assert len(read_fleet(fleet).logs) == 1
    (tmp_path / "logs" / "a" / "2026-01-02.csv").symlink_to("2026-01-02.csv")
    with pytest.raises(InputError, match=r"2026-01-02\.csv: what the pattern names is not there"):
        read_fleet(fleet)


def test_a_folder_that_cannot_be_read_may_be_left_out(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fleet = described(tmp_path, LOGS)
    (tmp_path / "logs" / "shut").mkdir()
    scandir = os.scandir

    def refusing(path: str | Path) -> object:
        if str(path).endswith("shut"):
            raise PermissionError(13, "Permission denied", path)
        return scandir(path)

    monkeypatch.setattr(os, "scandir", refusing)
    with pytest.raises(InputError, match=r"shut: the folder cannot be read.*leave it out \(exclude\)"):
        read_fleet(fleet)
    fleet.write_text(fleet.read_text(encoding="utf-8") + "exclude = 'logs/shut'\n", encoding="utf-8")
    assert len(read_fleet(fleet).logs) == 1


def test_a_log_named_with_its_folder_and_without_is_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = (tmp_path / "logs").as_posix()
    described(tmp_path, LOGS + f"[[logs]]\nfiles = '{whole}/{{unit}}/{{date}}.csv'\n")
    monkeypatch.chdir(tmp_path)
    (log,) = read_fleet("fleet.toml").logs
    assert Path(log.source) == Path("logs/a/2026-01-01.csv")


def test_an_empty_manifest_and_a_path_too_long(tmp_path: Path) -> None:
    fleet = described(tmp_path, "[[logs]]\nmanifest = 'list.csv'\n")
    (tmp_path / "list.csv").write_text("", encoding="utf-8")
    with pytest.raises(InputError, match="no column 'source'; found nothing"):
        read_fleet(fleet)
    for cell, message in (("7" * 200_000, "not CSV"), ("7" * 300, "cannot be called so")):
        (tmp_path / "list.csv").write_text(
            f"source,unit,date\nlogs/a/2026-01-01.csv,{cell},2026-01-01\n", encoding="utf-8"
        )
        with pytest.raises(InputError, match=message):
            read_fleet(fleet)
    long = "folder/" * 1000
    (tmp_path / "list.csv").write_text(f"source,unit,date\n{long},a,2026-01-01\n", encoding="utf-8")
    with pytest.raises(InputError, match=r"list\.csv:2: the log .* is not to be read") as error:
        read_fleet(fleet)
    assert len(str(error.value)) < 600
