"""What a format of packages is, and what it is given: kernel, functions with shapes and units, names, and who
looks after it."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Final, Literal

from robodyn.dynamics.functions import array_named, function_named
from robodyn.emit.language import Language
from robodyn.emit.unit import needs_libm
from robodyn.errors import InputError
from robodyn.firmware.language_tests import language_tests
from robodyn.ir.signature import ScalarType, Signature
from robodyn.kernels.generate import Generated
from robodyn.robot.model import Robot

#: Files by path within the folder of the package; bytes where a file is no text.
Files = Mapping[str, str | bytes]
#: What kernels may have and not every tool has a place for: run-time parameters (``NAME_params``), memory
#: from call to call (``NAME_state``), and sines that the caller computes (``--trig given``).
Trait = Literal["parameters", "memory", "given sines"]


@dataclass(frozen=True, slots=True)
class Format:
    """A format of packages.

    Attributes
    ----------
    name: what it is called after ``--as``, as its module.
    title: what the package is, as in "a CMake package".
    tool: who takes it, with the oldest version that does.
    language: what its kernels are written in.
    files: all files of a package, those that are the same in every package included.
    take: the command that takes it, or what to do in a few words; ``{folder}`` is where it was written and
        ``{name}`` the package's name (:attr:`.Package.name`).
    functions: which functions it has unless some are named; none: those that are written by default.
    needs: functions that it always has; a robot that lacks one has no such package.
    options: options of kernels that differ from those of ``gen``, unless they or a target are named, by the
        names that :class:`robodyn.kernels.options.Options` has for them.
    lacks: what its kernels cannot have.
    derivatives: whether functions come with those that have their derivatives, as far as the robot has them.
    binary: whether a compiler for this machine is needed to write it, and what is written is for such only.
    called: what a package is called, of the robot's name; a name of its own, since robots may be called like
        targets and libraries that are there already (``test``, ``m``).
    """

    name: str
    title: str
    tool: str
    language: Language
    files: Callable[[Package], Files]
    take: str
    functions: tuple[str, ...] = ()
    needs: tuple[str, ...] = ()
    options: Mapping[str, str] = field(default_factory=dict)
    lacks: frozenset[Trait] = frozenset()
    derivatives: bool = False
    binary: bool = False
    called: Callable[[str], str] = "{}_dynamics".format


@dataclass(frozen=True, slots=True)
class Argument:
    """An array of a function: its shape for this robot, ``()`` for a single number; ``holds`` and ``unit``
    say what it is. In C it is one row of ``size`` numbers, a matrix row by row. ``optional``: where
    a language lets callers leave it out it is zero then."""

    name: str
    shape: tuple[int, ...]
    size: int
    holds: str
    unit: str
    optional: bool = False


@dataclass(frozen=True, slots=True)
class Routine:
    """A function of the kernel: ``name`` without the robot's, ``symbol`` in C, what it is for, its arrays in
    the order of the arguments. Run-time parameters come after them, then the state and its time step."""

    name: str
    symbol: str
    purpose: str
    inputs: tuple[Argument, ...]
    outputs: tuple[Argument, ...]
    stateful: bool


@dataclass(frozen=True, slots=True)
class Package:
    """A package: what its files are made of.

    ``license`` is an SPDX expression; it and ``maintainer`` are None where none is stated.
    """

    generated: Generated
    format: Format
    version: str
    license: str | None
    maintainer: Maintainer | None

    @property
    def robot(self) -> Robot:
        """The robot whose dynamics it has."""
        return self.generated.unit.robot

    @property
    def name(self) -> str:
        """What the package, its library and its Fortran module are called; the header is ``NAME.h``, and
        functions begin with ``NAME_``."""
        return self.format.called(self.robot.name)

    @property
    def scalar(self) -> ScalarType:
        """The type of all numbers."""
        return self.generated.options.scalar

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the run-time parameters, members of ``NAME_params``."""
        return self.robot.parameters

    @property
    def states(self) -> tuple[str, ...]:
        """Members of ``NAME_state``, which stateful functions remember."""
        return self.generated.unit.states

    @property
    def libm(self) -> bool:
        """Whether the kernel in C calls the mathematical library."""
        return needs_libm(self.generated.unit)

    @property
    def traits(self) -> dict[Trait, str]:
        """What the kernels have and not every format has a place for, in words."""
        given = bool(self.generated.unit.sc) or self.generated.options.trig == "given"
        traits: dict[Trait, tuple[str, bool]] = {
            "parameters": ("run-time parameters", bool(self.parameters)),
            "memory": ("memory from call to call", bool(self.states)),
            "given sines": ("sines and cosines that are given (--trig given)", given),
        }
        return {trait: phrase for trait, (phrase, is_there) in traits.items() if is_there}

    @property
    def routines(self) -> tuple[Routine, ...]:
        """The functions, in the order of the header."""
        return tuple(map(_routine, self.generated.signatures))

    @property
    def arrays(self) -> tuple[Argument, ...]:
        """The arrays of all functions, each once."""
        every = (array for routine in self.routines for array in (*routine.inputs, *routine.outputs))
        return tuple(dict.fromkeys(every))

    def kernel(self) -> dict[str, str]:
        """The sources that ``gen`` writes in the format's language: text by path, tests with vectors
        included where the language has any."""
        names = (self.format.language.name,)
        return {**self.generated.files(names), **language_tests(self.generated, names)}

    def tests(self, entry: str = "main") -> dict[str, str]:
        """Programs that compare every function with results of 40 digits, and end with 1 where one is wrong;
        text by file name. Languages whose tests :meth:`kernel` has already have none. In C another ``entry``
        makes a function of it, which returns that number."""
        return language_tests(self.generated, (self.format.language.name,), packaged=True, entry=entry)

    def files(self) -> Files:
        """All files of the package, by path within its folder.

        Raises
        ------
        InputError: a number or a name does not fit the language.
        ToolError: it has a binary, and there is no compiler.
        """
        return self.format.files(self)


