"""All pages that are made when the site is built."""

from __future__ import annotations

from functools import cache

from robodyn_site import outside


@cache
def pages() -> dict[str, str]:
    """Path in the site -> Markdown."""
    return {**outside.pages()}
