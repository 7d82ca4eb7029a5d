"""Docstrings as Markdown: sections with underlines, literal blocks, roles, examples."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Final

from robodyn_site.markdown import definitions, fenced, plain

_ROLE: Final = re.compile(r":\w+:`[~.]?([^`]+)`")
_LITERAL: Final = re.compile(r"``(.+?)``", re.DOTALL)
_CODE: Final = re.compile(r"(`[^`]*`)")
_ITEM: Final = re.compile(r"^([\w*][\w, *]*): (.*)", re.DOTALL)


def markdown(docstring: str) -> str:
    """A docstring (as :func:`inspect.getdoc` gives it) in Markdown."""
    return "\n\n".join(part for part in _parts(docstring.splitlines()) if part)


def prose(text: str) -> str:
    """Running text: roles and literals are code, all else is plain."""
    text = _ROLE.sub(lambda match: f"`{match[1].removeprefix('robodyn.')}`", text)
    text = _LITERAL.sub(lambda match: f"`{' '.join(match[1].split())}`", text)
    pieces = _CODE.split(" ".join(text.split()))
    return "".join(piece if k % 2 else plain(piece) for k, piece in enumerate(pieces))


def _parts(lines: list[str]) -> Iterator[str]:
    block: list[str] = []
    k = 0
    while k < len(lines):
        line = lines[k]
        if k + 1 < len(lines) and line and set(lines[k + 1]) == {"-"}:
            yield prose("\n".join(block))
            block = []
            items, k = _items(lines, k + 2)
            yield f"**{line}**"
            yield items
        elif line.startswith((" ", ">>>")):
            ends = bool(block) and block[-1].endswith("::")
            if ends:
                block[-1] = block[-1].removesuffix(":")
            yield prose("\n".join(block))
            block = []
            literal, k = _literal(lines, k)
            yield literal
        else:
            if not line:
                if k + 1 < len(lines) and lines[k + 1].startswith(" ") and block and block[-1].endswith("::"):
                    k += 1
                    continue
                yield prose("\n".join(block))
                block = []
            else:
                block.append(line)
            k += 1
    yield prose("\n".join(block))


def _items(lines: list[str], k: int) -> tuple[str, int]:
    """The ``name: text`` of a section from line ``k`` on, and the line behind them."""
    items: list[str] = []
    while k < len(lines) and lines[k]:
        if items and not _ITEM.match(lines[k]):
            items[-1] += "\n" + lines[k].strip()
        else:
            items.append(lines[k])
        k += 1
    matches = [_ITEM.match(item) for item in items]
    if not all(matches):
        return prose("\n".join(items)), k
    terms = [(f"`{match[1]}`", prose(match[2])) for match in matches if match]
    return definitions(terms), k


def _literal(lines: list[str], k: int) -> tuple[str, int]:
    """An indented block, or an example of Python, from line ``k`` on, and the line behind it."""
    start = k
    if lines[k].startswith(">>>"):
        while k < len(lines) and lines[k]:
            k += 1
        return fenced("\n".join(lines[start:k]), "pycon"), k
    while k < len(lines) and (lines[k].startswith(" ") or not lines[k]):
        k += 1
    indented = [line.removeprefix("    ") for line in lines[start:k]]
    language = "pycon" if indented[0].startswith(">>>") else "text"
    return fenced("\n".join(indented), language), k
