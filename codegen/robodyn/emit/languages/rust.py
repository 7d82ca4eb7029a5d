"""Rust, edition 2021: a ``no_std`` crate without ``unsafe``.

Rust fuses no products and sums, so a kernel with its own sine and cosine gives the bits of the C. What the
core library lacks (``exp``, ``tanh``, ``pow``, ``sqrt``, and sine and cosine unless they are built in) is the
crate ``libm``'s; apart from ``sqrt`` its last bit may differ from that of C's library.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from robodyn.emit.body import Lines
from robodyn.emit.language import FunctionText, Language
from robodyn.emit.loops import ANGLES, COSINES, SINES, Run
from robodyn.emit.spelling import WIDTH, Sines, Spelling, Syntax, call, elements, functions_of
from robodyn.emit.stages import NEXT, ROW, Repeated, Stage
from robodyn.emit.statements import Expression
from robodyn.emit.unit import BUILTIN, OF_LIBM, Listing, Unit, builtin_words, calls, listing_of
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


def _spelling(*, single: bool, states: Sequence[str] = ()) -> Spelling:
    return Spelling(
        literal=lambda digits: digits,
        element=elements([identifier(name) for name in states], "state.{}", "{}[{}]"),
        member=lambda name: f"p.{identifier(name)}",
        functions={
            **functions_of(f"libm::{{}}{'f' if single else ''}"),
            **{name: call(name) for name in ("abs", "select", "sign")},
        },
        single=single,
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


def _syntax(signature: Signature, unit: Unit) -> Syntax:
    spelling = _spelling(single=signature.scalar == "float", states=signature.states)
    if unit.builtin:
        spelling = spelling.calling(atan2=call("atan2"))
    return Syntax(
        spelling,
        comment="// %s",
        declare=lambda name, text: f"let {name} = {text};",
        assign=lambda target, text: f"{target} = {text};",
        longest_call=_ARGUMENTS,
        sines=_sines(spelling),
    )


def _sines(spelling: Spelling) -> Sines:
    """``sincos`` of an angle is the array of both."""

    def filled(array: str, values: Sequence[Expression]) -> list[str]:
        text = spelling.row(values)
        skip = ["    #[rustfmt::skip]"] if len(text) > _ARGUMENTS else []
        return [*skip, *spelling.wrapped(f"let {array} = [{text}];", "    ")]

    def every(angles: Sequence[Expression]) -> list[str]:
        return [
            *filled(ANGLES, angles),
            *(f"    let mut {array} = [0.0; {len(angles)}];" for array in (SINES, COSINES)),
            f"    for (i, angle) in {ANGLES}.iter().enumerate() {{",
            f"        [{SINES}[i], {COSINES}[i]] = sincos(*angle);",
            "    }",
        ]

    def run(it: Run) -> list[str]:
        ups, alongs, angles = it.arrays
        return [
            *filled(ups, it.ups),
            *filled(alongs, it.alongs),
            f"    let mut {angles} = [0.0; {len(it.ups)}];",
            f"    for (i, angle) in {angles}.iter_mut().enumerate() {{",
            f"        *angle = atan2({ups}[i], {alongs}[i]);",
            "    }",
        ]

    return Sines(every, lambda array, x: [f"    let {array} = sincos({spelling.text(x)});"], run)


def _repeating(it: Repeated, _: Syntax) -> Lines:
    given = {name for name, _ in it.whole.inputs}

    def called(stage: Stage, indent: str, state: str) -> list[str]:
        """Arrays of the caller are references; of our own one is lent."""
        inputs = [name if name in given else f"&{state}" for name, _ in stage.signature.inputs]
        lent = {STATE: f"&mut {STATE}", NEXT: f"&mut {NEXT}"}
        arguments = [*inputs, *(lent.get(name, name) for name, _ in stage.signature.outputs)]
        return _broken(f"{stage.signature.called}(", arguments, ");", indent, _ARGUMENTS)

    state = STATE if it.rows == 1 else ROW
    loop = [
        f"    for _ in 0..{it.most} {{",
        f"        if {state}[{it.size - 1}] > 0.0 {{",
        "            break;",
        "        }",
        *called(it.step, "        ", state),
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
    declared = [f"    let mut {array} = [0.0; {size}];" for array, size in it.arrays.items()]
    return Lines([*declared, *called(it.start, "    ", STATE), *loop, *called(it.finish, "    ", STATE)], {})


def _broken(
    opening: str, arguments: Sequence[str], closing: str, indent: str = "", longest: int = WIDTH
) -> list[str]:
    """A call or the head of a function, on one line if it fits."""
    text = ", ".join(arguments)
    line = f"{indent}{opening}{text}{closing}"
    if len(line) <= WIDTH and len(text) <= longest:
        return [line]
    return [indent + opening, *(f"{indent}    {argument}," for argument in arguments), indent + closing]


def _function(text: FunctionText) -> dict[str, Any]:
    signature, lines = text.signature, text.lines
    arguments = [f"{array}: &[Real; {size}]" for array, size in signature.inputs]
    arguments += [f"{array}: &mut [Real; {size}]" for array, size in signature.outputs]
    arguments += ["p: &Params"] if signature.parameters else []
    arguments += ["state: &mut State", "dt: Real"] if signature.states else []
    read = {x.array for x in lines.inputs if x.index is not None}
    unread = [array for array in (SINES, COSINES) if array in lines.arrays and array not in read]
    listing = listing_of(signature)
    return {
        "name": signature.called,
        "head": _broken(f"{'' if text.stage else 'pub '}fn {signature.called}(", arguments, ") {"),
        "listing": listing,
        "listing_head": listing and _listing_head(listing),
        "lines": [*lines.angles, *lines.statements],
        "unused": [*text.unused, *unread],
    }


def _listing_head(listing: Listing) -> list[str]:
    arguments = ["T: &[Real; 12]"]
    arguments += [f"q_near: &[Real; {listing.joints}]"] if listing.near else []
    arguments += [f"Q: &mut [Real; {listing.size}]", f"flags: &mut [i32; {listing.branches}]"]
    arguments += ["p: &Params"] if listing.kernel.parameters else []
    return _broken(f"pub fn {listing.name}(", arguments, ") -> i32 {")


def uses_libm(unit: Unit) -> bool:
    """Whether the crate needs ``libm``."""
    return not calls(unit).isdisjoint((OF_LIBM - {"abs"}) | (frozenset() if unit.builtin else BUILTIN))


def _context(unit: Unit) -> dict[str, Any]:
    return {
        "crate": crate_name(unit.robot.name),
        "real": "f32" if unit.single else "f64",
        "helpers": sorted({"abs", "select", "sign"} & calls(unit)),
        "libm": uses_libm(unit),
        "parameters": [identifier(name) for name in unit.functions[0][0].parameters],
        "states": [identifier(name) for name in unit.states],
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
    spelling=lambda single: _spelling(single=single),
    syntax=_syntax,
    function=_function,
    repeating=_repeating,
    context=_context,
    advice=_advice,
    type_name=lambda robot, kind: kind.capitalize(),
    trig="builtin",
    takers=(Tool(("cargo",), Use.LANGUAGES, "builds and tests of crates", "cargo", "https://rustup.rs"),),
)
