"""The lists of effects in a description, read by the definitions of the catalogue."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache

from robodyn.effects.catalogue import CATALOGUE, nearest
from robodyn.effects.effect import Effect, Parameter
from robodyn.robot import numbers
from robodyn.robot.document import Mapping, Node, Scalar, Sequence, describe
from robodyn.robot.fields import Section
from robodyn.robot.keys import EFFECTS, INERTIA, KNOTS, Key, expectation
from robodyn.robot.parts import AXES, EffectEntry, Inertia, JointKind, Setting
from robodyn.robot.values import ZERO

#: How far apart load fractions of an efficiency are: closer ones are a jump, and lose digits.
_APART = Fraction(1, 10**6)


class EntrySection(Section):
    """A section with what only entries have: efficiencies and numbers of joints."""

    def share(self, name: str) -> Fraction | tuple[tuple[Fraction, Fraction], ...]:
        """An efficiency: a number in (0, 1], or a table of loads that rise and of such numbers."""
        node, key, path = self.values[name], self.keys[name], self.path(name)
        if not isinstance(node, Sequence):
            return self._constant(node, key, path)
        few, many = KNOTS
        if not few <= len(node.items) <= many:
            what = f"{path} must have {few} to {many} knots"
            self.source.fail(node, what, found=describe(node), expected=expectation(key))
        knots: list[tuple[Fraction, Fraction]] = []
        for i, knot in enumerate(node.items, 1):
            of = f"{path}: knot {i}"
            if not isinstance(knot, Sequence) or len(knot.items) != 2:
                pair = "[load fraction, efficiency]"
                self.source.fail(knot, f"{of} must be a pair", found=describe(knot), expected=pair)
            load = self._constant(knot.items[0], replace(key, sign="nonnegative"), f"{of}: load fraction")
            if knots and load < knots[-1][0] + _APART:
                sorted_ = load > knots[-1][0]
                self.source.fail(
                    knot.items[0],
                    f"{path}: two knots are too close"
                    if sorted_
                    else f"{path} is an unsorted table: load fractions must rise",
                    found=f"{numbers.brief(load)} after {numbers.brief(knots[-1][0])}",
                    expected=f"load fractions at least {float(_APART)!r} apart" if sorted_ else None,
                    remedy="leave one of them out" if sorted_ else "sort the knots by load",
                )
            knots.append((load, self._constant(knot.items[1], key, f"{of}: efficiency")))
        return tuple(knots)

    def joint(self, name: str, joints: int) -> int:
        """The number of a joint or a link, 1 to ``joints``."""
        node = self.scalar(name)
        assert node is not None
        text = node.text
        if not (text.isascii() and text.isdecimal() and len(text) < 9 and 1 <= int(text) <= joints):
            expected = f"a whole number from 1 to {joints}"
            what = f"{self.path(name)} is no joint of this robot"
            self.source.fail(node, what, found=describe(node), expected=expected)
        return int(text)


@dataclass(frozen=True, slots=True)
class Written:
    """An entry and where it stands."""

    entry: EffectEntry
    section: EntrySection

    @property
    def effect(self) -> str:
        """The id of its effect."""
        return self.entry.effect


def belongs(effect: Effect, *, of_robot: bool) -> bool:
    """Whether ``effect`` may stand in the robot's list, or in that of a link."""
    if of_robot:
        return effect.level == "robot" or effect.traits.of_all
    return effect.level != "robot"


@cache
def keys_of(id: str, kind: JointKind | None = None) -> tuple[Key, ...]:
    """The keys of an entry, with units for a joint of that kind (None: for either)."""
    effect = CATALOGUE[id]
    named = Key("effect", "choice", f"{effect.title}.", required=True, choices=(id,))
    return (named, *(_key(parameter, kind) for parameter in effect.parameters))


def _key(parameter: Parameter, kind: JointKind | None) -> Key:
    unit = parameter.unit_at(revolute=kind != "prismatic")
    if kind is None and parameter.linear_unit is not None:
        unit = f"{unit}, prismatic {parameter.linear_unit}"
    default = parameter.default
    assumed = "" if default is None else default if isinstance(default, str) else numbers.brief(default)
    return Key(
        parameter.name,
        "group" if parameter.kind == "inertia" else parameter.kind,
        parameter.doc,
        "" if unit == "1" else unit,
        required=parameter.required,
        names=parameter.names,
        sign=parameter.sign,
        default=f"[{', '.join([assumed] * 3)}]" if assumed and parameter.kind == "vector" else assumed,
        choices=parameter.choices,
        members=INERTIA if parameter.kind == "inertia" else (),
    )


