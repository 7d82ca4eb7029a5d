"""Plain text as Markdown: nothing in it is taken for markup."""

from __future__ import annotations

import html
import re
from collections.abc import Iterable, Sequence
from typing import Final

_MARKS: Final = re.compile(r"[\\`*_{}\[\]|$~^]")


def plain(text: str) -> str:
    """Text that is shown as it is."""
    return _MARKS.sub(lambda mark: f"&#{ord(mark[0])};", html.escape(text, quote=False))


def code(text: str) -> str:
    """Text as code within a line."""
    return f"`{text}`"


def fenced(text: str, language: str = "text") -> str:
    """Text as a block of code."""
    return f"```{language}\n{text.rstrip()}\n```"


def sentence(text: str) -> str:
    """A phrase as a sentence."""
    return text[:1].upper() + text[1:].rstrip(".") + "."


def table(head: Sequence[str], rows: Iterable[Sequence[str]], align: str = "") -> str:
    """A table; ``align`` has a letter for each column, ``r`` where it holds numbers."""
    marks = ["---:" if mark == "r" else "---" for mark in align.ljust(len(head))]
    return "\n".join(f"| {' | '.join(cells)} |" for cells in (head, marks, *rows))


def definitions(items: Iterable[tuple[str, str]]) -> str:
    """Terms, each with what it is."""
    return "\n\n".join(f"{term}\n:   {text}" for term, text in items)


def page(*parts: str) -> str:
    """A page of its parts, without those that are empty."""
    return "\n\n".join(part.strip("\n") for part in parts if part) + "\n"
