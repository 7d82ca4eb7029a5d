"""MISRA C:2012 in emitted C: which rules are not kept, and why. The rules' words are not ours to print."""

from __future__ import annotations

from robodyn.emit.listing import listing_of
from robodyn.emit.unit import Unit

_MACROS = "macros of the header say sizes and bits of flags to callers; the kernel itself does not need all"
_LISTED = "a function that another one of the file calls is for callers as well"
_BITS = (
    "a union reads the bits of a floating number, to choose and to sign sine and cosine without a branch; "
    "its members have one size, C99 defines what is read (6.5.2.3), and the number is IEEE 754"
)


def deviations(unit: Unit) -> dict[str, str]:
    """Rules that a kernel written for MISRA C:2012 does not keep, and why."""
    signatures = [signature for signature, _ in unit.functions]
    listed = any(listing_of(signature) is not None for signature in signatures)
    rules = {}
    if listed or any(signature.columns for signature in signatures):
        rules["2.5"] = _MACROS
    if listed:
        rules["8.7"] = _LISTED
    if unit.builtin:
        rules["19.2"] = _BITS
    return rules


def notes(unit: Unit) -> tuple[str, ...]:
    """What the head of such a kernel says."""
    lines = deviations(unit)
    if not lines:
        return ("MISRA C:2012: cppcheck finds no rule that is not kept (robodyn prove).",)
    return (
        f"MISRA C:2012: every rule that cppcheck checks is kept but {', '.join(lines)} (robodyn prove):",
        *(f"{rule}: {why}" for rule, why in lines.items()),
    )
