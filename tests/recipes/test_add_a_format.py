"""The recipe "Add a format of packages" of CONTRIBUTING.md: one file, two templates, and make builds it."""

from __future__ import annotations

from pathlib import Path

import pytest

from packages.consumers import run
from recipes.copies import Copy, source_in_recipe
from robodyn.packages import FORMATS
from robodyn_testing import require_tool

pytestmark = pytest.mark.thorough
NAME = "make"
FILES = (
    f"codegen/robodyn/packages/formats/{NAME}.py",
    f"templates/package/{NAME}/Makefile.j2",
    f"templates/package/{NAME}/use.md.j2",
)


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Copy:
    assert NAME not in FORMATS
    files = {file: source_in_recipe("Add a format of packages", file) for file in FILES}
    return Copy(tmp_path_factory.mktemp("format"), files)


def package(copy: Copy, folder: str, *options: str) -> Path:
    copy.robodyn("package", "stanford_3dof", "--as", NAME, "-o", folder, "--optimize", "fast", *options)
    return copy.work / folder


def test_make_builds_and_tests_it(copy: Copy) -> None:
    for tool in ("make", "cc"):
        require_tool(tool)
    for folder, options in (("libm", ()), ("own", ("--trig", "builtin", "--scalar", "float"))):
        place = package(copy, folder, *options)
        output = run("make", "check", cwd=place)
        assert "stanford_3dof: every result is within its tolerance" in output
        assert (place / "libstanford_3dof_dynamics.a").is_file()


def test_help_and_projects_know_it(copy: Copy) -> None:
    words = " ".join(copy.robodyn("package", "--help").split())
    assert "make (a Makefile, for make and a C compiler)" in words
    (copy.work / "robodyn.toml").write_text(f"[robots.stanford_3dof]\npackages = ['{NAME}']\n")
    copy.robodyn("build", "--workers", "1")
    assert (copy.work / "packages" / "stanford_3dof" / NAME / "Makefile").is_file()
