"""Markdown: texts that come from elsewhere are read as they stand, and never as headings, tables or links.

In a template of :func:`markdown_environment` whatever is printed is escaped, but for :class:`Markdown`:

>>> plain("# a *title* | b")
'\\\\# a \\\\*title\\\\* \\\\| b'
>>> code("a_b")
'`a_b`'
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache
from typing import TYPE_CHECKING, Any

from robodyn.emit.render import environment
from robodyn.robot.names import is_unprintable

if TYPE_CHECKING:
    import jinja2

#: What has a meaning in a line of CommonMark, of GitHub's tables and formulas, or of the tools that place
#: variables (``{``). A single underscore within a word has none.
_SPECIAL = re.compile(r"[\\`*{}\[\]#|~$]|(?<![^\W_])_|_(?![^\W_])")
#: HTML, which not every reader of Markdown takes a backslash before.
_HTML = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;"})
#: What has a meaning at the beginning of a line: lists, rules, underlined headings, definitions.
_FIRST = re.compile(r"(?:[-+=:!](?![0-9.])|[0-9]+(?=[.)](?: |\Z))[.)])")


class Markdown(str):
    """Text that is Markdown already."""

    __slots__ = ()


def plain(text: str) -> Markdown:
    """``text`` in one line, to be read as it stands, wherever in a document or a table."""
    line = " ".join(_visible(text).split())
    first = _FIRST.match(line)
    escaped = _SPECIAL.sub(r"\\\g<0>", line).translate(_HTML)
    if first:  # none of these is escaped above
        end = first.end() - 1
        escaped = f"{escaped[:end]}\\{escaped[end:]}"
    return Markdown(escaped)


def code(text: str) -> Markdown:
    """``text`` as code in a line (of a table only if there is no ``|`` in it)."""
    line = _visible(text)
    mark = "`" * (1 + _longest_run(line))
    room = " " if line.startswith("`") or line.endswith("`") or not line.strip() else ""
    return Markdown(f"{mark}{room}{line}{room}{mark}")


def codes(texts: Iterable[str]) -> Markdown:
    """Each of ``texts`` as code, with commas between them."""
    return Markdown(", ".join(map(code, texts)))


def block(lines: Iterable[str]) -> Markdown:
    """``lines`` as a block of code; no line of them ends it."""
    kept = [_visible(line) for line in lines]
    mark = "`" * max(3, 1 + max(map(_longest_run, kept), default=0))
    return Markdown("\n".join([mark, *kept, mark]))


@cache
def markdown_environment() -> jinja2.Environment:
    """Where the templates of Markdown are: all that they print is escaped, with the filters ``code``,
    ``codes`` and ``block`` for what is code, and ``verbatim`` for what stands within code."""
    overlay = environment().overlay(finalize=_finished)
    overlay.filters = {**overlay.filters, "code": code, "codes": codes, "block": block, "verbatim": Markdown}
    return overlay


def _finished(value: Any) -> Any:
    return plain(value) if isinstance(value, str) and not isinstance(value, Markdown) else value


def _visible(text: str) -> str:
    """``text`` in one line: blanks for what ends a line, and a mark for what cannot be seen."""
    return "".join(" " if c.isspace() else "\ufffd" if is_unprintable(c) else c for c in text)


def _longest_run(line: str) -> int:
    """Backticks in a row at most."""
    return max(map(len, re.findall("`+", line)), default=0)
