"""What a hostile xacro file gets: no code run, no file made, no variable or other file read, in seconds."""

from __future__ import annotations

import os
import sys
from contextlib import suppress
from itertools import pairwise
from pathlib import Path

import pytest
import yaml

from robodyn.errors import InputError
from robodyn.formats import xacro, xacro_process
from robodyn.formats.xacro_expressions import evaluate
from robodyn.formats.xacro_files import load_yaml
from robodyn.formats.xacro_values import MATH, PYTHON, Names, Refused
from robodyn_testing import representative, require_module
from robodyn_testing.xacro_arms import HEAD, PACKAGE, write

CANARY = "canary_7f3a"
_LOOP = '<xacro:macro name="m%d"><xacro:m%d/><xacro:m%d/></xacro:macro>'


def link(expression: str, before: str = "") -> str:
    return f'{before}<link name="{expression}"/>'


def include(name: str, more: str = "") -> str:
    return f'<xacro:include filename="{name}"{more}/>'


RUN = "__import__('os').system('touch MADE')"
#: Expressions, and whole files by what they attempt: inside ``<robot>``, with what stands in the message.
HOSTILE = yaml.safe_load(Path(__file__).with_name("hostile_xacro.yaml").read_text(encoding="utf-8"))
HOSTILE["files"]["a long text"] = {"inside": link("$a" * 200000), "says": "more than 100000"}
#: Of each wall one.
FEW = (
    "a program", "import", "format", "f-string", "an argument", "a number in YAML", "Python in YAML",
    "environment", "outside by dots", "outside by a linked folder", "outside by a pattern", "a hidden file",
    "a folder that is no package", "entities, included", "itself", "aliases", "words for a terminal",
)  # fmt: skip
FILES = {
    "ws/code.yaml": f"a: !degrees {RUN}",
    "ws/python.yaml": f"!!python/object/apply:os.system ['touch MADE'] # {CANARY}",
    "ws/.secret.yaml": CANARY,
    "outside.yaml": CANARY,
    "outside.xacro": f'{HEAD}<link name="{CANARY}"/></robot>',
    "other/a.xacro": f'{HEAD}<link name="{CANARY}"/></robot>',
    "deep/down/below/far/linked/package.xml": PACKAGE % "linked",
    "ws/entities.xacro": f'<!DOCTYPE robot [<!ENTITY a SYSTEM "../outside.yaml">]>{HEAD}&a;</robot>',
    "ws/aliases.yaml": "a: &a [1,1,1,1,1,1,1,1,1]\n"
    + "".join(f"{x}: &{x} [{','.join(9 * [f'*{y}'])}]\n" for y, x in pairwise("abcdefghij")),
    "ws/itself.yaml": "&a [*a]",
    "ws/blocks.xacro": f'{HEAD}<xacro:property name="p"><b/></xacro:property></robot>',
    "ws/deep.yaml": "[" * 5000 + "]" * 5000,
}  # fmt: skip


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    require_module("xacro")
    write(tmp_path, FILES)
    (tmp_path / "ws" / "link.yaml").symlink_to(tmp_path / "outside.yaml")
    (tmp_path / "ws" / "up").symlink_to(tmp_path)
    (tmp_path / "linked").symlink_to(tmp_path / "deep" / "down" / "below" / "far" / "linked")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("ROBODYN_CANARY", CANARY)
    return tmp_path / "ws"


@pytest.mark.usefixtures("uncollected")
@pytest.mark.skipif(sys.platform == "win32", reason="missing: POSIX; links need rights on Windows")
@pytest.mark.parametrize("name", representative(HOSTILE["files"], *FEW))
def test_a_hostile_file_is_refused(name: str, folder: Path) -> None:
    inside, words = HOSTILE["files"][name].values()
    (folder / "arm.xacro").write_text(f"{HEAD}{inside}</robot>")
    files = sorted(folder.parent.rglob("*"))
    with pytest.raises(InputError) as caught:
        xacro.expanded(folder / "arm.xacro")
    message = str(caught.value)
    assert "the xacro file cannot be expanded; found " in message
    assert words in message
    assert CANARY not in message
    assert "root:" not in message
    assert " s or " not in message  # the process was not ended for its time
    assert sorted(folder.parent.rglob("*")) == files


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="missing: os.mkfifo; only POSIX has it")
def test_a_file_that_never_ends_is_not_opened(folder: Path) -> None:
    os.mkfifo(folder / "never.xacro")
    (folder / "arm.xacro").write_text(f"{HEAD}{include('never.xacro')}</robot>")
    with pytest.raises(InputError, match="this is not a regular file"):
        xacro.expanded(folder / "arm.xacro")


