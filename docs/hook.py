"""What the site has beyond the documents in this folder: called by mkdocs (``hooks`` in mkdocs.yml)."""

from __future__ import annotations

from typing import Any

from mkdocs.structure.files import File, Files

from robodyn_site import equations, navigation, outside, tables
from robodyn_site.pages import pages


def on_config(config: Any) -> None:
    """Fill in the folders of the navigation."""
    config.nav = navigation.expanded(config.nav, dict.fromkeys([*navigation.documents(), *pages()]))


def on_files(files: Files, config: Any) -> Files:
    """Add the pages that are made here, and the pictures that lie elsewhere."""
    for path, text in pages().items():
        written = files.get_file_from_path(path)
        if written is not None:
            files.remove(written)
        files.append(File.generated(config, path, content=text))
    for path, source in outside.PICTURES.items():
        files.append(File.generated(config, path, abs_src_path=str(outside.ROOT / source)))
    return files


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """Links of the repository are links of the site."""
    return outside.relinked(markdown, page.file.src_uri)


def on_page_content(html: str, **_: Any) -> str:
    """Typeset the equations, and mend the tables."""
    return tables.without_empty_heads(equations.typeset(html))
