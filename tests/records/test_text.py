"""Records as text: what is written is read again as it was, and what is damaged is refused with its line."""

from __future__ import annotations

import contextlib
import re
from collections.abc import Callable
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dynamics.direct import NO_SHRINKING
from records.made import ELBOW, SMOOTH, TOOL, arm, bundled, fast, recorded
from robodyn import InputError, Options, program
from robodyn.dynamics.equality import equals_recursion
from robodyn.dynamics.functions import FUNCTIONS, NoSuchFunction
from robodyn.ir import Input, Label, Operation, Program
from robodyn.optimize.records import Record, parse_record
from robodyn.optimize.records.record import header
from robodyn.robot import Robot, bundled_names
from robodyn_testing import representative
from robodyn_testing.clocks import calls_of

FILE = "arm.record"
#: The functions that have records.
RECORDED = [name for name, function in FUNCTIONS.items() if function.searchable]


def programs_of(robot: Robot) -> dict[str, Program]:
    """The functions that records may have, but those that the robot does not."""
    programs = {}
    for function in RECORDED:
        with contextlib.suppress(NoSuchFunction):
            programs[function] = fast(robot, function)
    return programs


def check_round_trip(record: Record) -> None:
    text = record.text()
    found = parse_record(text, FILE)
    assert found == record
    assert found.program.operations == record.program.operations  # labels, too
    assert (found.file, found.text()) == (FILE, text)
    assert text.isascii()
    assert text.endswith("\n")
    assert not re.search(r"[ \t\r]$", text, re.M), "editors take space at the end of a line away"


@pytest.mark.parametrize("name", representative(bundled_names(), "puma560_3dof", "stanford", rest="slow"))
def test_programs_of_bundled_robots_are_read_as_they_were_written(name: str) -> None:
    robot = bundled(name)
    for function, made in programs_of(robot).items():
        check_round_trip(recorded(robot, made, function))


@pytest.mark.parametrize("text", [TOOL, SMOOTH, ELBOW], ids=["tool", "smooth", "elbow"])
def test_friction_and_names_of_numbers_are_read_as_they_were_written(text: str) -> None:
    robot = arm(text)
    programs = programs_of(robot)
    assert len(programs) > 3
    for function, made in programs.items():
        check_round_trip(recorded(robot, made, function))
    ops = {operation.op for operation in programs["inverse_dynamics"].operations}
    assert text == ELBOW or ("tanh" if text == SMOOTH else "sign") in ops


def test_every_kind_of_operation_operand_and_label() -> None:
    q, m = Input("q", 0), Input("m_1", None)
    lines = (
        Operation("add", (q, m), Label(1, "w", "x")),
        Operation("sub", (0, Fraction(-7, 3)), Label(12, "lam", "23", negative=True)),
        Operation("mul", (Fraction(1, 10**200), 1), Label(2, "s", "")),
        Operation("div", (2, 0), Label(2, "s", "", negative=True)),
        Operation("neg", (3,), Label(0, "v", "10_12")),
        *(Operation(op, (q,)) for op in ("sin", "cos")),
        *(Operation(op, (4,)) for op in ("sqrt", "tanh", "sign")),
    )
    made = Program(lines, (("M", (9, q, m, Fraction(-1, 2), Fraction(0))), ("other", (3,))))
    check_round_trip(Record("r", "0" * 32, "gravity", "weighted:cortex-m4", "by hand; two words", made))


def test_texts_as_they_were_before_labels_without_axis_lost_their_space() -> None:
    text = recorded(bundled("puma560_3dof"), fast(bundled("puma560_3dof"))).text()
    assert re.search(r": \d+ [a-z]\w*$", text, re.M)
    before = re.sub(r"(: \d+ [a-z]\w*)$", r"\1 ", text, flags=re.M)
    assert parse_record(before, FILE) == parse_record(text, FILE)


# --- damage -----------------------------------------------------------------------------------------------

ROBOT = bundled("stanford_3dof_d3")
GOOD = recorded(ROBOT, fast(ROBOT)).text()
HEAD, BODY = GOOD.split("program\n")
LINES = BODY.splitlines()
FIRST, N = 9, len(LINES) - 1  # the first operation stands in line 9; the output after N of them


def with_lines(*more: str, output: str = LINES[-1]) -> str:
    """The record with operations added before its output."""
    return HEAD + "program\n" + "\n".join([*LINES[:-1], *more, output]) + "\n"


def swapped(old: str, new: str) -> str:
    assert old in GOOD
    return GOOD.replace(old, new, 1)


