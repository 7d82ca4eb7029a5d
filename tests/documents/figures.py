"""The figures in the text of a document, and what each of them comes from.

A **figure** is a number in the text or in a table: not in a block, not in ``code``, not in an address. The
examples of its page show it (what they are given, and what they print, which tests compare), rounded or
not, or a comment says what it is, anywhere in the section that the comment stands in:

``<!-- from PATH, PATH -->``
    files of the checkout that have the figures: results of a benchmark, code, a robot, the README of a log
``<!-- 217 = 797 - 580 -->``
    an expression of numbers, of ``robodyn...`` and of the ``results("NAME")`` of a benchmark

A whole number below ten counts together with the word after it. A **name** is no figure: a number that ends
one ("Table 4.6", "joint 3", "Slotine 2018") where the code has the same words. A decision is a record of
its day: ``<!-- closed DIGEST -->`` says that it is as it was then. What a benchmark writes between ``<!--
MARK -->`` and ``<!-- end -->``, and a page ``<!-- written by COMMAND -->``, are compared with what writes
them, as a whole.
"""

from __future__ import annotations

import functools
import hashlib
import json
import math
import pkgutil
import re
import shlex
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from decimal import Decimal
from signal import Signals
from typing import Any, Final

from click.testing import CliRunner

from documents.blocks import FENCE, ROOT, Block, blocks, commands
from robodyn_cli.main import cli

NUMBER: Final = re.compile(
    r"(?<![\w.,^/])(?<!\w[-/])[-+]?(?:\d{1,3}(?:[ ,]\d{3})+(?!\d)|\d+)(?:\.\d+)?(?:e[-+]?\d+)?"
    r"(?![\w^]|[.,]\d|-[a-zA-Z])"
)
_CODE: Final = re.compile(r"(`+)[^`]+?\1")
_WRITTEN: Final = re.compile(r"^<!-- [\w. -]+ -->\n(?:(?!^#|^<!--).)*?<!-- end -->", re.MULTILINE | re.DOTALL)
#: What is no text: blocks, what benchmarks write, comments, equations, code, addresses.
_OTHER: Final = tuple(
    re.compile(pattern, re.MULTILINE | re.DOTALL)
    for pattern in (
        FENCE.pattern,
        _WRITTEN.pattern,
        r"<!--.*?-->",
        r"\$\$.*?\$\$",
        _CODE.pattern,
        r"\]\([^)]*\)|https?://\S+|<[^<>\n]*>",
        r"^(?:#+ | *)\d+\.(?= )",
    )
)
_COMMENT: Final = re.compile(r"<!--\s+(.*?)\s+-->", re.DOTALL)
_HEADING: Final = re.compile(r"^(#+) ", re.MULTILINE)
_NAMED: Final = re.compile(
    r"(?:[A-Z]\S*|axis|axes|(?:chapter|code|decision|joint|link|rule|section|step|version)s?)"
)
_BEFORE: Final = re.compile(r"([^\s(\[*\"']+)\s+(?:\d[\d.]*(?:,| and| or| to|, and)\s+)*$")
_AFTER: Final = re.compile(r"[\s*\"'`|]*([A-Za-zµ°]+|%)")
_IN_CODE: Final = re.compile(r"([A-Za-z]+)[^\w\n]{1,4}(\d+(?:\.\d+)*)")


@dataclass(frozen=True, slots=True)
class Figure:
    """A number in the text, its place, and the words before and after it."""

    text: str
    start: int
    before: str
    after: str


@dataclass(frozen=True, slots=True)
class Numbers:
    """What figures may be: numbers as they stand or rounded, and the same with the word after each."""

    values: frozenset[Decimal]
    phrases: frozenset[tuple[Decimal, str]]

    def __contains__(self, figure: Figure) -> bool:
        value = _value(figure.text)
        if value < 10 and value == int(value):
            return (value, figure.after) in self.phrases
        return value in self.values


@dataclass(frozen=True, slots=True)
class Comment:
    """What a comment says, and the section that it says it of."""

    text: str
    start: int
    end: int


def figures(page: str) -> Iterator[Figure]:
    """The numbers in the text of ``page`` that are not the end of a name."""
    for pattern in _OTHER:
        page = pattern.sub(_blank, page)
    for match in NUMBER.finditer(page):
        before = _BEFORE.search(page, max(0, match.start() - 120), match.start())
        noun = before[1] if before else ""
        if _NAMED.fullmatch(noun) and (noun.lower().rstrip("s"), match[0]) in _names():
            continue
        after = _AFTER.match(page, match.end())
        yield Figure(match[0], match.start(), noun, after[1].lower() if after else "")


def faults(page: str) -> list[str]:
    """The figures of the text ``page`` that come from nowhere, and what its comments say of none of them."""
    comments = list(_comments(page))
    for comment in comments:
        kind, _, detail = comment.text.partition(" ")
        if kind == "closed":
            digest = digest_of(page)
            dated = re.search(r"^Status: .* Date: \d{4}-\d\d-\d\d\.", page, re.MULTILINE)
            return [] if dated and detail == digest else [f"not as it was closed: <!-- closed {digest} -->"]
        if comment.text.startswith("written by robodyn "):
            same = page == _printed(comment.text.removeprefix("written by robodyn "))
            return [] if same else [f"not what is {comment.text}"]
    shown = _numbers(
        "\n".join([*map(_shown, blocks(page)), *(match[0] for match in _WRITTEN.finditer(page))])
    )
    files = [(comment, _file(path)) for comment in comments for path in _paths(comment.text)]
    equations = [
        (comment, _value(one[1]), one[2]) for comment in comments if (one := _equation(comment.text))
    ]
    wrong, used = [], set()
    for figure in figures(page):
        value = _value(figure.text)
        equal = {
            comment
            for comment, left, _ in equations
            if left == value and comment.start <= figure.start < comment.end
        }
        used |= equal
        there = any(figure in numbers for it, numbers in files if it.start <= figure.start < it.end)
        if not equal and figure not in shown and not there:
            line = page.count("\n", 0, figure.start) + 1
            wrong.append(f"line {line}: {figure.before} {figure.text} {figure.after}: comes from nowhere")
    for comment, left, right in equations:
        if comment not in used:
            wrong.append(f"no figure is {comment.text}")
        elif not _rounds(_evaluated(right), left):
            wrong.append(f"{comment.text}: it is {_evaluated(right)}")
    return wrong


