"""The equation of an effect that adds a torque, out of what its definition prints."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from robodyn.effects.catalogue import CATALOGUE


def definitions(id: str) -> list[tuple[str, str]]:
    """Symbols that the equation of a gas spring defines beside the torque, and their right sides."""
    if id != "gas_spring":
        return []
    parts = [part.partition(" = ") for part in CATALOGUE[id].latex.split(r", \quad ")[1:]]
    return [(symbol, text) for symbol, _, text in parts]


def typeset(id: str, p: Mapping[str, Any]) -> str:
    """The right side of the equation for what the effect adds, out of its LaTeX."""
    latex = CATALOGUE[id].latex
    if id == "load_dependent_friction":
        kind = "radial" if p["bearing"] == "journal" and "span" not in p else p["bearing"]
        found = re.search(rf"\\text\{{{kind}: \}}\s*&?\s*\\tau =(.*?)(\\\\|, \\quad|\\end)", latex)
    elif id == "gas_spring":
        found = re.search(r"\\tau =(.*?), \\quad", latex)
    elif id == "motor_coupling":
        found = re.search(r"T =(.*?), \\quad", latex)
    elif id == "transmission_loss":
        found = re.search(r"\\tau_\{in\} =(.*?\\end\{cases\})", latex)
    else:
        found = re.fullmatch(r"\\tau =(.*)", latex)
    assert found, latex
    return found[1]