def _routine(signature: Signature) -> Routine:
    function = function_named(signature.function)
    inputs, outputs = (
        tuple(_argument(name, size, signature) for name, size in arrays)
        for arrays in (signature.inputs, signature.outputs)
    )
    name = signature.function if function.emitted else signature.called
    return Routine(name, signature.symbol, function.purpose, inputs, outputs, bool(signature.states))


def _argument(name: str, size: int, signature: Signature) -> Argument:
    array = array_named(name)
    units = " or ".join(unit for unit in (array.unit, array.prismatic) if unit)
    return Argument(name, array.shape_of(size, signature.joints), size, array.holds, units, array.optional)


#: Beside letters, digits and their marks. Quotes, backslashes, commas, ``@`` and ``$`` end a text, list a
#: second person or name a variable in one manifest or another (TOML, METADATA, Arduino's, pkg-config's).
_IN_NAMES: Final = " .'\u2019&+-_"
#: What ROS takes (catkin_pkg, whose schema is the strictest), and the other formats as well.
_EMAIL: Final = re.compile(r"[\w%+-]+(\.[\w%+-]+)*@[A-Za-z0-9-]+(\.[A-Za-z0-9-]+)*\.[A-Za-z]{2,}", re.ASCII)
#: The longest address that mail has (RFC 5321), and as much for a name [characters].
_LONGEST: Final = 254
_EXAMPLE: Final = "Ada Lovelace <ada@example.org>"


@dataclass(frozen=True, slots=True)
class Maintainer:
    """A person, a team or a company, and their address."""

    name: str
    email: str

    def __str__(self) -> str:
        return f"{self.name} <{self.email}>"


#: For formats that require one, where none is stated. No mail ever goes to ``.invalid`` (RFC 2606).
NOT_STATED: Final = Maintainer("not stated", "not-stated@example.invalid")


def read_maintainer(text: str) -> Maintainer:
    """The maintainer that ``text`` states as ``NAME <EMAIL>``.

    Raises
    ------
    InputError: it has another form, or a name or an address that not every format takes.
    """
    match = re.fullmatch(r"\s*([^<>]*?)\s*<([^<>]*)>\s*", text)
    if match is None:
        expected = f"a name and an address, such as {_EXAMPLE!r}"
        raise InputError("this is no maintainer of a package", found=repr(text[:_LONGEST]), expected=expected)
    name, email = " ".join(match[1].split()), match[2]
    other = sorted({c for c in name if c not in _IN_NAMES and unicodedata.category(c)[0] not in "LMN"})
    if other or not re.search(r"[^\W\d_]", name) or len(name) > _LONGEST:
        raise InputError(
            "not every manifest takes this name of a maintainer",
            found=" ".join(map(ascii, other)) or repr(name[:_LONGEST]),
            expected=f"letters, digits, spaces and any of {_IN_NAMES.strip()}, such as {_EXAMPLE!r}",
        )
    if not _EMAIL.fullmatch(email) or len(email) > _LONGEST:
        expected = f"one such as in {_EXAMPLE!r}"
        raise InputError(
            "this is no address of a maintainer", found=repr(email[:_LONGEST]), expected=expected
        )
    return Maintainer(name, email)
