"""What is to be proven, of what, within which ranges, and what it came to; running the provers."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from pathlib import Path
from typing import Any, Literal

from robodyn.dynamics.functions import function_named
from robodyn.errors import InputError, ToolError
from robodyn.ir.program import Input, Program
from robodyn.ir.signature import Signature
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.optimize.prune.box import Box, box_of
from robodyn.passes.trig_given import given_layout
from robodyn.robot.model import Robot
from robodyn.robot.names import shown
from robodyn.robot.numbers import NumberError, parse_number
from robodyn.toolchain import running
from robodyn.toolchain.running import Finished
from robodyn.tools import Tool

PROOFS = ("gappa", "eva", "stack", "misra")
#: How long Eva, a compiler or cppcheck may take [s].
PATIENCE = 600.0


@dataclass(frozen=True, slots=True)
class ProofOptions:
    """What is asked for: which proofs, how long Gappa may take for a torque [s] and how many at a time, and
    which share of each joint's largest torque the bound may reach."""

    only: tuple[str, ...] = PROOFS
    seconds: float = 300.0
    workers: int = 1
    tolerance: Fraction | None = None

    def __post_init__(self) -> None:
        for name in self.only:
            if name not in PROOFS:
                raise InputError(f"unknown proof {name!r}", expected=f"some of {', '.join(PROOFS)}")
        if not self.only:
            raise InputError("no proof asked for", expected=f"some of {', '.join(PROOFS)}")


@dataclass(frozen=True, slots=True)
class Subject:
    """A kernel with its files, and the ranges that bounds hold in; ``robot`` has them as its limits."""

    robot: Robot
    generated: Generated
    files: dict[str, str]
    #: The same programs on angles, where sines and cosines are given.
    plain: Generated

    @property
    def scalar(self) -> str:
        """``float`` or ``double``."""
        return self.generated.options.scalar

    def bounded(self) -> list[tuple[Signature, Program]]:
        """Functions whose rounding errors are bounded."""
        return [(s, p) for s, p in self.generated.unit.functions if function_named(s.function).gives_torques]

    def box(self, signature: Signature) -> Box:
        """Where the inputs of a function are."""
        box = box_of(self.robot, [name for name, _ in self.plain_signature(signature).inputs])
        if self.generated.options.trig != "given":
            return box
        ranges: dict[Input, Range] = {Input("sc", 0): (Fraction(0), Fraction(0))}
        layout = given_layout([program for _, program in self.plain.unit.functions])
        for k, (kind, terms, _) in enumerate(layout):
            ranges[Input("sc", k)] = box.ranges[terms[0][0]] if kind == "q" else (Fraction(-1), Fraction(1))
        others = {x: limits for x, limits in box.ranges.items() if x.array != "q"}
        return Box((), {**ranges, **others}, {})

    def plain_signature(self, signature: Signature) -> Signature:
        """The interface of the same function on angles."""
        return next(s for s in self.plain.signatures if s.function == signature.function)

    def plain_program(self, signature: Signature) -> Program:
        """The program of the same function on angles."""
        return next(p for s, p in self.plain.unit.functions if s.function == signature.function)


def subject(robot: Robot, ranged: Robot, options: Options) -> Subject:
    """The kernel of ``robot`` that ``options`` ask for, in C; ``ranged`` is the robot with the ranges as its
    limits."""
    options = replace(options, misra=True)
    generated = generate(robot, options)
    plain = generate(robot, replace(options, trig="libm")) if options.trig == "given" else generated
    return Subject(ranged, generated, generated.files(("c",)), plain)


#: Is told how far a proof is.
Tell = Callable[[str], None]
#: ``proved``: what it says holds. ``failed``: it does not, or could not be shown. ``not run``: a tool is
#: missing.
Status = Literal["proved", "failed", "not run"]


@dataclass(frozen=True, slots=True)
class Finding:
    """One proof: ``claim`` is what it shows in one sentence, ``lines`` what came out, for people; ``data``
    the same for programs. ``commands``, run in the folder of the proof, run it again."""

    name: str
    status: Status
    claim: str
    lines: tuple[str, ...] = ()
    data: dict[str, Any] = field(default_factory=dict)
    tools: tuple[str, ...] = ()
    commands: tuple[str, ...] = ()
    files: dict[str, str] = field(default_factory=dict)

    def to_dict(self) -> dict[str, Any]:
        """For JSON; files are left out."""
        return {
            "proof": self.name,
            "status": self.status,
            "claim": self.claim,
            "tools": list(self.tools),
            "commands": list(self.commands),
            **self.data,
        }


