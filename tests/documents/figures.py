"""The figures in the text of a document, and what each of them is.

A **figure** is a number in the text or in a table: not in a block, not in ``code``, not in an address. The
examples of its page show it (what they are given, and what they print, which tests compare), rounded or not;
or a comment in its section says what it is::

    <!-- 217 = 797 - 580 -->
    <!-- 157 = after("robot: mass") -->                   in what the page shows
    <!-- 350 = after("LINES =", "tests/test_layout.py") -->
    <!-- 200 = robodyn.compare.STATES -->          results("NAME"): those of a benchmark

Numbers in words are language and not looked at. A digit alone counts together with the word after it or the
noun before it ("3 files", "joint 3"). A **name** is no figure: a number that ends one ("Table 4.6",
"Slotine 2018") where the code has the same words; "Python 3.11 or newer" is a requirement, and so a figure.
A decision is a record of its day: ``<!-- closed DIGEST -->`` says that it is as it was then. What a
benchmark writes between ``<!-- MARK -->`` and ``<!-- end -->``, and a page ``<!-- written by COMMAND -->``,
are compared with what writes them, as a whole.
"""

from __future__ import annotations

import functools
import hashlib
import json
import math
import pkgutil
import re
import shlex
from collections.abc import Iterable, Iterator
from decimal import Decimal
from signal import Signals
from typing import Any, Final, NamedTuple

from click.testing import CliRunner

from documents.blocks import FENCE, ROOT, Block, blocks, commands
from robodyn_cli.main import cli
from robodyn_cli.output import Document

NUMBER: Final = re.compile(
    r"(?<![\w.,^/])(?<!\w[-/])[-+]?(?:\d{1,3}(?:,\d{3})+(?!\d)|\d+)(?:\.\d+)?(?:e[-+]?\d+)?"
    r"(?![\w^]|[.,]\d|-[a-zA-Z])"
)
REMEDY: Final = "show it in an example, leave it out, or say what it is: <!-- FIGURE = EXPRESSION -->"
CLOSED: Final = re.compile(r"\n*<!-- closed \w+ -->\n*")
_CODE: Final = re.compile(r"(`+)[^`]+?\1")
_COMMENT: Final = re.compile(r"<!--\s+(.*?)\s+-->", re.DOTALL)
WRITTEN: Final = re.compile(r"(?ms)^<!-- ([\w. -]+) -->\n(?:(?!^#|^<!--).)*?<!-- end -->")
#: What is no text: blocks, what benchmarks write, comments, equations, code, addresses, numbers of a list.
_OTHER: Final = (
    FENCE,
    WRITTEN,
    _COMMENT,
    re.compile(r"\$\$.*?\$\$", re.DOTALL),
    _CODE,
    re.compile(r"\]\([^)]*\)|https?://\S+|<[^<>\n]*>"),
    re.compile(r"^(?:#+ | *)\d+\.(?= )", re.MULTILINE),
)
_HEADING: Final = re.compile(r"^(#+) ", re.MULTILINE)
_NAMED: Final = re.compile(r"[A-Z]\S*|axis|axes|(?:chapter|decision|rule|section|step|version)s?")
_BEFORE: Final = re.compile(r"([^\s(\[*\"']+)\s+(?:\d[\d.]*(?:,| and| or| to|, and)\s+)*$")
_AFTER: Final = re.compile(r"[\s*\"'`|]*([A-Za-zµ°]+|%)")
_CODED: Final = (".py", ".yaml", ".j2")
_IN_CODE: Final = re.compile(r"([A-Za-z]+)[^\w\n]{1,4}(\d+(?:\.\d+)*)")


class Figure(NamedTuple):
    """A number in the text, its place, and the words before and after it."""

    text: str
    start: int
    before: str
    after: str


class Equation(NamedTuple):
    """What a comment says that the figures of a section are, from one place of the page to another."""

    left: str
    right: str
    start: int
    end: int


