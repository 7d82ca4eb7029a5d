"""``fleet.json`` and ``fleet.parquet``: whole, as their schema says, the same bytes from the same result."""

from __future__ import annotations

import io
import json
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import pytest

from report.made_up import fleet, of_one
from robodyn.errors import ToolError
from robodyn.fleet.as_json import document, fleet_schema, text
from robodyn.fleet.result import FleetResult, address, unit_folder
from robodyn.fleet.table import COLUMNS, parquet, rows_of
from robodyn.tools.libraries import PYARROW
from robodyn_cli.main import main
from robodyn_testing import require_module


@pytest.fixture(scope="module")
def small() -> FleetResult:
    return fleet(12, 4)


@pytest.mark.parametrize("result", [fleet(12, 4), of_one(), replace(fleet(3, 0), types=(), units=())])
def test_the_json_is_as_its_schema_says(result: FleetResult) -> None:
    jsonschema = require_module("jsonschema")
    schema = fleet_schema()
    jsonschema.Draft202012Validator.check_schema(schema)
    read = json.loads(text(document(result)))
    jsonschema.Draft202012Validator(schema).validate(read)
    assert read == document(result)


def test_the_schema_refuses_what_is_not_there(small: FleetResult) -> None:
    validator = require_module("jsonschema").Draft202012Validator(fleet_schema())
    for path, value in (
        (("false_names",), "0.05"),
        (("units", 0, "claims", 0, "since"), 5),
        (("units", 0, "claims", 0, "shape"), "jump"),
        (("units", 0, "claims", 0, "since_interval"), ["2025-01-01T00:00:00Z"]),
        (("units", 0, "more"), 1),
        (("types", 0, "features", 0, "effects"), "backlash"),
    ):
        wrong = document(small)
        at: Any = wrong
        for key in path[:-1]:
            at = at[key]
        at[path[-1]] = value
        assert not validator.is_valid(wrong), path


def test_the_table_has_a_row_for_each_unit_and_feature(small: FleetResult) -> None:
    files = require_module("pyarrow.parquet")
    table = files.read_table(io.BytesIO(parquet(small))).to_pylist()
    assert len(table) == sum(len(unit.readings) for unit in small.units) == len(list(rows_of(small)))
    assert list(table[0]) == list(COLUMNS)
    claims = {(u.type, u.unit, c.feature): c for u in small.units for c in u.claims}
    rows = {(row["type"], row["unit"], row["feature"]): row for row in table}
    assert {key for key, row in rows.items() if row["claimed"]} == set(claims)
    for key, claim in claims.items():
        row = rows[key]
        assert (row["size"], row["size_stderr"], row["share"], row["p"], row["q"]) == (
            claim.size, claim.stderr, claim.share, claim.p, claim.q,
        )  # fmt: skip
        assert (row["joint"], row["shape"], row["claimed_effects"]) == (
            claim.joint,
            claim.shape,
            list(claim.effects),
        )
        since = None if claim.since is None else datetime.fromtimestamp(round(claim.since), UTC)
        assert row["since"] == since
    quiet = next(row for row in table if not row["claimed"])
    empty = ("shape", "since", "since_from", "since_to", "size", "claimed_effects", "q")
    assert [quiet[name] for name in empty] == [None] * len(empty)
    assert parquet(small) == parquet(fleet(12, 4))


def test_a_number_that_is_none_is_null_in_the_table(small: FleetResult) -> None:
    files = require_module("pyarrow.parquet")
    unit = replace(small.units[0], unusual=dict.fromkeys(small.units[0].unusual, float("nan")), now={})
    table = files.read_table(io.BytesIO(parquet(replace(small, units=(unit,))))).to_pylist()
    assert {(row["unusual"], row["value"], row["stderr"]) for row in table} == {(None, None, None)}


def test_without_pyarrow_there_is_a_remedy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, PYARROW.module, None)
    with pytest.raises(ToolError, match="pyarrow"):
        parquet(fleet(3, 0))


def test_the_command_prints_the_schema(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["schema", "--fleet"]) == 0
    assert json.loads(capsys.readouterr().out) == fleet_schema()
    assert main(["schema", "--fleet", "--project"]) == 2
    assert "--project and --fleet cannot be combined" in capsys.readouterr().err


# --- folders of units -------------------------------------------------------------------------------------


NAMES = (
    "A-12", "cell 7", "..", ".", "", "/etc/passwd", "a/b", "a\\b", "%2E", "<b>", "x\ny", "\0", "x" * 300,
    "x" * 301, "é" * 200, "\udcff", ".hidden", "C:",
)  # fmt: skip


def test_plain_names_stay_as_they_are() -> None:
    assert unit_folder("ur5", "A-12 (left)") == "units/ur5/A-12 (left)"


@pytest.mark.parametrize("name", NAMES)
def test_a_folder_can_be_made_and_is_two_levels_down(name: str, tmp_path: Path) -> None:
    folder = unit_folder(name, name)
    assert folder.count("/") == 2
    (tmp_path / folder).mkdir(parents=True)
    assert (tmp_path / folder).resolve().parents[2] == tmp_path.resolve()


def test_no_two_units_share_a_folder() -> None:
    assert len({unit_folder(a, b) for a in NAMES for b in NAMES}) == len(NAMES) ** 2


def test_addresses_lead_to_folders() -> None:
    assert address("units/a b/%2E") == "units/a%20b/%252E"
    assert unquote(address(unit_folder("a?b", "#c"))) == unit_folder("a?b", "#c")
