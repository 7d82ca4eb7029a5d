"""The examples of a document: fenced blocks with what is to be done with them, in their order.

A block ```` ```console ```` has commands after ``$ ``, each followed by what it prints::

    $ robodyn flops puma560
    puma560: PUMA 560, six joints
    ...

``...`` stands for any text of a line, and on a line of its own for any lines. A command under which nothing
is shown may print what it likes. Every command must end in 0, unless the next one is ``echo $?``. A line that
ends in a backslash is continued. Each block starts in the folder of the checkout, in a shell of its own. A
block ```` ```python ```` is run as it stands, or as a doctest if it has prompts; the Python blocks of a
document share their names. A comment before a block says what else is to be known:

``<!-- not run: REASON -->``
    it is not executed; its commands and options must exist all the same
``<!-- run by PATH -->``
    the document or test of that path executes it
``<!-- needs TOOL, TOOL -->``
    programs without which the examples of the document cannot be run
``<!-- file NAME -->``
    the block, in whatever language, is the text of a file that the next examples use
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[2]
PAGES = tuple(
    path.relative_to(ROOT).as_posix()
    for path in (ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("**/*.md")))
)
TUTORIALS = tuple(page for page in PAGES if "/tutorials/" in page and not page.endswith("README.md"))
FENCE = re.compile(
    r"^(?:[ ]*<!--[ ](?P<mark>[^\n]*?)[ ]-->\n)?"
    r"^(?P<indent>[ ]*)```(?P<language>\w*)\n(?P<text>.*?)^(?P=indent)```[ ]*$",
    re.DOTALL | re.MULTILINE,
)
#: A command, continued after a backslash, and the lines beneath it.
_COMMAND = re.compile(r"^\$ ((?:[^\n]*\\\n)*[^\n]*)\n?((?:(?!\$ )[^\n]*\n)*)", re.MULTILINE)
_MARK = re.compile(r"(not run:|run by|needs|file) (.+)")


@dataclass(frozen=True, slots=True)
class Block:
    """A fenced block: its language, text and line; ``mark`` and ``detail`` are of the comment before it."""

    language: str
    text: str
    line: int
    mark: str = ""
    detail: str = ""

    @property
    def is_example(self) -> bool:
        return self.language in ("console", "python")

    @property
    def is_run(self) -> bool:
        """Whether the document's own test executes it."""
        return self.is_example and self.mark in ("", "needs")


@dataclass(frozen=True, slots=True)
class Command:
    """A command of a console block, and what it prints; "" if nothing is shown."""

    text: str
    output: str
    line: int


def blocks(page: str) -> list[Block]:
    """All fenced blocks of the text ``page``."""
    matches = []
    for match in FENCE.finditer(page):
        mark = _MARK.fullmatch(match["mark"] or "")
        line = page.count("\n", 0, match.start("language")) + 1
        kind, detail = (mark[1].rstrip(":"), mark[2]) if mark else ("", "")
        matches.append(Block(match["language"], textwrap.dedent(match["text"]), line, kind, detail))
    return matches


def read(path: str) -> list[Block]:
    """The blocks of the document ``path`` of the checkout."""
    return blocks((ROOT / path).read_text(encoding="utf-8"))


def commands(block: Block) -> Iterator[Command]:
    """The commands of a console block.

    Raises
    ------
    ValueError: the block does not begin with a command.
    """
    if not block.text.startswith("$ "):
        raise ValueError(f"line {block.line}: a console block begins with a command after '$ '")
    for match in _COMMAND.finditer(block.text):
        line = block.line + 1 + block.text.count("\n", 0, match.start())
        yield Command(match[1], match[2].rstrip("\n"), line)


def matches(expected: str, output: str) -> bool:
    """Whether ``output`` is what is shown; ``...`` is any text of a line, alone on a line any lines."""
    pattern = ""
    for line in expected.splitlines():
        if line.strip() == "...":
            pattern += r"(?:[^\n]*\n)*?"
        else:
            pattern += r"[^\n]*?".join(map(re.escape, line.rstrip().split("..."))) + r"\n"
    shown = "".join(f"{line.rstrip()}\n" for line in output.rstrip().splitlines())
    return re.fullmatch(pattern, shown) is not None
