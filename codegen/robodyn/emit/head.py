"""The comment at the top of emitted files: what someone who has nothing but the file must know."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import Any

from robodyn.dynamics.functions import array_named, function_named
from robodyn.emit.language import Language
from robodyn.emit.spelling import WIDTH
from robodyn.emit.unit import Unit, counted
from robodyn.ir.signature import Signature
from robodyn.robot.account import account_lines
from robodyn.robot.coupling import coupling_lines
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


def _wrapped(texts: Iterable[str], indent: str = "", *, hyphens: bool = True) -> Iterator[str]:
    for text in texts:
        yield from textwrap.wrap(
            comment(text), WIDTH - 4, subsequent_indent=f"{indent}  ", break_on_hyphens=hyphens
        ) or [""]


def head_of(robot: Robot, notes: Sequence[str]) -> list[str]:
    """The comment at the top of a file that is no kernel: whose dynamics, the ``notes``, and what is known of
    the robot's numbers."""
    texts = (f"{robot.name}: {robot.title or 'a serial arm'}", *notes, *account_lines(robot))
    return [*_wrapped(texts), "Written by robodyn; do not edit, generate again."]


def head_lines(unit: Unit, language: Language) -> list[str]:
    """The lines: what this is and of which description, the joints, units and order of the arguments,
    run-time parameters, effects, options, and counts by kind."""
    lines: list[str] = []

    def say(*texts: str, indent: str = "", hyphens: bool = True) -> None:
        lines.extend(_wrapped(texts, indent, hyphens=hyphens))

    robot = unit.robot
    say(f"{robot.name}: {robot.title or 'a serial arm'}")
    if robot.source:
        say(f"Numbers: {robot.source}")
    say(*account_lines(robot), indent="  ")
    say(f"Written by robodyn {VERSION}; do not edit, generate again.")
    say(f"Description: {identity(robot)} (a hash of its numbers)")
    if unit.options:
        say(f"Options: {unit.options}", hyphens=False)
    say("", "Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:")
    say(*_table(robot), indent="      ")
    say(f"Gravity in the base frame: {', '.join(repr(float(g)) for g in robot.base_gravity)} m/s^2")
    frames = (("Base frame in the world", robot.base), ("Tool frame in the last link", robot.tool))
    say(*(f"{where}: {_placed(frame)}" for where, frame in frames if frame is not None))
    say(*coupling_lines(robot), indent="  ")
    say(f"Arguments, in SI units, {'base to tip' if robot.couplings else 'joint 1 first'}:")
    width = max(4, *map(len, unit.arrays))
    say(*(f"  {array:{width}} {array_named(array).text}" for array in unit.arrays), indent="      ")
    for line in _sides(robot):
        say(line, indent="  " if line.startswith("  ") else "")
    if names := unit.functions[0][0].parameters:
        say(f"Run-time parameters, in {language.type_name(robot.name, 'params')}:")
        uses = parameter_uses(robot)
        for name in names:
            places = (f"{what} [{unit}]" if unit else what for what, unit in uses.get(name, ()))
            say(f"  {name}: {', '.join(places)}", indent="      ")
    if unit.states:
        say(
            f"inverse_dynamics has states: {language.type_name(robot.name, 'state')} begins at zero and a "
            "call with dt = 0; then call it at every sample, dt > 0 [s] after the one before."
        )
    if unit.sc:
        element = language.spelling(unit.single).element
        say("sc, the sines and cosines that the functions read:")
        say(*(f"  {element('sc', k)} = {text}" for k, text in enumerate(unit.sc)))
    say(*unit.notes)
    say(*language.advice(unit), hyphens=False)
    say("", "Operations (every binary * is a multiplication, every binary + or - an addition):")
    say(
        *(f"  {signature.function}: {counted(program)}" for signature, program in unit.functions),
        indent="    ",
    )
    zeros = [  # solvers of sparse systems ask for them
        f"  {signature.function}: {array} is 0 at {', '.join(map(str, places))}"
        for signature, program in unit.functions
        if not function_named(signature.function).by_default
        for array, places in program.zeros().items()
    ]
    if zeros:
        say("Always 0, elements counted from 0:", *zeros, indent="    ")
    return lines


def comment(text: str) -> str:
    """``text`` from a file, made harmless inside a comment of any language: ASCII, one line, no
    comment marks, no trigraphs, no line splice."""
    text = "".join(ch if " " <= ch <= "~" else ("?" if ch > " " else " ") for ch in text)
    text = text.replace("\\", "|")
    for mark in ("*/", "/*", "//", "??"):
        while mark in text:
            text = text.replace(mark, f"{mark[0]} {mark[1]}")
    return text


