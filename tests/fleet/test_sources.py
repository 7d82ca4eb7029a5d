"""Where a fleet's logs are: ``fleet.toml``, patterns of paths, manifests and bare folders."""

from __future__ import annotations

import math
import os
from datetime import UTC, datetime
from pathlib import Path

import pytest

from robodyn.errors import InputError
from robodyn.fleet.sources.fleet import Fleet
from robodyn.fleet.sources.reading import read_fleet
from robodyn.logs.log import read_log
from robodyn.logs.mapping import map_of_text
from robodyn.robot.reader import read_text

TYPE = "[types.ur5]\n"


def touch(folder: Path, *names: str) -> None:
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).touch()


def read(folder: Path, text: str, *names: str) -> Fleet:
    touch(folder, *names)
    (folder / "fleet.toml").write_text(text, encoding="utf-8")
    return read_fleet(folder / "fleet.toml")


def logs_of(fleet: Fleet, folder: Path) -> list[tuple[str, str, str, str]]:
    """Source below the folder, type, unit and date of each log."""
    return [
        (
            os.path.relpath(log.source, folder),
            log.type,
            log.unit,
            "" if math.isnan(log.date) else datetime.fromtimestamp(log.date, UTC).isoformat(),
        )
        for log in fleet.logs
    ]


def refusal(folder: Path, text: str, *names: str) -> str:
    with pytest.raises(InputError) as caught:
        read(folder, text, *names)
    return str(caught.value)


def test_a_pattern_names_type_unit_and_date(tmp_path: Path) -> None:
    fleet = read(
        tmp_path,
        'name = "Hall 3"\n[types.ur5]\n[types.big]\nrobot = "ur10"\n'
        '[[logs]]\nfiles = "logs/{type}/{unit}/{date}.csv"\n',
        "logs/ur5/7/2026-05-03T1200.csv",
        "logs/ur5/7/2026-05-02.csv",
        "logs/big/a b/20260503T120000+0200.csv",
        "logs/ur5/7/2026-05-02.csv.json",
        "logs/ur5/7/.2026-05-02.csv",
    )
    assert fleet.name == "Hall 3"
    assert logs_of(fleet, tmp_path) == [
        ("logs/big/a b/20260503T120000+0200.csv", "big", "a b", "2026-05-03T10:00:00+00:00"),
        ("logs/ur5/7/2026-05-02.csv", "ur5", "7", "2026-05-02T00:00:00+00:00"),
        ("logs/ur5/7/2026-05-03T1200.csv", "ur5", "7", "2026-05-03T12:00:00+00:00"),
    ]
    assert "name: ur10" in fleet.types["big"].text
    assert fleet.types["big"].mapping is None


def test_fields_stand_anywhere_and_others_are_conditions(tmp_path: Path) -> None:
    fleet = read(
        tmp_path,
        TYPE + "[[logs]]\ntimezone = 'Europe/Berlin'\nconditions = {load = 2}\n"
        "files = '{date:%Y}/{date:%m-%d}/arm_{unit}_{date:%H%M}_{temperature}C.csv'\n",
        "2026/05-03/arm_A_7_1200_-31.5C.csv",
        "2026/05-03/notes.csv",
    )
    assert logs_of(fleet, tmp_path)[0][2:] == ("A_7", "2026-05-03T10:00:00+00:00")
    assert fleet.logs[0].conditions == {"load": 2.0, "temperature": -31.5}
    assert len(fleet.logs) == 1


def test_a_log_is_counted_once_and_two_entries_complete_each_other(tmp_path: Path) -> None:
    (tmp_path / "about.csv").write_text("source,temperature\nlogs/7/2026-05-03.csv,31\n", encoding="utf-8")
    entries = (
        TYPE + "[[logs]]\nfiles = 'logs/{unit}/{date}.csv'\n"
        "[[logs]]\nfiles = 'logs/**/{date}.csv'\n[[logs]]\nmanifest = 'about.csv'\n"
    )
    fleet = read(tmp_path, entries, "logs/7/2026-05-03.csv")
    assert logs_of(fleet, tmp_path) == [("logs/7/2026-05-03.csv", "ur5", "7", "2026-05-03T00:00:00+00:00")]
    assert fleet.logs[0].conditions == {"temperature": 31.0}
    (tmp_path / "about.csv").write_text("source,unit\nlogs/7/2026-05-03.csv,8\n", encoding="utf-8")
    assert "about.csv:2: two places differ in the unit" in refusal(tmp_path, entries)


@pytest.mark.parametrize("mark", [",", ";", "\t"])
def test_a_manifest_has_quotes_a_byte_order_mark_and_zones(tmp_path: Path, mark: str) -> None:
    rows = (
        ("Datei", "Serie", "Datum", "Temp"),
        ('"a,b;\tc.csv"', '"7 ""x"""', "03.05.2026 12:00 +0200", "31.5"),
        ("d.csv", "8", "03.05.2026 12:00 +0000", ""),
    )
    text = "\ufeff" + "\r\n".join(mark.join(row) for row in rows) + "\r\n"
    (tmp_path / "list.csv").write_text(text, encoding="utf-8", newline="")
    fleet = read(
        tmp_path,
        TYPE + "[[logs]]\nmanifest = 'list.csv'\ndate = '%d.%m.%Y %H:%M %z'\n"
        "columns = {source = 'Datei', unit = 'Serie', date = 'Datum'}\n"
        "conditions = {temperature = 'Temp'}\n",
        "a,b;\tc.csv",
        "d.csv",
    )
    assert logs_of(fleet, tmp_path) == [
        ("a,b;\tc.csv", "ur5", '7 "x"', "2026-05-03T10:00:00+00:00"),
        ("d.csv", "ur5", "8", "2026-05-03T12:00:00+00:00"),
    ]
    assert [log.conditions for log in fleet.logs] == [{"temperature": 31.5}, {}]


