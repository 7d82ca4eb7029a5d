"""The files of the folder: kernel, self-tests, image, CMake, Makefile; and the README with the figures."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.dynamics.functions.arguments import Q
from robodyn.emit.c_syntax import c_spelling
from robodyn.emit.language import Language
from robodyn.emit.languages import LANGUAGES, defaults, languages_named
from robodyn.emit.lines import head_of
from robodyn.emit.markdown import Markdown, markdown_environment
from robodyn.emit.render import environment
from robodyn.emit.spelling import Spelling
from robodyn.errors import InputError
from robodyn.firmware.digest import FNV_BASIS, FNV_PRIME, fnv1a, kernel_sine, outputs
from robodyn.firmware.measure import FLAGS, REPEATED, STATES, Figures
from robodyn.firmware.options import check_firmware, image_context, image_files, ticks
from robodyn.firmware.states import (
    DIGEST_SEED,
    DIGEST_STATES,
    DTYPE,
    INCREMENT,
    MULTIPLIER,
    VECTORS,
    Range,
    draw,
    ranges,
)
from robodyn.firmware.vectors import SMALLEST, Vectors, rounded_up, states_of, vectors
from robodyn.ir.evaluate import angle_form
from robodyn.ir.program import Input, Program
from robodyn.ir.signature import ScalarType, Signature
from robodyn.kernels.generate import Generated
from robodyn.robot.account import account_lines
from robodyn.targets import Target
from robodyn.verify.sample import draw_parameters

#: Templates by the file that each makes; ``NAME`` is the robot's.
_C = {
    "NAME_selftest.h": "selftest.h.j2",
    "NAME_selftest.c": "selftest.c.j2",
    "NAME_selftest_main.c": "selftest_main.c.j2",
    "NAME_semihosting.h": "semihosting.h.j2",
    "NAME_startup.c": "startup.c.j2",
    "NAME_image.c": "image.c.j2",
    "link.ld": "link.ld.j2",
    "CMakeLists.txt": "CMakeLists.txt.j2",
    "Makefile": "Makefile.j2",
}
_NOTES = {
    "NAME_selftest.h": "Self-test of the kernel: test vectors, and a digest of its bits.",
    "NAME_selftest.c": "Self-test of the kernel. Test vectors: results evaluated to 40 digits{confirmed}, "
    "and as the tolerance of each the bound that a running error analysis of the kernel's operations gives, "
    "constants and sines included: a compiler that rounds as written cannot exceed it. Digest: every bit of "
    "the results at {states} states; it differs where a compiler contracts or reorders.",
    "NAME_selftest_main.c": "The self-test on this computer.",
    "NAME_semihosting.h": "What an image needs of the processor: output and exit through a debugger, or "
    "qemu, and a counter at its clock.",
    "NAME_startup.c": "Start of a bare-metal image: stack, traps, floating-point unit, .data and .bss.",
    "NAME_image.c": "The self-test as an image, and what a call costs: ticks at the processor's clock, which "
    "are cycles (in qemu with {ticks}), and bytes of stack.",
    "link.ld": "Sections of the image; the file of each target says where memory is, and includes this.",
    "CMakeLists.txt": "The kernel as a library; alone, or with {prefix}_SELFTEST, its self-test.",
    "Makefile": "The self-test as an image and on this computer; GNU make.",
}
_OTHER = "Self-test of the {title} kernel: the same digest of the bits as of the C."
#: Of the digests' generator: from an integer to a position in a range.
_SCALE = Fraction(1, 2**23)
_WIDTH = 96


@dataclass(frozen=True, slots=True)
class Folder:
    """A firmware folder: its ``files`` but for the README, text by name, the same on every machine."""

    files: dict[str, str]
    _context: dict[str, Any]

    def readme(self, figures: Sequence[Figures]) -> str:
        """``README.md``, with what was measured on this machine, or what that needs."""
        name = Markdown(self._context["name"])  # an identifier
        template = markdown_environment().get_template("firmware/README.md.j2")
        return template.render(self._context, name=name, figures=figures)


def firmware(
    generated: Generated, targets: Sequence[Target], languages: Sequence[str] | None = None
) -> Folder:
    """The firmware folder of ``generated`` (with the options of :func:`robodyn.firmware.firmware_options`).

    Raises
    ------
    InputError: no self-test can be made of these functions (:func:`check_firmware`), there is no C, or a
        language that firmware is not written in.
    """
    check_firmware(generated)
    chosen = languages_named(defaults() if languages is None else languages)
    names = [language.name for language in chosen]
    unable = [language.title for language in chosen if "firmware" not in language.features]
    if "c" not in names or unable:
        beside = ", ".join(one.name for one in LANGUAGES.values() if one.selftest is not None)
        raise InputError(
            f"a firmware folder is not written in {' and '.join(unable)}"
            if unable
            else "a firmware folder is for C",
            found=", ".join(names),
            expected=f"c, alone or with {beside}",
        )
    others = [language for language in chosen if language.selftest is not None]
    context = _context(generated, targets, others)
    files = generated.files(names)
    name = generated.unit.robot.name
    figures = {
        "confirmed": f" and confirmed by {context['confirmed']}" if context["confirmed"] else "",
        "states": DIGEST_STATES,
        "prefix": context["prefix"],
        "ticks": ticks(targets),
    }

    def write(file: str, template: str, head: str, **own: object) -> None:
        heading = head_of(generated.unit.robot, [head])
        files[file.replace("NAME", name)] = (
            environment().get_template(f"firmware/{template}").render(context, head=heading, **own)
        )

    for file, template in _C.items():
        write(file, template, _NOTES[file].format(**figures))
    for language in others:
        if language.selftest is not None:
            own = _in_language(language, context["numbers"], single=generated.options.scalar == "float")
            head = _OTHER.format(title=language.title)
            write(language.selftest.file, language.selftest.template, head, own=own)
    files |= image_files(generated.unit.robot, targets, context)
    return Folder(files, context)


def _in_language(language: Language, numbers: _Numbers, *, single: bool) -> dict[str, Any]:
    """What the template of a self-test is told in the language's own spelling."""
    assert language.selftest is not None
    spelling = language.spelling(single)
    return {
        **language.selftest.types(single),
        "ranges": [
            {"array": s.array, "middle": _numbers(s.middle, spelling), "half": _numbers(s.half, spelling)}
            for s in numbers.ranges
        ],
        "scale": spelling.number(_SCALE),
        "parameters": [(name, spelling.number(value)) for name, value in numbers.parameters.items()],
    }


