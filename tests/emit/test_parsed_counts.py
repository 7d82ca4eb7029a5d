"""The emitted C, read by a C parser, has exactly the operations that the counts say."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import asdict
from typing import Any

import pytest
from pycparser import c_ast, c_parser

from emit.kernels import ODD, RANDOM, in_single, made, robots
from robodyn.counts import Count
from robodyn.kernels.generate import Generated
from robodyn_testing import sampled

CALLS = {
    "sin": "sincos", "cos": "sincos", "tanh": "other", "sqrt": "sqrt", "fabs": "other", "exp": "other",
    "pow": "other",
}  # fmt: skip
_FLOAT_CALL = rf"\b({'|'.join(CALLS)})f\b"
#: What may stand in an emitted function, beside expressions.
STATEMENTS = (c_ast.Decl, c_ast.Assignment, c_ast.Cast)


def preprocessed(files: dict[str, str]) -> str:
    """Header and source as one text, without comments and directives, as a C compiler sees them."""
    (header,) = (text for name, text in files.items() if name.endswith(".h"))
    (source,) = (text for name, text in files.items() if name.endswith(".c"))
    text = re.sub(r"/\*.*?\*/", " ", header + source, flags=re.DOTALL)
    assert "//" not in text
    text = re.sub(r"#ifdef __cplusplus.*?#endif", " ", text, flags=re.DOTALL)
    return "\n".join(line for line in text.splitlines() if not line.startswith("#"))


class BodyCount:
    """Counts the operations of one function's body."""

    def __init__(self, single: bool) -> None:
        self.single = single
        self.found: Counter[str] = Counter()

    def statement(self, node: c_ast.Node) -> None:
        assert isinstance(node, STATEMENTS), node
        if isinstance(node, c_ast.Decl):
            self.expression(node.init)
        elif isinstance(node, c_ast.Assignment):
            assert node.op == "="
            if isinstance(node.lvalue, c_ast.StructRef):  # state->z1 = z1_next: no state is read after
                assert node.lvalue.name.name == "state"
                assert isinstance(node.rvalue, c_ast.ID)
            else:
                assert isinstance(node.lvalue, c_ast.ArrayRef)
            self.expression(node.rvalue)
        else:  # (void)q;
            assert isinstance(node.expr, c_ast.ID)

    def expression(self, node: Any) -> None:
        if isinstance(node, c_ast.BinaryOp):
            self.found[{"*": "mul", "+": "add", "-": "add", "/": "div"}[node.op]] += 1
            self.expression(node.left)
            self.expression(node.right)
        elif isinstance(node, c_ast.UnaryOp):
            assert node.op == "-"
            if not isinstance(node.expr, c_ast.Constant):  # else it is the sign of a literal
                self.found["neg"] += 1
            self.expression(node.expr)
        elif isinstance(node, c_ast.FuncCall):
            name = node.name.name.removesuffix("f") if self.single else node.name.name
            assert node.name.name.endswith("f") is self.single
            self.found[CALLS[name]] += 1
            assert len(node.args.exprs) == (2 if name == "pow" else 1)
            for argument in node.args.exprs:
                self.expression(argument)
        elif isinstance(node, c_ast.TernaryOp):
            self.sign(node)
        elif isinstance(node, c_ast.Constant):
            assert node.type == ("float" if self.single else "double")
            assert node.value.endswith("f") is self.single
        elif isinstance(node, c_ast.ArrayRef):
            assert isinstance(node.subscript, c_ast.Constant)
        elif isinstance(node, c_ast.StructRef):
            assert node.name.name in ("p", "state")
        else:
            assert isinstance(node, c_ast.ID), node

    def sign(self, node: c_ast.TernaryOp) -> None:
        """``(x > 0 ? 1 : (x < 0 ? -1 : 0))``: one sign, of one x that is no operation itself."""
        above, below = node.cond, node.iffalse.cond
        assert (above.op, below.op) == (">", "<")
        assert not isinstance(above.left, c_ast.BinaryOp)
        self.found["other"] += 1
        for literal in (node.iftrue, node.iffalse.iftrue, node.iffalse.iffalse, above.right, below.right):
            self.expression(literal)
        before = self.found.copy()
        self.expression(above.left)
        assert self.found == before


