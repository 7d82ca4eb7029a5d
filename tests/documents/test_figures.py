"""Every figure in the text of README and the documents comes from somewhere, and a wrong one is noticed."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from documents.blocks import PAGES, ROOT
from documents.figures import WRITTEN, Page, faults

TEXTS = {page: (ROOT / page).read_text(encoding="utf-8") for page in PAGES}
NEW = "\nIt takes 1,234 operations.\n"


def planted(text: str, digits: str = "") -> Iterator[str]:
    """A text for each wrong figure: a new one at the end, and each there is with another last digit, the next
    one; with ``digits`` with each of them in the place of each of its digits."""
    yield text + NEW
    for figure in Page(text).figures:
        significant = [k for k, x in enumerate(figure.text.partition("e")[0]) if x.isdigit()]
        for k in significant if digits else significant[-1:]:
            for digit in digits or str((int(figure.text[k]) + 1) % 10):
                if digit != figure.text[k]:
                    place = figure.start + k
                    yield text[:place] + digit + text[place + 1 :]


@pytest.mark.parametrize("page", PAGES)
def test_every_figure_comes_from_somewhere(page: str) -> None:
    assert faults(TEXTS[page]) == []


@pytest.mark.parametrize("page", PAGES)
def test_a_wrong_figure_is_noticed(page: str) -> None:
    right = TEXTS[page]
    missed = [_difference(right, wrong) for wrong in planted(right) if not faults(wrong)]
    assert missed == [], "as good with another digit: say what it is, <!-- FIGURE = EXPRESSION -->"


def _difference(right: str, wrong: str) -> str:
    lines = zip(right.splitlines(), wrong.splitlines(), strict=False)
    return next((line for old, line in lines if old != line), NEW)


def test_what_a_benchmark_writes_is_compared() -> None:
    """A table between marks is no text: another test has its mark."""
    files = (path for top in ("tests", "benchmarks") for path in ROOT.glob(f"{top}/**/*.py"))
    code = "\n".join(path.read_text(encoding="utf-8") for path in files)
    for page, text in TEXTS.items():
        for written in WRITTEN.finditer(text):
            assert f'"{written[1]}"' in code or f"<!-- {written[1]} -->" in code, page
