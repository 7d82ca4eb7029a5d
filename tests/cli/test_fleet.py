"""``robodyn fleet``: a fleet from its logs to files and lines; what is refused before work begins."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from fleet.small_fleet import NAME, write_log
from robodyn.fleet.as_json import fleet_schema
from robodyn.fleet.sources.reading import read_fleet
from robodyn.formats.loading import text_of
from robodyn.tools.libraries import PYARROW
from robodyn_cli.main import main
from robodyn_testing import require_module

Capture = pytest.CaptureFixture[str]
DAYS = ("2025-01-03", "2025-06-07T0830")


@pytest.fixture(scope="module")
def logs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder TYPE/UNIT/DATE.csv of three units, one of which has a log that is none."""
    folder = tmp_path_factory.mktemp("fleet") / "plant"
    for unit in range(3):
        path = folder / NAME / f"unit {unit}"
        path.mkdir(parents=True)
        for k, day in enumerate(DAYS):
            write_log(path / f"{day}.csv", 10 * unit + k)
    (folder / NAME / "unit 2" / "2025-07-01.csv").write_text("t,q1\n0,nothing\n", encoding="utf-8")
    return folder


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_fleet_becomes_a_page_a_table_and_data(logs: Path, here: Path, capsys: Capture) -> None:
    """The second run says the same, byte for byte, and with --json prints what fleet.json has."""
    words = ["fleet", str(logs), "-o", "out", "--on", "here", "--diagnose", "none"]
    assert main(words) == 0
    lines = capsys.readouterr().out.splitlines()
    assert "3 units of 1 type, 6 logs of 155 days (1 not used)" in lines
    assert lines[-1] == "page: out/index.html"
    out = here / "out"
    written = {path: path.read_bytes() for path in out.rglob("*.*") if path.name != "store.sqlite"}
    pages = {f"units/{NAME}/unit {k}/index.html" for k in range(3)}
    assert {str(path.relative_to(out)) for path in written} == {
        ".robodyn.sha256", "fleet.json", "fleet.parquet", "index.html", *pages,
    }  # fmt: skip
    data = json.loads(written[out / "fleet.json"])
    require_module("jsonschema").Draft202012Validator(fleet_schema()).validate(data)
    assert [(unit["unit"], unit["logs"]) for unit in data["units"]] == [(f"unit {k}", 2) for k in range(3)]
    (unused,) = data["unused"]
    assert unused["unit"] == "unit 2"
    html = written[out / "index.html"].decode()
    assert all(f'href="{path.replace(" ", "%20")}"' in html for path in pages)

    assert main([*words, "--json"]) == 0
    assert json.loads(capsys.readouterr().out) == data
    assert all(path.read_bytes() == content for path, content in written.items())


@pytest.mark.thorough
def test_units_are_diagnosed_and_their_pages_lead_there(here: Path) -> None:
    log = here / "plant" / NAME / "unit 0" / "2025-01-03.csv"
    log.parent.mkdir(parents=True)
    write_log(log, 1)
    assert main(["fleet", "plant", "-o", "out", "--on", "here", "--diagnose", "all"]) == 0
    out = here / "out"
    (unit,) = json.loads((out / "fleet.json").read_text(encoding="utf-8"))["units"]
    assert unit["diagnosis"] == f"units/{NAME}/unit 0/report.html"
    assert (out / unit["diagnosis"]).is_file()
    page = (out / f"units/{NAME}/unit 0/index.html").read_text(encoding="utf-8")
    assert '<a href="report.html">' in page


def test_the_plain_install_runs_a_fleet_and_says_what_is_missing(
    logs: Path, here: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(type(PYARROW), "present", lambda _: False)
    assert main(["fleet", str(logs), "-o", "out", "--diagnose", "none"]) == 0
    messages = capsys.readouterr().err
    assert "one process works" in messages
    assert "fleet.parquet is left out: it needs pip install 'robodyn[fleet]'" in messages
    assert sorted(path.name for path in (here / "out").iterdir()) == [
        ".robodyn.sha256", "fleet.json", "index.html", "store.sqlite", "units",
    ]  # fmt: skip


def test_a_log_is_not_written_over(here: Path, capsys: Capture) -> None:
    log = here / NAME / "unit" / "2025-01-03.csv"
    log.parent.mkdir(parents=True)
    write_log(log, 1)
    (here / "out").mkdir()
    (here / "fleet.toml").write_text(
        f'[types.{NAME}]\n[[logs]]\nfiles = "out/*.json"\ntype = "{NAME}"\nunit = "a"\ndate = 2025-01-03\n'
    )
    (here / "out" / "fleet.json").write_text("{}")
    assert main(["fleet", "fleet.toml", "-o", "out"]) == 2
    assert "is an input and would be overwritten" in capsys.readouterr().err
    assert (here / "out" / "fleet.json").read_text() == "{}"


def test_a_flat_folder_gets_a_fleet_toml(here: Path, capsys: Capture) -> None:
    folder = here / "flat"
    folder.mkdir()
    (folder / f"{NAME}.yaml").write_text(text_of(NAME), encoding="utf-8")
    for arm in ("A-17", "B_2"):
        for day in DAYS:
            write_log(folder / f"{arm}_{day}.csv", 3)
    (folder / "notes.csv").write_text("", encoding="utf-8")
    assert main(["fleet", "init", "flat"]) == 0
    captured = capsys.readouterr()
    text = (folder / "fleet.toml").read_text(encoding="utf-8")
    assert captured.out.strip() == text.strip()
    assert 'files = "{unit}_{date}.csv"' in text
    assert "left out: 1 of 5 logs" in captured.err
    fleet = read_fleet(folder)
    assert [(log.type, log.unit) for log in fleet.logs] == [
        (NAME, arm) for arm in ("A-17", "B_2") for _ in DAYS
    ]
    (folder / "fleet.toml").write_text("mine", encoding="utf-8")
    assert main(["fleet", "init", "flat"]) == 2  # a file of the user's stays
    assert main(["fleet", "init", "none"]) == 2
    assert main(["fleet", "flat"]) == 2


@pytest.mark.parametrize(
    ("names", "proposed"),
    [
        (["A_2026-01-02.csv", f"{NAME}/B/2026-01-02.csv"], {("plant", "A"), (NAME, "B")}),
        ([f'{NAME}/a"b\\c/2026-01-02.csv'], {(NAME, 'a"b\\c')}),
        (["a\nb_2026-01-02_{unit}*.csv"], {("plant", "a\nb")}),
        (["2026-01-02_{type}.csv", "notes.csv"], {("plant", "{type}")}),
    ],
    ids=["flat and in folders", "marks of strings", "marks of patterns", "no date"],
)
def test_what_is_proposed_reads_the_logs(
    names: list[str], proposed: set[tuple[str, str]], here: Path
) -> None:
    """Whatever their names have in them."""
    (here / "plant").mkdir()
    (here / "plant" / "plant.yaml").write_text(text_of(NAME), encoding="utf-8")
    for name in names:
        (here / "plant" / name).parent.mkdir(parents=True, exist_ok=True)
        write_log(here / "plant" / name, 3)
    assert main(["fleet", "init", "plant"]) == 0
    assert {(log.type, log.unit) for log in read_fleet("plant").logs} == proposed


def test_a_log_whose_name_is_no_text_is_refused(here: Path, capsys: Capture) -> None:
    write_log(here / "a\udcff_2026-01-02.csv", 3)
    assert main(["fleet", "init", "."]) == 2
    assert "the name of a log is no text" in capsys.readouterr().err
    assert not (here / "fleet.toml").exists()
