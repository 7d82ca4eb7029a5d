"""MISRA C:2012 in emitted C: which rules are not kept, and why. The rules' words are not ours to print."""

from __future__ import annotations

#: Rule -> why it is not kept, by the kind of sine and cosine.
DEVIATIONS: dict[str, dict[str, str]] = {
    "libm": {},
    "given": {},
    "builtin": {
        "19.2": "a union reads the bits of a floating number, to choose and to sign sine and cosine without "
        "a branch; its members have one size, C99 defines what is read (6.5.2.3), and the number is IEEE 754"
    },
}


def deviations(trig: str) -> dict[str, str]:
    """Rules that a kernel written for MISRA C:2012 does not keep, and why."""
    return DEVIATIONS.get(trig, {})


def notes(trig: str) -> tuple[str, ...]:
    """What the head of such a kernel says."""
    lines = deviations(trig)
    if not lines:
        return ("MISRA C:2012: cppcheck finds no rule that is not kept (robodyn prove).",)
    return (
        f"MISRA C:2012: every rule that cppcheck checks is kept but {', '.join(lines)} (robodyn prove):",
        *(f"{rule}: {why}" for rule, why in lines.items()),
    )
