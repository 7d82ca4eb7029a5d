"""Where a fleet's logs are: ``fleet.toml``, its schema, patterns of paths, manifests and bare folders.

What is refused for a text alone stands in tests/refusals/fleet.yaml and manifest.yaml.
"""

from __future__ import annotations

import json
import math
import os
import tomllib
from collections.abc import Mapping
from datetime import UTC, datetime
from pathlib import Path

import pytest

from robodyn.errors import InputError
from robodyn.fleet.sources.fleet import Fleet
from robodyn.fleet.sources.reading import read_fleet
from robodyn.logs.mapping import map_of_text
from robodyn.robot.reader import read_text
from robodyn_cli.main import main
from robodyn_testing import require_module

TYPE = "[types.ur5]\n"
FILES = "[[logs]]\nfiles = 'logs/{unit}/{date}.csv'\n"
MANIFEST = "[[logs]]\nmanifest = 'm.csv'\n"
LOG = "logs/a/2026-01-01.csv"


def write(folder: Path, *names: str, **texts: str) -> None:
    """Empty files with these ``names``; ``texts`` are those of files of CSV, by their stems."""
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).touch()
    for stem, text in texts.items():
        (folder / f"{stem}.csv").write_text(text, encoding="utf-8", newline="")


def read(folder: Path, text: str, *names: str, **texts: str) -> Fleet:
    write(folder, *names, **texts)
    (folder / "fleet.toml").write_text(text, encoding="utf-8")
    return read_fleet(folder / "fleet.toml")


