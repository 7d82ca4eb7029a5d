"""Rust, edition 2021: a ``no_std`` crate without ``unsafe``.

Rust fuses no products and sums, so a kernel with its own sine and cosine gives the bits of the C. What the
core library lacks (``exp``, ``tanh``, ``pow``, ``sqrt``, and sine and cosine unless they are built in) is the
crate ``libm``'s; apart from ``sqrt`` its last bit may differ from that of C's library.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from robodyn.emit.arctangent import arctangent_context
from robodyn.emit.body import Lines
from robodyn.emit.language import FunctionText, Language
from robodyn.emit.listing import BRANCH, FLAGS, listing_of
from robodyn.emit.runs import Run
from robodyn.emit.sines import ANGLES, COSINES, SINES
from robodyn.emit.spelling import WIDTH, Spelling, elements
from robodyn.emit.stages import NEXT, ROW, Repeated, Stage
from robodyn.emit.statements import Expression
from robodyn.emit.syntax import Sines, Syntax
from robodyn.emit.trig import trig_context
from robodyn.emit.unit import BUILTIN, Unit, builtin_words, calls, has_arctangents, has_sines
from robodyn.errors import InputError
from robodyn.ir.program import STATE
from robodyn.ir.signature import Signature
from robodyn.tools import Tool, Use

#: Words that no name may be; the four that cannot even be written ``r#word`` are refused.
_KEYWORDS = frozenset(
    """
    abstract as async await become box break const continue do dyn else enum extern false final fn for if impl
    in let loop macro match mod move mut override priv pub ref return static struct trait true try type typeof
    unsafe unsized use virtual where while yield
    """.split()  # noqa: SIM905 (it reads as the list that it is)
)
_NEVER = frozenset({"self", "Self", "super", "crate"})
#: Names that a crate should not have.
_CRATES = _KEYWORDS | _NEVER | {"alloc", "core", "libm", "proc_macro", "std", "test"}

#: rustfmt breaks a call whose arguments are longer, and an array.
_ARGUMENTS = 60

#: Operations of the crate libm.
_OF_LIBM = frozenset({"exp", "pow", "sqrt", "tanh"})


def rust_spelling(*, single: bool, states: Sequence[str] = ()) -> Spelling:
    """``states`` are the members of ``state``, where a function has one; it has ``dt`` then."""

    f = "f" if single else ""
    return Spelling(
        literal=lambda digits: digits,
        element=elements([identifier(name) for name in states], "state.{}", "{}[{}]"),
        member=lambda name: f"p.{identifier(name)}",
        functions={
            "sin": lambda x: f"libm::sin{f}({x})",
            "cos": lambda x: f"libm::cos{f}({x})",
            "tanh": lambda x: f"libm::tanh{f}({x})",
            "sqrt": lambda x: f"libm::sqrt{f}({x})",
            "exp": lambda x: f"libm::exp{f}({x})",
            "pow": lambda x, y: f"libm::pow{f}({x}, {y})",
            "atan2": lambda y, x: f"libm::atan2{f}({y}, {x})",
            "select": lambda c, a, b: f"select({c}, {a}, {b})",
            "abs": lambda x: f"abs({x})",
            "sign": lambda x: f"sign({x})",
        },
        single=single,
        continuation="",
        times=" * ",
    )


def identifier(name: str) -> str:
    """``name`` as a member of a struct.

    Raises
    ------
    InputError: it is one of the four words that Rust keeps for itself.
    """
    if name in _NEVER:
        raise InputError(f"{name} cannot be a name in Rust", remedy="give the run-time parameter another one")
    return f"r#{name}" if name in _KEYWORDS else name


def crate_name(robot: str) -> str:
    """What the crate is called: like the robot, unless that is a word or a crate of Rust's own."""
    return f"{robot}_dynamics" if robot in _CRATES else robot


def _plain_syntax(spelling: Spelling) -> Syntax:
    return Syntax(
        spelling,
        comment="// %s",
        declare=lambda name, text: f"let {name} = {text};",
        assign=lambda target, text: f"{target} = {text};",
        longest_call=_ARGUMENTS,
    )


