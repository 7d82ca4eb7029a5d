"""What stands in the files: comments that cannot break out, literals that read back, lines that fit."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from emit.kernels import STRICT, STRICT_CPP, STRICT_FORTRAN, complaints, made, robots, write
from emit.names import WAYS, arm
from robodyn import Options, load
from robodyn.ir import Label
from robodyn.kernels.generate import Generated, generate
from robodyn.optimize.records import best_record
from robodyn.robot import Robot
from robodyn_testing import representative, require_tool

HOSTILE = (
    "*/ int x; /*",
    "*\\ int x; \\*",
    "/\\* nested",
    "\\\\ two backslashes",
    "??/",
    "/??/* trigraph",
    "ends in a backslash \\",
    "a // comment",
    "a /* comment",
    "**////**//**//",
    "*?/?/",
    "#include <stdio.h>",
    '"; system("true"); "',
    "!$omp parallel",
    "! end module",
    "& continued &",
    "été, 日本, 🤖, \u202egnirts",
    "tab\tand\x0bvertical\x0cfeed\x85next\u2028line\u2029paragraph",
    "line\nbreak\r\nand\rmore",
    "% {{ 1 + 1 }} {% raw %}",
    "x" * 5000,
    "long " * 2000,
    "   ",
)


def named(title: str, source: str = "", link: str = "link1") -> Robot:
    """A small robot with texts of somebody else's."""
    robot = load("stanford_3dof")
    links = (replace(robot.links[0], name=link), *robot.links[1:])
    return replace(robot, title=title, source=source, links=links)


def files_of(robot: Robot) -> dict[str, str]:
    """Its files, whatever the texts: one function is enough, and it is always the same."""
    plain = gravity()
    return replace(plain, unit=replace(plain.unit, robot=robot)).files()


@cache
def gravity() -> Generated:
    """One function of the small robot."""
    return generate(named("plain"), Options(functions=("gravity",)))


def code_of(text: str) -> list[str]:
    """C without its comments, in the way of a compiler: trigraphs, spliced lines, then comments."""
    for mark, meaning in {"??/": "\\", "??=": "#", "??'": "^", "??(": "[", "??)": "]", "??<": "{"}.items():
        text = text.replace(mark, meaning)
    text = text.replace("\\\n", "")
    code, k = "", 0
    while k < len(text):
        if text.startswith("/*", k):
            end = text.index("*/", k + 2)
            assert "/*" not in text[k + 2 : end], "a comment in a comment"
            k = end + 2
        else:
            code += text[k]
            k += 1
    return code.split()


def fortran_code_of(text: str) -> list[str]:
    """Fortran without its comments, which all begin their lines."""
    return [line for line in text.splitlines() if not re.match(r" *!( |$)", line)]


#: Of 40 characters, as its parameters are of 31.
LONGEST = "the_longest_name_that_a_robot_may_have_x"
PLAIN = files_of(named("plain"))


def check_only_comments_differ(files: dict[str, str]) -> None:
    for name, text in files.items():
        assert text.isascii()
        assert not re.search(r"[^\n -~]", text)
        code = fortran_code_of if name.endswith(".f90") else code_of
        assert code(text) == code(PLAIN[name])
        assert max(map(len, text.splitlines())) <= 100
        assert text.endswith("\n")
        assert not re.search(r"[ \t]$", text, flags=re.MULTILINE)


# --- texts ------------------------------------------------------------------------------------------------


@settings(deadline=None, max_examples=150)
@given(st.text(max_size=30) | st.text("*/\\? !\n", max_size=12), st.text("*/\\?&#", max_size=12))
@example("*\\", "")
def test_any_text_stays_in_its_comment(title: str, source: str) -> None:
    check_only_comments_differ(files_of(named(title, source)))


@pytest.mark.parametrize("way", WAYS)
def test_texts_stay_in_their_comments_in_every_file(way: str, tmp_path: Path) -> None:
    """Those of builds too: # begins a comment there."""
    plain = WAYS[way](arm("zq", head="title: x\n"))
    for text in (
        "\n".join(HOSTILE),
        "\u2028\x85\x0b\r\x0c".join(HOSTILE[::-1]),
        "$(shell true)\n#[[\n\t@true \\",
    ):
        files = WAYS[way](replace(arm("zq"), title=text, source=text))
        assert list(files) == list(plain)
        for name, found in files.items():
            assert not re.search(r"[^\n\t -~]", found)
            if name.endswith((".c", ".h", ".ld")):
                assert code_of(found) == code_of(plain[name])
            elif name.endswith(".f90"):
                assert fortran_code_of(found) == fortran_code_of(plain[name])
            else:
                lines, as_plain = (
                    [line for line in some.splitlines() if not re.match("#( |$)", line)]
                    for some in (found, plain[name])
                )
                assert lines == as_plain


