"""What a hostile xacro file gets: no code run, no file made, no variable or other file read, in seconds."""

from __future__ import annotations

import os
import sys
from contextlib import suppress
from itertools import pairwise
from pathlib import Path

import pytest

from robodyn.errors import InputError
from robodyn.formats import xacro, xacro_process
from robodyn.formats.xacro_expressions import evaluate
from robodyn.formats.xacro_files import load_yaml
from robodyn.formats.xacro_values import MATH, PYTHON, Names, Refused
from robodyn_testing import require_module
from robodyn_testing.xacro_arms import HEAD, PACKAGE, write

CANARY = "canary_7f3a"
_LOOP = '<xacro:macro name="m%d"><xacro:m%d/><xacro:m%d/></xacro:macro>'


def link(expression: str, before: str = "") -> str:
    return f'{before}<link name="{expression}"/>'


def include(name: str, more: str = "") -> str:
    return f'<xacro:include filename="{name}"{more}/>'


def loaded(name: str) -> str:
    return link(f"${{xacro.load_yaml('{name}')}}")


RUN = "__import__('os').system('touch MADE')"
_GET = "python['vars'](python['type'](%s))['%s']"
_GLOBALS = _GET % ("xacro.load_yaml", "__globals__")
_MODULES = f"{_GET % (_GLOBALS, '__get__')}({_GLOBALS}, xacro.load_yaml)"
#: What ran a program as long as names were refused by their spelling.
PROGRAM = f"python['vars']({_MODULES}['os'])['system']('touch MADE')"
#: Whole files by what they attempt: inside ``<robot>``, with what stands in the message.
HOSTILE = {
    "a program": (link(f"${{{PROGRAM}}}"), "name 'vars' is not defined"),
    "vars by subscript": (link("${python['vars'](python['type'](1))}"), "name 'vars' is not defined"),
    "class": (link("${().__class__.__bases__[0].__subclasses__()}"), "no attribute '__class__'"),
    "globals of a function": (link("${xacro.load_yaml.__globals__}"), "no attribute '__globals__'"),
    "frame": (link("${(x for x in [1]).gi_frame.f_back}"), "no attribute 'gi_frame'"),
    "import": (link(f"${{{RUN}}}"), "name '__import__' is not defined"),
    "lambda": (link("${(lambda f: f(f))(lambda f: f(f))}"), "nested too deeply"),
    "walrus": (link("${[x := 1]}"), "NamedExpr is not"),
    "format": (link("${f.format(sin)}", '<xacro:property name="f" value="{0.__self__}"/>'),
    "no attribute 'format'"),
    "f-string": (link("$(eval f'{sin.__self__}')"), "JoinedStr is not"),
    "percent": (link("${'%(a.__class__)s' % dict(a=1)}"), "a field of a text"),
    "percent of a function": (link("${'%s' % sin}"), "is not a value"),
    "eval by a property": (link("${p}", f'<xacro:property name="p" value="${{{RUN}}}"/>'), "__import__"),
    "a default": ('<xacro:macro name="m" params="a:=${().__class__}"/><xacro:m/>', "__class__"),
    "a condition": ('<xacro:if value="${().__class__}"/>', "__class__"),
    "an argument": ('<xacro:arg name="a" default="${().__class__}"/>', "__class__"),
    "a name of a macro": ('<xacro:call macro="${().__class__}"/>', "__class__"),
    "a number in YAML": (loaded("code.yaml"), "__import__"),
    "Python in YAML": (loaded("python.yaml"), "python.yaml:1: not plain YAML"),
    "environment": (link("$(env ROBODYN_CANARY)"), "ROBODYN_CANARY is not read"),
    "environment, by default": (link("$(optenv ROBODYN_CANARY x)"), "ROBODYN_CANARY is not read"),
    "environment, in eval": (link("$(eval env)"), "no argument 'env'"),
    "outside by dots": (loaded("../outside.yaml"), "outside the file's folder"),
    "outside by an absolute path": (loaded("/etc/passwd"), "outside the file's folder"),
    "outside by file": (loaded("file:///etc/passwd"), "outside the file's folder"),
    "outside by a linked folder": (loaded("up/outside.yaml"), "outside the file's folder"),
    "outside, if it is there": (include("/etc/passwd", ' optional="true"'), "outside the file's folder"),
    "outside by a link": (loaded("link.yaml"), "outside the file's folder"),
    "outside, included": (include("../outside.xacro"), "outside the file's folder"),
    "outside by a pattern": (include("../out*.xacro"), "outside the file's folder"),
    "outside by a pattern of folders": (include("*/out*.xacro"), "a pattern of folders"),
    "a hidden file": (loaded(".secret.yaml"), "outside the file's folder"),
    "a folder that is no package": (include("$(find other)/a.xacro"), "no package.xml"),
    "a package of dots": (link("$(find ..)"), "is no name of a package"),
    "a link called package": (include("$(find linked)/a.xacro"), "no package.xml"),
    "entities, included": (include("entities.xacro"), "document type"),
    "no XML, included": (include("python.yaml"), "python.yaml:1: "),
    "itself": (include("arm.xacro"), "without end"),
    "a macro of itself": ('<xacro:macro name="m"><xacro:m/></xacro:macro><xacro:m/>', "without end"),
    "aliases": (loaded("aliases.yaml"), "more than 100000"),
    "itself in YAML": (loaded("itself.yaml"), "more than 100000"),
    "deep YAML": (loaded("deep.yaml"), "nested too deeply"),
    "texts that double": (
        "".join(f'<xacro:property name="x{i}" value="a${{x{i + 1}}}${{x{i + 1}}}"/>' for i in range(40))
        + link("${x0}", '<xacro:property name="x40" value="a"/>'),
        "more than 100000",
    ),
    "a long text": (link("$a" * 200000), "more than 100000"),
    "words for a terminal": ("<xacro:call macro=\"${'\\x1b[31m'}\"/>", "unknown macro name: xacro:\\x1b[31m"),
    "a mapping of blocks": (link("${a['**p']}", include("blocks.xacro", ' ns="a"')), "is not a value"),
    "a function as a value": (link("${sin}"), "a function is not a value"),
}  # fmt: skip
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


