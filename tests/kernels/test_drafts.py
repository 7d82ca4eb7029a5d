"""Of several drafts the cheapest after the passes, and which drafts go through them at all."""

from fractions import Fraction

import pytest

from robodyn.ir.program import Input, Operation, Program
from robodyn.kernels.drafts import CLEARLY, SMALL, least


def _sum(terms: int) -> Program:
    """``x1 + x2 + ...``: so many additions."""
    operations = [Operation("add", (Input("x", 0), Input("x", 1)))]
    operations += [Operation("add", (i, Input("x", i + 2))) for i in range(terms - 1)]
    return Program(tuple(operations), (("y", (len(operations) - 1,)),))


class _Shortening:
    """A pass that leaves out operations, and keeps in mind which programs it was given."""

    def __init__(self, left: dict[int, int]) -> None:
        self.left, self.seen = left, []  # type: tuple[dict[int, int], list[int]]

    def __call__(self, program: Program) -> Program:
        size = len(program.operations)
        self.seen.append(size)
        return _sum(self.left.get(size, size))


@pytest.mark.parametrize("sizes", [(1000, 950), (950, 1000)])
def test_what_the_passes_may_bring_below_goes_through_them(sizes: tuple[int, int]) -> None:
    saving = _Shortening({1000: 910})
    k, program = least([_sum(size) for size in sizes], [saving])
    assert sizes[k] == 1000
    assert len(program.operations) == 910
    assert sorted(saving.seen) == [950, 1000]


def test_what_is_clearly_dearer_does_not() -> None:
    far = int(500 / CLEARLY) + 1
    saving = _Shortening({far: 1})  # more than passes save
    k, program = least([_sum(far), _sum(500)], [saving])
    assert (k, len(program.operations)) == (1, 500)
    assert saving.seen == [500]


def test_of_few_operations_all_go_through_them() -> None:
    saving = _Shortening({SMALL: 1})
    assert least([_sum(10), _sum(SMALL)], [saving])[0] == 1


def test_another_cost_makes_no_such_promise() -> None:
    saving = _Shortening({2000: 1})
    k, _ = least([_sum(500), _sum(2000)], [saving], lambda program: float(len(program.operations)))
    assert k == 1


def test_of_equals_the_first_is_taken() -> None:
    assert least([_sum(300), _sum(300)], [])[0] == 0


def test_the_best_is_spelled() -> None:
    one = Operation("neg", (Input("x", 0),))
    two = Operation("mul", (0, Fraction(2)))
    draft = Program((one, two), (("y", (1,)),))
    for drafts in ([draft], [draft, draft]):
        _, program = least(drafts, [])
        assert [operation.op for operation in program.operations] == ["mul"]