def chain(first: str, *, line: str, times: int, last: str) -> str:
    """``first``, then ``line`` so often, each upon the one before (``{}``), then ``last``."""
    lines = [f"%{N} = {first}", *(f"%{N + k} = {line.format(N + k - 1)}" for k in range(1, times + 1))]
    return with_lines(*lines, f"%{N + times + 1} = {last.format(N + times)}")


DAMAGES: dict[str, tuple[str, int]] = {
    "nothing": ("", 1),
    "another title": (swapped("robodyn record 1", "robodyn record 2"), 1),
    "a line of the head missing": (swapped("objective total\n", ""), 1),
    "the head in another order": (swapped("function inverse_dynamics\nobjective total\n", "objective total\n"
                                          "function inverse_dynamics\n"), 1),
    "no program": (HEAD, 8),
    "another word for program": (swapped("\nprogram\n", "\nprogramm\n"), 8),
    "no outputs": (swapped(LINES[-1] + "\n", ""), FIRST + N),
    "an empty program": (HEAD + "program\n", 9),
    "a line missing": (swapped(LINES[3] + "\n", ""), FIRST + 3),
    "a line twice": (swapped(LINES[3], LINES[3] + "\n" + LINES[3]), FIRST + 4),
    "two lines swapped": (swapped(LINES[0] + "\n" + LINES[1], LINES[1] + "\n" + LINES[0]), FIRST),
    "an empty line inside": (swapped("\n%3 =", "\n\n%3 ="), FIRST + 3),
    "an empty line at the end": (GOOD + "\n", FIRST + N + 1),
    "an operation after the output": (GOOD + f"%{N} = neg q[0]\n", FIRST + N + 1),
    "an output twice": (GOOD + LINES[-1] + "\n", FIRST + N + 1),
    "an unknown operation": (swapped("= cos q[1]", "= tan q[1]"), FIRST + 2),
    "an operand too few": (swapped("= mul qd[0] %0", "= mul qd[0]"), FIRST + 1),
    "an operand too many": (swapped("= sin q[1]", "= sin q[1] q[2]"), FIRST),
    "no operand": (swapped("= sin q[1]", "= sin"), FIRST),
    "an operand of a line below": (swapped("= mul qd[0] %0", "= mul qd[0] %1"), FIRST + 1),
    "a constant over zero": (with_lines(f"%{N} = mul q[0] 1/00"), FIRST + N),
    "a decimal": (with_lines(f"%{N} = mul q[0] 0.5"), FIRST + N),
    "digits of another script": (with_lines(f"%{N} = mul q[0] ٣"), FIRST + N),
    "a plus": (with_lines(f"%{N} = mul q[0] +3"), FIRST + N),
    "an underscore in a number": (with_lines(f"%{N} = mul q[0] 1_000"), FIRST + N),
    "twenty thousand digits": (with_lines(f"%{N} = mul q[0] {'9' * 19_900}"), FIRST + N),
    "five thousand digits": (with_lines(f"%{N} = mul q[0] 1/{'9' * 5000}"), FIRST + N),
    "a longer line than there is": (with_lines(f"%{N} = mul q[0] {'9' * 20_000}"), 1),
    "more lines than there are": (GOOD + "\n" * 100_000, 1),
    "a label of letters": (swapped("qd[0] %0 : 2 w x", "qd[0] %0 : two w x"), FIRST + 1),
    "a label too long": (swapped("qd[0] %0 : 2 w x", "qd[0] %0 : 2 w x - -"), FIRST + 1),
    "an empty label": (swapped("qd[0] %0 : 2 w x -", "qd[0] %0 : "), FIRST + 1),
    "a sine of a product": (with_lines(f"%{N} = mul q[0] q[1]", f"%{N + 1} = sin %{N}"), FIRST + N + 1),
    "a sine of a half": (with_lines(f"%{N} = mul 1/2 q[0]", f"%{N + 1} = sin %{N}"), FIRST + N + 1),
    "a sine of a sine": (with_lines(f"%{N} = sin %0"), FIRST + N),
    "a sine of doubles": (chain("neg q[0]", line="add %{0} %{0}", times=80, last="sin %{}"), FIRST + N + 81),
    "a sine of a multiple": (with_lines(f"%{N} = mul 987654321 q[0]", f"%{N + 1} = cos %{N}"), FIRST + N + 1),
    "a sine of a long sum": (chain("neg q[0]", line="neg %{}", times=999, last="sin %{}"), FIRST + N + 1000),
    "numbers alone": (with_lines(f"%{N} = mul 3 3"), FIRST + N),
    "a root of minus one": (with_lines(f"%{N} = sqrt -1"), FIRST + N),
    "a power of powers": (chain("neg qd[0]", line="mul %{0} %{0}", times=40, last="neg %{}"), FIRST + N + 10),
    "no record at all": ("#include <math.h>\n" * 20, 1),
}  # fmt: skip