#: [[logs]], files and manifests by their stems, and of each log its path, unit, time and conditions.
CASES: Mapping[str, tuple[str, list[str], dict[str, str], list[tuple[str, str, str, dict[str, float]]]]] = {
    "dates of ISO 8601, beside hidden files and others": (
        "[[logs]]\nfiles = 'logs/{type}/{unit}/{date}.csv'\n",
        [f"logs/ur5/{name}" for name in ("a b/20260503T120000+0200.csv", "7/2026-05-03_12-00.csv",
            "7/2026-05-02.csv", "7/2026-05-02.csv.json", "7/.2026-05-02.csv", ".8/2026-05-02.csv")],
        {},
        [("logs/ur5/7/2026-05-02.csv", "7", "2026-05-02T00:00", {}),
         ("logs/ur5/7/2026-05-03_12-00.csv", "7", "2026-05-03T12:00", {}),
         ("logs/ur5/a b/20260503T120000+0200.csv", "a b", "2026-05-03T10:00", {})],
    ),
    "a date in pieces, in a zone; another field is a condition": (
        "[[logs]]\ntimezone = 'Europe/Berlin'\nconditions = {load = 2}\n"
        "files = '{date:%Y}/{date:%m-%d}/arm_{unit}_{date:%H%M}_{temperature}C.csv'\n",
        ["2026/05-03/arm_A_7_1200_-3.5C.csv", "2026/05-03/notes.csv"],
        {},
        [("2026/05-03/arm_A_7_1200_-3.5C.csv", "A_7", "2026-05-03T10:00", {"load": 2, "temperature": -3.5})],
    ),
    "a unit whose name looks like a date, seconds, brackets and a field that comes twice": (
        "[[logs]]\nfiles = '[{unit}]/{unit}_{date:unix}.csv'\n[[logs]]\nfiles = '{unit}_{date}.csv'\n",
        ["[7]/7_1777809600.csv", "[7]/8_1777809600.csv", "2026_20260503.csv"],
        {},
        [("2026_20260503.csv", "2026", "2026-05-03T00:00", {}),
         ("[7]/7_1777809600.csv", "7", "2026-05-03T12:00", {})],
    ),
    "folders in folders, without what is left out; two entries complete each other": (
        FILES + "[[logs]]\nfiles = 'logs/**/{date}.csv'\nexclude = ['logs/*/test', '**/*-02.csv']\n"
        "[[logs]]\nmanifest = 'm.csv'\nexclude = 'gone'\n",
        ["logs/7/2026-05-03.csv", "logs/7/test/2026-05-03.csv"],
        {"m": "source,temperature\nlogs/7/2026-05-03.csv,31\ngone/x.csv,3\n"},
        [("logs/7/2026-05-03.csv", "7", "2026-05-03T00:00", {"temperature": 31})],
    ),
    "a manifest with quotes, names of its own and a byte order mark": (
        "[[logs]]\nmanifest = 'm.csv'\ndate = '%d.%m.%Y %H:%M %z'\n"
        "columns = {source = 'Datei', unit = 'Serie', date = 'Datum'}\nconditions = {temperature = 'Temp'}\n",
        ["a;,\t.csv", "b.csv"],
        {"m": "\ufeffDatei;Serie;Datum;Temp\r\n\"a;,\t.csv\";\"7 \"\"x\"\"\";03.05.2026 12:00 +0200;31.5\r\n"
              "\r\nb.csv;8;03.05.2026 12:00 +0000;\r\n"},
        [("a;,\t.csv", '7 "x"', "2026-05-03T10:00", {"temperature": 31.5}),
         ("b.csv", "8", "2026-05-03T12:00", {})],
    ),
    "a manifest with tabs, of logs in two files": (
        "[[logs]]\nmanifest = 'm.csv'\ndate = 'unix_ms'\nconditions = ['load']\n",
        ["a.csv", "b.csv", "c+d.csv"],
        {"m": "source\tunit\tdate\tload\tnote\n"
              "a.csv+b.csv\t8\t1777809600000\t2\tx\nc+d.csv\t9\t1777809600000\t\t\n"},
        [("a.csv+b.csv", "8", "2026-05-03T12:00", {"load": 2}), ("c+d.csv", "9", "2026-05-03T12:00", {})],
    ),
    "a date for all": (
        "[[logs]]\nfiles = '{unit}.csv'\ndate = 2026-05-03\n",
        ["7.csv"], {}, [("7.csv", "7", "2026-05-03T00:00", {})],
    ),
    "dates in the logs, and a recording's folder": (
        "[[logs]]\nfiles = 'bags/{unit}/r?n'\ndate = 'log'\n",
        ["bags/7/run/metadata.yaml"], {}, [("bags/7/run", "7", "", {})],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_logs_are_as_the_file_says(name: str, tmp_path: Path) -> None:
    text, names, texts, expected = CASES[name]
    fleet = read(tmp_path, TYPE + text, *names, **texts)
    logs = fleet.logs
    assert not fleet.missing
    assert [
        (
            log.source.replace(f"{tmp_path}/", ""),
            log.unit,
            "" if math.isnan(log.date) else datetime.fromtimestamp(log.date, UTC).isoformat()[:16],
            log.conditions,
        )
        for log in logs
    ] == expected
    assert {log.type for log in logs} == {"ur5"}


def test_a_type_has_a_map_columns_and_parameters(tmp_path: Path) -> None:
    (tmp_path / "map.yaml").write_text("q: joint_%d_pos[deg]\n", encoding="utf-8")
    arm = "name: arm\nlinks:\n  - {joint: revolute, mass: m}\n"
    (tmp_path / "arm.yaml").write_text(arm, encoding="utf-8")
    fleet = read(
        tmp_path,
        "name = 'Hall 3'\n[types.one]\nrobot = 'arm.yaml'\nmap = 'map.yaml'\nparameters = {m = 1.5}\n"
        "[types.two]\nrobot = 'ur10'\ncolumns = 't=time[ms],q=joint_%d_pos[deg],tau=-i_%d[A]'\n"
        "[[logs]]\nfiles = '{type}/{unit}/{date}.csv'\n",
        "one/1/2026-05-03.csv",
        "two/1/2026-05-03.csv",
    )
    one, two = fleet.types["one"], fleet.types["two"]
    assert (fleet.name, one.mapping) == ("Hall 3", "q: joint_%d_pos[deg]\n")
    assert not read_text(one.text).parameters
    assert "name: ur10" in two.text
    assert two.mapping is not None
    assert map_of_text(two.mapping).groups["t"].unit == "ms"
    with pytest.raises(InputError, match=r"toml:1:1: arm has .* without values; .*parameters = \{NAME"):
        read(tmp_path, "[types.one]\nrobot = 'arm.yaml'\n" + FILES)


def test_a_folder_without_a_description(tmp_path: Path) -> None:
    write(
        tmp_path,
        "ur5/7/arm_2026-05-03T1200.csv",
        "ur5/8/2026-05-03/metadata.yaml",
        "mine/1/20260503.parquet",
        "mine/1/20260504.json",
        "mine/1/20260503.parquet.json",
        "mine/1/notes.md",
        "other/stuff/readme.md",
    )
    (tmp_path / "mine.yaml").write_text("name: mine\nlinks:\n  - {joint: revolute}\n", encoding="utf-8")
    (tmp_path / "ur5" / "map.yaml").write_text("q: joint_%d_pos[deg]\n", encoding="utf-8")
    fleet = read_fleet(tmp_path)
    assert [(log.type, log.unit, Path(log.source).suffix) for log in fleet.logs] == [
        ("mine", "1", ".parquet"),
        ("mine", "1", ".json"),
        ("ur5", "7", ".csv"),
        ("ur5", "8", ""),
    ]
    assert fleet.types["ur5"].mapping == "q: joint_%d_pos[deg]\n"
    (tmp_path / "empty").mkdir()
    for name, folder, message in (
        ("strange/1/2026-05-03.csv", ".", r"neither a description nor a bundled robot.*'strange\.yaml'"),
        ("ur5/7/second.csv", ".", r"a log of the folder has no date in its name; found 'ur5/7/second\.csv'"),
        ("notes.md", "empty", "no log fits the pattern"),
        ("notes.md", "gone", "gone: the file cannot be read; .*expected a description of a fleet"),
    ):
        write(tmp_path, name)
        with pytest.raises(InputError, match=message):
            read_fleet(tmp_path / folder)


@pytest.mark.parametrize(
    ("text", "names", "message"),
    [
        (f"name = {'9' * 5000}\n", [], "fleet.toml: this is not TOML"),
        ("name = '''\n" + "x = 1\n" * 300 + "'''\nbad = 1\n" + FILES, [], "fleet.toml: unknown key 'bad'"),
        (TYPE + FILES, [f"logs/7/2026-05-3{k}.csv" for k in range(2, 9)], r"-32\.csv: .* and 4 more\)"),
        (TYPE + FILES, ["logs/\x1b[31m..\n$(reboot)/2026-13-03.csv"], r"\\n\$\(reboot\)/2026-13-03.csv: "),
        (TYPE + MANIFEST, ["m.csv"], "no column 'source'; found nothing"),
        (TYPE + MANIFEST, [f"source,unit,date\n{LOG},{'7' * 200_000},2026-01-01\n"], "not CSV"),
        (TYPE + MANIFEST, [f"source,unit,date\n{LOG}\0,7,2026-01-01\n"], "not CSV"),
        (TYPE + FILES + MANIFEST, [f"source,unit\n{LOG},8\n", LOG], r"m\.csv:2: two .* differ in the unit"),
        (TYPE + "[[logs]]\nfiles='logs/{unit}/x/{date}.csv'", [LOG], r"in .*logs/a: '2026.*; expected 'x'"),
        (TYPE + "[[logs]]\nfiles='**/{date}.md'", [LOG], r"no log fits .* expected '\{date\}\.md'"),
        (TYPE + MANIFEST, ["source,unit,date\nlogs/gone,,\n"], "the fleet has no logs"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused(text: str, names: list[str], message: str, tmp_path: Path) -> None:
    """Of ``names`` one that begins with "source" is the text of a manifest."""
    for name in names:
        write(tmp_path, *([] if name.startswith("source") else [name]))
        write(tmp_path, **({"m": name} if name.startswith("source") else {}))
    with pytest.raises(InputError, match=message) as caught:
        read(tmp_path, text)
    assert str(caught.value).isprintable()


def test_wrong_paths_of_a_manifest_are_named_and_do_not_end_the_run(tmp_path: Path) -> None:
    rows = f"{LOG},a,2026-01-01,3\nlogs/gone.csv,,,3\n{'x/' * 2000},,,3\nlogs/gone.csv2,b,2026-01-01,3\n"
    fleet = read(tmp_path, TYPE + MANIFEST, LOG, m=f"source,unit,date,temperature\n{rows}")
    assert [(log.unit, log.named) for log in fleet.logs] == [
        ("a", f"{tmp_path}/m.csv:2"),
        ("b", f"{tmp_path}/m.csv:5"),
    ]
    reasons = [each.why for each in fleet.missing]
    assert reasons == [f"{tmp_path}/m.csv:{line} names it, and it is not there" for line in (3, 4)]


def test_links_that_lead_round_in_circles_end(tmp_path: Path) -> None:
    text = TYPE + "[[logs]]\nunit = '7'\nfiles = '**/{date}.csv'\n"
    write(tmp_path, "a/b/2026-05-03.csv", "elsewhere/2026-05-04.csv")
    (tmp_path / "a" / "b" / "loop").symlink_to(tmp_path / "a")
    (tmp_path / "a" / "self").symlink_to("self")
    (tmp_path / "a" / "linked").symlink_to(tmp_path / "elsewhere")
    sources = [log.source.replace(f"{tmp_path}/", "") for log in read(tmp_path, text).logs]
    assert sources == ["a/b/2026-05-03.csv", "a/linked/2026-05-04.csv", "elsewhere/2026-05-04.csv"]


def test_a_folder_that_cannot_be_read_may_be_left_out(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write(tmp_path, LOG, "logs/shut/2026-01-01.csv")
    scandir = os.scandir

    def refusing(path: str | Path) -> object:
        if str(path).endswith("shut"):
            raise PermissionError(13, "Permission denied", path)
        return scandir(path)

    monkeypatch.setattr(os, "scandir", refusing)
    with pytest.raises(InputError, match=r"shut: the folder cannot be read.*leave it out \(exclude\)"):
        read(tmp_path, TYPE + FILES)
    assert len(read(tmp_path, TYPE + FILES + "exclude = 'logs/shut'\n").logs) == 1


def test_a_log_named_with_its_folder_and_without_is_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    whole = f"[[logs]]\nfiles = '{tmp_path.as_posix()}/../{tmp_path.name}/logs/{{unit}}/{{date}}.csv'\n"
    write(tmp_path, LOG)
    Path("fleet.toml").write_text(TYPE + FILES + whole, encoding="utf-8")
    (log,) = read_fleet("fleet.toml").logs
    assert log.source == LOG


#: Descriptions that are right, and that are wrong, without what all of them have.
GOOD = ["", "exclude = ['a/*']\nconditions = {load = 2}\ntype = 'ur5'\n"]
GOOD_TABLES = ["columns = {unit = 'serial'}\nconditions = ['load']\n", "conditions = {load = 'load'}\n"]
BAD = [
    "manifest = 'm.csv'\n", "columns = {unit = 'x'}\n", "conditions = ['load']\n", "exclude = [3]\n",
    "date = 3\n", "unit = ' '\n", "conditions = {unit = 3}\n",
]  # fmt: skip
BAD_TABLES = ["columns = {serial = 'unit'}\n", "conditions = [3]\n", "conditions = {load = 3}\n"]
BAD_WHOLE = [
    TYPE, FILES, "[types]\n" + FILES, TYPE + "logs = []\n" + FILES, "name = 3\n" + TYPE + FILES,
    TYPE + "map = 'm.yaml'\ncolumns = 'q=q%d'\n" + FILES, TYPE + "parameters = {m = 'x'}\n" + FILES,
    TYPE + "[[logs]]\nunit = 'x'\n",
]  # fmt: skip


@pytest.mark.parametrize(
    ("text", "good"),
    [
        *((TYPE + FILES + text, True) for text in GOOD),
        *((TYPE + MANIFEST + text, True) for text in GOOD_TABLES),
        *((TYPE + FILES + text, False) for text in BAD),
        *((TYPE + MANIFEST + text, False) for text in BAD_TABLES),
        *((text, False) for text in BAD_WHOLE),
    ],
)
def test_the_schema_and_the_reader_agree(
    text: str, good: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    jsonschema = require_module("jsonschema")
    assert main(["schema", "--fleet-file"]) == 0
    schema = json.loads(capsys.readouterr().out)
    jsonschema.Draft202012Validator.check_schema(schema)
    assert jsonschema.Draft202012Validator(schema).is_valid(tomllib.loads(text)) == good
    (tmp_path / "map.yaml").write_text("q: q%d\n", encoding="utf-8")
    try:
        manifest = f"source,serial,unit,date,load\n{LOG},7,7,2026-05-03,1\n"
        assert read(tmp_path, text, LOG, m=manifest).logs
    except InputError:
        assert not good
    else:
        assert good


def test_what_is_too_much_is_refused_and_never_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    many = "source,unit,date\n" + "".join(f"{k}.csv,a,2026-01-0{k}\n" for k in range(1, 7))
    names = [f"logs/a/2026-01-0{k}.csv" for k in range(1, 7)]
    deep = "logs/" + "".join(f"{k}/" for k in range(1, 50))
    anywhere = TYPE + "[[logs]]\nunit = 'a'\nfiles = 'logs/**/{date}.csv'\n"
    write(tmp_path, *names, f"{deep}2026-02-01.csv")
    assert len(read(tmp_path, anywhere).logs) == len(names)
    for limit, text, told in (
        ("gathering.MOST_LOGS", TYPE + FILES, "there are too many logs; found more than 3"),
        ("gathering.MOST_LOGS", TYPE + MANIFEST, r"m\.csv:5: there are too many logs"),
        ("pattern.MOST_ENTRIES", TYPE + FILES, "leads through too many files; found more than 3"),
        (
            "gathering.MOST_CONDITIONS",
            TYPE + FILES + "conditions = {a=1,b=2,c=3,d=4}\n",
            "too many conditions",
        ),
        ("dates.LONGEST_FORMAT", TYPE + FILES + "date = '%Y-%m-%d'\n", "this is no format of dates"),
    ):
        with monkeypatch.context() as patch:
            patch.setattr(f"robodyn.fleet.sources.{limit}", 3)
            with pytest.raises(InputError, match=told):
                read(tmp_path, text, m=many)


def test_a_name_that_fits_in_many_ways_is_told_soon(tmp_path: Path) -> None:
    write(tmp_path, "logs/" + "1_" * 100 + "x.txt")
    fields = "_".join("{" + name + "}" for name in "abcdefghij")
    with pytest.raises(InputError, match="no log fits"):
        read(tmp_path, f"{TYPE}[[logs]]\nunit = 'a'\nfiles = 'logs/{fields}_{{date}}.csv'\n")
