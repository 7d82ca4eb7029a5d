"""Every figure in the text of README and the documents comes from somewhere, and a wrong one is noticed."""

from __future__ import annotations

import pytest

from documents.blocks import PAGES, ROOT
from documents.figures import digest_of, faults, figures, with_another_digit

TEXTS = {page: (ROOT / page).read_text(encoding="utf-8") for page in PAGES}


@pytest.mark.parametrize("page", PAGES)
def test_every_figure_comes_from_somewhere(page: str) -> None:
    assert faults(TEXTS[page]) == []


@pytest.mark.parametrize("page", PAGES)
def test_a_wrong_figure_is_noticed(page: str) -> None:
    """Each figure of the page in turn, its last digit changed."""
    text = TEXTS[page]
    missed = [
        f"line {text.count(chr(10), 0, one.start) + 1}: {one.before} {one.text} {one.after}"
        for one in figures(text)
        if not faults(with_another_digit(text, one))
    ]
    assert missed == [], "as good with another last digit: say what it is, <!-- FIGURE = EXPRESSION -->"


PAGE = """\
# A page

<!-- from pyproject.toml -->
Python 3.11 has `x1`, [four links](a4.md), and 12 joints, 0.43 of 1,262 things; see Table 2.10, joint 3.

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
    assert [one.text for one in figures(PAGE)] == ["12", "0.43", "1,262", "30", "12"]
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
    assert faults(closed.replace("Status: accepted.", "")) != []
