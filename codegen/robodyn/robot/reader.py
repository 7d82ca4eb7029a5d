"""A robot description to a Robot; every complaint with file, line and column."""

from __future__ import annotations

import re
import warnings
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from robodyn.errors import InputError
from robodyn.robot import numbers
from robodyn.robot.account import GROUPS, PARTS, Account, Origin, Origins
from robodyn.robot.document import Mapping, Node, Scalar, compose, decode, describe
from robodyn.robot.fields import Section, Source
from robodyn.robot.frames import (
    effect_from_standard,
    from_poses,
    from_standard,
    placement_at,
    pose_at,
    standard_end_of,
    tool_from_standard,
)  # fmt: skip
from robodyn.robot.keys import INERTIA, LINK, LINKS, REST_VELOCITY, ROBOT, ROW, expectation
from robodyn.robot.masses import inertia_doubt, is_judged, only_about_base_axis
from robodyn.robot.model import Comparison, Gear, Inertia, Joint, JointKind, Limits, Link, Placement, Robot
from robodyn.robot.names import ROBOT_NAME_EXPECTED, parameter_clash, robot_name_fault, shown
from robodyn.robot.parts import UNKNOWN, Confidence, Covariance
from robodyn.robot.rotations import limits_doubt
from robodyn.robot.values import ZERO

if TYPE_CHECKING:
    from robodyn.robot.effects import Written

Warn = Callable[[str], object]


class _Common(NamedTuple):
    """What a description says of all links that do not state their own."""

    confidence: Confidence
    origins: dict[str, Origin]


class DoubtfulRobot(UserWarning):
    """Numbers of a robot that physics hardly allows; see ``strict``."""


def doubtful(text: str) -> None:
    """Make ``text`` a :class:`DoubtfulRobot` warning."""
    warnings.warn(text, DoubtfulRobot, stacklevel=2)


def read_text(text: str, file: str = "<text>", *, strict: bool = False, warn: Warn | None = None) -> Robot:
    """The robot that the YAML ``text`` describes; ``file`` is what messages call it.

    Physically doubtful numbers are told to ``warn``, one line of text each (by default they become a
    :class:`DoubtfulRobot` warning); ``strict`` refuses them.

    Raises
    ------
    InputError: the text is not a robot description; message and place say why.
    """
    source = Source(file, strict, warn or doubtful)
    return _robot(Section(source, "", compose(text, file), ROBOT))


def read_bytes(data: bytes, file: str, *, strict: bool = False, warn: Warn | None = None) -> Robot:
    """As :func:`read_text`, from the bytes of a file, which must be UTF-8.

    Raises
    ------
    InputError: as :func:`read_text`, and for other encodings and files over 1 MiB.
    """
    return read_text(decode(data, file), file, strict=strict, warn=warn)


def _robot(section: Section) -> Robot:
    name = _robot_name(section)
    title, from_ = section.text("title"), section.text("source")
    gravity = section.vector("gravity")
    imported = section.section("imported")
    account = None
    if imported is not None:
        texts = {part: imported.texts(part) for part in PARTS}
        account = Account(imported.text("file"), imported.text("format"), **texts)
    common = _Common(section.confidence("confidence"), section.origins("origin"))
    compared = section.section("compare")
    comparison = Comparison(compared.text("table"), compared.text("row")) if compared else None
    convention = section.choice("convention") or "mdh"
    links, effects, base, end = _links(section, convention, common)
    for parameter, place in section.source.names.values():
        fault = parameter_clash(parameter, name)
        if fault:
            what, remedy = f"the run-time parameter {fault}", "choose another name"
            raise InputError(what, where=place, found=shown(parameter), remedy=remedy)
    side = section.choice("torque_side")
    rest, band = _at_rest(section)
    robot = Robot(
        name, links, title, from_, compare=comparison, torque_side="link" if side == "link" else "motor",
        rest_velocity=rest, dead_band=band, base=base, standard_end=end, account=account,
        covariance=_covariance(section),
    )  # fmt: skip
    if gravity is not None:
        x, y, z = (value for value in gravity if isinstance(value, Fraction))  # no names there: all three
        robot = replace(robot, gravity=(x, y, z))
    tool = placement_at(section, "tool")
    if convention == "sdh":
        assert end is not None
        tool = tool_from_standard(tool, end)
    robot = replace(robot, tool=tool)
    if nodes := section.items("couplings"):
        from robodyn.robot.reading_couplings import read_couplings  # an arm without any does without

        robot = replace(robot, couplings=read_couplings(section.source, nodes, robot))
    if effects:
        from robodyn.robot.folding import into_robot

        robot = into_robot(robot, effects)
    return robot