RECORD = best_record(load("stanford_3dof"), "inverse_dynamics")


def test_how_a_record_was_found_stays_in_its_comment() -> None:
    """It comes from a file beside the robot's, or from a program."""
    text = "\n".join(HOSTILE)
    assert RECORD is not None
    plain, hostile = (
        generate(
            load("stanford_3dof"),
            Options(("inverse_dynamics",), records=(replace(RECORD, origin=found),)),
        ).files()
        for found in ("plain", text)
    )
    assert any("plain" in head for head in plain.values())
    for name, found in hostile.items():
        assert not re.search(r"[^\n -~]", found)
        code = fortran_code_of if name.endswith(".f90") else code_of
        assert code(found) == code(plain[name])
        assert max(map(len, found.splitlines())) <= 100


def test_labels_of_a_record_are_no_words_of_the_language(tmp_path: Path) -> None:
    """INT8_MAX is link 8's quantity INT, component MAX; char16_t, int8_t and PRId16 are no better."""
    assert RECORD is not None
    labels = [Label(8, "INT", "MAX"), Label(8, "int", "t"), Label(16, "char", "t"), Label(16, "PRId", "")]
    labels += [Label(386, "i", ""), Label(8, "INT", "C"), Label(2, "FE", "X"), Label(1, "tau", "")]
    operations = tuple(
        operation._replace(label=None if operation.op in ("sin", "cos") or not labels else labels.pop())
        for operation in RECORD.program.operations
    )
    record = replace(RECORD, program=replace(RECORD.program, operations=operations))
    robot = load("stanford_3dof")
    made = generate(robot, Options(("inverse_dynamics",), records=(record,), trig="builtin"))
    assert "INT8_MAX_2 = " in made.files()["stanford_3dof.c"]
    write(tmp_path, made.files(batch=True))
    files = ["stanford_3dof.c", "stanford_3dof_batch.c"]
    for tool, flags in (("gcc", STRICT), ("g++", STRICT_CPP), ("gcc", ("-std=gnu17", "-D_GNU_SOURCE"))):
        assert complaints(require_tool(tool), flags, files, tmp_path) == ""
    assert complaints(require_tool("gfortran"), STRICT_FORTRAN, ["stanford_3dof.f90"], tmp_path) == ""


def test_compilers_accept_any_text(tmp_path: Path) -> None:
    names = []
    for k, text in enumerate(HOSTILE):
        folder = tmp_path / str(k)
        folder.mkdir()
        files = files_of(named(text, text, text))
        check_only_comments_differ(files)
        write(folder, files)
        names.append(f"{k}/stanford_3dof.c")
    for tool, flags, some in (
        ("gcc", STRICT, names),
        ("clang", STRICT, names),
        ("g++", STRICT_CPP, names[:6]),
    ):
        flags = (*flags, "-Wcomment", "-Wtrigraphs", "-fsyntax-only")
        assert complaints(require_tool(tool), flags, some, tmp_path) == ""
    fortran = [name.replace(".c", ".f90") for name in names]
    assert (
        complaints(
            require_tool("gfortran"), (*STRICT_FORTRAN, "-fopenmp", "-fsyntax-only"), fortran, tmp_path
        )
        == ""
    )


def test_arguments_come_in_the_order_of_the_contract() -> None:
    text = " ".join(made("puma560").files()["puma560.h"].split())
    assert (
        "void puma560_inverse_dynamics( const puma560_real q[6], const puma560_real qd[6], "
        "const puma560_real qdd[6], puma560_real tau[6]);" in text
    )
    assert "void puma560_gravity(const puma560_real q[6], puma560_real tau[6]);" in text
    assert "void puma560_mass_matrix(const puma560_real q[6], puma560_real M[36]);" in text
    parameters = " ".join(made("tool").files()["tool.h"].split())
    assert "const tool_real qdd[3], tool_real tau[3], const tool_params *p);" in parameters


@pytest.mark.parametrize("name", representative(robots(), "puma560", "tool", LONGEST, rest="slow"))
def test_lines_fit_and_quantities_have_headings(name: str) -> None:
    """In 110 columns, and with the longest names Fortran in the 132 that every compiler takes."""
    for file, text in made(name).files().items():
        assert text.isascii()
        lines = text.splitlines()
        limit = 132 if "longest" in name else 110
        if file.endswith(".f90") or "longest" not in name:
            assert max(map(len, lines)) <= limit, file
        assert not [line for line in lines if line != line.rstrip()]
    if name == "puma560":
        text = made(name).files()["puma560.c"]
        assert "/* link 3: angular velocity [rad/s] */" in text
        assert "/* sines and cosines of the joint angles */" in text
