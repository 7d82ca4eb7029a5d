"""What a proof may rely on: how exact the sines and cosines are that a kernel reads."""

from __future__ import annotations

from dataclasses import dataclass

from robodyn.emit.trig import DOUBLE, FLOAT, accuracy_notes


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