def _covariance(section: Section) -> Covariance | None:
    name = section.full_text("covariance")
    if name and not re.fullmatch(r"\w[\w.-]*\.json", name, re.ASCII):
        section.source.fail(
            section.values["covariance"], "covariance is no name of a file beside this one",
            found=shown(name), expected="letters, digits, _, - and ., such as identify.json",
        )  # fmt: skip
    return Covariance(name) if name else None


def _robot_name(section: Section) -> str:
    node = section.scalar("name")
    assert node is not None  # the key is required
    fault = robot_name_fault(node.text)
    if fault:
        section.source.fail(
            node,
            f"the robot's name {fault}",
            found=shown(node.text),
            expected=ROBOT_NAME_EXPECTED,
            remedy="choose another name; 'title' takes any text",
        )
    return node.text


def _written(section: Section, joint: int | None, kind: JointKind, joints: int) -> tuple[Written, ...]:
    if not section.items("effects"):
        return ()
    from robodyn.robot.effects import read_effects  # with the catalogue: a rigid arm does without

    return read_effects(section, joint, kind, joints)


def _links(
    section: Section, convention: str, common: _Common
) -> tuple[tuple[Link, ...], tuple[Written, ...], Placement | None, Placement | None]:
    """The links in modified frames, effects in them, where the base frame stands, and where the last standard
    frame does in the last modified one."""
    source = section.source
    nodes = section.items("links") or ()
    if not 1 <= len(nodes) <= LINKS:
        source.fail(
            section.values["links"],
            f"{section.path('links')} must have 1 to {LINKS} entries",
            found=describe(section.values["links"]),
            expected="one entry a joint, base to tip",
        )
    sections = [Section(source, f"link {i}", node, LINK) for i, node in enumerate(nodes, 1)]
    read = [_link(part, i, len(nodes), common) for i, part in enumerate(sections, 1)]
    rows = tuple(link for link, _ in read)
    _refuse_twins(sections, rows)
    effects = [entry for _, entries in read for entry in entries]
    effects += _written(section, None, "revolute", len(nodes))
    links, base, end = rows, placement_at(section, "base"), placement_at(section, "standard_end")
    poses = [pose_at(part, convention) for part in sections]
    try:
        if convention == "sdh":
            links, end = from_standard(rows), standard_end_of(section, sections, rows[-1])
            effects = [replace(one, entry=effect_from_standard(one.entry, rows[-1])) for one in effects]
        elif any(poses):
            links, base = from_poses(rows, poses, base)
    except OverflowError:
        source.fail(
            section.values["links"],
            "the links' numbers are too large to be converted to modified DH",
            expected="numbers well below 1e308",
        )
    for i, (part, link) in enumerate(zip(sections, rows, strict=True)):
        reason = inertia_doubt(link.inertia)
        if reason and not (i == 0 and only_about_base_axis(links[0].joint, links[0].inertia)):
            part.doubt(
                part.values.get("inertia", part.node),
                f"{part.label}: inertia is not physical: {reason}",
                "check the table, or move a rotor's share to motor_inertia"
                + ("" if source.strict else ", or say why it stands (acknowledged: ...)"),
            )
        if link.acknowledged and not part.doubt_count and is_judged(link.inertia):
            source.note(
                part.values["acknowledged"],
                f"{part.path('acknowledged')}: nothing about this link is implausible",
                "delete the key",
            )
    return links, tuple(effects), base, end


def _refuse_twins(sections: list[Section], links: tuple[Link, ...]) -> None:
    first: dict[str, int] = {}
    for i, (section, link) in enumerate(zip(sections, links, strict=True), 1):
        if first.setdefault(link.name, i) != i:
            node = section.values.get("name", section.node)
            section.source.fail(
                node,
                f"link {i}: another link has this name",
                found=f"{shown(link.name)}, as link {first[link.name]}",
                remedy="give each link a name of its own, or none",
            )


