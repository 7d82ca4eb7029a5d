"""``robodyn tables``: text and JSON, one table or all, the picture, and what is refused."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from robodyn.thesis import tables as rooms
from robodyn.thesis.tables import TABLE_IDS, make, picture, to_text
from robodyn_cli.main import main

Capture = pytest.CaptureFixture[str]


def run(capsys: Capture, *arguments: str, code: int = 0) -> tuple[str, str]:
    assert main(["tables", *arguments]) == code
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    return out, err


@pytest.mark.parametrize("table", ["2.9", "3.3", "4.2", "4.4", "4.5", "4.6"])
def test_one_table(table: str, capsys: Capture) -> None:
    out, err = run(capsys, table)
    assert out == to_text(make(table))
    assert err == ""
    found = json.loads(run(capsys, table, "--json")[0])
    assert found == make(table).to_dict()


def test_all_tables(capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    asked = []

    def quick(table: str, progress: object) -> rooms.Table:
        asked.append(table)
        return make("4.4")

    monkeypatch.setattr(rooms, "make", quick)
    out, err = run(capsys)
    assert tuple(asked) == TABLE_IDS
    assert out == "\n".join([to_text(make("4.4"))] * len(TABLE_IDS))
    assert err == ""
    assert [found["id"] for found in json.loads(run(capsys, "--json")[0])] == ["4.4"] * len(TABLE_IDS)


def test_the_picture(tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(picture, "operations_svg", lambda: "<svg/>\n")
    file = tmp_path / "new" / "figure.svg"
    out, err = run(capsys, "2.9", "--picture", str(file))
    assert out == to_text(make("2.9"))
    assert "wrote" in err
    assert file.read_text() == "<svg/>\n"
