"""A Robot back to its description: what is written reads back to an equal Robot."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction
from typing import Literal

from robodyn.robot import numbers
from robodyn.robot.account import PARTS, Account, Origin, origins_to_state
from robodyn.robot.model import (
    AXES,
    Confidence,
    Coupling,
    EffectEntry,
    Inertia,
    Joint,
    Limits,
    Link,
    Placement,
    Robot,
    Setting,
)
from robodyn.robot.values import ZERO, Affine, Angle, Value, angle

# Smallest part of pi that is looked for behind an angle: pi/360 is half a degree.
_PARTS = 360


def to_yaml(robot: Robot) -> str:
    """The description of ``robot`` as YAML text, ending in a line break; the same text for equal robots.

    Keys that hold their default are left out, save the rigid-body ones. Every number is written exactly
    where that takes at most 200 characters (always, for numbers that were read from a description), else
    as the nearest double.
    """
    lines = [f"name: {robot.name}"]
    lines += [
        f"{key}: {_quoted(text)}" for key, text in (("title", robot.title), ("source", robot.source)) if text
    ]
    if robot.account is not None:
        lines += _imported_lines(robot.account)
    lines.append(f"gravity: {_list(robot.gravity)}")
    if robot.base is not None:
        lines.append(f"base: {_placement(robot.base)}")
    if robot.compare:
        lines.append(f"compare: {{table: {_quoted(robot.compare.table)}, row: {_quoted(robot.compare.row)}}}")
    common = _common_confidence(robot)
    if common is not None:
        lines.append(f"confidence: {_confidence(common)}")
    if robot.covariance is not None:
        lines.append(f"covariance: {robot.covariance.file}")
    origins = _common_origins(robot)
    if origins:
        lines.append(f"origin: {_words(origins)}")
    lines.append("links:")
    for i, link in enumerate(robot.links, 1):
        lines += _link_lines(link, i, common, origins)
        lines += _effect_lines(robot.effects_at(i), "    ")
    lines += ["couplings:"] * bool(robot.couplings) + [f"  - {_coupling(robot, x)}" for x in robot.couplings]
    if robot.tool is not None:
        lines.append(f"tool: {_placement(robot.tool)}")
    if robot.standard_end is not None:
        lines.append(f"standard_end: {_placement(robot.standard_end)}")
    if robot.torque_side != "motor":
        lines.append(f"torque_side: {robot.torque_side}")
    if robot.rest_velocity is not None:
        lines.append(f"friction_at_rest: {{smooth: {{velocity: {number_text(robot.rest_velocity)}}}}}")
    elif robot.dead_band is not None:
        lines.append(f"friction_at_rest: {{dead_band: {{velocity: {number_text(robot.dead_band)}}}}}")
    lines += _effect_lines(robot.effects_at(None), "")
    return "\n".join(lines) + "\n"


def _imported_lines(account: Account) -> list[str]:
    lines = ["imported:", f"  file: {_quoted(account.file)}", f"  format: {_quoted(account.format)}"]
    for part in PARTS:
        texts = getattr(account, part)
        lines += [f"  {part}:", *(f"    - {_quoted(text)}" for text in texts)] if texts else []
    return lines


def _common_confidence(robot: Robot) -> Confidence:
    """What all of several links state; None where they differ or one states nothing."""
    first, *others = (link.confidence for link in robot.links)
    return first if others and all(confidence == first for confidence in others) else None


def _common_origins(robot: Robot) -> dict[str, Origin]:
    """The origins by group that all of several links state alike."""
    first, *others = (origins_to_state(link) for link in robot.links)
    return {
        group: word
        for group, word in first.items()
        if others and all(origins.get(group) == word for origins in others)
    }


def _words(words: Mapping[str, str]) -> str:
    return "{" + ", ".join(f"{key}: {word}" for key, word in words.items()) + "}"


def _confidence(confidence: Fraction | Literal["unknown"]) -> str:
    return number_text(confidence) if isinstance(confidence, Fraction) else confidence


def _link_lines(link: Link, i: int, common: Confidence, origins: Mapping[str, Origin]) -> list[str]:
    joint, inertia = link.joint, link.inertia
    inertial = {
        "mass": number_text(link.mass),
        "com": _list(link.com),
        "inertia": group_text(dict(zip(AXES, inertia.entries, strict=True))),
    }
    lines = [] if link.name == f"link{i}" else [f"name: {_quoted(link.name)}"]
    lines += [
        f"joint: {joint.kind}",
        *(_row(joint) if link.origins.geometry != "absent" else []),
        *(f"{key}: {text}" for key, text in inertial.items() if getattr(link.origins, key) != "absent"),
    ]
    if link.origins.motor_inertia != "absent":
        lines.append(f"motor_inertia: {number_text(joint.motor_inertia)}")
    if joint.gear is not None:
        constant = joint.gear.torque_constant
        gear: dict[str, Value] = {"ratio": joint.gear.ratio}
        if constant is not None:
            gear["torque_constant"] = constant
        lines.append(f"gear: {group_text(gear)}")
    if joint.limits != Limits():
        lines.append(f"limits: {_limits(joint.limits)}")
    if link.confidence is not None and common is None:
        lines.append(f"confidence: {_confidence(link.confidence)}")
    words = {group: word for group, word in origins_to_state(link).items() if origins.get(group) != word}
    if words:
        lines.append(f"origin: {_words(words)}")
    if link.acknowledged:
        lines.append(f"acknowledged: {_quoted(link.acknowledged)}")
    if (joint.viscous, joint.coulomb) != (ZERO, ZERO):
        lines.append(f"friction: {_friction(joint)}")
    return [("  - " if k == 0 else "    ") + line for k, line in enumerate(lines)]


def _row(joint: Joint) -> list[str]:
    return [
        f"alpha: {_angle(joint.alpha)}",
        f"a: {number_text(joint.a)}",
        *([f"b: {number_text(joint.b)}"] if joint.b != ZERO else []),
        f"d: {number_text(joint.d)}",
        f"theta: {_angle(joint.theta)}",
    ]


def _effect_lines(entries: tuple[EffectEntry, ...], indent: str) -> list[str]:
    if not entries:
        return []
    return [f"{indent}effects:", *(f"{indent}  - {entry_text(entry)}" for entry in entries)]


def entry_text(entry: EffectEntry) -> str:
    """An entry as one line of YAML, without what is at its default."""
    from robodyn.effects.catalogue import CATALOGUE  # not at the top: a rigid arm does without
    from robodyn.robot.effects import default_of

    known = {parameter.name: parameter for parameter in CATALOGUE[entry.effect].parameters}
    stated = [(name, value) for name, value in entry.settings if value != default_of(known[name])]
    parts = [f"effect: {entry.effect}"]
    parts += [f"{name}: {setting_text(value, plain=known[name].kind != 'text')}" for name, value in stated]
    return "{" + ", ".join(parts) + "}"


def setting_text(value: Setting, *, plain: bool) -> str:
    """A parameter of an effect as YAML; ``plain``: a word of it needs no quotes."""
    if isinstance(value, (Fraction, Affine)):
        return number_text(value)
    if isinstance(value, Inertia):
        entries = zip(AXES, value.entries, strict=True)
        return group_text({axes: entry for axes, entry in entries if entry != ZERO})
    if isinstance(value, tuple):
        parts = [_list(part) if isinstance(part, tuple) else number_text(part) for part in value]
        return f"[{', '.join(parts)}]"
    return str(value) if plain or isinstance(value, int) else _quoted(value)


def _limits(limits: Limits) -> str:
    parts = [] if limits.position is None else [f"position: {_list(limits.position)}"]
    for name in ("velocity", "acceleration", "torque"):
        value = getattr(limits, name)
        if value is not None:
            parts.append(f"{name}: {number_text(value)}")
    return "{" + ", ".join(parts) + "}"


def _coupling(robot: Robot, coupling: Coupling) -> str:
    follower, leader = (robot.links[joint - 1] for joint in (coupling.joint, coupling.of))
    parts = [f"joint: {_quoted(follower.name)}, of: {_quoted(leader.name)}"]
    if coupling.ratio != 1:
        parts.append(f"ratio: {number_text(coupling.ratio)}")
    if coupling.offset:
        part = _part_of_pi(Fraction(float(coupling.offset) / math.pi).limit_denominator(_PARTS))
        same = numbers.rounded(numbers.parse(part).value) == coupling.offset
        parts.append(f"offset: {part if same else number_text(coupling.offset)}")
    return "{" + ", ".join(parts) + "}"


def _placement(frame: Placement) -> str:
    return f"{{xyz: {_list(frame.xyz)}, rpy: [{', '.join(map(_angle, frame.rpy))}]}}"


def _friction(joint: Joint) -> str:
    terms = {"viscous": joint.viscous, "coulomb": joint.coulomb}
    return group_text({name: value for name, value in terms.items() if value != ZERO})


def group_text(values: Mapping[str, Value]) -> str:
    """Numbers by name as YAML in flow style."""
    return "{" + ", ".join(f"{name}: {number_text(value)}" for name, value in values.items()) + "}"


def _list(values: tuple[Value, ...]) -> str:
    return "[" + ", ".join(number_text(value) for value in values) + "]"


def _quoted(text: str) -> str:
    """A double-quoted YAML scalar; what does not print is escaped."""
    escapes = {'"': '\\"', "\\": "\\\\"}
    return '"' + "".join(escapes.get(c, c if c.isprintable() else _escaped(c)) for c in text) + '"'


def _escaped(character: str) -> str:
    code = ord(character)
    return f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"


def number_text(value: Value) -> str:
    """A number as YAML: exact where that takes at most 200 characters, else the nearest double."""
    text = _affine(value) if isinstance(value, Affine) else _rational(value)
    if len(text) <= numbers.LENGTH:
        return text
    value = numbers.rounded(value)
    return _affine(value) if isinstance(value, Affine) else _rational(value)


def _affine(value: Affine) -> str:
    text = "" if value.constant == 0 else _rational(value.constant)
    for name, coefficient in value.terms:
        size = "" if abs(coefficient) == 1 else _rational(abs(coefficient)) + "*"
        sign = "-" if coefficient < 0 else "+" if text else ""
        text += (f" {sign} " if text else sign) + size + name
    return text


def _rational(value: Fraction) -> str:
    """``0.4318``, ``1e-12``, or ``1/3`` where no decimal ends."""
    twos = fives = 0
    rest = value.denominator
    while rest % 2 == 0:
        rest, twos = rest // 2, twos + 1
    while rest % 5 == 0:
        rest, fives = rest // 5, fives + 1
    if rest != 1:
        return f"{value.numerator}/{value.denominator}"
    places = max(twos, fives)
    digits = str(abs(value.numerator) * 10**places // value.denominator)
    kept = digits.rstrip("0") or "0"
    exponent = len(digits) - 1 - places if value else 0
    sign = "-" if value < 0 else ""
    if -5 <= exponent < 16:
        padded = digits.zfill(places + 1)
        whole, decimals = padded[: len(padded) - places], padded[len(padded) - places :].rstrip("0")
        return sign + whole + ("." + decimals if decimals else "")
    return sign + kept[0] + ("." + kept[1:] if kept[1:] else "") + f"e{exponent}"


def _angle(value: Angle) -> str:
    """A part of pi where one reads back as the same angle, else the double that makes the angle."""
    if value.quarter is not None:
        return _part_of_pi(Fraction(value.quarter, 2))
    text = _part_of_pi(Fraction(value.radians / math.pi).limit_denominator(_PARTS))
    read = numbers.parse(text).value
    return text if isinstance(read, Fraction) and angle(read) == value else repr(value.radians)


def _part_of_pi(part: Fraction) -> str:
    if part == 0:
        return "0"
    size = "pi" if abs(part.numerator) == 1 else f"{abs(part.numerator)}*pi"
    return ("-" if part < 0 else "") + size + ("" if part.denominator == 1 else f"/{part.denominator}")