def _syntax(signature: Signature, unit: Unit) -> Syntax:
    spelling = rust_spelling(single=signature.scalar == "float", states=signature.states)
    if unit.builtin:
        spelling = spelling.calling(atan2=lambda y, x: f"atan2({y}, {x})")
    syntax = _plain_syntax(spelling)
    return replace(syntax, sines=_sines(syntax.spelling))


def _sines(spelling: Spelling) -> Sines:
    """``sincos`` of an angle is the array of both."""

    def loop(angles: Sequence[Expression]) -> list[str]:
        size = len(angles)
        texts = [spelling.text(angle) for angle in angles]
        line = f"    let {ANGLES} = [{', '.join(texts)}];"
        lines = [line]
        if len(", ".join(texts)) > _ARGUMENTS:
            lines = ["    #[rustfmt::skip]", *spelling.wrapped(line.strip(), "    ")]
        return [
            *lines,
            f"    let mut {SINES} = [0.0; {size}];",
            f"    let mut {COSINES} = [0.0; {size}];",
            f"    for (i, angle) in {ANGLES}.iter().enumerate() {{",
            f"        [{SINES}[i], {COSINES}[i]] = sincos(*angle);",
            "    }",
        ]

    def pair(array: str, angle: Expression) -> list[str]:
        return [f"    let {array} = sincos({spelling.text(angle)});"]

    def run(it: Run) -> list[str]:
        ups, alongs, angles = it.arrays
        lines = []
        for array, values in ((ups, it.ups), (alongs, it.alongs)):
            texts = ", ".join(spelling.text(value) for value in values)
            long = len(texts) > _ARGUMENTS
            lines += ["    #[rustfmt::skip]"] if long else []
            lines += spelling.wrapped(f"let {array} = [{texts}];", "    ")
        return [
            *lines,
            f"    let mut {angles} = [0.0; {len(it.ups)}];",
            f"    for (i, angle) in {angles}.iter_mut().enumerate() {{",
            f"        *angle = atan2({ups}[i], {alongs}[i]);",
            "    }",
        ]

    return Sines(loop, pair, run)


def _repeating(it: Repeated) -> Lines:
    own = {name for name, _ in it.whole.inputs}

    def call(stage: Stage, indent: str, state: str) -> list[str]:
        """Arrays of the caller are references; of our own one is lent."""
        inputs = [name if name in own else f"&{state}" for name, _ in stage.signature.inputs]
        lent = {STATE: f"&mut {STATE}", NEXT: f"&mut {NEXT}"}
        arguments = [*inputs, *(lent.get(name, name) for name, _ in stage.signature.outputs)]
        line = f"{indent}{stage.signature.called}({', '.join(arguments)});"
        if len(line) <= WIDTH and len(", ".join(arguments)) <= _ARGUMENTS:
            return [line]
        return [
            f"{indent}{stage.signature.called}(",
            *(f"{indent}    {argument}," for argument in arguments),
            f"{indent});",
        ]

    last, inner = it.size - 1, "        "
    state = STATE if it.rows == 1 else ROW
    loop = [
        f"    for _ in 0..{it.most} {{",
        f"        if {state}[{last}] > 0.0 {{",
        "            break;",
        "        }",
        *call(it.step, inner, state),
        f"        {state} = {NEXT};",
        "    }",
    ]
    if it.rows > 1:
        loop = [
            f"    for each in {STATE}.chunks_exact_mut({it.size}) {{",
            f"        let mut {ROW} = [0.0; {it.size}];",
            f"        {ROW}.copy_from_slice(each);",
            *(f"    {line}" for line in loop),
            f"        each.copy_from_slice(&{ROW});",
            "    }",
        ]
    declared = [
        f"    let mut {STATE} = [0.0; {it.size * it.rows}];",
        f"    let mut {NEXT} = [0.0; {it.size}];",
    ]
    lines = [*declared, *call(it.start, "    ", STATE), *loop, *call(it.finish, "    ", STATE)]
    return Lines.of(lines, {})