@pytest.mark.parametrize("damage", DAMAGES)
def test_damage_is_refused_where_it_is(damage: str) -> None:
    text, line = DAMAGES[damage]
    with pytest.raises(InputError) as refused:
        calls_of(lambda: parse_record(text, FILE), most=100_000)
    assert str(refused.value).startswith(f"{FILE}:{line}: "), str(refused.value)
    assert len(str(refused.value)) < 400


def test_records_without_the_key_of_their_function_are_read() -> None:
    before = re.sub("^computes .*\n", "", GOOD, flags=re.M)
    assert before != GOOD
    assert parse_record(before, FILE) == parse_record(GOOD, FILE) == parse_record(GOOD[:-1], FILE)
    assert list(header(before)) == ["robot", "identity", "function", "objective", "found"]


def test_a_header_is_read_or_not() -> None:
    assert list(header(GOOD)) == ["robot", "identity", "function", "objective", "found", "computes"]
    for text in ("", "\n", GOOD[:40], "robodyn record 1\n" + "robot x\n" * 5, GOOD.replace("\n", "\r\n")):
        assert header(text) == {}


def refusal(text: str) -> str | None:
    """How ``text`` is refused; None where it is read."""
    try:
        parse_record(text, FILE)
    except InputError as error:
        return str(error)
    return None


def used(text: str, robot: Robot = ROBOT) -> Program | None:
    """The inverse dynamics that a record's text leads to, None where it is refused as it should be."""
    if (message := refusal(text)) is not None:
        assert re.match(rf"{FILE}:\d+: ", message)
        return None
    record = parse_record(text, FILE)
    made = None
    for function in ("inverse_dynamics", "gravity"):
        try:
            made = made or program(robot, function, Options((function,), records=(record,)))
        except InputError as error:
            message = str(error)
    if message is not None:
        assert message.startswith(f"{FILE}: ")
        return None
    return made


@given(st.text(max_size=200))
def test_any_text_is_a_record_or_refused(text: str) -> None:
    for whole in (text, HEAD + "program\n" + text, GOOD + text):
        message = refusal(whole)
        assert message is None or re.match(rf"{FILE}:\d+: ", message)


#: Operations that a program may have, whatever it computes: upon inputs, constants and the operations before.
OPERANDS = st.sampled_from(["q[0]", "q[1]", "q[2]", "qd[0]", "qdd[2]", "0", "-1", "5/7", "%{a}", "%{b}"])
OPERATIONS = st.lists(
    st.tuples(
        st.sampled_from(["add", "sub", "mul", "div", "neg", "sqrt", "sin", "cos", "tanh", "sign"]),
        OPERANDS,
        OPERANDS,
        st.integers(1, 9),
        st.integers(1, 9),
    ),
    max_size=12,
)


@settings(max_examples=60, deadline=None, phases=NO_SHRINKING)
@given(OPERATIONS, st.integers(0, 2))
def test_what_is_written_well_but_means_nothing_is_refused_or_harmless(
    operations: list[tuple[str, str, str, int, int]], element: int
) -> None:
    lines: list[str] = []
    for op, first, second, a, b in operations:
        at = N + len(lines)
        words = [word.format(a=at - a, b=at - b) for word in (first, second)]
        lines.append(f"%{at} = {op} {' '.join(words[: 2 if op in ('add', 'sub', 'mul', 'div') else 1])}")
    outputs = LINES[-1].split()[2:]
    if lines:  # the last of them, less itself, is added to a torque
        at = N + len(lines)
        lines += [f"%{at} = sub %{at - 1} %{at - 1}", f"%{at + 1} = add %{at} {outputs[element]}"]
        outputs[element] = f"%{at + 1}"
    made = used(with_lines(*lines, output=f"tau = {' '.join(outputs)}"))
    assert made is None or equals_recursion(ROBOT, "inverse_dynamics", made)


@pytest.mark.parametrize(
    "build",
    [
        lambda: chain("add q[0] q[1]", line="add %{0} %{0}", times=5000, last="tanh %{}"),
        lambda: chain("add 3 qd[0]", line="mul %{} 123456789/1000000007", times=900, last="neg %{}"),
        lambda: chain("neg q[0]", line="neg %{}", times=20_000, last="sqrt %{}"),
    ],
    ids=["doubled", "multiplied", "long"],
)
def test_what_is_long_takes_few_calls_and_no_room(build: Callable[[], str]) -> None:
    refused = []
    calls_of(lambda: refused.append(used(build()) is None), most=3_000_000)
    assert refused == [True]