class Page:
    """A document as a text, its figures, and all that they may be."""

    def __init__(self, text: str) -> None:
        self.text = text
        parts = [*map(_text_of, blocks(text)), *(match[0] for match in WRITTEN.finditer(text))]
        self.shown = " ".join("\n".join(parts).split())
        self.numbers = _numbers("\n".join(parts))
        self.equations = list(_equations(text))
        self.figures = list(_figures(text))

    def faults(self, figures: Iterable[Figure] | None = None) -> list[str]:
        """Those of its ``figures`` that are nothing, and equations that are wrong or of no figure."""
        wrong, used = [], set()
        for figure in self.figures if figures is None else figures:
            said = (one for one in self.equations if one.start <= figure.start < one.end)
            equal = {one for one in said if _text(figure.text) == _text(one.left)}
            used |= equal
            if not equal and not _is_among(figure, self.numbers):
                line = self.text.count("\n", 0, figure.start) + 1
                words = f"{figure.before} {figure.text} {figure.after}"
                wrong.append(f"line {line}: {words}: comes from nowhere; {REMEDY}")
        return wrong + [f"no figure is {one.left} = {one.right}" for one in self.equations if one not in used]

    def untrue(self) -> list[str]:
        """The equations whose sides differ."""
        values = [(one, self._value(one.right)) for one in self.equations]
        return [f"{one.left} = {one.right}: it is {x}" for one, x in values if not _is(one.left, x)]

    def _value(self, expression: str) -> str:
        """The value of an expression of a comment, with the modules that it names imported."""
        names: dict[str, Any] = {
            "after": self._after, "math": math, "results": _results, "signal": lambda name: int(Signals[name])
        }  # fmt: skip
        modules = re.findall(r"(?:robodyn(?:_\w+)?|benchmarks)(?:\.\w+)+", expression)
        named = sorted(set(modules), key=len, reverse=True)
        for k, name in enumerate(named):
            expression = expression.replace(name, f"_{k}")
            names[f"_{k}"] = pkgutil.resolve_name(name)
        value = eval(expression, names)  # of our own documents, not of somebody's file
        return value if isinstance(value, str) else repr(value)

    def _after(self, words: str, path: str = "") -> str:
        """The first number after ``words``, in what the page shows or in a file of the checkout."""
        text = " ".join((ROOT / path).read_text(encoding="utf-8").split()) if path else self.shown
        _, there, rest = text.partition(words)
        figure = NUMBER.search(rest)
        assert there, f"{words!r} is not in {path or 'what the page shows'}"
        assert figure, words
        return figure[0]


def faults(text: str) -> list[str]:
    """What is wrong with the figures of the document ``text``."""
    for comment in _comments(text):
        if comment.startswith("closed "):
            dated = re.search(r"^Status: .* Date: \d{4}-\d\d-\d\d\.", text, re.MULTILINE)
            closed = f"closed {digest_of(text)}"
            return [] if dated and comment == closed else [f"not as it was closed: <!-- {closed} -->"]
        if comment.startswith("written by robodyn "):
            same = text == _printed(comment.removeprefix("written by robodyn "))
            return [] if same else [f"not what is {comment}"]
    page = Page(text)
    return page.faults() + page.untrue()


def digest_of(text: str) -> str:
    """What ``<!-- closed DIGEST -->`` of a document states: of all of it but this comment."""
    return hashlib.sha256(CLOSED.sub("", text).rstrip().encode()).hexdigest()[:12]


def _blank(match: re.Match[str]) -> str:
    """Blanks in the place of what is no text; a number in the type of code is a number all the same."""
    return match[0] if NUMBER.fullmatch(match[0].strip("`")) else re.sub(r"\S", " ", match[0])


def _figures(text: str) -> Iterator[Figure]:
    """The numbers in the text that are not the end of a name."""
    for pattern in _OTHER:
        text = pattern.sub(_blank, text)
    for figure in _in_context(text):
        named = _NAMED.fullmatch(figure.before) and (_noun(figure.before), figure.text) in _names()
        required = text.startswith(" or newer", figure.start + len(figure.text))
        if not named or required:  # a requirement is no name
            yield figure