def counted(files: dict[str, str], single: bool) -> dict[str, Count]:
    """The operations of each function in the emitted C, by symbol."""
    declared = "".join(f"double {f}(double); float {f}f(float);" for f in CALLS)
    tree = c_parser.CParser().parse(declared + preprocessed(files))
    found: dict[str, Count] = {}
    for node in tree.ext:
        if not isinstance(node, c_ast.FuncDef):
            assert isinstance(node, (c_ast.Decl, c_ast.Typedef)), "a global"
            assert not isinstance(node, c_ast.Decl) or isinstance(node.type, c_ast.FuncDecl), "a variable"
            continue
        counter = BodyCount(single)
        names: list[str] = []
        for statement in node.body.block_items or []:
            if isinstance(statement, c_ast.Decl):
                names.append(statement.name)
                assert "const" in statement.quals
            counter.statement(statement)
        assert len(set(names)) == len(names)
        found[node.decl.name] = Count(**counter.found)
    return found


def by_symbol(generated: Generated) -> dict[str, Count]:
    return {s.symbol: generated.counts[s.function] for s in generated.signatures}


def structure(files: dict[str, str]) -> str:
    """The text with every literal, and the names of types and functions, alike in double and float."""
    text = re.sub(r"\b[0-9]+\.?[0-9]*(e[+-]?[0-9]+)?f?\b(?!\])", "0", preprocessed(files))
    return re.sub(_FLOAT_CALL, r"\1", text).replace("typedef float", "typedef double")


@pytest.mark.parametrize(
    ("name", "trig"),
    sampled(
        [
            (name, trig)
            for name in robots()
            for trig in ("libm", "given")
            if not (name in RANDOM and trig == "given")
        ],
        every=11,
        rest="slow",
    ),
)
def test_the_text_has_the_operations_that_are_counted(name: str, trig: str) -> None:
    generated = made(name, trig)
    single = in_single(generated)
    files = generated.files(("c",))
    assert counted(files, single=False) == by_symbol(generated)
    if name == "huge_and_tiny":  # in float its numbers are none
        return
    files_in_single = single.files(("c",))
    if name in (*ODD, "puma560", "stanford"):  # the others: the same text but for the literals
        assert counted(files_in_single, single=True) == by_symbol(generated)
    assert structure(files_in_single).split() == structure(files).split()


@pytest.mark.parametrize("name", ["puma560", "smooth", "rubbing", "tool"])
def test_counts_by_kind_stand_in_the_files(name: str) -> None:
    generated = made(name)
    for name_, text in generated.files().items():
        flat = " ".join(re.sub(r"^( \*|!)", "", line).strip() for line in text.splitlines())
        for function, found in generated.counts.items():
            told = f"{function}: {found}; {found.neg} unary minus; {found.sincos} sine/cosine"
            assert told in flat, name_


@pytest.mark.parametrize(
    ("statement", "expected"),
    [
        ("fc3_x = 4.8*(a3_x - 0.07*lam3_12)", {"mul": 2, "add": 1}),  # the worked line of the documentation
        ("x = -0.5*y", {"mul": 1}),
        ("x = -y*y", {"mul": 1, "neg": 1}),
        ("x = -y - z", {"add": 1, "neg": 1}),
        ("x = y - (-0.5)", {"add": 1}),
        ("x = 2.0*y + y*y", {"mul": 2, "add": 1}),
        ("x = 1.0/(q[1] + q[0])", {"div": 1, "add": 1}),
        ("x = (y > 0.0 ? 1.0 : (y < 0.0 ? -1.0 : 0.0))*tanh(z)", {"mul": 1, "other": 2}),
    ],
)
def test_the_parser_counts_as_the_thesis_does(statement: str, expected: dict[str, int]) -> None:
    """The convention, line by line: without this the comparison could be wrong on both sides."""
    text = f"typedef double r;\nvoid f(const r q[2], r t[1]) {{ const r {statement}; t[0] = x; }}"
    (found,) = counted({"f.h": "", "f.c": text}, single=False).values()
    assert {kind: n for kind, n in asdict(found).items() if n} == expected
