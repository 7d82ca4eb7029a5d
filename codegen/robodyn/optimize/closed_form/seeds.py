"""Programs of an arm's inverse dynamics from its closed form."""

from __future__ import annotations

import random
from collections import Counter
from fractions import Fraction
from typing import Any

from robodyn.ir.graph import Graph
from robodyn.ir.lowering import lower
from robodyn.ir.program import Program
from robodyn.optimize.closed_form.coordinates import values
from robodyn.optimize.closed_form.extraction import System
from robodyn.optimize.closed_form.forms import Form, forms_of
from robodyn.optimize.closed_form.scales import Scaling
from robodyn.optimize.programs import exact
from robodyn.robot.model import Robot

#: Arms with more joints are left to recursions.
MOST_JOINTS = 4
#: Forms that are looked at closely, and those that a whole search is spent on.
_FORMS, _BEST = 12, 4
#: Factorisations of a form whose constants are scaled, and programs handed back.
_TRIED, _KEPT = 150, 12
#: Work, of one to two microseconds: of the first extractions, in a form and in all; of all that follow.
_START, _LOOKING, _EXTRACTING = 30_000, 1_000_000, 4_000_000
#: Work of scaling, of a third of a microsecond.
_SCALING = 8_000_000


def closed_forms(robot: Robot, *, effort: float = 1.0, seed: int = 0) -> list[Program]:
    """Programs of ``inverse_dynamics`` of ``robot`` from its closed form, the smallest first.

    None for arms of more than four joints, or whose closed form is long. Equal arguments give equal
    programs; with ``effort`` 1 they take seconds.
    """
    if robot.n > MOST_JOINTS:
        return []
    forms = sorted(forms_of(robot, seed), key=lambda form: form.model.size)[:_FORMS]
    work = 0
    for form in forms:
        if work < _LOOKING * effort:
            work += form.search.run(int(_START * effort))
    forms = [form for form in forms if form.search.systems]
    for share in (0.3, 0.3, 0.4):
        forms.sort(key=lambda form: form.cost)
        forms = forms[: min(_BEST, max(2, len(forms) // 2))]
        for form in forms:
            form.search.run(int(_EXTRACTING * effort * share / len(forms)))
    return _scaled(forms, effort, seed)


def _scaled(forms: list[Form], effort: float, seed: int) -> list[Program]:
    """The programs of the best that was found, in several forms and factorisations."""
    chance = random.Random(seed)
    best: list[tuple[Form, Scaling]] = []
    for form in forms:
        ranked = sorted(form.search.systems.values(), key=lambda item: item[0])
        # Constants of a longer factorisation may scale better: some of those as well.
        close = [item for item in ranked[_TRIED:] if item[0] <= ranked[0][0] + 3]
        ranked = ranked[:_TRIED] + chance.sample(close, min(len(close), _TRIED))
        best += [(form, Scaling.of(system, form.search.numbers)) for _, system in ranked]
    for kept, share in ((len(best), 0.4), (100, 0.2), (36, 0.2), (_KEPT, 0.2)):
        best.sort(key=lambda item: item[0].leaves + item[1].cost)
        best = _mixed(best, kept) if kept < len(best) else best
        for _, scaling in best:
            scaling.improve(chance, int(_SCALING * effort * share / (kept * scaling.work)))
    programs = [written(form, scaling.system, scaling.scales()) for form, scaling in best]
    distinct = {program.operations: program for program in programs}
    return sorted(distinct.values(), key=operations)


def _mixed(best: list[tuple[Form, Scaling]], kept: int) -> list[tuple[Form, Scaling]]:
    """The first ``kept`` of ``best``, no form more often than in half of them."""
    taken: list[tuple[Form, Scaling]] = []
    of_form: Counter[int] = Counter()
    for item in best:
        of_form[id(item[0])] += 1
        if of_form[id(item[0])] <= max(kept // 2, 1):
            taken.append(item)
    return taken[:kept]


def operations(program: Program) -> int:
    """Operations of ``program`` beside sines, cosines and signs."""
    return sum(op in ("add", "sub", "mul", "div") for op, _, _ in program.operations)


def written(form: Form, system: System, scales: dict[int, Fraction]) -> Program:
    """The program of ``system`` with its variables so scaled."""
    graph = Graph()
    numbers = form.search.numbers
    one = Fraction(1)
    computed: dict[int, Any] = {}
    for v, node in enumerate(values(graph, form.robot, form.at, form.model.leaves)):
        computed[v] = node * scales.get(v, 1)

    def value(v: int) -> Any:
        if v not in computed:
            total: Any = 0
            for m, k in system.polynomials[v].items():
                factor = numbers.value(k) * scales.get(v, one)
                product: Any = 1
                for u in m:
                    product = product * value(u)
                    factor /= scales.get(u, one)
                total = total + exact(factor) * product
            computed[v] = total
        return computed[v]

    return lower(graph, [("tau", [value(v) / scales.get(v, one) for v in system.outputs])])