def contained(robot: Robot, signature: Signature) -> str:
    """What the drives add to the torques of a function with velocities, for its comment, with accelerations
    what needs these too; empty if nothing. What has a state is in its steady form unless the function
    remembers: elastic joints are stiff."""
    function = function_named(signature.function)
    taken = {array.name for array in function.inputs}
    if robot.torque_side == "link" or "qd" not in taken:
        return ""
    accelerated = "qdd" in taken or function.solves
    names = [
        name
        for field, name, *_ in _PLAIN
        if (accelerated or field != "motor_inertia")
        and any(getattr(link.joint, field) for link in robot.links)
    ]
    steady = "" if signature.states else " (steady: as if nothing had changed for long)"
    forms = {"algebraic": "", "state": steady}
    for entry in robot.effects:
        if entry.definition.kind in forms:
            names.append(_lowered(entry.definition.title) + forms[entry.definition.kind])
    return f"with {', '.join(dict.fromkeys(names))}" if names else ""


# --- joints ------------------------------------------------------------------------------------------


def _table(robot: Robot) -> Iterator[str]:
    """A line for each joint: its number, name and kind, its row of DH numbers, its limits."""
    rows = []
    for i, link in enumerate(robot.links, 1):
        joint = link.joint
        turned, slid = _angle(joint.theta), _value(joint.d)
        if joint.kind == "revolute":
            turned = "q" if turned == "0" else f"q + {turned}"
        else:
            slid = "q" if slid == "0" else f"q + {slid}"
        aside = f"b {_value(joint.b)}" if joint.b else ""
        name = link.name if link.name != f"link{i}" else ""
        numbers = (
            f"alpha {_angle(joint.alpha)}",
            f"a {_value(joint.a)}",
            aside,
            f"d {slid}",
            f"theta {turned}",
        )
        rows.append((f"{i}", name, joint.kind, *numbers))
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for row, link in zip(rows, robot.links, strict=True):
        cells = [cell.ljust(width) for cell, width in zip(row, widths, strict=True) if width]
        yield "  " + "  ".join(cells).rstrip()
        if limits := _limits(link.joint):
            yield f"      limits: {limits}"
        if link.joint.gear is not None:
            yield f"      gear: {_gear(link.joint)}"


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
    lines = []
    for field, name, *units in _PLAIN if robot.torque_side != "link" else ():
        values = [
            f"joint {i} {_value(getattr(link.joint, field))} {units[link.joint.kind != 'revolute']}"
            for i, link in enumerate(robot.links, 1)
            if getattr(link.joint, field)
        ]
        lines += [f"  {name}: {', '.join(values)}"] if values else []
    lines += [f"  {_entry(robot, entry)}" for entry in robot.effects]
    if robot.torque_side == "link":
        yield "Torques act behind the gear: rotor inertia and friction are not in them."
    if robot.torque_side == "motor" and lines:
        yield "Torques are the motors', reflected to the joints; what lies between is in them."
    yield from ["Effects in this model:", *lines] if lines else []
    if robot.rest_velocity is not None:
        yield f"Near rest friction's sign is tanh(qd / {_value(robot.rest_velocity)})."
    if robot.dead_band is not None:
        yield f"Friction's sign is 0 below {_value(robot.dead_band)} rad/s or m/s."


def _entry(robot: Robot, entry: EffectEntry) -> str:
    effect, (where, units) = entry.definition, _place(robot, entry)
    settings = ", ".join(
        f"{name} {_setting(value)} {'' if units.get(name) == '1' else units.get(name, '')}".rstrip()
        for name, value in entry.settings
    )
    outside = {"sensor": "; of the sensors, in no kernel", "outside": "; in no kernel"}.get(effect.kind, "")
    return f"{_lowered(effect.title)}{where}: {settings}{outside}"


def _place(robot: Robot, entry: EffectEntry) -> tuple[str, dict[str, str]]:
    """Where an effect is, and the units of its parameters there."""
    revolute = entry.joint is None or robot.links[entry.joint - 1].joint.kind == "revolute"
    where = "" if entry.joint is None else f" at joint {entry.joint}"
    return where, {p.name: p.unit_at(revolute=revolute) for p in entry.definition.parameters}


def _lowered(title: str) -> str:
    """``title`` within a sentence: names stay as they are."""
    return title if title.startswith(("Coulomb ", "Stribeck ")) else title[:1].lower() + title[1:]


def _setting(value: Any) -> str:
    if isinstance(value, (Fraction, Affine)):
        return _value(value)
    if isinstance(value, Inertia):
        value = (value.xx, value.yy, value.zz, value.xy, value.xz, value.yz)
    return f"[{', '.join(map(_setting, value))}]" if isinstance(value, tuple) else str(value)


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
        for name in ("a", "b", "d"):
            note(getattr(link.joint, name), f"{name} of joint {i}", "m")
        note(link.mass, f"mass of link {i}", "kg")
        note(link.com, f"centre of mass of link {i}", "m")
        note(link.inertia, f"inertia of link {i}", "kg m^2")
        for field, name, *units in _PLAIN:
            note(getattr(link.joint, field), f"{name} of joint {i}", units[link.joint.kind != "revolute"])
    for entry in robot.effects:
        where, units_of = _place(robot, entry)
        for name, value in entry.settings:
            note(value, f"{name} of {_lowered(entry.definition.title)}{where}", units_of.get(name, ""))
    return {name: tuple(names) for name, names in uses.items()}
