"""Numbers and entries of a description as text: new ones, and those that are changed where they stand."""

from __future__ import annotations

from fractions import Fraction

from robodyn.effects.catalogue import CATALOGUE
from robodyn.robot import numbers
from robodyn.robot.effects import default_of
from robodyn.robot.model import EffectEntry
from robodyn.robot.values import Value
from robodyn.robot.writer import _number as number_text
from robodyn.robot.writer import _setting as setting_text

__all__ = ["changed_text", "entry_text", "number_text", "setting_text", "value_of"]


def entry_text(entry: EffectEntry) -> str:
    """An entry as one line of YAML, without what is at its default."""
    known = {p.name: p for p in CATALOGUE[entry.effect].parameters}
    parts = [f"effect: {entry.effect}"]
    parts += [
        f"{name}: {setting_text(value, plain=known[name].kind != 'text')}"
        for name, value in entry.settings
        if value != default_of(known[name])
    ]
    return "{" + ", ".join(parts) + "}"


def value_of(text: str) -> Value:
    """A number of the description, as the reader takes it."""
    read = numbers.parse(text, names=True)
    return numbers.rounded(read.value) if read.has_pi else read.value


def changed_text(text: str, added: Value) -> str:
    """The number ``text`` with ``added``: a new one, or behind a run-time name the sum."""
    old = value_of(text)
    new = old + added
    if isinstance(old, Fraction) or not isinstance(added, Fraction):
        return number_text(new)
    longer = f"{text} {'-' if added < 0 else '+'} {number_text(abs(added))}"
    return longer if len(longer) <= numbers.LENGTH and value_of(longer) == new else number_text(new)
