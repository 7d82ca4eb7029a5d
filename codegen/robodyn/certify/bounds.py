"""The proof of rounding errors: Gappa's bound of every torque beside ours and the worst error found."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from robodyn.certify.forward import Forward
from robodyn.certify.gappa import Proven, Scripts, prove
from robodyn.certify.observed import peaks, worst_errors
from robodyn.certify.plan import Finding, ProofOptions, Subject, Tell, not_run, ranges_of
from robodyn.certify.readback import check_read_back
from robodyn.certify.tools import version
from robodyn.dynamics.functions import FUNCTIONS
from robodyn.emit.trig import DOUBLE, FLOAT, accuracy_notes
from robodyn.errors import CheckError, InputError, ToolError
from robodyn.ir.program import Program
from robodyn.ir.signature import Signature
from robodyn.kernels.kernel import load
from robodyn.optimize.prune.box import box_of
from robodyn.tools.programs import GAPPA

#: Where the scripts go, within the folder of the proof.
FOLDER = "rounding"


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
    files = {f"{FOLDER}/{name}": text for parts in scripts.values() for name, (text, _) in parts.items()}
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8", newline="\n")
    names = list(files)
    tell(f"Gappa: 0 of {len(names)} torques")
    proven = dict(
        zip(
            names,
            prove(
                gappa,
                folder,
                names,
                seconds=proofs.seconds,
                workers=proofs.workers,
                progress=lambda done: tell(f"Gappa: {done} of {len(names)} torques"),
            ),
            strict=True,
        )
    )
    rows: list[dict[str, Any]] = []
    for signature, program in functions:
        own = scripts[signature.function]
        rows += _rows(
            subject, proofs, signature, program, {f"{FOLDER}/{k}": v for k, v in own.items()}, proven, tell
        )
    return _finding(subject, rows, files)


def _scripts(subject: Subject, signature: Signature, program: Program) -> dict[str, tuple[str, float]]:
    """Script and our own bound for each torque, by the script's name.

    Raises
    ------
    InputError: there is no bound.
    """
    known = claim(subject.generated.options.trig, subject.scalar)
    ranges = ranges_of(subject.box(signature))
    forward = Forward(program, ranges, subject.scalar, known.ulps, known.limit)
    scripts = Scripts(program, forward)
    written = {}
    for (_, elements), (_, operands) in zip(scripts.body.outputs, program.outputs, strict=True):
        for i, (element, operand) in enumerate(zip(elements, operands, strict=True), 1):
            title = (
                f"{signature.symbol} in {signature.scalar}: rounding error of tau[{i - 1}], "
                f"the torque of joint {i}.\n"
                f"Written by robodyn from the statements of {signature.robot}.c; run it with gappa.\n"
                f"{known.text}"
            )
            bound = forward.of(operand)
            written[f"{signature.function}_{i}.g"] = (scripts.of(element, title), bound.error)
    return written


def _rows(
    subject: Subject,
    proofs: ProofOptions,
    signature: Signature,
    program: Program,
    own: dict[str, tuple[str, float]],
    bounds: dict[str, Proven],
    tell: Tell,
) -> list[dict[str, Any]]:
    tell(f"searching for the worst error of {signature.function}")
    inputs = [name for name, _ in subject.plain_signature(signature).inputs]
    largest = peaks(subject.plain_program(signature), box_of(subject.robot, inputs))
    try:
        kernel = load(subject.generated.signatures, subject.files)
        worst = worst_errors(program, kernel, signature, subject.box(signature))
    except ToolError:  # no compiler
        worst = None
    rows = []
    for i, (name, (_, bound)) in enumerate(own.items()):
        proven = bounds[name]
        seen = worst[i] if worst is not None else None
        row: dict[str, Any] = {
            "function": signature.function,
            "joint": i + 1,
            "script": name,
            "range": None if proven.low is None else [proven.low, proven.high],
            "bound": proven.error,
            "peak": largest[i],
            "relative": proven.error / largest[i] if proven.error is not None and largest[i] else None,
            "own_bound": bound,
            "worst_found": seen,
            "seconds": round(proven.seconds, 1),
            "reason": proven.reason,
        }
        if proven.error is not None:
            if seen is not None and not seen <= proven.error:
                row["reason"] = (
                    f"an error of {seen:.3g} was found: this is a defect of robodyn, please report it"
                )
            elif proofs.tolerance is not None and Fraction(proven.error) > proofs.tolerance * Fraction(
                largest[i]
            ):
                row["reason"] = f"above the tolerance of {float(proofs.tolerance):.3g} of the largest torque"
        rows.append(row)
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
        return Claim(
            1.0,
            None,
            "Assumed, not proven: errors of libm's sine and cosine are at most 1 unit in the last place.",
        )
    numbers = FLOAT if scalar == "float" else DOUBLE
    return Claim(
        1.0,
        numbers.exact,
        "Stated of the kernel's sine and cosine: " + " ".join(accuracy_notes(single=scalar == "float")),
    )
