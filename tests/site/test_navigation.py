"""The documentation site: every page can be reached, and links of the repository are links of the site."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest
import yaml

from robodyn.dynamics.functions import FUNCTIONS
from robodyn.effects.catalogue import CATALOGUE
from robodyn.emit.languages import LANGUAGES
from robodyn.targets.table import TARGETS
from robodyn_cli.main import COMMANDS
from robodyn_site import navigation, outside
from robodyn_site.pages import REPLACED, pages

ROOT = Path(__file__).parents[2]
NAV = yaml.safe_load((ROOT / "mkdocs.yml").read_text(encoding="utf-8"))["nav"]


def test_every_page_is_in_the_navigation_once() -> None:
    there = {*navigation.documents(), *pages()}
    assert sorted(navigation.named(navigation.expanded(NAV, there))) == sorted(there)


def test_no_page_is_made_that_is_written() -> None:
    assert set(navigation.documents()) & pages().keys() == REPLACED


@pytest.mark.parametrize(
    ("folder", "names"),
    [
        ("commands", COMMANDS),
        ("effects", CATALOGUE),
        ("functions", FUNCTIONS),
        ("targets", TARGETS),
        ("languages", LANGUAGES),
    ],
)
def test_each_has_a_page_that_says_what_it_is(folder: str, names: Iterable[str]) -> None:
    for name in names:
        title, _, text = pages()[f"{folder}/{name}.md"].partition("\n\n")
        assert title.startswith("# ")
        assert re.match(r"[^|#\s-].{20}", text), text[:80]


@pytest.mark.parametrize(
    ("nav", "expected"),
    [
        (["a.md", {"B": ["b/"]}], ["a.md", {"B": ["b/index.md", "b/y.md", "b/x.md"]}]),
        ([{"B": ["b/x.md", "b/"]}], [{"B": ["b/x.md", "b/index.md", "b/y.md"]}]),
        (["a.md", {"C": ["c/"]}, {"D": [{"E": ["c/"]}]}], ["a.md"]),
    ],
)
def test_folders_stand_for_their_pages(nav: Any, expected: Any) -> None:
    assert navigation.expanded(nav, ["a.md", "b/y.md", "b/x.md", "b/index.md"]) == expected


@pytest.mark.parametrize(
    ("page", "text", "expected"),
    [
        ("real-arms.md", "![x](../benchmarks/results/gap.svg)", "![x](benchmarks/gap.svg)"),
        (
            "decisions/README.md",
            "[c](../../CONTRIBUTING.md#add-a-robot)",
            "[c](../contributing.md#add-a-robot)",
        ),
        ("contributing.md", "[a](docs/architecture.md)", "[a](architecture.md)"),
        ("contributing.md", "[a](https://x.org/y) [b](#here)", "[a](https://x.org/y) [b](#here)"),
        ("contributing.md", "[a](Makefile)", "[a](Makefile)"),
    ],
)
def test_links_of_the_repository_are_links_of_the_site(page: str, text: str, expected: str) -> None:
    assert outside.relinked(text, page) == expected


def test_what_lies_elsewhere_is_there() -> None:
    for source in [*outside.DOCUMENTS.values(), *outside.PICTURES.values()]:
        assert (ROOT / source).is_file()


def test_links_elsewhere_are_whole() -> None:
    """They are not opened here: an address is https, of a host, and without what ends a sentence."""
    texts = [path.read_text(encoding="utf-8") for path in (ROOT / "docs").rglob("*.md")]
    links = re.findall(r"https?:[^\s)>\"'`]*", "\n".join([*texts, *pages().values()]))
    assert links
    for link in links:
        address = urlsplit(link)
        assert address.scheme == "https", link
        assert re.fullmatch(r"[a-z0-9-]+(\.[a-z0-9-]+)+", address.netloc), link
        assert link[-1] not in ".,;:", link


def test_links_work_in_a_checkout() -> None:
    """Pages that only the site has are linked from its first page alone, which is for the site."""
    documents = [*(ROOT / "docs").rglob("*.md"), ROOT / "README.md", ROOT / "CONTRIBUTING.md"]
    for document in documents:
        text = re.sub(
            r"^ *```.*?^ *```", "", document.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL
        )
        for target in re.findall(r"\]\(([^)#:\s]+)", text):
            if document != ROOT / "docs" / "index.md":
                assert (document.parent / target).exists(), f"{document.relative_to(ROOT)}: {target}"