def not_run(name: str, tool: Tool) -> Finding:
    """The finding of a proof whose tool is missing."""
    remedy = f"needs {tool.remedy}"
    return Finding(name, "not run", f"not run: {remedy}", data={"remedy": remedy})


def run(command: Sequence[str], folder: Path, seconds: float = PATIENCE) -> Finished:
    """Run ``command`` in ``folder``, with all that it starts, for ``seconds`` at most.

    Raises
    ------
    ToolError: it cannot be started.
    """
    try:
        return running.run(command, folder=folder, seconds=seconds)
    except OSError as error:
        raise ToolError(f"{command[0]} cannot be started", found=error.strerror or str(error)) from None


def last_lines(output: str, count: int = 3) -> str:
    """The last lines of what a program said, as one."""
    lines = [re.sub(r"\s+", " ", line).strip() for line in output.splitlines() if line.strip()]
    return " | ".join(lines[-count:])[:400] or "nothing"


def version(tool: Tool) -> str:
    """The first line that ``tool`` says about itself."""
    output = run([tool.needed(), *tool.version_arguments], Path.cwd(), 60).output.strip()
    return output.splitlines()[0].strip() if output else "(says no version)"


# --- the ranges that bounds hold in -------------------------------------------------------------------------

Range = tuple[Fraction, Fraction]
#: What a range may be given for: the limit in a robot's file, and an example.
_ARRAYS = {"q": ("position", "pi"), "qd": ("velocity", "3"), "qdd": ("acceleration", "10")}
_EXPECTED = "for example qd=3,qdd=10 or q2=-pi/2:pi/2: q, qd or qdd, a joint or none, and a bound or LOW:HIGH"
_KEY = re.compile(r"(qdd|qd|q)([1-9][0-9]{0,3})?\Z")


def with_ranges(robot: Robot, text: str | None) -> Robot:
    """``robot`` with the limits of ``text`` (``qd=3,qdd2=10,q=-pi/2:pi/2``) in place of those in its file.

    Raises
    ------
    InputError: it does not say what a range is, or a joint is left without one.
    """
    limits = [link.joint.limits for link in robot.links]
    for array, joint, (low, high) in () if text is None else _entries(text):
        if joint > robot.n:
            raise InputError(
                "a range for a joint that is not there",
                found=f"{array}{joint}",
                expected=f"a joint from 1 to {robot.n} of {robot.name}",
            )
        if array != "q" and low != -high:
            raise InputError(
                f"the range of {array} is not the same to both sides",
                found=f"{float(low):g} to {float(high):g}",
                expected="one bound of the size, as limits of speeds and accelerations are",
            )
        change: dict[str, Any] = {_ARRAYS[array][0]: (low, high) if array == "q" else high}
        for i in (joint - 1,) if joint else range(robot.n):
            limits[i] = replace(limits[i], **change)
    for array, (key, example) in _ARRAYS.items():
        lacking = [str(i) for i, limit in enumerate(limits, 1) if getattr(limit, key) is None]
        if lacking:
            raise InputError(
                f"{robot.name}: no proof without ranges",
                found=f"no limit of {key} at joint{'s' * (len(lacking) > 1)} {', '.join(lacking)}",
                remedy=f"write it in the robot's file, or give --ranges {array}={example}",
            )
    joints = [replace(link.joint, limits=limit) for link, limit in zip(robot.links, limits, strict=True)]
    links = tuple(replace(link, joint=joint) for link, joint in zip(robot.links, joints, strict=True))
    return replace(robot, links=links)


def _entries(text: str) -> Iterator[tuple[str, int, Range]]:
    """Array, joint (0: all of them) and range of each part of ``text``."""
    for part in text.split(","):
        key, equals, value = part.partition("=")
        if not equals:
            raise InputError("a range cannot be read", found=shown(part), expected=_EXPECTED)
        match = _KEY.match(key.strip())
        if match is None:
            raise InputError("a range of something unknown", found=shown(key.strip()), expected=_EXPECTED)
        yield match[1], int(match[2] or 0), _range(value)


def _range(text: str) -> Range:
    low, colon, high = text.partition(":")
    try:
        first = parse_number(low)
        pair = (first, parse_number(high)) if colon else (-first, first)
    except NumberError as error:
        what = f"a range cannot be read: {error.what}"
        raise InputError(what, found=shown(text), expected=_EXPECTED) from None
    if not pair[0] <= pair[1]:
        raise InputError(
            "a range is empty" if colon else "a bound is below zero",
            found=shown(text.strip()),
            expected="the smaller number first" if colon else "its size",
        )
    return pair
