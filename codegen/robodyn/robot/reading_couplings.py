"""The couplings of a description, each with the place of what is wrong with it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

from robodyn.errors import did_you_mean
from robodyn.robot.coupling import Circle, transmission_of
from robodyn.robot.document import Node
from robodyn.robot.fields import Section, Source
from robodyn.robot.keys import COUPLING
from robodyn.robot.model import Coupling, Robot
from robodyn.robot.names import shown
from robodyn.robot.values import ZERO


def read_couplings(source: Source, nodes: Sequence[Node], robot: Robot) -> tuple[Coupling, ...]:
    """The entries of the list ``couplings`` in the description of ``robot``.

    Raises
    ------
    InputError: one names no link, follows itself or the same joint twice, or is in a circle; with its place.
    """
    numbers_of = {link.name: i for i, link in enumerate(robot.links, 1)}
    parts = [Section(source, f"coupling {i}", node, COUPLING) for i, node in enumerate(nodes, 1)]
    couplings: dict[tuple[int, int], Coupling] = {}
    for part in parts:
        joint, of = (_number(part, key, numbers_of) for key in ("joint", "of"))
        fault = remedy = None
        if joint == of:
            fault = "the joint follows itself"
        elif (joint, of) in couplings:
            fault, remedy = "the joint follows this one already", "add the ratios up in one entry"
        if fault:
            source.fail(
                part.values["of"], part.path(fault), found=shown(part.text("of")), expected="another joint",
                remedy=remedy,
            )  # fmt: skip
        ratio = part.constant("ratio") if "ratio" in part.values else Fraction(1)
        couplings[joint, of] = Coupling(joint, of, ratio or Fraction(1), part.constant("offset") or ZERO)
    try:
        transmission_of(replace(robot, couplings=tuple(couplings.values())))
    except Circle as circle:
        pairs = zip(parts, couplings, strict=True)
        part = next(part for part, (joint, _) in pairs if joint - 1 in circle.joints)
        source.fail(
            part.node,
            part.path(circle.what),
            found=", ".join(robot.links[joint].name for joint in circle.joints),
            expected=circle.expected,
            remedy=circle.remedy,
        )
    return tuple(couplings.values())


def _number(part: Section, key: str, numbers_of: Mapping[str, int]) -> int:
    """The number of the link that ``key`` names."""
    name = part.full_text(key)
    if name not in numbers_of:
        part.source.fail(
            part.values[key],
            f"{part.path(key)}: there is no such link",
            found=shown(name),
            expected=f"one of {', '.join(numbers_of)}",
            remedy=did_you_mean(name, numbers_of),
        )
    return numbers_of[name]
