"""Each program and library is named once: in its record, which agrees with pyproject.toml and CI."""

from __future__ import annotations

import re
import shlex
import sys
import tomllib
from pathlib import Path

import pytest

from robodyn.doctor import known
from robodyn.errors import Place, ToolError
from robodyn.tools import Library, Tool, Use
from robodyn.tools.libraries import H5PY, OPTIONAL, PYYAML, REQUIRED
from robodyn.tools.programs import DEVELOPMENT, FRAMA_C, PYTHON_HEADERS

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
TOOLS = [tool for tool in known() if isinstance(tool, Tool)]


def packages(requirements: list[str]) -> set[str]:
    return {re.split(r"[<>=;\[ ]", requirement)[0] for requirement in requirements}


def test_what_is_required_is_what_pip_installs() -> None:
    assert {library.distribution for library in REQUIRED} == packages(PROJECT["dependencies"])
    assert all(library.use is Use.EVERYTHING and library.extra is None for library in REQUIRED)


def test_extras_bring_what_the_records_say() -> None:
    extras = {name: packages(lines) for name, lines in PROJECT["optional-dependencies"].items()}
    for library in OPTIONAL:
        if library.extra is not None:
            assert library.distribution in extras[library.extra]
    assert {x.distribution for x in OPTIONAL if x.extra is not None} == extras["all"]
    for_users = set(extras) - {"all", "test", "lint", "docs", "arms"}
    assert for_users == {x.extra for x in OPTIONAL if x.extra is not None} - {"all"}


def test_ci_installs_what_the_records_say() -> None:
    script = (ROOT / ".ci" / "run").read_text(encoding="utf-8")
    listed = dict(re.findall(r"\[([\w+-]+)\]=([\w+-]+)", script.partition("packages=(")[2]))
    by_name = {tool.name: tool.debian for tool in TOOLS}
    assert len(listed) > 20
    for name, package in listed.items():
        if name != "python3":
            assert by_name[name] == package, name
    assert {tool.name for tool in DEVELOPMENT} <= set(listed)


def test_every_tool_can_be_found_by_its_name() -> None:
    names = [tool.name for tool in known()]
    assert len(set(names)) == len(names)
    for tool in known():
        assert tool.install, tool.name
        assert not tool.enables.endswith("."), tool.name


def test_no_other_file_says_how_to_get_a_tool() -> None:
    records = ("codegen/robodyn/tools/", "codegen/robodyn/emit/languages/", "codegen/robodyn/targets/")
    said = []
    for path in (*(ROOT / "codegen").rglob("*.py"), *(ROOT / "cli").rglob("*.py")):
        name = path.relative_to(ROOT).as_posix()
        text = path.read_text(encoding="utf-8")
        if re.search(r"(apt(-get)?|dnf|brew) install|pip install '?(?!--|robodyn\b)[\w\[]", text):
            said += [] if name.startswith(records) else [name]
    assert said == []


class TestTool:
    @pytest.fixture(autouse=True)
    def _path(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setenv("PATH", str(tmp_path))
        for name in ("second", "third"):
            (tmp_path / name).write_text("#!/bin/sh\n", encoding="utf-8")
            (tmp_path / name).chmod(0o755)

    def test_the_first_name_that_is_there(self, tmp_path: Path) -> None:
        tool = Tool(("first", "second", "third"), Use.PROOFS, "proofs", "first-package", "https://first.org")
        assert tool.path() == tool.needed() == str(tmp_path / "second")
        assert tool.remedy == "first (Debian, Ubuntu: apt install first-package; https://first.org)"
        assert (
            Tool(("first",), Use.PROOFS, "proofs", None, "https://first.org").install == "https://first.org"
        )

    def test_one_that_is_nowhere(self) -> None:
        assert FRAMA_C.path() is None
        assert FRAMA_C.command() is None
        with pytest.raises(ToolError, match=r"no program frama-c; install it: .*apt install frama-c-base"):
            FRAMA_C.needed()

    def test_the_environment_comes_first(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        tool = Tool(("second",), Use.KERNELS, "kernels", "second", variable="OWN")
        monkeypatch.delenv("OWN", raising=False)
        assert tool.command() == (str(tmp_path / "second"),)
        monkeypatch.setenv("OWN", f"{shlex.quote(str(tmp_path / 'third'))} -m32")
        assert tool.command() == (str(tmp_path / "third"), "-m32")
        for wrong in ("nowhere", "'"):
            monkeypatch.setenv("OWN", wrong)
            assert tool.command() is None

    def test_a_file_in_a_folder(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr("sysconfig.get_path", lambda name: str(tmp_path))
        assert PYTHON_HEADERS.path() is None
        (tmp_path / "Python.h").write_text("", encoding="utf-8")
        assert PYTHON_HEADERS.path() == str(tmp_path / "Python.h")


class TestLibrary:
    def test_one_that_is_here(self) -> None:
        assert PYYAML.present()
        assert PYYAML.load().safe_load("1") == 1
        assert PYYAML.load("tokens").__name__ == "yaml.tokens"
        assert PYYAML.install == "pip install pyyaml"
        library = Library("module", Use.LOGS, "logs", package="dist", title="Title")
        assert (library.name, library.distribution) == ("Title", "dist")

    def test_one_that_is_missing(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setitem(sys.modules, "h5py", None)
        assert not H5PY.present()
        with pytest.raises(ToolError) as caught:
            H5PY.load(where=Place("log.mat"), otherwise="save it as CSV")
        assert str(caught.value) == (
            "log.mat: logs of MATLAB 7.3 and in HDF5 need h5py, which is not installed; "
            "pip install 'robodyn[mat]', or save it as CSV"
        )
