"""All pages that are made when the site is built."""

from __future__ import annotations

from functools import cache
from typing import Final

from robodyn_site import (
    benchmarks,
    commands,
    description,
    effects,
    formats,
    functions,
    languages,
    outside,
    python,
    targets,
    tools,
)

#: Documents that are more on the site: an overview of pages, with links to them.
REPLACED: Final = frozenset({"effects.md", "functions.md"})
_MAKERS: Final = (
    outside,
    commands,
    effects,
    functions,
    targets,
    languages,
    description,
    formats,
    python,
    tools,
    benchmarks,
)


@cache
def pages() -> dict[str, str]:
    """Path in the site -> Markdown."""
    return {path: text for maker in _MAKERS for path, text in maker.pages().items()}
