"""The comment at the top of emitted files: what someone who has nothing but the file must know."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from robodyn.dynamics.functions import array_named, function_named
from robodyn.emit.language import Language
from robodyn.emit.spelling import WIDTH
from robodyn.emit.unit import Unit, counted
from robodyn.robot.account import account_lines
from robodyn.robot.identity import identity
from robodyn.robot.model import EffectEntry, Inertia, Joint, Placement, Robot
from robodyn.robot.values import Affine, Angle, Value
from robodyn.version import VERSION

#: Numbers of a joint that stand in the description itself: what they are, with units at revolute and at
#: prismatic joints.
_PLAIN = (
    ("motor_inertia", "rotor inertia", "kg m^2", "kg"),
    ("viscous", "viscous friction", "N m s/rad", "N s/m"),
    ("coulomb", "Coulomb friction", "N m", "N"),
)


def head_lines(unit: Unit, language: Language) -> list[str]:
    """The lines: what this is and of which description, the joints, units and order of the arguments,
    run-time parameters, effects, options, and counts by kind."""
    lines: list[str] = []

    def say(text: str, indent: str = "", *, hyphens: bool = True) -> None:
        wrapped = textwrap.wrap(
            comment(text), WIDTH - 4, subsequent_indent=indent + "  ", break_on_hyphens=hyphens
        )
        lines.extend(wrapped or [""])

    robot = unit.robot
    say(f"{robot.name}: {robot.title or 'a serial arm'}")
    if robot.source:
        say(f"Numbers: {robot.source}")
    for line in account_lines(robot):
        say(line, "  ")
    say(f"Written by robodyn {VERSION}; do not edit, generate again.")
    say(f"Description: {identity(robot)} (a hash of its numbers)")
    if unit.options:
        say(f"Options: {unit.options}", hyphens=False)
    lines.append("")
    say("Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:")
    for line in _table(robot):
        say(line, "      ")
    say(f"Gravity in the base frame: {', '.join(repr(float(g)) for g in robot.base_gravity)} m/s^2")
    for where, frame in (
        ("Base frame in the world", robot.base),
        ("Tool frame in the last link", robot.tool),
    ):
        if frame is not None:
            say(f"{where}: {_placed(frame)}")
    say("Arguments, in SI units, joint 1 first:")
    arrays = dict.fromkeys(a for s, _ in unit.functions for a, _ in (*s.inputs, *s.outputs))
    width = max(4, *map(len, arrays))
    for array in arrays:
        say(f"  {array:{width}} {array_named(array).text}", "      ")
    for line in _sides(robot):
        say(line, "  " if line.startswith("  ") else "")
    _say_parameters(unit, language, say)
    if state_members(unit):
        struct = language.type_name(robot.name, "state")
        say(
            f"inverse_dynamics has states: {struct} begins at zero and a call with dt = 0; then "
            "call it at every sample, dt > 0 [s] after the one before."
        )
    if unit.sc:
        say("sc, the sines and cosines that the functions read:")
        spelling = language.spelling(unit.functions[0][0].scalar == "float")
        for k, text in enumerate(unit.sc):
            say(f"  {spelling.element('sc', k)} = {text}")
    for note in (*unit.notes, *language.notes(unit)):
        say(note)
    for note in language.advice(unit):
        say(note, hyphens=False)
    lines.append("")
    say("Operations (every binary * is a multiplication, every binary + or - an addition):")
    for signature, program in unit.functions:
        say(f"  {signature.function}: {counted(program)}", "    ")
    for line in _zeros(unit):
        say(line, "    ")
    return lines


def _zeros(unit: Unit) -> list[str]:
    """Which elements of results are always 0, of functions on request: solvers of sparse systems ask."""
    lines = []
    for signature, program in unit.functions:
        if not function_named(signature.function).by_default:
            for array, places in program.zeros().items():
                lines.append(f"  {signature.function}: {array} is 0 at {', '.join(map(str, places))}")
    return ["Always 0, elements counted from 0:", *lines] if lines else []


def state_members(unit: Unit) -> tuple[str, ...]:
    """Members of the state struct of ``unit``, if a function has one."""
    return next((signature.states for signature, _ in unit.functions if signature.states), ())


def comment(text: str) -> str:
    """``text`` from a file, made harmless inside a comment of any language: ASCII, one line, no
    comment marks, no trigraphs, no line splice."""
    text = "".join(ch if " " <= ch <= "~" else ("?" if ch > " " else " ") for ch in text)
    text = text.replace("\\", "|")
    for mark in ("*/", "/*", "//", "??"):
        while mark in text:
            text = text.replace(mark, f"{mark[0]} {mark[1]}")
    return text


def contained(robot: Robot, *, accelerated: bool, remembers: bool) -> tuple[str, ...]:
    """What the drives add to torques of a moving arm, for the comment of a function; with ``accelerated``
    what needs an acceleration too. What has a state is in its steady form unless the function ``remembers``:
    elastic joints are stiff."""
    if robot.torque_side == "link":
        return ()
    plain = [
        name
        for field, name, *_ in _PLAIN
        if (accelerated or field != "motor_inertia")
        and any(getattr(link.joint, field) for link in robot.links)
    ]
    steady = "" if remembers else " (steady: as if nothing had changed for long)"
    forms = {"algebraic": "", "state": steady}
    entries = (entry.definition for entry in robot.effects)
    titles = [lowered(effect.title) + forms[effect.kind] for effect in entries if effect.kind in forms]
    return tuple(dict.fromkeys([*plain, *titles]))


# --- joints ------------------------------------------------------------------------------------------


def _table(robot: Robot) -> Iterator[str]:
    """A line for each joint: its number, name and kind, its row of DH numbers, its limits."""
    rows = [
        (
            f"{i}",
            link.name if link.name != f"link{i}" else "",
            link.joint.kind,
            *(f"{name} {text}" if text else "" for name, text in _row(link.joint)),
        )
        for i, link in enumerate(robot.links, 1)
    ]
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    for row, link in zip(rows, robot.links, strict=True):
        cells = [cell.ljust(width) for cell, width in zip(row, widths, strict=True) if width]
        yield "  " + "  ".join(cells).rstrip()
        limits = _limits(link.joint)
        if limits:
            yield f"      limits: {limits}"
        if link.joint.gear is not None:
            yield f"      gear: {_gear(link.joint)}"


def _row(joint: Joint) -> tuple[tuple[str, str], ...]:
    turned, slid = _angle(joint.theta), _value(joint.d)
    if joint.kind == "revolute":
        turned = "q" if turned == "0" else f"q + {turned}"
    else:
        slid = "q" if slid == "0" else f"q + {slid}"
    aside = (("b", _value(joint.b) if joint.b else ""),)
    return (("alpha", _angle(joint.alpha)), ("a", _value(joint.a)), *aside, ("d", slid), ("theta", turned))


def _placed(frame: Placement) -> str:
    origin, turn = ", ".join(map(_value, frame.xyz)), ", ".join(map(_angle, frame.rpy))
    return f"[{origin}] m, roll, pitch, yaw {turn} rad"


def _limits(joint: Joint) -> str:
    unit, force = ("rad", "N m") if joint.kind == "revolute" else ("m", "N")
    limits, parts = joint.limits, []
    if limits.position is not None:
        low, high = limits.position
        parts.append(f"{_value(low)} to {_value(high)} {unit}")
    for value, dimension in (
        (limits.velocity, f"{unit}/s"), (limits.acceleration, f"{unit}/s^2"), (limits.torque, force),
    ):  # fmt: skip
        if value is not None:
            parts.append(f"{_value(value)} {dimension}")
    return ", ".join(parts)


def _gear(joint: Joint) -> str:
    gear = joint.gear
    assert gear is not None
    text = f"ratio {_value(gear.ratio)}" + ("" if joint.kind == "revolute" else " rad/m")
    constant, joined = gear.torque_constant, gear.torque_per_ampere
    if constant is None or joined is None:
        return text
    unit = "N m/A" if joint.kind == "revolute" else "N/A"
    return f"{text}, torque constant {_value(constant)} N m/A, so {_value(joined)} {unit} at the joint"


def _angle(angle: Angle) -> str:
    if angle.quarter is None:
        return f"{angle.radians!r}"
    whole, half = divmod(abs(angle.quarter), 2)
    sign = "-" if angle.quarter < 0 else ""
    if not half:
        return "0" if not whole else f"{sign}{whole if whole > 1 else ''}pi"
    return f"{sign}{abs(angle.quarter) if whole else ''}pi/2"


def _value(value: Value) -> str:
    if isinstance(value, Affine):
        terms = [name if k == 1 else f"{_value(k)} {name}" for name, k in value.terms]
        return " + ".join([*([_value(value.constant)] if value.constant else []), *terms])
    return str(value.numerator) if value.denominator == 1 else f"{float(value)!r}"


# --- drives and parameters ---------------------------------------------------------------------------


def _sides(robot: Robot) -> Iterator[str]:
    """Whose torques these are, and what effects the numbers of the drives stand for."""
    if robot.torque_side == "link":
        yield "Torques act behind the gear: rotor inertia and friction are not in them."
    plain = list(_plain(robot))
    if robot.torque_side == "link":
        plain = []
    if robot.torque_side == "motor" and (plain or robot.effects):
        yield "Torques are the motors', reflected to the joints; what lies between is in them."
    entries = [_entry(robot, entry) for entry in robot.effects]
    if plain or entries:
        yield "Effects in this model:"
        yield from (f"  {line}" for line in (*plain, *entries))
    if robot.rest_velocity is not None:
        yield f"Near rest friction's sign is tanh(qd / {_value(robot.rest_velocity)})."
    if robot.dead_band is not None:
        yield f"Friction's sign is 0 below {_value(robot.dead_band)} rad/s or m/s."


def _plain(robot: Robot) -> Iterator[str]:
    for field, name, revolute, prismatic in _PLAIN:
        values = [
            f"joint {i} {_value(getattr(link.joint, field))} "
            + (revolute if link.joint.kind == "revolute" else prismatic)
            for i, link in enumerate(robot.links, 1)
            if getattr(link.joint, field)
        ]
        if values:
            yield f"{name}: {', '.join(values)}"


def _entry(robot: Robot, entry: EffectEntry) -> str:
    effect = entry.definition
    revolute = entry.joint is None or robot.links[entry.joint - 1].joint.kind == "revolute"
    units = {p.name: p.unit_at(revolute=revolute) for p in effect.parameters}
    settings = ", ".join(
        f"{name} {_setting(value)} {'' if units.get(name) == '1' else units.get(name, '')}".rstrip()
        for name, value in entry.settings
    )
    where = "" if entry.joint is None else f" at joint {entry.joint}"
    outside = {"sensor": "; of the sensors, in no kernel", "outside": "; in no kernel"}.get(effect.kind, "")
    return f"{lowered(effect.title)}{where}: {settings}{outside}"


def lowered(title: str) -> str:
    """``title`` within a sentence: names and acronyms stay as they are."""
    first = title.split(" ", 1)[0]
    return (
        title if first[:1].isupper() and first in ("Coulomb", "Stribeck") else title[:1].lower() + title[1:]
    )


def _setting(value: Any) -> str:
    if isinstance(value, (Fraction, Affine)):
        return _value(value)
    if isinstance(value, Inertia):
        return _setting((value.xx, value.yy, value.zz, value.xy, value.xz, value.yz))
    if isinstance(value, tuple):
        return f"[{', '.join(map(_setting, value))}]"
    return str(value)


def _say_parameters(unit: Unit, language: Language, say: Any) -> None:
    names = unit.functions[0][0].parameters
    if not names:
        return
    say(f"Run-time parameters, in {language.type_name(unit.robot.name, 'params')}:")
    uses = parameter_uses(unit.robot)
    for name in names:
        places = (f"{what} [{unit}]" if unit else what for what, unit in uses.get(name, ()))
        say(f"  {name}: {', '.join(places)}", "      ")


def parameter_uses(robot: Robot) -> dict[str, tuple[tuple[str, str], ...]]:
    """By run-time parameter: the numbers that it stands in, and their units."""
    uses: dict[str, dict[tuple[str, str], None]] = {}

    def note(value: Any, what: str, unit: str) -> None:
        if isinstance(value, Affine):
            for name, _ in value.terms:
                uses.setdefault(name, {})[what, unit] = None
        elif isinstance(value, Inertia):
            for axes in ("xx", "yy", "zz", "xy", "xz", "yz"):
                note(getattr(value, axes), f"{what} {axes}", unit)
        elif isinstance(value, tuple):
            for axis, element in zip("xyz", value, strict=False):
                note(element, f"{what} {axis}", unit)

    for i, link in enumerate(robot.links, 1):
        joint = link.joint
        note(joint.a, f"a of joint {i}", "m")
        note(joint.b, f"b of joint {i}", "m")
        note(joint.d, f"d of joint {i}", "m")
        note(link.mass, f"mass of link {i}", "kg")
        note(link.com, f"centre of mass of link {i}", "m")
        note(link.inertia, f"inertia of link {i}", "kg m^2")
        for field, name, *units in _PLAIN:
            note(getattr(joint, field), f"{name} of joint {i}", units[joint.kind != "revolute"])
    for entry in robot.effects:
        revolute = entry.joint is None or robot.links[entry.joint - 1].joint.kind == "revolute"
        where = "" if entry.joint is None else f" at joint {entry.joint}"
        units_of = {p.name: p.unit_at(revolute=revolute) for p in entry.definition.parameters}
        for name, value in entry.settings:
            note(value, f"{name} of {lowered(entry.definition.title)}{where}", units_of.get(name, ""))
    return {name: tuple(names) for name, names in uses.items()}