def digest_of(page: str) -> str:
    """What ``<!-- closed DIGEST -->`` of a page states: of all before it."""
    return hashlib.sha256(page.partition("<!-- closed ")[0].rstrip().encode()).hexdigest()[:12]


def with_another_digit(page: str, figure: Figure) -> str:
    """``page`` with the last digit of ``figure``, before an exponent, one higher, 0 for 9."""
    k = len(figure.text.partition("e")[0]) - 1
    changed = figure.text[:k] + str((int(figure.text[k]) + 1) % 10) + figure.text[k + 1 :]
    return page[: figure.start] + changed + page[figure.start + len(figure.text) :]


def _blank(match: re.Match[str]) -> str:
    """Blanks in the place of what is no text; a number in the type of code is a number all the same."""
    return match[0] if NUMBER.fullmatch(match[0].strip("`")) else re.sub(r"\S", " ", match[0])


def _comments(page: str) -> Iterator[Comment]:
    """The comments, each with its section: from the heading above to the next of its rank or above it."""
    for pattern in (FENCE, _CODE):
        page = pattern.sub(lambda match: re.sub(r"\S", " ", match[0]), page)
    headings = [(match.start(), len(match[1])) for match in _HEADING.finditer(page)]
    for match in _COMMENT.finditer(page):
        start, rank = max((one for one in headings if one[0] < match.start()), default=(0, 0))
        end = min((at for at, other in headings if at > start and other <= rank), default=len(page))
        yield Comment(" ".join(match[1].split()), start, end)


def _paths(text: str) -> list[str]:
    return text.removeprefix("from ").split(", ") if text.startswith("from ") else []


def _equation(text: str) -> re.Match[str] | None:
    return re.fullmatch(r"([-\d., e]+) = (.+)", text)


def _shown(block: Block) -> str:
    """What a block gives to its example, and what the example is known to print."""
    if block.language == "console":
        compared = block.is_run or block.mark == "run by"
        return "\n".join(one.text + ("\n" + one.output if compared else "") for one in commands(block))
    return block.text if block.language != "text" or block.mark == "file" else ""


def _value(text: str) -> Decimal:
    return abs(Decimal(re.sub(r"[ ,+]", "", text))).normalize()


@functools.cache
def _numbers(text: str) -> Numbers:
    values, phrases = set(), set()
    for match in NUMBER.finditer(text.replace("_", " ")):
        number = _value(match[0])
        _, digits, exponent = number.as_tuple()
        kept = {number}
        if "." in match[0] or "e" in match[0]:
            for count in range(1, len(digits)):
                last = int(exponent) + len(digits) - count
                if last <= 0 or "e" in match[0]:
                    kept.add(number.quantize(Decimal(1).scaleb(last)).normalize())
        values |= kept
        after = _AFTER.match(text, match.end())
        phrases |= {(value, after[1].lower()) for value in kept if after}
    return Numbers(frozenset(values), frozenset(phrases))


@functools.cache
def _file(path: str) -> Numbers:
    return _numbers((ROOT / path).read_text(encoding="utf-8"))


@functools.cache
def _printed(command: str) -> str:
    return CliRunner().invoke(cli, shlex.split(command), catch_exceptions=False).stdout


@functools.cache
def _names() -> frozenset[tuple[str, str]]:
    """Words and the numbers after them in the code: Table 4.6, joint 3, Python 3.11."""
    listed = subprocess.run(
        ["git", "ls-files", "codegen", "cli", "robots", "templates", "benchmarks/*.py", "pyproject.toml"],
        cwd=ROOT, capture_output=True, text=True, check=True,
    )  # fmt: skip
    texts = [(ROOT / path).read_text(encoding="utf-8", errors="replace") for path in listed.stdout.split()]
    text = "\n".join([*texts, *(f"decision {path.name}" for path in (ROOT / "docs" / "decisions").iterdir())])
    return frozenset((word.lower().rstrip("s"), number) for word, number in _IN_CODE.findall(text))


@functools.cache
def _evaluated(expression: str) -> Any:
    """The value of an expression of a comment, with the modules that it names imported."""
    names: dict[str, Any] = {"math": math, "results": _results, "signal": lambda name: int(Signals[name])}
    for k, name in enumerate(
        sorted(set(re.findall(r"robodyn(?:_\w+)?(?:\.\w+)+", expression)), key=len, reverse=True)
    ):
        expression = expression.replace(name, f"_{k}")
        names[f"_{k}"] = pkgutil.resolve_name(name)
    return eval(expression, names)


def _results(name: str) -> Any:
    return json.loads((ROOT / "benchmarks" / "results" / f"{name}.json").read_text(encoding="utf-8"))


def _rounds(value: Any, figure: Decimal) -> bool:
    """Whether ``figure`` is the size of ``value``, rounded to as many digits."""
    size = abs(Decimal(repr(value)))
    return size.quantize(Decimal(1).scaleb(min(0, int(figure.as_tuple().exponent)))).normalize() == figure
