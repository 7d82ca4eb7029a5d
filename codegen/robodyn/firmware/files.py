"""The files of the folder: kernel, self-tests, image, CMake, Makefile; and the README with the figures."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.dynamics.functions.record import Q
from robodyn.emit.c_syntax import c_spelling
from robodyn.emit.head import head_of
from robodyn.emit.languages import LANGUAGES, languages_named
from robodyn.emit.markdown import Markdown, markdown_environment
from robodyn.emit.render import environment
from robodyn.emit.spelling import Spelling
from robodyn.errors import InputError
from robodyn.firmware.digest import (
    DIGEST_SEED,
    DIGEST_STATES,
    DTYPE,
    FNV_BASIS,
    FNV_PRIME,
    INCREMENT,
    MULTIPLIER,
    VECTORS,
    Range,
    draw,
    fnv1a,
    kernel_sine,
    outputs,
    ranges,
)  # fmt: skip
from robodyn.firmware.measure import FLAGS, REPEATED, STATES, Figures
from robodyn.firmware.options import check_firmware, image_context, image_files, ticks
from robodyn.firmware.vectors import SMALLEST, Vectors, rounded_up, states_of, vectors
from robodyn.ir.evaluate import angle_form
from robodyn.ir.program import Input, Program
from robodyn.ir.signature import Signature
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
    chosen = languages_named(languages)
    names = [language.name for language in chosen]
    unable = [language.title for language in chosen if "firmware" not in language.features]
    if "c" not in names or unable:
        beside = ", ".join(one.name for one in LANGUAGES.values() if one.selftest is not None)
        written = f"is not written in {' and '.join(unable)}" if unable else "is for C"
        raise InputError(
            f"a firmware folder {written}", found=", ".join(names), expected=f"c, alone or with {beside}"
        )
    robot, scalar = generated.unit.robot, generated.options.scalar
    arrays = dict.fromkeys(array for interface in generated.signatures for array, _ in interface.inputs)
    spans = ranges(robot, tuple(arrays), scalar)
    values = draw_parameters(robot, None, 0, np.dtype(DTYPE[scalar]))
    others = [(language, each) for language in chosen if (each := language.selftest) is not None]
    context = _context(generated, targets, spans, values)
    context["others"] = {language.name: each for language, each in others}
    files = generated.files(names)
    figures = {
        "confirmed": f" and confirmed by {context['confirmed']}" if context["confirmed"] else "",
        "states": DIGEST_STATES,
        "prefix": context["prefix"],
        "ticks": ticks(targets),
    }

    def write(file: str, template: str, note: str, **more: object) -> None:
        text = environment().get_template(f"firmware/{template}")
        files[file.replace("NAME", robot.name)] = text.render(context, head=head_of(robot, [note]), **more)

    for file, template in _C.items():
        write(file, template, _NOTES[file].format(**figures))
    for language, selftest in others:
        single = scalar == "float"
        spelling = language.spelling(single)
        own = {
            **selftest.types(single),
            "ranges": _spelled_ranges(spans, spelling),
            "scale": spelling.number(_SCALE),
            "parameters": [
                (name, spelling.number(Fraction(values[name]))) for name in generated.signatures[0].parameters
            ],
        }
        write(selftest.file, selftest.template, _OTHER.format(title=language.title), own=own)
    files |= image_files(robot, targets, context)
    return Folder(files, context)


def _context(
    generated: Generated, targets: Sequence[Target], spans: Sequence[Range], values: Mapping[str, float]
) -> dict[str, Any]:
    """What the templates are given; states lie within ``spans``, run-time parameters have ``values``."""
    robot, scalar = generated.unit.robot, generated.options.scalar
    c = c_spelling(single=scalar == "float")
    states = draw(spans, DIGEST_STATES, DIGEST_SEED, scalar)
    functions, confirmed = [], []
    for interface, program in generated.unit.functions:
        pruning = generated.prunings.get(interface.function)
        spare = pruning.proven if pruning is not None else ()
        tested = states_of(robot, interface, program, values)
        expected = vectors(robot, interface.function, program, tested, values, scalar, spare=spare)
        confirmed.append(expected.confirmed)
        inputs = {array: states[array] for array, _ in interface.inputs}
        digest = fnv1a(outputs(program, inputs, values, scalar, kernel_sine(scalar)))
        lines = _vector_lines(expected, tested, c, SMALLEST[scalar])
        functions.append({**_function(interface, program), "digest": digest, "vectors": lines})
    sizes: dict[str, int] = {}  # of the arrays that results go to: each as large as the largest of its name
    for function in functions:
        sizes[function["output"]] = max(function["size"], sizes.get(function["output"], 0))
    parameters = generated.signatures[0].parameters
    return {
        "name": robot.name,
        "prefix": robot.name.upper(),
        "guard": robot.name.upper(),
        "n": len(robot.commanded),
        "scalar": scalar,
        **image_context(targets),
        "flags": FLAGS,
        "measured_states": STATES,
        "repeated": REPEATED,
        "states": DIGEST_STATES,
        "title": robot.title or "a serial arm",
        "account": list(account_lines(robot)),
        "confirmed": " and ".join(dict.fromkeys(confirmed)) if all(confirmed) else "",
        "functions": functions,
        "vectors": VECTORS,
        "ranges": _spelled_ranges(spans, c),
        "parameters": [c.number(Fraction(values[name])) for name in parameters],
        "outputs": list(sizes.items()),
        "seed": DIGEST_SEED,
        "multiplier": MULTIPLIER,
        "increment": INCREMENT,
        "basis": FNV_BASIS,
        "prime": FNV_PRIME,
        "scale": c.number(_SCALE),
        "largest": c.number(Fraction(10**38 if scalar == "float" else 10**308)),
        "bits": "uint32_t" if scalar == "float" else "uint64_t",
        "width": 32 if scalar == "float" else 64,
    }


def _function(interface: Signature, program: Program) -> dict[str, Any]:
    """What the templates say of the calls of one function. The results of a function that has several go to
    one array, one after another, in C and in Fortran."""
    inputs = [array for array, _ in interface.inputs]
    several, drawn = len(interface.outputs) > 1, f"{interface.function}_found"
    output = "elements" if several else interface.outputs[0][0]
    places, slices, start = [], [], 0
    for _, size in interface.outputs:
        places.append(f"{output} + {start}" if start else output)
        slices.append(f"{drawn}({start + 1}:{start + size})" if several else drawn)
        start += size
    last = [f"&{interface.robot}_selftest_params"] if interface.parameters else []
    vector = f"{interface.function}_vectors[k]"
    in_fortran = [*(f"{a}_drawn" for a in inputs), *slices, *["values"] * bool(interface.parameters)]
    return {
        "name": interface.function,
        "symbol": interface.symbol,
        "inputs": interface.inputs,
        "output": output,
        "size": start,
        "angles": _angles(program),
        "vector_call": ", ".join([*(f"{vector}.{a}" for a in inputs), *places, *last]),
        "state_call": ", ".join([*(f"state.{a}" for a in inputs), *places, *last]),
        "drawn_call": " &\n        ".join(textwrap.wrap(", ".join(in_fortran), _WIDTH - 30)),
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
    vectors: Vectors, states: Mapping[str, NDArray[Any]], spelling: Spelling, smallest: float
) -> list[list[list[str]]]:
    """Each vector as lists of lines, array by array."""
    lines = []
    for k, expected in enumerate(vectors.expected):
        rows: list[Sequence[float | Fraction]] = [[float(v) for v in x[k]] for x in states.values()]
        rows.append([Fraction(0) if abs(x) < smallest else x for x in expected])
        rows.append([rounded_up(t, smallest) for t in vectors.tolerance[k]])
        *first, last = (_braced(row, spelling) for row in rows)
        lines.append([*([*row[:-1], row[-1] + ","] for row in first), last])
    return lines


def _braced(numbers: Sequence[float | Fraction], spelling: Spelling) -> list[str]:
    """An initialiser as lines."""
    text = "{ " + ", ".join(_numbers(numbers, spelling)) + " }"
    return textwrap.wrap(
        text, _WIDTH, initial_indent=" " * 8, subsequent_indent=" " * 10, break_long_words=False,
        break_on_hyphens=False,
    )  # fmt: skip


def _numbers(numbers: Sequence[float | Fraction], spelling: Spelling) -> list[str]:
    return [spelling.number(Fraction(x)) for x in numbers]


def _spelled_ranges(spans: Sequence[Range], spelling: Spelling) -> list[dict[str, Any]]:
    """Ranges of the inputs in a language's spelling."""
    return [
        {"array": s.array, "middle": _numbers(s.middle, spelling), "half": _numbers(s.half, spelling)}
        for s in spans
    ]
