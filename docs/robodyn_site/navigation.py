"""The navigation: a path that ends in / stands for the pages of that folder."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Final

from robodyn_site.outside import ROOT

DOCS: Final = ROOT / "docs"


def documents() -> list[str]:
    """The documents in this folder, by their paths in the site, in the order of their names."""
    return sorted(path.relative_to(DOCS).as_posix() for path in DOCS.rglob("*.md"))


def expanded(nav: Any, pages: Iterable[str]) -> Any:
    """``nav`` of mkdocs.yml with the pages of each folder that it names: the index, the others as they come.

    What is named by itself is left out of its folder, and a section without a page is left out.
    """
    alone = set(named(nav))
    return _expanded(nav, sorted((page for page in pages if page not in alone), key=_is_no_index))


def named(nav: Any) -> list[str]:
    """The pages and folders of a navigation, in order."""
    if isinstance(nav, str):
        return [nav]
    items = nav.values() if isinstance(nav, dict) else nav
    return [path for item in items for path in named(item)]


def _is_no_index(path: str) -> bool:
    return not path.endswith(("/index.md", "/README.md"))


def _expanded(items: list[Any], pages: list[str]) -> list[Any]:
    filled: list[Any] = []
    for item in items:
        if isinstance(item, str) and item.endswith("/"):
            filled += [page for page in pages if page.startswith(item)]
        elif isinstance(item, dict):
            ((title, below),) = item.items()
            below = below if isinstance(below, str) else _expanded(below, pages)
            filled += [{title: below}] if below else []
        else:
            filled.append(item)
    return filled