def _listing(signature: Signature) -> dict[str, Any] | None:
    """The function that lists solutions, before the kernel that has all branches."""
    listing = listing_of(signature)
    if listing is None:
        return None
    arguments = ["T: &[Real; 12]"]
    arguments += [f"q_near: &[Real; {listing.joints}]"] if listing.near else []
    arguments += [f"Q: &mut [Real; {listing.size}]", f"flags: &mut [i32; {listing.branches}]"]
    arguments += ["p: &Params"] if signature.parameters else []
    return {
        "head": _head(f"pub fn {listing.name}(", arguments, ") -> i32 {"),
        "name": listing.name,
        "symbol": listing.symbol,
        "kernel": signature.called,
        "near": listing.near,
        "branches": listing.branches,
        "joints": listing.joints,
        "size": listing.size,
        "parameters": bool(signature.parameters),
        "flags": FLAGS,
        "branch": BRANCH,
    }


def _head(opening: str, arguments: list[str], closing: str) -> list[str]:
    """The head of a function, on one line if it fits."""
    line = f"{opening}{', '.join(arguments)}{closing}"
    return [line] if len(line) <= WIDTH else [opening, *(f"    {x}," for x in arguments), closing]


def _function(text: FunctionText) -> dict[str, Any]:
    signature, lines = text.signature, text.lines
    arguments = [f"{array}: &[Real; {size}]" for array, size in signature.inputs]
    arguments += [f"{array}: &mut [Real; {size}]" for array, size in signature.outputs]
    if signature.parameters:
        arguments.append("p: &Params")
    if signature.states:
        arguments += ["state: &mut State", "dt: Real"]
    opening = f"{'' if text.stage else 'pub '}fn {signature.called}("
    unread = [array for array in (SINES, COSINES) if array in lines.arrays and array not in lines.reads]
    return {
        "name": signature.called,
        "head": _head(opening, arguments, ") {"),
        "listing": _listing(signature),
        "lines": lines.angles + lines.statements,
        "results": lines.results,
        "unused": [*text.unused, *unread],
    }


def uses_libm(unit: Unit) -> bool:
    """Whether the crate needs ``libm``."""
    return bool(calls(unit) & (_OF_LIBM if unit.builtin else _OF_LIBM | BUILTIN))


def _context(unit: Unit) -> dict[str, Any]:
    interface = unit.functions[0][0]
    single = interface.scalar == "float"
    operations = calls(unit)
    syntax = _plain_syntax(rust_spelling(single=single))
    states = next((signature.states for signature, _ in unit.functions if signature.states), ())
    return {
        "trig": trig_context(syntax) if has_sines(unit) else None,
        "arctangent": arctangent_context(syntax) if has_arctangents(unit) else None,
        "crate": crate_name(unit.robot.name),
        "real": "f32" if single else "f64",
        "bits": 32 if single else 64,
        "helpers": sorted({"abs", "select", "sign"} & operations),
        "libm": uses_libm(unit),
        "parameters": [identifier(name) for name in interface.parameters],
        "states": [identifier(name) for name in states],
    }


def _advice(unit: Unit) -> tuple[str, ...]:
    advice: tuple[str, ...] = ()
    if unit.builtin:
        advice += (
            f"{builtin_words(unit)}. The same bits on every machine with IEEE arithmetic, and those of "
            "the C with -ffp-contract=off: Rust fuses no products and sums.",
        )
    if uses_libm(unit):
        advice += (
            "Functions of the crate libm are called; but for sqrt their last bit may differ from that of C's "
            "library.",
        )
    return advice


LANGUAGE = Language(
    name="rust",
    title="Rust",
    aliases=("rs",),
    suffixes=(".rs",),
    files={"Cargo.toml": "rust/Cargo.toml.j2", "src/lib.rs": "rust/lib.rs.j2"},
    tests={"tests/vectors.rs": "rust/vectors.rs.j2"},
    spelling=lambda single: rust_spelling(single=single),
    syntax=_syntax,
    function=_function,
    repeating=_repeating,
    context=_context,
    advice=_advice,
    type_name=lambda robot, kind: kind.capitalize(),
    trig="builtin",
    takers=(Tool(("cargo",), Use.LANGUAGES, "builds and tests of crates", "cargo", "https://rustup.rs"),),
)