@dataclass(frozen=True, slots=True)
class _Numbers:
    """Numbers of a self-test that every language spells: ranges of the inputs, values of the parameters."""

    ranges: Sequence[Range]
    parameters: dict[str, Fraction]


def _base(generated: Generated, targets: Sequence[Target], others: Sequence[Language]) -> dict[str, Any]:
    robot, scalar = generated.unit.robot, generated.options.scalar
    return {
        "name": robot.name,
        "prefix": robot.name.upper(),
        "guard": robot.name.upper(),
        "n": robot.n,
        "scalar": scalar,
        **image_context(targets),
        "others": {language.name: language.selftest for language in others},
        "flags": FLAGS,
        "measured_states": STATES,
        "repeated": REPEATED,
        "states": DIGEST_STATES,
        "title": robot.title or "a serial arm",
        "account": list(account_lines(robot)),
    }


def _context(generated: Generated, targets: Sequence[Target], others: Sequence[Language]) -> dict[str, Any]:
    """What the templates are given."""
    robot, scalar = generated.unit.robot, generated.options.scalar
    single = scalar == "float"
    c = c_spelling(single=single)
    arrays = tuple(dict.fromkeys(a for interface in generated.signatures for a, _ in interface.inputs))
    spans = ranges(robot, arrays, scalar)
    at = draw(spans, DIGEST_STATES, DIGEST_SEED, scalar)
    values = draw_parameters(robot, None, 0, np.dtype(DTYPE[scalar]))
    functions, confirmed = [], []
    for interface, program in generated.unit.functions:
        pruning = generated.prunings.get(interface.function)
        spare = pruning.proven if pruning is not None else ()
        states = states_of(robot, interface, program, values)
        vectors_of = vectors(robot, interface.function, program, states, values, scalar, spare=spare)
        confirmed.append(vectors_of.confirmed)
        own = {array: at[array] for array, _ in interface.inputs}
        bits = outputs(program, own, values, scalar, kernel_sine(scalar))
        functions.append(_function(interface, program, vectors_of, states, fnv1a(bits), scalar))
    parameters = generated.signatures[0].parameters
    return _base(generated, targets, others) | {
        "confirmed": " and ".join(dict.fromkeys(confirmed)) if all(confirmed) else "",
        "functions": functions,
        "vectors": VECTORS,
        "ranges": [
            {"array": s.array, "middle": _numbers(s.middle, c), "half": _numbers(s.half, c)} for s in spans
        ],
        "parameters": [c.number(Fraction(values[name])) for name in parameters],
        "outputs": _memory(generated.signatures),
        "seed": DIGEST_SEED,
        "multiplier": MULTIPLIER,
        "increment": INCREMENT,
        "basis": FNV_BASIS,
        "prime": FNV_PRIME,
        "scale": c.number(_SCALE),
        "largest": c.number(Fraction(10**38 if single else 10**308)),
        "bits": "uint32_t" if single else "uint64_t",
        "width": 32 if single else 64,
        "numbers": _Numbers(spans, {name: Fraction(values[name]) for name in parameters}),
    }