def test_macros_that_double_each_time_have_an_end(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(xacro, "XACRO_SECONDS", 2)
    macros = "".join(_LOOP % (i, i + 1, i + 1) for i in range(40))
    (folder / "arm.xacro").write_text(
        f'{HEAD}{macros}<xacro:macro name="m40"><a/></xacro:macro><xacro:m0/></robot>'
    )
    with pytest.raises(InputError, match="more than 2 s or"):
        xacro.expanded(folder / "arm.xacro")


def test_what_the_command_line_states_is_read(folder: Path) -> None:
    inside = link("$(env ROBODYN_CANARY)_$(optenv NONE x)") + include("$(find other)/a.xacro")
    (folder / "arm.xacro").write_text(f"{HEAD}{inside}</robot>")
    text = xacro.expanded(
        folder / "arm.xacro",
        {"env ROBODYN_CANARY": "stated", "env NONE": "y", "find other": str(folder.parent / "other")},
    ).text
    assert '<link name="stated_y"/>' in text
    assert f'<link name="{CANARY}"/>' in text


def test_a_version_that_evaluates_by_another_way_is_refused(folder: Path) -> None:
    """The walls behind: each is tried by a process that goes around the replacement."""
    import subprocess

    for line, words in (
        ("eval('1')", "exec"),
        ("open('outside.yaml')", "open"),
        ("__import__('antigravity')", "import"),
        ("__import__('os').system('touch MADE')", "os.system"),
    ):
        script = f"from robodyn.formats.xacro_process import guard; guard(); {line}"
        ended = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False)
        assert ended.returncode == 1
        assert f"went another way than it may ({words})" in ended.stderr
    assert not (folder.parent / "MADE").exists()


def test_a_version_without_what_is_replaced_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    package = require_module("xacro")
    monkeypatch.delattr(package, "safe_eval")
    with pytest.raises(Refused, match=r"no safe_eval: install 'xacro>=2\.1,<3'"):
        xacro_process.Expansion("arm.xacro", {}, ("", ""))


BOUND = {"deep": [[]], "text": "a" * 1000, "many": list(range(1000))}
GLOBAL = {**PYTHON, **MATH, "python": Names(PYTHON.__getitem__)}


def value(expression: str) -> object:
    return evaluate(expression, Names((GLOBAL | BOUND).__getitem__))


#: Expressions that are too long to be written out.
LONG = (
    "(" * 300 + ")" * 300, "-" * 9999 + "1", "1" + "+1" * 4990, "not " * 2000 + "1",
    "[" * 150 + "]" * 150 + "[0]" * 2000, "x" * 20000,
)  # fmt: skip


@pytest.mark.usefixtures("uncollected")
def test_no_expression_escapes_takes_long_or_grows() -> None:
    for case in (*HOSTILE["expressions"], *({"expression": long} for long in LONG)):
        with pytest.raises(Refused) as caught:
            value(case["expression"])
        assert case.get("says", "") in str(caught.value), case["expression"]
        assert len(str(caught.value)) < 400, case["expression"]


def test_a_mapping_gives_its_keys_and_nothing_else() -> None:
    entries = {"__class__": 1, "pop": 2, "a": 3}
    names = Names({"d": entries}.__getitem__)
    assert [evaluate(f"d.{name}", names) for name in entries] == [1, 2, 3]
    for name in ("update", "__init__", "clear"):
        with pytest.raises(Refused, match="no attribute"):
            evaluate(f"d.{name}", names)


def test_variables_of_a_comprehension_are_its_own() -> None:
    assert value("[x for x in [1, 2]] + [deep for deep in [3]] + deep") == [1, 2, 3, []]
    with pytest.raises(Refused, match="name 'x' is not defined"):
        value("[x for x in [1]] + [x]")


def test_merges_of_merges_have_an_end() -> None:
    text = "a: &a {" + ",".join(f"k{i}: 1" for i in range(99)) + "}\n"
    for key, last in zip("bcdefghijklm", "abcdefghijkl", strict=True):
        text += f"{key}: &{key} {{<<: [{','.join(9 * [f'*{last}'])}]}}\n"
    with suppress(Refused):  # newer versions of PyYAML merge a key once
        merged = load_yaml(text.encode(), "merges.yaml", float)
        assert all(set(merged[key]) == {f"k{i}" for i in range(99)} for key in "abcdefghijklm")


def test_words_of_a_file_that_is_not_yaml_are_not_repeated() -> None:
    for text in (f"root:x:0:{CANARY}\n\t- [", f"!{CANARY} a", f"a: !!binary {CANARY}", f"{{{CANARY}: [1"):
        with pytest.raises(Refused) as caught:
            load_yaml(text.encode(), "file.yaml", float)
        assert CANARY not in str(caught.value)
