"""Large functions in short texts: numbers with names, headings that explain a quantity once."""

from __future__ import annotations

from fractions import Fraction

import pytest

from robodyn.emit.c_syntax import c_spelling
from robodyn.emit.headings import explained_once
from robodyn.emit.statements import LARGE, Apply, Body, statements
from robodyn.ir import Input, Label, Operation, Program

OFTEN, RARE, SHORT = Fraction("0.123456789012"), Fraction("0.987654321098"), Fraction("0.25")
Q = Input("q", 0)


def _large(*more: Operation) -> Program:
    """``more``, and a sum of products with numbers, long enough to be told shortly."""
    n = len(more)
    operations = [
        *more,
        Operation("mul", (RARE, Q)),
        Operation("mul", (SHORT, Q)),
        Operation("add", (n, n + 1)),
    ]
    while len(operations) <= LARGE:
        last = len(operations) - 1
        operations += [Operation("mul", (OFTEN, last)), Operation("mul", (SHORT, last))]
        operations.append(Operation("add", (last + 1, last + 2), Label(1 + last % 2, "fc", "x")))
    return Program(tuple(operations), (("tau", (len(operations) - 1,)),))


def _text(body: Body) -> str:
    spelling = c_spelling(single=False)
    return "\n".join(f"{s.name} = {spelling.text(s.expression)}" for s in body.statements)


def test_a_long_number_that_is_read_often_is_written_once() -> None:
    program = _large()
    body = statements(program, concise=True)
    first, second = body.statements[:2]
    assert (first.name, first.expression, first.heading) == ("k1", OFTEN, "numbers that are read often")
    assert isinstance(second.expression, Apply)
    text = _text(body)
    assert text.count("0.123456789012") == 1
    assert text.count("k1*") == sum(OFTEN in operation.args for operation in program.operations)
    assert "0.987654321098*q[0]" in text, "what is read once stands where it is read"
    assert "0.25*" in text, "a name would be no shorter"


@pytest.mark.parametrize("way", ["asked for", "small"])
def test_else_numbers_stand_where_they_are_read(way: str) -> None:
    program = _large()
    if way == "small":
        program = Program(program.operations[: LARGE - 1], (("tau", (LARGE - 2,)),))
    text = _text(statements(program, concise=way == "small"))
    assert text.count("0.123456789012") > 4
    assert "k1" not in text


def test_arguments_of_sines_are_written_whole() -> None:
    angle = [Operation("add", (Q, OFTEN)), Operation("cos", (0,))]
    body = statements(_large(*angle), concise=True)
    assert [s.expression for s in body.statements if s.angle] == [Apply("add", (Q, OFTEN))]


def test_headings_explain_a_quantity_once() -> None:
    headings = [s.heading for s in statements(_large(), concise=True).statements if s.heading]
    assert headings[1] == "link 1: force that moves the link [N]"
    assert set(headings[2:]) == {"link 1: force that moves the link", "link 2: force that moves the link"}


@pytest.mark.parametrize(
    ("heading", "again"),
    [
        ("link 3: lambda matrix: takes a position to its acceleration [1/s^2]", "link 3: lambda matrix"),
        (
            "link 12: moment through the joint, about the frame's origin [N m]",
            "link 12: moment through the joint",
        ),
        ("sines and cosines of the joint angles", "sines and cosines of the joint angles"),
        ("factorisation M = U D U^T", "factorisation M = U D U^T"),
    ],
)
def test_the_second_time_a_heading_has_no_explanation(heading: str, again: str) -> None:
    explained: set[str] = set()
    assert explained_once(heading, explained) == heading
    assert explained_once(heading, explained) == again
