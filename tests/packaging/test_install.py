"""Installed from an sdist, a wheel and in editable mode, in a clean environment, seen from another folder."""

from __future__ import annotations

import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

from robodyn_testing.environments import clean_environment, pip_install, run

pytestmark = pytest.mark.thorough
ROOT = Path(__file__).parents[2]
DATA = {
    f"robodyn/_data/{path.relative_to(ROOT).as_posix()}"
    for folder in ("templates", "robots")
    for path in (ROOT / folder).rglob("*")
    if path.is_file()
}


def use(environment: Path, folder: Path) -> Path:
    """What a user does first, from `folder`; returns where the installed package lies."""
    robodyn = environment / "bin" / "robodyn"
    folder.mkdir()
    names = run(robodyn, "robots", "--names", cwd=folder).split()
    assert names == sorted(path.stem for path in (ROOT / "robots").glob("*.yaml"))
    run(robodyn, "gen", "puma560", "-o", "out", cwd=folder)
    assert {"puma560.c", "puma560.h"} <= {path.name for path in (folder / "out").iterdir()}
    assert list(folder.iterdir()) == [folder / "out"]
    where = "import robodyn; print(robodyn.__file__)"
    return Path(run(environment / "bin" / "python", "-c", where, cwd=folder).strip()).parent


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with an sdist made from the checkout, and the wheel made from that sdist."""
    folder = tmp_path_factory.mktemp("dist")
    run(sys.executable, "-m", "build", "--no-isolation", "--outdir", folder, ROOT, cwd=folder)
    return folder


@pytest.fixture(scope="module")
def environment(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A clean virtual environment, without even pip."""
    return clean_environment(tmp_path_factory.mktemp("clean") / "venv")


def wheel_of(folder: Path) -> Path:
    (wheel,) = folder.glob("*.whl")
    return wheel


def test_wheel_holds_code_and_data(built: Path) -> None:
    names = set(zipfile.ZipFile(wheel_of(built)).namelist())
    assert names >= DATA
    assert any(name.startswith("robodyn/_data/robots/") for name in DATA)
    assert any(name.startswith("robodyn/_data/templates/") for name in DATA)
    for source, package in (("codegen", "robodyn"), ("cli", "robodyn_cli")):
        files = {
            path.relative_to(ROOT / source).as_posix() for path in (ROOT / source / package).rglob("*.py")
        }
        assert names >= files | {f"{package}/py.typed"}
    others = {name.partition("/")[0] for name in names} - {"robodyn", "robodyn_cli"}
    assert {name.partition("-")[2] for name in others} == {"0.1.0.dist-info"}
    assert not [name for name in names if "__pycache__" in name]


def test_sdist_builds_the_same_wheel(built: Path, tmp_path: Path) -> None:
    run(sys.executable, "-m", "build", "--no-isolation", "--wheel", "--outdir", tmp_path, ROOT, cwd=tmp_path)
    assert wheel_of(tmp_path).read_bytes() == wheel_of(built).read_bytes()


def test_sdist_holds_what_the_tests_need(built: Path) -> None:
    (sdist,) = built.glob("*.tar.gz")
    with tarfile.open(sdist) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
    assert {"pyproject.toml", "README.md", "LICENSE", "NOTICE", "Makefile", "tests/conftest.py"} <= names


def test_wheel_installs_and_works(built: Path, environment: Path, tmp_path: Path) -> None:
    pip_install(environment, f"{wheel_of(built)}[all]")
    package = use(environment, tmp_path / "elsewhere")
    assert package.is_relative_to(environment)


def test_editable_installs_and_works(environment: Path, tmp_path: Path) -> None:
    pip_install(
        environment, "--editable", ROOT
    )  # in place of the wheel, whose dependencies are there already
    package = use(environment, tmp_path / "elsewhere")
    assert package == ROOT / "codegen" / "robodyn"
