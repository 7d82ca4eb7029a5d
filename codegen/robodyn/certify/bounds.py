"""The proof of rounding errors: Gappa's bound of every torque beside ours, and beside the worst error that a
search finds with the compiled kernel and its program in longer numbers."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

from robodyn.certify.forward import Forward
from robodyn.certify.gappa import Proven, Scripts, prove
from robodyn.certify.plan import Finding, ProofOptions, Subject, Tell, not_run, version
from robodyn.certify.readback import check_read_back
from robodyn.dynamics.functions import FUNCTIONS
from robodyn.emit.trig import DOUBLE, FLOAT
from robodyn.errors import CheckError, InputError, ToolError
from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input, Program
from robodyn.ir.signature import Signature
from robodyn.kernels.kernel import load
from robodyn.optimize.prune.box import Box, box_of, largest
from robodyn.tools.programs import GAPPA

if TYPE_CHECKING:
    from robodyn.kernels.kernel import Kernel

#: Where the scripts go, within the folder of the proof.
FOLDER = "rounding"
#: States drawn first in a search for the worst error.
STATES = 20_000


@dataclass(frozen=True, slots=True)
class _Script:
    """What Gappa is asked of one torque; ``bound``: our own."""

    text: str
    bound: float


def prove_bounds(subject: Subject, proofs: ProofOptions, folder: Path, tell: Tell) -> Finding:
    """Bounds of the rounding errors of all torques."""
    gappa = GAPPA.path()
    if gappa is None:
        return not_run("gappa", GAPPA)
    functions = subject.bounded()
    if not functions:
        torques = ", ".join(name for name, function in FUNCTIONS.items() if function.gives_torques)
        return _failed(f"no function of this kernel gives torques: ask for some of {torques}")
    try:
        scripts = {s.function: _scripts(subject, s, p) for s, p in functions}
        source = subject.files[f"{subject.generated.unit.robot.name}.c"]
        for signature, program in functions:
            check_read_back(source, signature, program)
    except (InputError, CheckError) as error:
        return _failed(str(error))
    (folder / FOLDER).mkdir()
    files = {name: script.text for parts in scripts.values() for name, script in parts.items()}
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8", newline="\n")
    names = list(files)

    def progress(done: int) -> None:
        tell(f"Gappa: {done} of {len(names)} torques")

    progress(0)
    bounds = prove(gappa, folder, names, seconds=proofs.seconds, workers=proofs.workers, progress=progress)
    proven = dict(zip(names, bounds, strict=True))
    rows: list[dict[str, Any]] = []
    for signature, program in functions:
        tell(f"searching for the worst error of {signature.function}")
        rows += _rows(subject, proofs, signature, program, scripts[signature.function], proven)
    return _finding(subject, rows, files)


def _scripts(subject: Subject, signature: Signature, program: Program) -> dict[str, _Script]:
    """A script for each torque, by its path.

    Raises
    ------
    InputError: there is no bound.
    """
    known = claim(subject.generated.options.trig, subject.scalar)
    box = subject.box(signature)
    ranges = {x: box.interval(x) for x in box.inputs}
    forward = Forward(program, ranges, subject.scalar, known.ulps, known.limit)
    scripts = Scripts(program, forward)
    written: dict[str, _Script] = {}
    for (_, elements), (_, operands) in zip(scripts.body.outputs, program.outputs, strict=True):
        for i, (element, operand) in enumerate(zip(elements, operands, strict=True), 1):
            title = (
                f"{signature.symbol} in {signature.scalar}: rounding error of tau[{i - 1}], "
                f"the torque of joint {i}.\n"
                f"Written by robodyn from the statements of {signature.robot}.c; run it with gappa.\n"
                f"{known.text}"
            )
            script = _Script(scripts.of(element, title), forward.of(operand).error)
            written[f"{FOLDER}/{signature.function}_{i}.g"] = script
    return written


def _rows(
    subject: Subject,
    proofs: ProofOptions,
    signature: Signature,
    program: Program,
    scripts: dict[str, _Script],
    bounds: dict[str, Proven],
) -> list[dict[str, Any]]:
    inputs = [name for name, _ in subject.plain_signature(signature).inputs]
    sizes = peaks(subject.plain_program(signature), box_of(subject.robot, inputs))
    try:
        kernel = load(subject.generated.signatures, subject.files)
        worst = worst_errors(program, kernel, signature, subject.box(signature))
    except ToolError:  # no compiler
        worst = None
    rows, within = [], proofs.tolerance
    for i, (name, script) in enumerate(scripts.items()):
        proven, peak = bounds[name], sizes[i]
        error, reason, seen = proven.error, proven.reason, None if worst is None else worst[i]
        if error is not None and seen is not None and not seen <= error:
            reason = f"an error of {seen:.3g} was found: this is a defect of robodyn, please report it"
        elif error is not None and within is not None and Fraction(error) > within * Fraction(peak):
            reason = f"above the tolerance of {float(within):.3g} of the largest torque"
        rows.append(
            {
                "function": signature.function,
                "joint": i + 1,
                "script": name,
                "range": None if proven.low is None else [proven.low, proven.high],
                "bound": error,
                "peak": peak,
                "relative": error / peak if error is not None and peak else None,
                "own_bound": script.bound,
                "worst_found": seen,
                "seconds": round(proven.seconds, 1),
                "reason": reason,
            }
        )
    return rows


def _finding(subject: Subject, rows: list[dict[str, Any]], files: dict[str, str]) -> Finding:
    lines = [f"{'torque':24} {'bound':>9} {'of peak':>9} {'our bound':>9} {'worst found':>11} {'peak':>9}"]
    for row in rows:
        name = f"{row['function']} {row['joint']}"
        cells = [row[key] for key in ("bound", "relative", "own_bound", "worst_found", "peak")]
        shown = [("-" if x is None else f"{x:.2e}") for x in cells]
        text = f"{name:24} {shown[0]:>9} {shown[1]:>9} {shown[2]:>9} {shown[3]:>11} {shown[4]:>9}"
        lines.append(text + (f"  {row['reason']}" if row["reason"] else ""))
    known = claim(subject.generated.options.trig, subject.scalar)
    return Finding(
        "gappa",
        "failed" if any(row["reason"] for row in rows) else "proved",
        f"Within the ranges, every torque computed in {subject.scalar} (IEEE 754, to nearest even, every "
        "operation rounded, no contraction) is at most the bound [N m, prismatic N] away from the torque of "
        "the model in real numbers, and nothing overflows.",
        tuple(lines),
        {"bounds": rows, "sine_and_cosine": known.text},
        (version(GAPPA),),
        tuple(f"gappa {name}" for name in files),
        files,
    )


def _failed(reason: str) -> Finding:
    return Finding(
        "gappa", "failed", "Bounds of rounding errors.", (reason,), {"bounds": [], "reason": reason}
    )


@dataclass(frozen=True, slots=True)
class Claim:
    """Errors of sine and cosine below ``ulps`` units in the last place (of a value below 1) while angles are
    below ``limit`` [rad]; ``text`` says so, and who says it."""

    ulps: float
    limit: float | None
    text: str


def claim(trig: str, scalar: str) -> Claim:
    """What is known of the sine and cosine of kind ``trig``."""
    if trig == "given":
        return Claim(0.0, None, "The sines and cosines in sc count as exact: their error is the caller's.")
    if trig == "libm":
        text = "Assumed, not proven: errors of libm's sine and cosine are at most 1 unit in the last place."
        return Claim(1.0, None, text)
    numbers = FLOAT if scalar == "float" else DOUBLE
    notes = " ".join(numbers.sines_told)
    return Claim(1.0, numbers.exact, f"Stated of the kernel's sine and cosine: {notes}")


# --- a search for the worst error ---------------------------------------------------------------------------


def worst_errors(
    program: Program, kernel: Kernel, signature: Signature, box: Box, states: int = STATES, seed: int = 1
) -> list[float] | None:
    """The worst error of the compiled ``kernel`` against ``program``, output by output, that random states of
    ``box``, half of them corners, and ascent from the worst of them find: lower bounds of the true ones.

    None where numpy's longdouble has fewer than 64 digits, which is too few to judge a double.
    """
    import numpy as np

    if signature.scalar == "double" and np.finfo(np.longdouble).nmant < 63:
        return None

    def errors(drawn: Any) -> Any:
        inputs = _arrays(drawn, box, kernel.dtype.type)
        arguments = [
            np.stack([inputs[Input(name, i)] for i in range(size)], axis=1) for name, size in signature.inputs
        ]
        outputs = getattr(kernel, signature.function)(*arguments).astype(np.longdouble).T
        return np.abs(outputs - _exact(program, inputs)).astype(float)

    return [float(x) for x in largest(errors, box, seed, first=states)]


def peaks(program: Program, box: Box, seed: int = 1) -> list[float]:
    """The largest output of ``program`` in ``box``, each, that a search finds: at most the true one."""
    import numpy as np

    def sizes(drawn: Any) -> Any:
        return _exact(program, _arrays(drawn, box, np.float64)).astype(float)

    return [float(x) * (1 - 1e-9) for x in largest(sizes, box, seed)]


def _arrays(drawn: Any, box: Box, real: Any) -> dict[Input, Any]:
    """States ``drawn`` of ``box``, rounded to the type, nothing outside the intervals."""
    import numpy as np

    def edge(limit: Fraction, side: int) -> Any:
        near = real(float(limit))
        outside = (Fraction(float(near)) - limit) * side < 0
        return np.nextafter(near, real(side * np.inf)) if outside else near

    arrays = {}
    for x, row in zip(box.inputs, drawn, strict=True):
        low, high = box.interval(x)
        arrays[x] = np.clip(row.astype(real), edge(low, 1), edge(high, -1))
    return arrays


def _exact(program: Program, inputs: dict[Input, Any]) -> Any:
    """The program's outputs ``[m, N]`` in longdouble."""
    import numpy as np

    def wide(value: Fraction) -> Any:
        high = float(value)
        return np.longdouble(high) + np.longdouble(float(value - Fraction(high)))

    functions = {"sin": np.sin, "cos": np.cos, "sign": np.sign, "abs": np.abs}
    arrays = {x: row.astype(np.longdouble) for x, row in inputs.items()}
    count = len(next(iter(arrays.values())))
    values = evaluate(program, arrays, constant=wide, functions=functions)
    rows = [row for elements in values.values() for row in elements]
    return np.stack([np.broadcast_to(np.asarray(row, dtype=np.longdouble), (count,)) for row in rows])
