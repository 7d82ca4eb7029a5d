"""Every figure in the text of README and the documents comes from somewhere, and a wrong one is noticed."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from documents.blocks import PAGES, ROOT
from documents.figures import WRITTEN, Page, digest_of, faults

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


@pytest.mark.slow
def test_no_wrong_digit_passes() -> None:
    noticed = {
        page: [bool(faults(wrong)) for wrong in planted(text, "0123456789")] for page, text in TEXTS.items()
    }
    figures = sum(len(Page(text).figures) for text in TEXTS.values())
    pages = f"{sum(map(all, noticed.values()))} of {len(noticed)} pages, {figures} figures"
    found = f"{sum(map(sum, noticed.values()))} of {sum(map(len, noticed.values()))}"
    print(f"{pages}: of wrong ones {found} are noticed")
    assert all(map(all, noticed.values()))


def test_what_a_benchmark_writes_is_compared() -> None:
    """A table between marks is no text: another test has its mark."""
    files = (path for top in ("tests", "benchmarks") for path in ROOT.glob(f"{top}/**/*.py"))
    code = "\n".join(path.read_text(encoding="utf-8") for path in files)
    for page, text in TEXTS.items():
        for written in WRITTEN.finditer(text):
            assert f'"{written[1]}"' in code or f"<!-- {written[1]} -->" in code, page


PAGE = """\
# A page

Python 3.11 has `x1`, [four links](a4.md), and 12 joints, 0.43 of 1,262 things; see Table 2.10.

<!-- not run: no -->
```console
$ echo 12 joints 0.4317
9 joints
```

## A section

It has 30 of 12. <!-- 30 = 12 * 2 + 6 -->

## Another

1. No figure.

```console
$ echo 1262
1262
```
"""


def test_figures_and_names_are_told_apart() -> None:
    assert [one.text for one in Page(PAGE).figures] == ["12", "0.43", "1,262", "30", "12"]
    assert faults(PAGE) == []


@pytest.mark.parametrize(
    ("right", "wrong", "fault"),
    [
        ("12 joints,", "9 joints,", "and 9 joints"),  # printed where nothing is run
        ("12 joints,", "1262 joints,", None),
        ("Table 2.10", "Table 2.19", "Table 2.19"),
        ("has 30 of", "has 31 of", "has 31 of"),
        ("has 30 of", "has three of", "no figure is 30"),
        ("= 12 * 2 + 6", "= 12 * 2 + 5", "it is 29"),
        ("No figure.", "Now 30 figures.", "Now 30 figures"),  # in another section
        ("0.43 of", "0.432 of", None),
        ("0.43 of", "0.431 of", "0.431 of"),
    ],
)
def test_what_is_wrong_is_named(right: str, wrong: str, fault: str | None) -> None:
    assert PAGE.count(right) == 1
    named = faults(PAGE.replace(right, wrong))
    assert fault in "\n".join(named) if fault else named == []


def test_a_decision_is_a_record_of_its_day() -> None:
    text = "# 0099: so\n\nStatus: accepted. Date: 2026-11-26.\n\nIt took 12 s.\n"
    closed = f"{text}\n<!-- closed {digest_of(text)} -->\n"
    assert faults(closed) == []
    assert faults(closed.replace("12 s", "13 s")) != []
    assert faults(closed + NEW) != []
    assert faults(closed.replace("Status: accepted.", "")) != []
