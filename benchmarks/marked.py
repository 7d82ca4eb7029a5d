"""Parts of documents that programs write: what stands between ``<!-- MARK -->`` and ``<!-- end -->``."""

from __future__ import annotations

_END = "<!-- end -->"


def part(document: str, mark: str) -> str:
    """The text between ``mark`` and its end, as it stands.

    Raises
    ------
    ValueError: there is no such mark or no end, or there are several such marks.
    """
    return _split(document, mark)[1]


def with_part(document: str, mark: str, text: str) -> str:
    """``document`` with ``text`` on lines of its own at ``mark``.

    Raises
    ------
    ValueError: there is no such mark or no end, or there are several such marks.
    """
    head, _, tail = _split(document, mark)
    return f"{head}{text.strip()}\n{tail}"


def _split(document: str, mark: str) -> tuple[str, str, str]:
    start = f"<!-- {mark} -->\n"
    if document.count(start) != 1:
        raise ValueError(f"the document has {document.count(start)} lines {start.strip()}; one is expected")
    head, _, rest = document.partition(start)
    text, end, tail = rest.partition(_END)
    if not end:
        raise ValueError(f"the document has no {_END} after {start.strip()}")
    return head + start, text, end + tail