def _in_context(text: str) -> Iterator[Figure]:
    for match in NUMBER.finditer(text):
        before = _BEFORE.search(text, max(0, match.start() - 120), match.start())
        after = _AFTER.match(text, match.end())
        yield Figure(match[0], match.start(), before[1] if before else "", after[1].lower() if after else "")


def _noun(word: str) -> str:
    return word.lower().rstrip("s:")


def _without_code(text: str) -> str:
    for pattern in (FENCE, _CODE):
        text = pattern.sub(lambda match: re.sub(r"\S", " ", match[0]), text)
    return text


def _comments(text: str) -> Iterator[str]:
    for match in _COMMENT.finditer(_without_code(text)):
        yield " ".join(match[1].split())


def _equations(text: str) -> Iterator[Equation]:
    """Each with its section: from the heading above to the next of its rank or above it."""
    bare = _without_code(text)
    headings = [(match.start(), len(match[1])) for match in _HEADING.finditer(bare)]
    for match in _COMMENT.finditer(bare):
        if sides := re.fullmatch(r"([-+\d.,e]+) = (.+)", match[1], re.DOTALL):
            start, rank = max((one for one in headings if one[0] < match.start()), default=(0, 0))
            end = min((at for at, other in headings if at > start and other <= rank), default=len(text))
            yield Equation(sides[1], " ".join(sides[2].split()), start, end)


def _text_of(block: Block) -> str:
    """What a block gives to its example, and what the example is known to print."""
    if block.language == "console":
        compared = block.is_run or block.mark == "run by"
        return "\n".join(one.text + ("\n" + one.output if compared else "") for one in commands(block))
    return block.text if block.language != "text" or block.mark == "file" else ""


def _text(number: str) -> str:
    """A number without its sign and commas between thousands."""
    return number.lstrip("-+").replace(",", "")


def _is_among(figure: Figure, numbers: frozenset[tuple[str, str]]) -> bool:
    text = _text(figure.text)
    words = (figure.after, f"{_noun(figure.before)} ") if len(text) == 1 else ("any",)
    return any((text, word) in numbers for word in words if word.strip())


def _is(figure: str, value: str) -> bool:
    return _text(figure) in _rounded(value) or Decimal(_text(figure)) == Decimal(_text(value))


def _rounded(number: str) -> set[str]:
    """A number as text, and with fewer of the digits after its point, or before its exponent."""
    plain = _text(number)
    exact = Decimal(plain)
    if "e" in plain:
        return {plain} | {re.sub(r"(?<=e)([-+]?)0+", r"\1", f"{exact:.{k}e}") for k in range(len(plain))}
    decimals = len(plain.partition(".")[2])
    return {plain} | {str(exact.quantize(Decimal(1).scaleb(-k))) for k in range(decimals)}


@functools.cache
def _numbers(text: str) -> frozenset[tuple[str, str]]:
    """The numbers of a text, rounded or not, each alone, with the word after it and the noun before it."""
    return frozenset(
        (rounded, word)
        for one in _in_context(text.replace("_", " "))
        for rounded in _rounded(one.text)
        for word in ("any", one.after, f"{_noun(one.before)} ")
    )


@functools.cache
def _printed(command: str) -> str:
    words = shlex.split(command)
    return CliRunner().invoke(cli, words, obj=Document("--json" in words), catch_exceptions=False).stdout


@functools.cache
def _names() -> frozenset[tuple[str, str]]:
    """Words and the numbers after them in the code: Table 4.6, joint 3, Python 3.11."""
    tops = ("codegen", "cli", "robots", "templates", "benchmarks")
    files = [path for top in tops for path in (ROOT / top).rglob("*") if path.suffix in _CODED]
    texts = [path.read_text(encoding="utf-8") for path in (*files, ROOT / "pyproject.toml")]
    texts += [f"decision {path.name}" for path in (ROOT / "docs" / "decisions").iterdir()]
    pairs = _IN_CODE.findall("\n".join(texts))
    return frozenset((word.lower().rstrip("s"), number) for word, number in pairs)


def _results(name: str) -> Any:
    return json.loads((ROOT / "benchmarks" / "results" / f"{name}.json").read_text(encoding="utf-8"))
