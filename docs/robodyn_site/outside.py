"""Documents and pictures that lie elsewhere in the repository, and links between all of them."""

from __future__ import annotations

import re
from pathlib import Path
from posixpath import dirname as folder_of
from posixpath import join, normpath, relpath
from typing import Final

ROOT: Final = Path(__file__).parents[2]

#: Page of the site -> document of the repository.
DOCUMENTS: Final = {
    "contributing.md": "CONTRIBUTING.md",
    "changelog.md": "CHANGELOG.md",
    "benchmarks/functions.md": "benchmarks/results/functions.md",
}
#: Picture of the site -> picture of the repository.
PICTURES: Final = {
    "benchmarks/gap.svg": "benchmarks/results/gap.svg",
}
_SITE_OF: Final = {source: page for page, source in (DOCUMENTS | PICTURES).items()}
_LINK: Final = re.compile(r"(\]\()([^)#:\s]+)(#[^)\s]*)?(\))")


def pages() -> dict[str, str]:
    """The documents that lie elsewhere, as pages."""
    return {page: (ROOT / source).read_text(encoding="utf-8") for page, source in DOCUMENTS.items()}


def relinked(text: str, page: str) -> str:
    """The text of a page with the repository's relative links as those of the site.

    A link to what is not in the site stays as it is, and the strict build refuses it.
    """
    here = folder_of(DOCUMENTS.get(page, f"docs/{page}"))

    def link(match: re.Match[str]) -> str:
        path = normpath(join(here, match[2]))
        target = _SITE_OF.get(path, path.removeprefix("docs/") if path.startswith("docs/") else "")
        if not target:
            return match[0]
        return f"{match[1]}{relpath(target, folder_of(page) or '.')}{match[3] or ''}{match[4]}"

    return _LINK.sub(link, text)