def _link(section: Section, i: int, joints: int, common: _Common) -> tuple[Link, tuple[Written, ...]]:
    kind: JointKind = "prismatic" if section.choice("joint") == "prismatic" else "revolute"
    name, acknowledged = section.full_text("name"), section.full_text("acknowledged")
    friction = section.section("friction")
    # Read in the order of the table, so that the first fault named is the first in a well-kept file.
    alpha, a, b = section.angle("alpha"), section.number("a"), section.number("b")
    d, theta = section.number("d"), section.angle("theta")
    mass, com = section.number("mass"), section.vector("com")
    tensor = section.section("inertia")
    motor_inertia = section.number("motor_inertia")
    gear = None
    if geared := section.section("gear"):
        ratio = geared.constant("ratio")
        assert ratio is not None  # the key is required
        gear = Gear(ratio, geared.constant("torque_constant"))
    limits = _limits(section, kind)
    confidence = common.confidence if (share := section.confidence("confidence")) is None else share
    viscous, coulomb = (friction.number(x) for x in ("viscous", "coulomb")) if friction else (ZERO, ZERO)
    joint = Joint(kind, alpha, a, d, theta, motor_inertia, viscous, coulomb, limits, gear, b)
    inertia = Inertia(*(tensor.number(key.name) for key in INERTIA)) if tensor else Inertia()
    origins = _origins(section, common.origins, confidence)
    link = Link(
        name or f"link{i}", joint, mass, com or (ZERO, ZERO, ZERO), inertia, confidence, acknowledged, origins
    )
    effects = _written(section, i, kind, joints)
    if effects:
        from robodyn.robot.folding import into_link

        return into_link(link, friction, effects)
    return link, ()


def _origins(section: Section, common: dict[str, Origin], confidence: Confidence) -> Origins:
    """Where the numbers of a link come from: what its description leaves out is absent. ``common``: what the
    robot's says of all links; inertial numbers of unknown ``confidence`` are assumed."""
    guess: dict[str, Origin] = {"inertial": "assumed"} if confidence == UNKNOWN else {}
    origins = {**guess, **common, **section.origins("origin")}
    stated = {key: key in section.values for key in ("mass", "com", "inertia", *GROUPS)}
    stated["geometry"] = any(key in section.values for key in (*ROW, "pose"))
    unknown = origins.get("inertial") == "absent"
    if unknown and stated["mass"] and stated["inertia"]:
        section.source.fail(
            section.values.get("origin", section.node),
            f"{section.label}: mass and inertia are stated, and inertial: absent says that nobody knows them",
            remedy="leave the numbers out, or say another origin",
        )
    if unknown:
        del origins["inertial"]
    return Origins(
        where=section.source.place(section.node),
        unknown=unknown,
        **{
            name: origins.get(group, "stated") if stated[name] else "absent"
            for group, names in GROUPS.items()
            for name in names
        },
    )


def _limits(section: Section, kind: JointKind) -> Limits:
    stated = section.section("limits")
    if stated is None:
        return Limits()
    limits = Limits(
        stated.range("position"),
        stated.constant("velocity"),
        stated.constant("acceleration"),
        stated.constant("torque"),
    )
    reason = limits_doubt(limits, kind)
    if reason and limits.position:
        low, high = map(numbers.brief, limits.position)
        section.doubt(
            stated.values["position"],
            f"{stated.path('position')}: {reason}",
            f"limits are in rad: write [{low}*pi/180, {high}*pi/180] if degrees are meant",
        )
    return limits


def _at_rest(section: Section) -> tuple[Fraction | None, Fraction | None]:
    """``exact``, ``smooth`` or ``dead_band``, these with ``{velocity: v}`` or without: their velocities."""
    key = section.keys["friction_at_rest"]
    node: Node | None = section.values.get(key.name)
    if node is None or (isinstance(node, Scalar) and node.text == "exact"):
        return None, None
    path = section.path(key.name)
    velocity = numbers.parse_number(REST_VELOCITY)
    rule = node.text if isinstance(node, Scalar) else ""
    if isinstance(node, Mapping):
        rules = [name.text for name, _ in node.entries]
        if sorted(rules) == ["dead_band", "smooth"]:
            what, remedy = f"{path} is both smooth and a dead band", "delete one of the two"
            section.source.fail(node, what, expected="one rule", remedy=remedy)
        rule = rules[0] if len(rules) == 1 else ""
    if rule not in ("smooth", "dead_band"):
        section.source.fail(node, f"{path} is unknown", found=describe(node), expected=expectation(key))
    if isinstance(node, Mapping):
        rest = Section(section.source, f"{path}: {rule}", node.entries[0][1], key.members)
        velocity = rest.constant("velocity") or velocity
    return (velocity, None) if rule == "smooth" else (None, velocity)
