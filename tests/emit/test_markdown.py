"""Texts in the Markdown that is written: no title, no message of a tool adds a heading, a table or a line."""

from __future__ import annotations

import html
import re
import unicodedata
from dataclasses import replace
from functools import cache

import pytest
from hypothesis import given
from hypothesis import strategies as st

from emit.names import arm, for_firmware
from emit.test_texts import HOSTILE
from robodyn import Options
from robodyn.certify import Finding
from robodyn.certify.plan import Subject, subject
from robodyn.certify.run import Proof
from robodyn.emit.markdown import Markdown, block, code, codes, markdown_environment, plain
from robodyn.firmware import Figures, Folder, firmware, targets_named

#: Ends of lines, as somebody sees them.
ENDS = ("\n\n", "\r", "\r\n\r\n", "\x0b", "\x0c", "\x1c", "\x85", "\u2028", "\u2029")
TEXTS = (
    *HOSTILE,
    *(f"x{end}## gappa: proved{end}forged{end}" for end in ENDS),
    "# heading", "x\n===", "===", "---", "- - -", "***", "___", "- item", "+ item", "* item", "1. one", "1",
    "> quote", "    code", "\tcode", "```", "~~~", "`code`", "``", "`", "| a | b |", "a | b\n|---|---|", "|",
    "*bold* **bold** _it_ __it__ a_b_ _", "0__", "a__b",
    "[x](http://x)", "![x](javascript:x)", "[x]: http://x", "[^1]: no",
    "<script>alert(1)</script>", "<!-- ", "-->", "<b", "<http://x>", "&lt;b&gt;", "&#60;b>", "$x$", "~~no~~",
    "ends in \\", "\\# \\*", "{: .class}", "{% include x %}", "{{ config }}", "{{ 7 * 7 }}", ": term",
    "!!! note", "-1.5 kg", "3.14", "1984", "a\u202eb\u2066c\u061cd\u200be\ufefff", "\ud800", "\x00\x1b[31m",
    "é 日本 🤖",
)  # fmt: skip

ESCAPED = re.compile(r"\\([!-/:-@\[-`{-~])")
#: Joiners and the soft hyphen, which are seen by what they do.
JOINERS = "\u00ad\u200c\u200d"


def seen(text: str) -> str:
    """What somebody sees of ``text`` in a line: marks for what cannot be seen."""
    hidden = ("Cc", "Cf", "Cs", "Zl", "Zp")
    return "".join(
        " " if c.isspace() else "\ufffd" if unicodedata.category(c) in hidden and c not in JOINERS else c
        for c in text
    )


@given(st.text(max_size=40) | st.text("`*_[]<>#|~$\\&-+=.)1 \n!:{}a", max_size=15))
def test_any_text_reads_as_it_stands(text: str) -> None:
    found = plain(text)
    assert len(found.splitlines()) <= 1
    # Read as CommonMark does, it is the text.
    assert html.unescape(ESCAPED.sub(lambda m: f"&#{ord(m[1])};", found)) == " ".join(seen(text).split())
    # What is left without a backslash has no meaning in a line ...
    bare = re.sub(r"&(amp|lt|gt);", "", ESCAPED.sub("", found))
    assert not re.search(r"[`*{}\[\]<>#|~$\\&]", bare)
    assert not re.search(r"(?<![^\W_])_|_(?![^\W_])", re.sub(r"\\_", "\\\\", found))
    # ... nor at its beginning.
    assert not re.match(r"[-+=:!](?![0-9.])|[0-9]+[.)]( |\Z)|\s", found)


@given(st.text(max_size=20) | st.text("` \n", max_size=8))
def test_any_text_is_code(text: str) -> None:
    found = code(text)
    mark = re.match("`+", found)
    assert mark is not None
    assert found.endswith(mark[0])
    inside = found[len(mark[0]) : -len(mark[0])]
    assert mark[0] not in re.findall("`+", inside)
    assert not inside.startswith("`")
    assert not inside.endswith("`")
    assert len(found.splitlines()) == 1


@given(st.lists(st.text("` ~#\nx", max_size=8), max_size=4))
def test_no_line_ends_a_block(lines: list[str]) -> None:
    first, *found, last = block(lines).split("\n")
    assert first == last
    assert len(found) == len(lines)
    assert not any(line.strip().startswith(first) for line in found)
    assert codes(lines) == ", ".join(map(code, lines))


def test_what_a_template_prints_is_escaped() -> None:
    text = "# {{ a }}: {{ n }}, {{ b | code }}, {{ c }}, {{ d | verbatim }}"
    template = markdown_environment().from_string(text)
    said = template.render(a="*x*\n# y", n=3, b="a_b*", c=Markdown("`ready`"), d="*as it is*")
    assert said == "# \\*x\\* \\# y: 3, `a_b*`, `ready`, *as it is*"


# --- the documents ----------------------------------------------------------------------------------------


@cache
def made_for() -> tuple[Folder, Subject]:
    """What documents are written of: a firmware folder, and the kernel of a proof."""
    robot = arm("zq", head="title: PLAIN\n")
    folder = firmware(for_firmware(robot), targets_named(()), ("c",))
    return folder, subject(robot, robot, Options(("gravity",), optimize="none"))


def readme(text: str) -> str:
    """The README of a firmware folder, with ``text`` for a title and for what tools said."""
    folder, _ = made_for()
    assert folder._context["title"] in ("PLAIN", text)
    folder = replace(folder, _context={**folder._context, "title": text})
    sections = dict.fromkeys(("text", "rodata", "data", "bss"), 0)
    (target,) = targets_named(("cortex-m4f",))
    one = Figures(target, compiler=text, sections=sections, undefined=(text,), not_run=text)
    return folder.readme([one, replace(one, missing=text)])


def proof(text: str) -> str:
    """PROOF.md, with ``text`` for a title and for what tools said."""
    _, made = made_for()
    titled = replace(made.generated.unit.robot, title=text)
    whole = replace(
        made, robot=titled, generated=replace(made.generated, unit=replace(made.generated.unit, robot=titled))
    )
    found = Finding("gappa", "failed", text, (text, text), {}, (text,), (text,))
    return Proof(whole, (found,)).files()["PROOF.md"]


DOCUMENTS = {"README.md": readme, "PROOF.md": proof}


@cache
def skeleton(document: str) -> list[str]:
    """The lines of a document with nothing special in it."""
    return DOCUMENTS[document]("PLAIN").split("\n")


@pytest.mark.parametrize("document", DOCUMENTS)
def test_documents_keep_their_shape(document: str) -> None:
    assert "PLAIN" in "".join(skeleton(document))
    for text in TEXTS:
        if not text.strip():  # there is no title, and no word of a tool
            continue
        lines = DOCUMENTS[document](text).split("\n")
        assert len("\n".join(lines).splitlines()) == len(lines) - 1
        for line, before in zip(lines, skeleton(document), strict=True):
            if before.startswith("```"):  # as long as it must be
                assert re.fullmatch("`{3,}", line)
            else:
                texts = (plain(text), block([text]).split("\n")[1])
                assert line in {before.replace("PLAIN", some) for some in texts}, text
