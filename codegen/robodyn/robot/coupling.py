"""Joints that follow others: ``q = G u + o``, with a constant matrix between the coordinates ``u`` that are
commanded and the joints ``q``."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any

from robodyn.errors import InputError
from robodyn.robot.model import Coupling, Robot
from robodyn.robot.values import PI, angle

#: Terms of a sum by what they multiply: coordinates, or joints, from 0.
Terms = Mapping[int, Fraction]


class Circle(InputError):
    """Joints that follow each other in a circle: ``joints``, from 0."""

    def __init__(self, joints: Sequence[int]) -> None:
        self.joints = tuple(joints)
        numbers = ", ".join(str(joint + 1) for joint in joints)
        super().__init__(
            "joints follow each other in a circle",
            found=f"the joints {numbers}",
            expected="one joint at least that follows no other, at the end of each",
            remedy="delete one of these couplings",
        )


@dataclass(frozen=True, slots=True)
class Transmission:
    """``q = G u + o`` of an arm: ``rows`` [n] of ``G``, the terms of each joint by coordinate; ``offsets``
    [n] [rad or m]; ``commanded`` [m], which joint each coordinate is."""

    rows: tuple[Terms, ...]
    offsets: tuple[Fraction, ...]
    commanded: tuple[int, ...]

    def columns(self) -> list[list[tuple[int, Fraction]]]:
        """The columns [m] of ``G``: the joints that each coordinate moves, with how far."""
        return [
            [(joint, row[k]) for joint, row in enumerate(self.rows) if k in row]
            for k in range(len(self.commanded))
        ]

    def spread(self, rates: Sequence[Any], number: Callable[[Fraction], Any]) -> list[Any]:
        """``G`` times ``rates`` [m], over any scalar that ``number`` makes of a rational."""
        return [_sum(((k, g) for k, g in row.items()), rates, number) for row in self.rows]

    def folded(self, torques: Sequence[Any], number: Callable[[Fraction], Any]) -> list[Any]:
        """``G^T`` times ``torques`` [n]."""
        return [_sum(column, torques, number) for column in self.columns()]

    def joints(self, u: Sequence[Any], number: Callable[[Fraction], Any]) -> list[Any]:
        """The positions ``q`` [n] of the joints at ``u`` [m]."""
        positions = self.spread(u, number)
        return [q + number(o) if o else q for q, o in zip(positions, self.offsets, strict=True)]


def _sum(
    terms: Iterator[tuple[int, Fraction]] | list[tuple[int, Fraction]],
    values: Sequence[Any],
    number: Callable[[Fraction], Any],
) -> Any:
    total: Any = 0
    for index, factor in terms:
        total = total + (values[index] if factor == 1 else number(factor) * values[index])
    return total


def transmission_of(robot: Robot) -> Transmission:
    """How the joints of ``robot`` follow its coordinates.

    Raises
    ------
    Circle: some follow each other, and none of them is commanded.
    """
    return _transmission(tuple(link.joint.kind == "revolute" for link in robot.links), robot.couplings)


@lru_cache(maxsize=64)
def _transmission(turns: tuple[bool, ...], couplings: tuple[Coupling, ...]) -> Transmission:
    n = len(turns)
    follows: dict[int, list[Coupling]] = {}
    for coupling in couplings:
        follows.setdefault(coupling.joint - 1, []).append(coupling)
    commanded = tuple(i for i in range(n) if i not in follows)
    known: dict[int, tuple[dict[int, Fraction], Fraction]] = {
        joint: ({k: Fraction(1)}, Fraction(0)) for k, joint in enumerate(commanded)
    }

    while len(known) < n:
        ready = [
            joint for joint in follows
            if joint not in known and all(each.of - 1 in known for each in follows[joint])
        ]  # fmt: skip
        if not ready:
            raise Circle(_circle(follows, known))
        for joint in ready:
            row: dict[int, Fraction] = {}
            offset = Fraction(0)
            for each in follows[joint]:
                terms, start = known[each.of - 1]
                offset += each.ratio * start + each.offset
                for k, g in terms.items():
                    row[k] = row.get(k, Fraction(0)) + each.ratio * g
            known[joint] = {k: g for k, g in sorted(row.items()) if g}, offset
    rows, offsets = zip(*(known[joint] for joint in range(n)), strict=True)
    offsets = tuple(as_turned(o) if turn else o for o, turn in zip(offsets, turns, strict=True))
    return Transmission(rows, offsets, commanded)


def as_turned(offset: Fraction) -> Fraction:
    """``offset`` [rad] as kernels turn by it (:func:`~robodyn.robot.values.angle`): a multiple of pi/2, or
    what a double says, whole turns kept."""
    turn = angle(offset)
    own = Fraction(turn.radians) if turn.quarter is None else turn.quarter * PI / 2
    return own + 2 * PI * round((offset - own) / (2 * PI))


def _circle(follows: Mapping[int, Sequence[Coupling]], known: Mapping[int, Any]) -> list[int]:
    """Joints that follow each other, from one to the one before it."""
    joint = min(joint for joint in follows if joint not in known)
    passed: list[int] = []
    while joint not in passed:
        passed.append(joint)
        joint = next(each.of - 1 for each in follows[joint] if each.of - 1 not in known)
    return passed[passed.index(joint) :]


def followers(robot: Robot) -> dict[str, str]:
    """What each joint that follows others is in the coordinates, for people; by its name."""
    if not robot.couplings:
        return {}
    at, names, texts = transmission_of(robot), [link.name for link in robot.links], {}
    for joint in sorted({coupling.joint - 1 for coupling in robot.couplings}):
        terms = [f"{float(g):+.10g} {names[at.commanded[k]]}" for k, g in at.rows[joint].items()]
        offset, unit = at.offsets[joint], "m" if robot.links[joint].joint.kind == "prismatic" else "rad"
        terms += [f"{float(offset):+.10g} {unit}"] if offset or not terms else []
        texts[names[joint]] = " ".join(terms)
    return texts


def coupling_lines(robot: Robot) -> list[str]:
    """Which joints of ``robot`` are the coordinates of its kernels, and which follow them, for people;
    nothing where all joints move by themselves."""
    if not robot.couplings:
        return []
    commanded = ", ".join(robot.links[joint].name for joint in robot.commanded)
    lines = [f"  {name} = {text}" for name, text in followers(robot).items()]
    return [f"Coordinates, which arrays have an element for: {commanded}", "Joints that follow them:", *lines]


def no_couplings(robot: Robot, what: str) -> None:
    """Refuse a robot whose joints follow others where ``what``, such as "identify", has no way with them yet.

    Raises
    ------
    InputError: joints follow others.
    """
    if robot.couplings:
        names = (robot.links[each.joint - 1].name for each in robot.couplings)
        raise InputError(
            f"{what} cannot do joints that follow others yet",
            found=f"couplings of {robot.name}: {', '.join(dict.fromkeys(names))}",
            expected="joints that move by themselves",
            remedy="gen, flops, verify, export and packages of plain kernels can; for the rest leave the "
            "couplings out, so that every joint moves by itself",
        )
