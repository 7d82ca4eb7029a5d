"""The claims of the text: numbers, sections, verdicts and figures as a review has them."""

from __future__ import annotations

import importlib
import inspect
from pathlib import Path
from typing import Any

import pytest
import yaml

from robodyn import load
from robodyn.thesis.claims import Arms
from robodyn.thesis.tables.claims import read_claims
from thesis.recomputed import table

REVIEW = yaml.safe_load(Path(__file__).with_name("claims.yaml").read_text(encoding="utf-8"))
MODULES = ("formulations", "listings", "friction", "tasks", "processors")


def test_numbers_sections_verdicts_and_figures_are_the_reviews() -> None:
    rows = table("claims").to_dict()["rows"]
    for row, review in zip(rows, REVIEW, strict=True):
        figures = {name: row["ours"].get(name) for name in review["ours"]}
        assert {**row, "ours": figures}.items() >= review.items(), row["row"]
    assert sorted({row["number"] for row in rows}) == list(range(1, 95))


@pytest.mark.thorough
def test_a_verdict_stands_in_the_data_only_where_no_figure_decides() -> None:
    recomputed = Arms()
    for claim in read_claims():
        _, holds = claim.recompute(recomputed)
        assert (
            claim.by is None or claim.verdict == "not recoverable" or (holds is None) == bool(claim.verdict)
        )
        assert claim.by or (claim.verdict and claim.ours.startswith("not recomputed")), claim.name


def test_every_function_belongs_to_a_claim() -> None:
    functions = {
        f"{name}.{function}"
        for name in MODULES
        for module in [importlib.import_module(f"robodyn.thesis.claims.{name}")]
        for function, value in vars(module).items()
        if inspect.isfunction(value) and value.__annotations__.get("return") == "Outcome"
        if function[0] != "_" and value.__module__ == module.__name__
    }
    assert functions == {claim.by for claim in read_claims() if claim.by}


def test_what_follows_from_printed_figures_is_apart() -> None:
    row: dict[str, Any] = table("claims").row("lambda form").to_dict()
    assert row["printed"].keys() == {"claim", "range_pct"}
    assert row["derived_from_printed"] == {"revolute": 34.9, "prismatic": 43.5}


def test_products_of_inertia_of_makers_arms() -> None:
    """What the reason of claim 27 says of the example arms, which are not in the package."""
    files = sorted((Path(__file__).parents[2] / "examples" / "arms").glob("*.yaml"))
    inertias = [[link.inertia for link in load(arm, warn=lambda _: None).links] for arm in files]
    oblique = [arm for arm in inertias if any(any((i.xy, i.xz, i.yz)) for i in arm)]
    (claim,) = (claim for claim in read_claims() if claim.claim_number == 27)
    assert f"of the {len(files)} arms from makers' files in examples/arms {len(oblique)} have" in claim.reason
