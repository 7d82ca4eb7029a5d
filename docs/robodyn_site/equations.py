"""Equations as MathML, which browsers typeset themselves: no script, no font, nothing from elsewhere."""

from __future__ import annotations

import html
import re
from typing import Final

_BLOCK: Final = re.compile(r'<div class="arithmatex">\\\[(.*?)\\\]</div>', re.DOTALL)
_INLINE: Final = re.compile(r'<span class="arithmatex">\\\((.*?)\\\)</span>', re.DOTALL)


def typeset(page: str) -> str:
    """A page's HTML with MathML in the place of what ``pymdownx.arithmatex`` has marked as LaTeX."""
    from latex2mathml.converter import convert

    def block(match: re.Match[str]) -> str:
        return f'<div class="equation">{convert(html.unescape(match[1]).strip(), display="block")}</div>'

    def inline(match: re.Match[str]) -> str:
        return str(convert(html.unescape(match[1]).strip()))

    return _INLINE.sub(inline, _BLOCK.sub(block, page))
