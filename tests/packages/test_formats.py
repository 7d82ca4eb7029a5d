"""Every format of packages: found in its folder, named nowhere else, the same bytes, nobody else's files;
shared libraries as bytes."""

from __future__ import annotations

import ast
import re
import zipfile
from io import BytesIO
from pathlib import Path, PurePosixPath

import pytest

from robodyn.dynamics.functions import by_default, function_named
from robodyn.errors import InputError, ToolError
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.outputs import is_marked
from robodyn.packages import FORMATS, Format, format_named, package
from robodyn.packages.format import Maintainer, Trait
from robodyn.packages.writing import zipped
from robodyn.robot import read_text
from robodyn.toolchain.compiler import shared_library
from robodyn_testing import require_tool

TOP = Path(__file__).parents[2]
ARM = """name: elbow
links:
- {joint: revolute, alpha: 1, mass: 3, com: [1, 0, 0.5], motor_inertia: 1}
- {joint: revolute, a: 1, mass: 2, motor_inertia: 1}
"""
#: What not every format has a place for: a description and the sines.
TRAITS = {
    "parameters": (ARM.replace("mass: 3", "mass: m_1"), "libm"),
    "memory": (
        ARM.replace(
            "mass: 3", "effects: [{effect: presliding_hysteresis, stiffness: 10, level: 1}], mass: 3"
        ),
        "libm",
    ),
    "given sines": (ARM, "given"),
}
FILES = sorted(
    path.relative_to(TOP)
    for place in ("codegen/robodyn/packages", "codegen/robodyn/project", "cli")
    for path in (TOP / place).rglob("*.py")
    if "packages/formats" not in path.as_posix()
)


def kernels(form: Format, text: str = ARM, **options: str) -> Generated:
    """Those of a small arm with the format's own options."""
    functions = tuple(dict.fromkeys((*(form.functions or by_default()[:1]), *form.needs)))
    return generate(read_text(text), Options(functions=functions, **{**form.options, **options}))  # type: ignore[arg-type]


def every() -> list[object]:
    """Formats that need a compiler are compiled in the thorough tests only."""
    marks = {name: [pytest.mark.thorough] * FORMATS[name].binary for name in FORMATS}
    return [pytest.param(name, marks=marks[name]) for name in FORMATS]


@pytest.mark.parametrize("file", FILES, ids=str)
def test_no_other_file_names_a_format(file: Path) -> None:
    tree = ast.parse((TOP / file).read_text(encoding="utf-8"))
    assert not {node.value for node in ast.walk(tree) if isinstance(node, ast.Constant)} & set(FORMATS)


@pytest.mark.parametrize("name", FORMATS)
def test_a_record_is_whole(name: str) -> None:
    form = FORMATS[name]
    assert form.title
    assert form.tool
    assert form.take.format(folder="here", name="arm_dynamics") != form.take
    for function in (*form.functions, *form.needs):
        function_named(function)
    assert set(form.needs) <= set(form.functions or by_default())


def test_the_document_has_a_row_for_each() -> None:
    text = (TOP / "docs" / "packages.md").read_text(encoding="utf-8")
    rows = re.findall(r"(?m)^\| \[?`(\w+)`(?:\]\(#[\w-]+\))? \| ", text)
    assert rows == list(FORMATS)


@pytest.mark.parametrize("name", every())
def test_the_files(name: str) -> None:
    """Inside the folder, each of them marked as ours, and the same at every time."""
    form = FORMATS[name]
    if form.binary:
        require_tool("cc")
    for path, content in package(kernels(form), form).files().items():  # without a licence
        assert not re.search(r"todo|fixme", str(content), re.IGNORECASE), path
    packed = package(kernels(form), form, license="MIT")
    files = packed.files()
    assert list(files.items()) == list(packed.files().items())
    for path, content in files.items():
        pure = PurePosixPath(path)
        assert not pure.is_absolute()
        assert ".." not in pure.parts
        data = content if isinstance(content, bytes) else content.encode("utf-8")
        assert is_marked(data), f"{path}: a second run would take it for somebody else's"
        if isinstance(content, str):
            assert content.endswith("\n")
            assert "\n\n\n\n" not in content
            assert " \n" not in content


@pytest.mark.parametrize("trait", TRAITS)
@pytest.mark.parametrize("name", FORMATS)
def test_what_has_no_place_is_refused(name: str, trait: Trait) -> None:
    form = FORMATS[name]
    text, trig = TRAITS[trait]
    if trig in form.language.trigonometry:
        generated = kernels(form, text, trig=trig)
        if trait in form.lacks:
            with pytest.raises(InputError, match=f"{form.title} has no place for"):
                package(generated, form)
        else:
            assert package(generated, form).kernel()


def test_an_unknown_format() -> None:
    with pytest.raises(InputError, match=r"unknown format of a package 'cmak'.*did you mean 'cmake'\?"):
        format_named("cmak")


@pytest.mark.parametrize(
    ("text", "name", "email"),
    [
        ("Ada Lovelace <ada@example.org>", "Ada Lovelace", "ada@example.org"),
        (" J. O’Brien-Søns  & Co+\t<a.b+c%d@x-y.org>", "J. O’Brien-Søns & Co+", "a.b+c%d@x-y.org"),
        ("आरती 2 <arti@example.org>", "आरती 2", "arti@example.org"),
    ],
)  # fmt: skip
def test_a_maintainer(text: str, name: str, email: str) -> None:
    form = next(iter(FORMATS.values()))
    packed = package(kernels(form), form, maintainer=text)
    assert packed.maintainer == Maintainer(name, email)
    assert f"maintained by {name.replace('&', '&amp;')} ({email})" in packed.files()["README.md"]


@pytest.mark.parametrize(
    ("what", "text", "message"),
    [
        ("version", "1.0.0\n", "no version of a package"),
        ("license", "MIT\nGPL", "this is no licence"),
        ("license", "x" * 200, "this is no licence"),
        ("maintainer", "x" * 300 + " <ada@example.org>", "this name of a maintainer"),
        ("maintainer", "Ada \u202eavA <ada@example.org>", "this name of a maintainer"),
        ("maintainer", "Ada <ada@example.org\n>", "this is no address"),
        ("maintainer", f"Ada <{'a' * 300}@example.org>", "this is no address"),
    ],
)
def test_what_would_end_a_line_or_fill_a_page(what: str, text: str, message: str) -> None:
    """What else nobody is called: cli/golden/package.txt."""
    form = next(iter(FORMATS.values()))
    with pytest.raises(InputError, match=message):
        package(kernels(form), form, **{what: text})


def test_an_archive() -> None:
    files: dict[str, str | bytes] = {"b/c.txt": "text\n", "a.bin": b"\0\1"}
    data = zipped(files)
    assert data == zipped(files)
    with zipfile.ZipFile(BytesIO(data)) as archive:
        assert archive.namelist() == ["b/c.txt", "a.bin"]
        assert archive.read("a.bin") == b"\0\1"
        assert archive.testzip() is None


def test_what_the_compiler_refuses() -> None:
    require_tool("cc")
    with pytest.raises(ToolError, match=r"the C compiler failed at wrong\.c; found .*error"):
        shared_library({"wrong.c": "double wrong(void) { return; ]\n"}, "libwrong.so")
