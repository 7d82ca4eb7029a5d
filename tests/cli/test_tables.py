"""``robodyn tables``: text and JSON, one table or all, the picture."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from robodyn.thesis import tables as rooms
from robodyn.thesis.tables import TABLE_IDS, make, pictures, to_text
from robodyn_cli.main import main

Capture = pytest.CaptureFixture[str]


def run(capsys: Capture, *arguments: str, code: int = 0) -> tuple[str, str]:
    assert main(["tables", *arguments]) == code
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    return out, err


def test_one_table(capsys: Capture) -> None:
    assert run(capsys, "4.4") == (to_text(make("4.4")), "")
    assert json.loads(run(capsys, "4.4", "--json")[0]) == make("4.4").to_dict()


def test_all_tables(capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    asked = []

    def quick(table: str, progress: object) -> rooms.Table:
        asked.append(table)
        return make("4.4")

    monkeypatch.setattr(rooms, "make", quick)
    assert run(capsys) == ("\n".join([to_text(make("4.4"))] * len(TABLE_IDS)), "")
    assert tuple(asked) == TABLE_IDS
    assert [found["id"] for found in json.loads(run(capsys, "--json")[0])] == ["4.4"] * len(TABLE_IDS)


def test_the_picture(tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pictures, "operations_svg", lambda: "<svg/>\n")
    file = tmp_path / "new" / "figure.svg"
    out, err = run(capsys, "2.9", "--picture", str(file))
    assert out == to_text(make("2.9"))
    assert "wrote" in err
    assert file.read_text() == "<svg/>\n"
