"""What is to be proven, of what, and what it came to."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any, Literal

from robodyn.certify.ranges import Range
from robodyn.dynamics.functions import function_named
from robodyn.errors import InputError
from robodyn.ir.program import Input, Program
from robodyn.ir.signature import Signature
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.optimize.prune.box import Box, box_of
from robodyn.passes.trig_given import given_layout
from robodyn.robot.model import Robot
from robodyn.tools import Tool

PROOFS = ("gappa", "eva", "stack", "misra")


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
        ranges: dict[Input, Range] = {}
        layout = given_layout([program for _, program in self.plain.unit.functions])
        for k, (kind, terms, _) in enumerate(layout):
            ranges[Input("sc", k)] = box.ranges[terms[0][0]] if kind == "q" else (Fraction(-1), Fraction(1))
        if not layout:
            ranges[Input("sc", 0)] = (Fraction(0), Fraction(0))
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


def ranges_of(box: Box) -> Mapping[Input, Range]:
    """All ranges of a box, those of angles too."""
    return {x: box.interval(x) for x in box.inputs}


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
