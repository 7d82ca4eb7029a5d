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
    "benchmarks/index.md": "benchmarks/README.md",
    "robots.md": "robots/README.md",
}
#: Picture of the site -> picture of the repository.
PICTURES: Final = {
    f"benchmarks/{name}.svg": f"benchmarks/results/{name}.svg"
    for name in ("gap", "growth", "peers", "reliability")
}
#: Made from results: page of the site -> document of the repository that the same code has written.
RESULTS: Final = {
    f"benchmarks/{name}.md": f"benchmarks/results/{name}.md"
    for name in ("batch", "cuda", "fleet", "functions", "gap", "limits", "peers", "public_files")
}
_SITE_OF: Final = {source: page for page, source in (DOCUMENTS | PICTURES | RESULTS).items()}
_LINK: Final = re.compile(r"(\]\()([^)#:\s]+)(#[^)\s]*)?(\))")


def pages() -> dict[str, str]:
    """The documents that lie elsewhere, as pages."""
    return {page: (ROOT / source).read_text(encoding="utf-8") for page, source in DOCUMENTS.items()}


def relinked(text: str, page: str) -> str:
    """The text of a page with the repository's relative links as those of the site.

    A link to what is not in the site stays as it is, and the strict build refuses it.
    """
    here = folder_of((DOCUMENTS | RESULTS).get(page, f"docs/{page}"))

    def link(match: re.Match[str]) -> str:
        path = normpath(join(here, match[2]))
        target = _SITE_OF.get(path, path.removeprefix("docs/") if path.startswith("docs/") else "")
        if not target:
            return match[0]
        return f"{match[1]}{relpath(target, folder_of(page) or '.')}{match[3] or ''}{match[4]}"

    return _LINK.sub(link, text)