def read_effects(section: Section, joint: int | None, kind: JointKind, joints: int) -> tuple[Written, ...]:
    """The list ``effects`` of ``section``: of a ``joint`` of that kind, or (None) of a robot with ``joints``.

    Raises
    ------
    InputError: an entry is not what the catalogue says, or two of them do not go together.
    """
    entries = []
    for i, node in enumerate(section.items("effects") or (), 1):
        section.source.effects += 1
        if section.source.effects > EFFECTS:
            section.source.fail(node, "too many effects", expected=f"at most {EFFECTS} in all lists together")
        entries.append(_entry(section, i, node, joint, kind, joints))
    _refuse_pairs(entries)
    return tuple(entries)


def _entry(section: Section, i: int, node: Node, joint: int | None, kind: JointKind, joints: int) -> Written:
    effect = _effect(section, section.path(f"effect {i}"), node, joint)
    part = EntrySection(section.source, section.path(effect.id), node, keys_of(effect.id, kind))
    settings: dict[str, Setting] = {}
    for parameter in effect.parameters:
        value = _setting(part, parameter, joints)
        if value is not None:
            settings[parameter.name] = value
    fault = effect.check(settings, kind == "revolute")
    if fault:
        place = part.values.get(fault.parameter)
        part.source.fail(
            place or node,
            f"{part.path(fault.parameter)} {fault.what}",
            found=describe(place) if place else None,
            expected=fault.expected,
            remedy=fault.remedy,
        )
    if joint is not None and settings.get("with") == joint:
        what, expected = f"{part.path('with')} names the joint itself", "the number of another joint"
        part.source.fail(part.values["with"], what, found=str(joint), expected=expected)
    return Written(EffectEntry(effect.id, joint, tuple(settings.items())), part)


def _effect(section: Section, label: str, node: Node, joint: int | None) -> Effect:
    of_robot = joint is None
    fit = [id for id, effect in CATALOGUE.items() if belongs(effect, of_robot=of_robot)]
    if not isinstance(node, Mapping):
        Section(section.source, label, node, (Key("effect", "choice", ""),))  # refuses it
    assert isinstance(node, Mapping)
    named = next((value for key, value in node.entries if key.text == "effect"), None)
    expected = f"one of {', '.join(fit)}"
    if named is None:
        section.source.fail(node, f"{label}: the key 'effect' is missing", expected=f"effect: {expected}")
    if not isinstance(named, Scalar) or named.text not in CATALOGUE:
        remedy = nearest(named.text) if isinstance(named, Scalar) else None
        what = f"{label} is unknown"
        section.source.fail(named, what, found=describe(named), expected=expected, remedy=remedy)
    effect = CATALOGUE[named.text]
    if effect.id not in fit:
        place = "'effects' of the link whose joint it is at"
        place = place if of_robot else "the list 'effects' beside 'links'"
        what = f"{label}: {effect.id} is an effect of {'a joint' if of_robot else 'the whole robot'}"
        section.source.fail(named, what, remedy=f"move it to {place}")
    return effect


def _setting(part: EntrySection, parameter: Parameter, joints: int) -> Setting | None:
    name = parameter.name
    if name not in part.values:
        return default_of(parameter)
    if parameter.kind == "joint":
        return part.joint(name, joints)
    if parameter.kind == "inertia":
        tensor = part.section(name)
        assert tensor is not None
        return Inertia(*(tensor.number(axes) for axes in AXES))
    readers: dict[str, Callable[[str], Setting | None]] = {
        "number": part.number, "vector": part.vector, "efficiency": part.share, "choice": part.choice,
        "text": part.full_text,
    }  # fmt: skip
    return readers[parameter.kind](name)


def default_of(parameter: Parameter) -> Setting | None:
    """What ``parameter`` is where it is left out; None: not there."""
    vector = parameter.kind == "vector" and parameter.default is not None
    return (ZERO, ZERO, ZERO) if vector else parameter.default


def _refuse_pairs(entries: Iterable[Written]) -> None:
    first: dict[tuple[str, object], Written] = {}
    for written in entries:
        id, other = written.effect, dict(written.entry.settings).get("with")
        source, place = written.section.source, written.section.node
        if first.setdefault((id, other), written) is not written and not CATALOGUE[id].traits.several:
            what = f"{written.section.label} stands here a second time"
            before = f"the first in line {first[id, other].section.node.line}"
            source.fail(place, what, found=before, remedy="delete one of the two")
        for whole, _ in first:
            part = next((one for one in CATALOGUE[whole].traits.absorbs if (one, None) in first), None)
            if part is not None:
                what = f"{written.section.label}: {part} and {whole} are at one joint"
                remedy = f"delete {part} and give {whole} its numbers"
                source.fail(place, what, expected="one of the two", remedy=remedy)
