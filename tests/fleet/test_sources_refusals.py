"""What a ``fleet.toml`` may not say: every refusal names the file, the place and the remedy."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from robodyn.errors import InputError
from robodyn.fleet.sources.reading import read_fleet

LOGS = "[[logs]]\nfiles = 'logs/{unit}/{date}.csv'\n"


@pytest.mark.parametrize(
    ("text", "where", "words"),
    [
        ("nmae = 'x'\n", "1:1", "did you mean 'name'?"),
        ("[types.ur5]\n", "", "nothing says where the logs are"),
        (LOGS, "", "the fleet has no types"),
        ("types = 3\n" + LOGS, "1:1", "types is not a table"),
        ("[types]\nur5 = 3\n" + LOGS, "2:1", "ur5 is not a table"),
        ("[types.ur55]\n" + LOGS, "1:1", "did you mean 'ur5'?"),
        ("[types.ur5]\nrobbot = 'a'\n" + LOGS, "2:1", "did you mean 'robot'?"),
        ("[types.ur5]\nmap = 'no.yaml'\n" + LOGS, "2:1", "there is no such map"),
        ("[types.ur5]\ncolumns = 'q'\n" + LOGS, "2:1", "a group of columns has no name"),
        ("[types.ur5]\nparameters = {m = 'x'}\n" + LOGS, "2:1", "m is not a number"),
        ("[types.ur5]\nparameters = {m = 1}\n" + LOGS, "2:1", "m"),
        ("[types.ur5]\nlogs = 3\n", "2:1", "unknown key 'logs'"),
        ("[types.ur5]\n[[logs]]\n", "2:1", "names none"),
        ("[types.ur5]\n[[logs]]\nfiles = 'a'\nmanifest = 'b'\n", "2:1", "both"),
        ("[types.ur5]\n[[logs]]\nfile = 'a'\n", "3:1", "did you mean 'files'?"),
        ("[types.ur5]\n[[logs]]\nfiles = ''\n", "3:1", "files is not a pattern of paths"),
        ("[types.ur5]\n[[logs]]\nfiles = '{unit'\n", "3:1", "no end"),
        ("[types.ur5]\n[[logs]]\nfiles = '{unit/x}.csv'\n", "3:1", "within one part"),
        ("[types.ur5]\n[[logs]]\nfiles = '{unit:x}.csv'\n", "3:1", "no field"),
        ("[types.ur5]\n[[logs]]\nfiles = '**'\n", "3:1", "ends in no file"),
        ("[types.ur5]\n[[logs]]\nfiles = '{date}/{date}.csv'\n", "3:1", "the format of each"),
        ("[types.ur5]\n[[logs]]\nfiles = '" + "*x" * 5 + "'\n", "3:1", "too many fields"),
        ("[types.ur5]\n[[logs]]\nfiles = 'gone/{unit}.csv'\n", "3:1", "no log fits the pattern"),
        ("[types.ur5]\n" + LOGS + "date = '%Q'\n", "4:1", "no format of dates"),
        ("[types.ur5]\n" + LOGS + "date = '%d.%m.'\n", "4:1", "has no year"),
        ("[types.ur5]\n" + LOGS + "date = 1969-07-20\n", "4:1", "no log has this date"),
        ("[types.ur5]\n" + LOGS + "date = 3\n", "4:1", "no format of dates"),
        ("[types.ur5]\n" + LOGS + "timezone = '../../etc/passwd'\n", "4:1", "no such time zone"),
        ("timezone = 'Mars'\n[types.ur5]\n" + LOGS, "1:1", "no such time zone"),
        ("[types.ur5]\n" + LOGS + "columns = {unit = 'x'}\n", "4:1", "columns are those of a manifest"),
        ("[types.ur5]\n" + LOGS + "conditions = {load = 'x'}\n", "4:1", "load is not a number"),
        ("[types.ur5]\n" + LOGS + "conditions = {load = nan}\n", "4:1", "load is not a number"),
        ("[types.ur5]\n" + LOGS + "exclude = 3\n", "4:1", "exclude is not a pattern"),
        ("[types.ur5]\n[[logs]]\nmanifest = 'gone.csv'\n", "3:1", "no such manifest"),
        ("[types.ur5]\n[[logs]]\nmanifest = 'logs'\n", "3:1", "no such manifest"),
        ("[types.ur5]\n" + LOGS + "[[logs]]\nfiles = 'x'\nuint = 'a'\n", "6:1", "did you mean 'unit'?"),
        ("[types.ur5]\n" + LOGS + f"conditions = {{load = {'9' * 400}}}\n", "4:1", "load is not a number"),
        (f"name = {'9' * 5000}\n", "", "this is not TOML"),
        ("[types.ur5]\n" + LOGS + "exclude = 'logs'\n", "", "all of them excluded"),
        ("[types.ur5]\n[[logs]]\nfiles = '" + "a" * 300 + "/{unit}.csv'\n", "3:1", "no log fits"),
        ("# a comment\n\n[types.ur5]\nrobbot = 'a'\n" + LOGS, "4:1", "did you mean 'robot'?"),
        ("name = '''\n" + "x = 1\n" * 300 + "'''\nbad = 1\n" + LOGS, "", "unknown key 'bad'"),
        ("name = '\n", "2", "this is not TOML"),
    ],
)
def test_what_is_wrong_has_its_place(tmp_path: Path, text: str, where: str, words: str) -> None:
    (tmp_path / "logs" / "7").mkdir(parents=True)
    (tmp_path / "logs" / "7" / "2026-05-03.csv").touch()
    (tmp_path / "fleet.toml").write_text(text, encoding="utf-8")
    with pytest.raises(InputError) as caught:
        read_fleet(tmp_path)
    assert words in str(caught.value)
    place = f":{where}" if where else ""
    assert str(caught.value).startswith(f"{tmp_path}/fleet.toml{place}: "), str(caught.value)


@pytest.mark.parametrize(
    ("content", "where", "words"),
    [
        ("", ":1", "no column 'source'"),
        ("sourse,unit,date\n", ":1", "did you mean 'sourse'?"),
        ("source,source\n", ":1", "two columns"),
        ("source,unit,date\na.csv,7\n", ":2", "another number of cells"),
        ("source,unit,date\n,7,2026-05-03\n", ":2", "names no log"),
        ("source,unit,date\n\nno.csv,7,2026-05-03\n", ":3", "not there"),
        ("source,unit,date\na.csv,7,\n", ":2", "the date of a log is not known"),
        ("source,unit,date\na.csv,,2026-05-03\n", ":2", "the unit of a log is not known"),
        ("source,unit,date\na.csv,7,soon\n", ":2", "the date of a log cannot be read"),
        ("source,unit,date\na.csv,7,2101-01-01\n", ":2", "a date from 1990 to 2099"),
        ("source,unit,date,type\na.csv,7,2026-05-03,ur\n", ":2", "did you mean 'ur5'?"),
        ("source,unit,date,note\na.csv,7,2026-05-03,hot\n", ":2", "'note' is not a number"),
        ("source,unit,date,t\na.csv,7,2026-05-03,inf\n", ":2", "'t' is not a number"),
        ('source,unit,date\n"a.csv,7,2026-05-03\n', "", "not CSV"),
        (f"source,unit,date\na.csv,{'7' * 300},2026-05-03\n", ":2", "cannot be called so"),
        (
            "source,unit,date\na.csv,7,2026-05-03\na.csv,7,2026-05-04\n",
            ":3",
            "found 2026-05-04T00:00:00Z; expected 2026-05-03T00:00:00Z, as {}/m.csv:2",
        ),
        ("source,unit,date,t\na.csv,7,2026-05-03,'31,5'\n", ":2", "another number of cells"),
        (f"source,unit,date\na.csv,{'7' * 200_000},2026-05-03\n", ":2", "not CSV"),
        ("source,unit,date\npipe.csv,7,2026-05-03\n", ":2", "neither a file nor a folder"),
        ("source,unit,date\nlogs,7,2026-05-03\n", ":2", "a folder without a recording"),
    ],
)
def test_a_manifest_is_held_to_its_lines(tmp_path: Path, content: str, where: str, words: str) -> None:
    (tmp_path / "a.csv").touch()
    (tmp_path / "logs").mkdir()
    os.mkfifo(tmp_path / "pipe.csv")
    (tmp_path / "m.csv").write_text(content, encoding="utf-8")
    (tmp_path / "fleet.toml").write_text("[types.ur5]\n[[logs]]\nmanifest = 'm.csv'\n", encoding="utf-8")
    with pytest.raises(InputError) as caught:
        read_fleet(tmp_path)
    assert words.replace("{}", str(tmp_path)) in str(caught.value)
    assert str(caught.value).startswith(f"{tmp_path}/m.csv{where}")


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
    long = "folder/" * 1000
    (tmp_path / "list.csv").write_text(f"source,unit,date\n{long},a,2026-01-01\n", encoding="utf-8")
    with pytest.raises(InputError, match=r"list\.csv:2: the log .* is not to be read") as error:
        read_fleet(fleet)
    assert len(str(error.value)) < 600
