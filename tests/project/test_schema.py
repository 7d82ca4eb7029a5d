"""The JSON Schema of ``robodyn.toml`` and the reader agree."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path
from typing import Any

import click
import pytest
from click.testing import CliRunner

from robodyn.errors import InputError
from robodyn.project.keys import Key
from robodyn.project.reading import OWN, OWN_OF_PACKAGE, read_project
from robodyn_cli.file_options import with_common_options
from robodyn_cli.gen import command as gen
from robodyn_cli.main import cli
from robodyn_cli.output import Document
from robodyn_cli.package import command as package
from robodyn_cli.project_keys import check_settings, project_keys
from robodyn_testing import require_module

ROOT = Path(__file__).parents[2]
KEYS = project_keys()


@pytest.mark.parametrize(
    ("command", "keys", "of_a_run", "own"),
    [
        (with_common_options(gen), KEYS.kernels, {"arg", "compile", "force", "on", "seeds"}, OWN),
        (with_common_options(package), KEYS.packages, {"arg", "as", "force"}, OWN_OF_PACKAGE),
    ],
)
def test_every_option_that_says_what_is_written_is_a_key(
    command: click.Command, keys: dict[str, Key], of_a_run: set[str], own: tuple[str, ...]
) -> None:
    options = {o.opts[0].removeprefix("--") for o in command.params if isinstance(o, click.Option)}
    assert set(keys) == options - {"-o", "check", "json", "keep", "budget-seconds", "seed"} - of_a_run
    assert not set(keys) & set(own)
    assert all(len(key.help()) > 10 for key in keys.values())
    assert '"robodyn functions" lists them' in keys["functions"].help()
    listed = {name for name, key in keys.items() if key.several or key.listed}
    assert listed == {"lang", "functions", "fuse", "without"} & set(keys)


@pytest.fixture(scope="module")
def validator() -> Any:
    """Of what ``robodyn schema --project`` prints."""
    jsonschema = require_module("jsonschema")
    printed = CliRunner().invoke(cli, ["schema", "--project"], obj=Document()).stdout
    schema = json.loads(printed)
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


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
        ("[robots.ur5]\npackages = ['cmake', 'fpm']\nlang = 'c'", True),
        (
            "[robots.ur5]\npackages.cmake = {output = 'there', version = '1.2.0', functions = ['gravity']}",
            True,
        ),
        ("[robots.ur5.packages.crate]", True),
        ("[robots.ur5]\npackages = ['cmake', 'cmake']", False),
        ("[robots.ur5]\npackages = ['cmak']", False),
        ("[robots.ur5]\npackages = 'cmake'", False),
        ("[robots.ur5]\npackages.cmak = {}", False),
        ("[robots.ur5]\npackages.cmake = true", False),
        ("[robots.ur5]\npackages.cmake.lang = 'c'", False),
        ("[robots.ur5]\npackages.cmake.scalar = 'flot'", False),
        ("[options]\npackages = ['cmake']\n[robots.ur5]", False),
    ],
)
def test_they_accept_and_refuse_the_same(text: str, good: bool, validator: Any, tmp_path: Path) -> None:
    assert validator.is_valid(tomllib.loads(text)) == good
    path = tmp_path / "robodyn.toml"
    path.write_text(text)
    try:
        for entry in read_project(path, KEYS).entries:
            check_settings(entry, KEYS)
    except InputError:
        assert not good
    else:
        assert good
