"""The JSON Schema of ``robodyn.toml`` and the reader agree."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

import click
import pytest

from robodyn.errors import InputError
from robodyn.project.reading import OWN, read_project
from robodyn_cli.gen import command as gen
from robodyn_cli.main import main
from robodyn_cli.project_keys import check_settings, project_keys
from robodyn_testing import require_module

ROOT = Path(__file__).parents[2]
KEYS = project_keys()


def test_every_option_of_gen_that_says_what_is_written_is_a_key() -> None:
    options = {option.opts[0].removeprefix("--") for option in gen.params if isinstance(option, click.Option)}
    of_a_run = {"-o", "compile", "check", "json", "keep", "budget-seconds", "seed", "firmware"}
    assert set(KEYS) == options - of_a_run
    assert not set(KEYS) & set(OWN)
    assert all(len(key.help()) > 10 for key in KEYS.values())
    assert "gravity" in KEYS["functions"].help()
    assert {name for name, key in KEYS.items() if key.several or key.listed} == {"lang", "functions", "fuse"}


@pytest.mark.parametrize(
    ("text", "good"),
    [
        ("[robots.ur5]", True),
        ("[options]\nfunctions = ['gravity', 'bias']\nlang = 'c,fortran'\n[robots.ur5]\nmisra = true", True),
        ("[robots.ur5]\nprune = 0.01\nbudgets.gravity = {total = 5, sincos = 3}\nscalar = 'float'", True),
        ("[robots]", False),
        ("[options]", False),
        ("[robots.ur5]\nscalar = 'flot'", False),
        ("[robots.ur5]\nmisra = 'true'", False),
        ("[robots.ur5]\nmisra = 1", False),
        ("[robots.ur5]\noutput = ''", False),
        ("[robots.ur5]\nfunctions = []", False),
        ("[robots.ur5]\nfuncs = 'gravity'", False),
        ("[options]\nrobot = 'ur5'\n[robots.ur5]", False),
        ("[robots.ur5]\nbudgets.gravity.all = 5", False),
        ("[robots.ur5]\nbudgets.gravity.total = 5.5", False),
    ],
)
def test_they_accept_and_refuse_the_same(
    text: str, good: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    jsonschema = require_module("jsonschema")
    assert main(["schema", "--project"]) == 0
    schema = json.loads(capsys.readouterr().out)
    jsonschema.Draft202012Validator.check_schema(schema)
    assert jsonschema.Draft202012Validator(schema).is_valid(tomllib.loads(text)) == good
    path = tmp_path / "robodyn.toml"
    path.write_text(text)
    try:
        for entry in read_project(path, KEYS).entries:
            check_settings(entry, KEYS)
    except InputError:
        assert not good
    else:
        assert good


def test_robodyns_own_project_is_one() -> None:
    assert len(read_project(ROOT / "robodyn.toml", KEYS).entries) > 10