def test_a_manifest_of_json_lines(tmp_path: Path) -> None:
    (tmp_path / "list.jsonl").write_text(
        '{"source": "a.csv", "unit": 7, "date": 1777809600, "conditions": {"temperature": 3}}\n\n'
        '{"source": "b.csv+c.csv", "unit": "8", "date": 1777809601.5, "load": 2}\n',
        encoding="utf-8",
    )
    fleet = read(
        tmp_path,
        TYPE + "[[logs]]\nmanifest = 'list.jsonl'\ndate = 'unix'\n",
        "a.csv",
        "b.csv",
        "c.csv",
    )
    assert [(log.unit, log.date, log.conditions) for log in fleet.logs] == [
        ("7", 1777809600.0, {"temperature": 3.0}),
        ("8", 1777809601.5, {"load": 2.0}),
    ]
    assert fleet.logs[1].source == f"{tmp_path}/b.csv+{tmp_path}/c.csv"


def test_a_date_may_hold_for_all_or_stand_in_the_log(tmp_path: Path) -> None:
    entry = TYPE + "[[logs]]\nfiles = '{unit}.csv'\ndate = "
    fleet = read(tmp_path, entry + "2026-05-03\n", "7.csv", "8.csv")
    assert {log.date for log in fleet.logs} == {datetime(2026, 5, 3, tzinfo=UTC).timestamp()}
    fleet = read(tmp_path, entry + "'log'\n")
    assert all(math.isnan(log.date) for log in fleet.logs)
    first, second = (log.source for log in fleet.logs)
    completed = fleet.completed({second: 1.8e9}, {first: {"load": 1.0}})
    assert [log.date for log in completed.logs if log.source == second] == [1.8e9]
    assert completed.logs[0].conditions == {"load": 1.0}


def test_a_type_has_a_map_columns_and_parameters(tmp_path: Path) -> None:
    (tmp_path / "map.yaml").write_text("q: joint_%d_pos[deg]\n", encoding="utf-8")
    (tmp_path / "arm.yaml").write_text(
        "name: arm\nlinks:\n  - {joint: revolute, mass: m}\n", encoding="utf-8"
    )
    fleet = read(
        tmp_path,
        "[types.one]\nrobot = 'arm.yaml'\nmap = 'map.yaml'\nparameters = {m = 1.5}\n"
        "[types.two]\nrobot = 'ur5'\ncolumns = 't=time[ms],q=joint_%d_pos[deg],tau=-i_%d[A]'\n"
        "[[logs]]\nfiles = '{type}/{unit}/{date}.csv'\n",
        "one/1/2026-05-03.csv",
        "two/1/2026-05-03.csv",
    )
    one, two = fleet.types["one"], fleet.types["two"]
    assert not read_text(one.text).parameters
    assert one.mapping == "q: joint_%d_pos[deg]\n"
    assert two.mapping is not None
    assert map_of_text(two.mapping).groups["t"].unit == "ms"
    text = refusal(tmp_path, "[types.one]\nrobot = 'arm.yaml'\n[[logs]]\nfiles = '{unit}.csv'\n")
    assert text.startswith(f"{tmp_path}/fleet.toml:1:1: arm has run-time parameters without values")
    assert text.endswith("parameters = {NAME = VALUE}")


def test_a_folder_without_a_description(tmp_path: Path) -> None:
    touch(
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
    touch(tmp_path, "ur5/7/second.csv")
    with pytest.raises(InputError, match=r"second\.csv: the name of a log has no date"):
        read_fleet(tmp_path)
    (tmp_path / "empty").mkdir()
    with pytest.raises(InputError, match="no fleet is recognised"):
        read_fleet(tmp_path / "empty")
    touch(tmp_path, "strange/1/2026-05-03.csv")
    with pytest.raises(InputError, match="the type 'strange' have no description"):
        read_fleet(tmp_path)


def test_links_that_lead_round_in_circles_end(tmp_path: Path) -> None:
    touch(tmp_path, "a/b/2026-05-03.csv")
    (tmp_path / "a" / "b" / "loop").symlink_to(tmp_path / "a")
    fleet = read(tmp_path, TYPE + "[[logs]]\nunit = '7'\nfiles = '**/{date}.csv'\nexclude = 'a/b/loop/*'\n")
    assert len(fleet.logs) == 1


def test_hostile_names_are_text(tmp_path: Path) -> None:
    name = "\x1b[31m..\n$(reboot)"
    fleet = read(tmp_path, TYPE + "[[logs]]\nfiles = '{unit}/{date}.csv'\n", f"{name}/2026-05-03.csv")
    assert fleet.logs[0].unit == name
    text = refusal(tmp_path, TYPE + "[[logs]]\nfiles = '{unit}/{date}.csv'\n", f"{name}/2026-13-03.csv")
    assert "\x1b" not in text
    assert "2026-13-03.csv: the date of a log cannot be read from its path" in text


def test_the_example_is_a_fleet() -> None:
    folder = Path(__file__).parents[2] / "examples" / "fleet"
    fleet = read_fleet(folder)
    assert [log.unit for log in fleet.logs] == [*5 * ["north"], *5 * ["south"]]
    assert all(set(log.conditions) == {"temperature"} for log in fleet.logs)
    page = (folder.parents[1] / "docs" / "fleet-sources.md").read_text(encoding="utf-8")
    assert (folder / "fleet.toml").read_text(encoding="utf-8") in page
    log = read_log(fleet.logs[0].source, 3)
    assert (log.samples, log.t[-1]) == (401, 8.0)