#: Where the self-test has the results of a function that has several, one after another.
_ELEMENTS = "elements"


def _results(interface: Signature) -> tuple[str, int, list[str]]:
    """The array that a self-test keeps the results of a function in, its size, and the results in C."""
    if len(interface.outputs) == 1:
        ((array, size),) = interface.outputs
        return array, size, [array]
    places, start = [], 0
    for _, size in interface.outputs:
        places.append(f"{_ELEMENTS} + {start}" if start else _ELEMENTS)
        start += size
    return _ELEMENTS, start, places


def _memory(interfaces: Sequence[Signature]) -> list[tuple[str, int]]:
    """The arrays that the results of all functions go to, each as large as the largest of its name."""
    sizes: dict[str, int] = {}
    for array, size, _ in map(_results, interfaces):
        sizes[array] = max(size, sizes.get(array, 0))
    return list(sizes.items())


def _continued(arguments: Sequence[str]) -> str:
    """Arguments in Fortran, on several lines where they are long."""
    return " &\n        ".join(textwrap.wrap(", ".join(arguments), _WIDTH - 30))


def _slices(interface: Signature) -> list[str]:
    """The results in Fortran: parts of one array."""
    array, start, parts = f"{interface.function}_found", 1, []
    for _, size in interface.outputs:
        parts.append(f"{array}({start}:{start + size - 1})" if len(interface.outputs) > 1 else array)
        start += size
    return parts


def _function(
    interface: Signature,
    program: Program,
    vectors: Vectors,
    states: Mapping[str, NDArray[Any]],
    digest: int,
    scalar: ScalarType,
) -> dict[str, Any]:
    """What the templates say of one function."""
    inputs = [array for array, _ in interface.inputs]
    output, size, places = _results(interface)
    last = [f"&{interface.robot}_selftest_params"] if interface.parameters else []
    vector = f"{interface.function}_vectors[k]"
    return {
        "name": interface.function,
        "symbol": interface.symbol,
        "inputs": interface.inputs,
        "output": output,
        "size": size,
        "digest": digest,
        "angles": _angles(program),
        "vector_call": ", ".join([*(f"{vector}.{a}" for a in inputs), *places, *last]),
        "state_call": ", ".join([*(f"state.{a}" for a in inputs), *places, *last]),
        "drawn_call": _continued(
            [
                *(f"{a}_drawn" for a in inputs),
                *_slices(interface),
                *(["values"] if interface.parameters else []),
            ]
        ),
        "vectors": _vector_lines(vectors, states, scalar),
    }


def _angles(program: Program) -> list[int]:
    """The elements of q whose sine or cosine is taken."""
    read = {arg for op in program.operations for arg in op.args if isinstance(arg, Input)}
    if not any(name.array == Q.name for name in read):
        return []
    taken = [op.args[0] for op in program.operations if op.op in ("sin", "cos")]
    read = {name for arg in taken for name, _ in angle_form(program, arg)[0]}
    return sorted(name.index for name in read if name.index is not None)


def _vector_lines(
    vectors: Vectors, states: Mapping[str, NDArray[Any]], scalar: ScalarType
) -> list[list[list[str]]]:
    """Each vector as lists of lines, array by array."""
    spelling = c_spelling(single=scalar == "float")
    lines = []
    for k, expected in enumerate(vectors.expected):
        arrays = [[float(v) for v in x[k]] for x in states.values()]
        small = [Fraction(0) if abs(x) < SMALLEST[scalar] else x for x in expected]
        rows = [_braced([Fraction(v) for v in row], spelling) for row in arrays]
        rows += [
            _braced(small, spelling),
            _braced([rounded_up(t, scalar) for t in vectors.tolerance[k]], spelling),
        ]
        lines.append([[*row[:-1], row[-1] + ","] for row in rows[:-1]] + [rows[-1]])
    return lines


def _braced(numbers: Sequence[Fraction], spelling: Spelling) -> list[str]:
    """An initialiser as lines."""
    text = "{ " + ", ".join(_numbers(numbers, spelling)) + " }"
    return textwrap.wrap(
        text,
        _WIDTH,
        initial_indent=" " * 8,
        subsequent_indent=" " * 10,
        break_long_words=False,
        break_on_hyphens=False,
    )


def _numbers(numbers: Sequence[float | Fraction], spelling: Spelling) -> list[str]:
    return [spelling.number(Fraction(x)) for x in numbers]