@pytest.mark.skipif(sys.platform == "win32", reason="missing: POSIX; links need rights on Windows")
@pytest.mark.parametrize("name", HOSTILE)
def test_a_hostile_file_is_refused(name: str, folder: Path) -> None:
    inside, words = HOSTILE[name]
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


@pytest.mark.parametrize(
    "expression",
    [
        "10 ** 10 ** 10", "(2 ** 2000) ** 2000", "2 ** 4095 * 2 ** 4095",
        "'a' * 10 ** 9", "[0] * 10 ** 9", "(0,) * 10 ** 9", "range(10 ** 9)",
        "range(10 ** 30)",
        "'%1000000000d' % 1", "'%.1000000000f' % 1", "'%*d' % (10 ** 9, 1)", "('%099d' * 9999) % 1",
        "text.replace('', text)", "text.replace('a', text * 10)", "text.join([text] * 999)",
        "round(5, -10 ** 9)", "int('9' * 9999)", "int('f' * 9999, 16)",
        "[x for x in many for y in many for z in many]", "[1 for x in many for y in many for z in many if 0]",
        "[text * 90 for x in many]", "zip(*[many] * 1000)", "map(list, [many] * 1000)",
        "sum([many] * 1000, [])",
        "sorted(many, key=range)", "'(' * 9999 + 1", "(" * 300 + ")" * 300, "-" * 9999 + "1",
        "1" + "+1" * 4990,
        "not " * 2000 + "1", "[" * 150 + "]" * 150 + "[0]" * 2000, "x" * 20000,
        "[many] * 101", "dict(a=many, b=[many] * 99)", "set([many])", "1j", "b'a'", "...", "(-8) ** 0.5",
        "divmod(1, 0)", "many.append(1)", "text.encode()", "dict.fromkeys(many)", "str.upper", "text.__len__",
        "python", "python.len", "many[sin]", "(yield)", "await x", "x if", "a; b", "[*sin]",
        "isinstance(1, 1)",
        "python.setattr", "type(sin)", "bool(python)", "-sin", "sin < cos", "sin + 1", "map(1, many)",
        "lambda x: x", "(lambda *x: x)(1)", "(lambda x=1: x)()", "(lambda x: x)()",
        "map(lambda x: many, many)",
    ],
)  # fmt: skip
def test_no_expression_takes_long_or_grows(expression: str) -> None:
    with pytest.raises(Refused) as caught:
        value(expression)
    assert len(str(caught.value)) < 400


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
