"""``gen --readable``: every line says its link and quantity; operations and results are those without it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from robodyn.counts import count
from robodyn.emit.headings import QUANTITIES
from robodyn.kernels.generate import Options, generate
from robodyn.robot import bundled_names, load
from robodyn_cli.main import main
from robodyn_testing import sampled

#: A value's declaration, and a heading, by the file's ending.
DEFINED = {"c": r"^    const \w+ (\w+) =", "f90": r"^    (\w+) = ", "rs": r"^    let (\w+)(?:: \w+)? ="}
HEADING = {"c": r"^    /\* (.*) \*/$", "f90": r"^    ! (.*)$", "rs": r"^    // (.*)$"}
LANGUAGES = {"c": "c", "f90": "fortran", "rs": "rust"}
ANONYMOUS = re.compile(r"\bt\d+\b")
PART = re.compile(r"(?P<quantity>[A-Za-z]+?)(?P<link>\d+)_part\d+(?:_\d+)?")


def text_of(robot: str, ending: str, *, readable: bool) -> str:
    options = Options(optimize="none", order="recursion", readable=readable)
    made = generate(load(robot, warn=lambda _: None), options)
    (text,) = (t for name, t in made.files((LANGUAGES[ending],)).items() if name.endswith(f".{ending}"))
    return text


@pytest.mark.parametrize("ending", LANGUAGES)
def test_no_line_is_anonymous(ending: str) -> None:
    plain, text = (text_of("puma560", ending, readable=readable) for readable in (False, True))
    assert ANONYMOUS.search(plain)
    assert not ANONYMOUS.search(text)
    assert "w2_part1" in text


@pytest.mark.parametrize("ending", LANGUAGES)
def test_a_part_stands_under_the_heading_of_its_step(ending: str) -> None:
    heading, parts = "", 0
    for line in text_of("puma560", ending, readable=True).splitlines():
        titled = re.match(HEADING[ending], line)
        if titled:
            heading = titled[1]
        name = re.match(DEFINED[ending], line)
        part = PART.fullmatch(name[1]) if name else None
        if part and part["quantity"] in QUANTITIES:
            step = QUANTITIES[part["quantity"]][:20]
            of_all_links = step.startswith("factorisation")
            assert heading.startswith(step if of_all_links else f"link {part['link']}: {step}"), line
            parts += 1
    assert parts > 10


@pytest.mark.parametrize("name", sampled(bundled_names(), every=12, rest="slow"))
def test_the_operations_are_those_without_it(name: str) -> None:
    robot = load(name, warn=lambda _: None)
    plain = generate(robot, Options(optimize="none", order="recursion"))
    readable = generate(robot, Options(readable=True))
    assert plain.counts == readable.counts
    assert [p for _, p in plain.unit.functions] == [p for _, p in readable.unit.functions]
    assert {
        f: count(p) for (_, p), f in zip(readable.unit.functions, readable.counts, strict=True)
    } == plain.counts
    text = readable.files(("c",))[f"{name}.c"]
    assert not ANONYMOUS.search(text)


@pytest.mark.parametrize(
    "options",
    [
        ["--optimize", "fast"], ["--optimize", "record"], ["--order", "registers"], ["--order", "auto"],
        ["--batch"], ["--prune", "1%"],
    ],
)  # fmt: skip
def test_contradictions_are_refused(
    options: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["gen", "stanford_3dof", "-o", str(tmp_path / "x"), "--readable", *options]) == 2
    err = capsys.readouterr().err
    assert "--readable" in err
    assert options[0] in err
    assert not (tmp_path / "x").exists()
