"""What a language is: the record that each file of :mod:`robodyn.emit.languages` holds."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from robodyn.emit.body import Lines
from robodyn.emit.spelling import Spelling, Syntax
from robodyn.emit.stages import Repeated
from robodyn.emit.unit import Unit
from robodyn.errors import InputError
from robodyn.ir.signature import ScalarType, Signature
from robodyn.robot.names import shown
from robodyn.tools import Tool

#: What not every language can do.
Feature = Literal["batch", "misra", "firmware"]


@dataclass(frozen=True, slots=True)
class FunctionText:
    """One function on its way to the templates: its interface, its lines, and which arguments nothing reads.

    ``stage``: only another function calls it.
    """

    signature: Signature
    lines: Lines
    unused: Sequence[str]
    stage: bool


@dataclass(frozen=True, slots=True)
class Compiled:
    """How a language is compiled, and called from C: the ``compiler``, ``flags`` that leave arithmetic as it
    is written, and the ``symbol`` of a function. ``header``: whether a header NAME.h declares them."""

    compiler: Tool
    flags: tuple[str, ...]
    symbol: Callable[[Signature], str]
    header: bool = False


@dataclass(frozen=True, slots=True)
class SelfTest:
    """A language's self-test in a firmware folder: ``file`` made by ``template``, the compiler's ``flags``,
    and names of types that the template is told, for ``double`` and for ``float`` (True)."""

    file: str
    template: str
    flags: tuple[str, ...]
    types: Callable[[bool], dict[str, str]]


@dataclass(frozen=True, slots=True)
class Language:
    """A language: how it spells a kernel, and what it can do beyond that. An option that it lacks is refused.

    ``syntax`` writes the statements of a function, ``function`` says what the templates are told of it beyond
    what they are told in every language, ``context`` what they are told of the file. ``files`` are the
    templates by the name of the file that each makes, ``NAME`` being the robot's.
    """

    name: str
    title: str
    files: Mapping[str, str]
    #: Ends of the files' names that are compiled.
    suffixes: tuple[str, ...]
    spelling: Callable[[bool], Spelling]
    """Numbers and operators of ``double``, or of ``float`` (True)."""
    syntax: Callable[[Signature, Unit], Syntax]
    function: Callable[[FunctionText], dict[str, Any]]
    context: Callable[[Unit], dict[str, Any]] = lambda unit: {}
    aliases: tuple[str, ...] = ()
    #: The lines of a function that repeats a step; None: it has no such functions.
    repeating: Callable[[Repeated, Syntax], Lines] | None = None
    #: Notes for the head of the file, on compiling and calling.
    advice: Callable[[Unit], tuple[str, ...]] = lambda unit: ()
    #: What the struct of a robot's ``params`` or ``state`` is called.
    type_name: Callable[[str, str], str] = lambda robot, kind: f"{robot}_{kind}"
    #: Whose sines and cosines its kernels have unless told otherwise.
    trig: Literal["libm", "builtin"] = "libm"
    #: Whether its library has sine and cosine in one call, which ``sines`` of its syntax write then.
    joins_sines: bool = False
    #: Templates of tests with vectors, by the file that each makes (:mod:`robodyn.firmware.language_tests`).
    tests: Mapping[str, str] = field(default_factory=dict)
    #: The same for packages, where ``gen`` writes none: programs that end with 1 if a result is wrong.
    package_tests: Mapping[str, str] = field(default_factory=dict)
    scalars: tuple[ScalarType, ...] = ("double", "float")
    #: Whose sines and cosines it can have; our own ask for ``syntax`` with ``sines``.
    trigonometry: tuple[str, ...] = ("libm", "builtin", "given")
    #: How many characters a name may have, where the language says.
    longest_name: int | None = None
    #: What it can do beyond plain kernels.
    features: frozenset[Feature] = frozenset()
    #: Files of batches, by name.
    batch: Callable[[Unit], dict[str, str]] | None = None
    #: How it is compiled and called from Python; None: it is not.
    compiled: Compiled | None = None
    #: Programs that take what is written, beside the compiler that robodyn calls.
    takers: tuple[Tool, ...] = ()
    #: What a firmware folder has of it beside the kernel; that of C is the folder itself.
    selftest: SelfTest | None = None

    def check(self, scalar: str, trig: str, signatures: Sequence[Signature]) -> None:
        """:class:`InputError` where it has no such numbers, no such sines and cosines, or no names as long as
        those of the functions."""
        for option, value, able in (("scalar", scalar, self.scalars), ("trig", trig, self.trigonometry)):
            if value not in able:
                raise InputError(
                    f"{self.title} is not written with --{option} {value}",
                    expected=f"--{option} {' or '.join(able)}",
                )
        longest = max(signatures, key=lambda signature: len(signature.symbol))
        if self.longest_name is not None and len(longest.symbol) > self.longest_name:
            room = self.longest_name - len(longest.symbol) + len(longest.robot)
            raise InputError(
                f"{self.title} allows names of {self.longest_name} characters",
                found=f"{len(longest.symbol)} in {shown(longest.symbol, self.longest_name)}",
                remedy=(f"shorten the robot's name to {room} characters, or " if room > 0 else "")
                + f"leave {self.name} out of the languages (--lang)",
            )
