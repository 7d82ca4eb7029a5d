"""The JSON Schema of ``fleet.toml`` and the reader agree."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

import pytest

from robodyn.errors import InputError
from robodyn.fleet.sources.reading import OF_LOGS, OF_TYPE, TOP, read_fleet
from robodyn.fleet.sources.schema import fleet_file_schema
from robodyn_cli.main import main
from robodyn_testing import require_module

FILES = "[[logs]]\nfiles = 'logs/{unit}/{date}.csv'\n"
MANIFEST = "[[logs]]\nmanifest = 'm.csv'\n"


def test_they_have_the_same_keys(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["schema", "--fleet-file"]) == 0
    schema = json.loads(capsys.readouterr().out)
    assert set(schema["properties"]) == set(TOP)
    assert set(schema["properties"]["types"]["additionalProperties"]["properties"]) == set(OF_TYPE)
    entries = schema["properties"]["logs"]["items"]["oneOf"]
    assert {key for entry in entries for key in entry["properties"]} == set(OF_LOGS)


@pytest.mark.parametrize(
    ("text", "good"),
    [
        ("[types.ur5]\n" + FILES, True),
        ("name = 'x'\ntimezone = 'UTC'\n[types.ur5]\nrobot = 'ur5'\nparameters = {}\n" + FILES, True),
        ("[types.ur5]\n" + FILES + "exclude = ['a/*']\nconditions = {load = 2}\ntype = 'ur5'\n", True),
        ("[types.ur5]\n" + MANIFEST + "columns = {unit = 'serial'}\nconditions = ['load']\n", True),
        ("[types.ur5]\n" + MANIFEST + "conditions = {load = 'load'}\nexclude = 'b*'\n", True),
        ("[types.ur5]\n", False),
        (FILES, False),
        ("[types]\n" + FILES, False),
        ("[types.ur5]\nlogs = []\n" + FILES, False),
        ("name = 3\n[types.ur5]\n" + FILES, False),
        ("[types.ur5]\nmap = 'm.yaml'\ncolumns = 'q=q%d'\n" + FILES, False),
        ("[types.ur5]\nparameters = {m = 'x'}\n" + FILES, False),
        ("[types.ur5]\n" + FILES + "manifest = 'm.csv'\n", False),
        ("[types.ur5]\n" + FILES + "columns = {unit = 'x'}\n", False),
        ("[types.ur5]\n" + FILES + "conditions = ['load']\n", False),
        ("[types.ur5]\n" + FILES + "exclude = [3]\n", False),
        ("[types.ur5]\n" + FILES + "date = 3\n", False),
        ("[types.ur5]\n" + MANIFEST + "columns = {serial = 'unit'}\n", False),
        ("[types.ur5]\n" + MANIFEST + "conditions = [3]\n", False),
        ("[types.ur5]\n" + MANIFEST + "conditions = {load = 3}\n", False),
        ("[types.ur5]\n[[logs]]\nunit = 'x'\n", False),
    ],
)
def test_they_accept_and_refuse_the_same(text: str, good: bool, tmp_path: Path) -> None:
    jsonschema = require_module("jsonschema")
    schema = fleet_file_schema()
    jsonschema.Draft202012Validator.check_schema(schema)
    assert jsonschema.Draft202012Validator(schema).is_valid(tomllib.loads(text)) == good
    (tmp_path / "logs" / "7").mkdir(parents=True)
    (tmp_path / "logs" / "7" / "2026-05-03.csv").touch()
    (tmp_path / "map.yaml").write_text("q: q%d\n", encoding="utf-8")
    header = "source,serial,unit,date,load\n"
    (tmp_path / "m.csv").write_text(f"{header}logs/7/2026-05-03.csv,7,7,2026-05-03,1\n", encoding="utf-8")
    (tmp_path / "fleet.toml").write_text(text, encoding="utf-8")
    try:
        assert read_fleet(tmp_path).logs
    except InputError:
        assert not good
    else:
        assert good
