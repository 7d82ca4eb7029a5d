"""What logarithmic forms cost: from few joints on a shorter chain, always more work."""

from __future__ import annotations

from itertools import pairwise

import pytest

from ir.programs import Point, exactly
from robodyn.ir import Input
from robodyn.schedule import Machine, solve
from robodyn.thesis.logarithmic import (
    FORMS,
    LINEAR,
    LOGARITHMIC,
    cost,
    first_shorter,
    form_graph,
    general_program,
    thesis_chain,
)
from robodyn_testing import representative


@pytest.mark.parametrize("n", [1, 2, 5])
def test_all_forms_compute_the_same(n: int) -> None:
    at = Point(3)
    circle = [at.circle(Input("q", i)) for i in range(n)]
    given = {Input("cs"[k], i): circle[i][k] for i in range(n) for k in (0, 1)}
    found = [exactly(general_program(form, n), at, given) for form in FORMS]
    assert all(torques == found[0] for torques in found)


@pytest.mark.parametrize("form", representative(LOGARITHMIC, "lathrop"))
def test_chains_grow_with_the_logarithm(form: str) -> None:
    chain = {n: cost(form, n).chain for n in (4, 8, 16, 32)}
    steps = [chain[8] - chain[4], chain[16] - chain[8], chain[32] - chain[16]]
    assert max(steps) <= 16  # each doubling of n costs so much, and no more
    assert chain[32] < thesis_chain(32) / 5


@pytest.mark.parametrize("form", LINEAR)
def test_linear_chains_grow_with_n(form: str) -> None:
    chains = [cost(form, n).chain for n in (6, 7, 8, 9)]
    assert len({b - a for a, b in pairwise(chains)}) == 1


@pytest.mark.parametrize("form", representative(LOGARITHMIC, "lathrop"))
def test_from_three_joints_on_the_chain_is_shorter_at_twice_the_work(form: str) -> None:
    sizes = range(2, 13)
    chains = {name: {n: cost(name, n).chain for n in sizes} for name in (form, *LINEAR)}
    assert [first_shorter(chains[form], chains[linear]) for linear in LINEAR] == [3, 3]
    assert first_shorter(chains[form], {n: thesis_chain(n) for n in sizes}) == 2
    for n in (3, 6, 12):
        own, other = cost(form, n), cost("modified-newton-euler", n)
        assert own.chain < other.chain
        assert 1.7 * other.work < own.work < 3 * other.work


def test_never_shorter_is_told() -> None:
    assert first_shorter({3: 5, 4: 6}, {3: 9, 4: 6}) is None


def test_at_six_joints_trees_are_done_sooner_from_35_processors_on() -> None:
    linear, quick = (form_graph(form, 6) for form in ("modified-newton-euler", "lathrop"))
    few = [
        solve(form_graph(form, 6), Machine(4)).timetable.span
        for form in ("modified-newton-euler", "lee-chang")
    ]
    assert few[0] < few[1]  # the linear form with less work
    spans = {p: [solve(graph, Machine(p)).timetable.span for graph in (linear, quick)] for p in (34, 35)}
    assert spans[34][0] <= spans[34][1]
    assert spans[35][0] > spans[35][1]
