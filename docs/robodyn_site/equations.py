"""Equations as MathML, which browsers typeset themselves: no script, no font, nothing from elsewhere."""

from __future__ import annotations

import html
import re
from typing import Final

from robodyn.draw.mathml import of_latex

_BLOCK: Final = re.compile(r'<div class="arithmatex">\\\[(.*?)\\\]</div>', re.DOTALL)
_INLINE: Final = re.compile(r'<span class="arithmatex">\\\((.*?)\\\)</span>', re.DOTALL)


def typeset(page: str) -> str:
    """A page's HTML with MathML in the place of what ``pymdownx.arithmatex`` has marked as LaTeX.

    Raises
    ------
    ValueError: an equation holds what :mod:`robodyn.draw.mathml` does not know.
    """

    def block(match: re.Match[str]) -> str:
        return f'<div class="equation">{of_latex(html.unescape(match[1]).strip())}</div>'

    def inline(match: re.Match[str]) -> str:
        return of_latex(html.unescape(match[1]).strip(), display=False)

    return _INLINE.sub(inline, _BLOCK.sub(block, page))
