"""From a robot to its kernels: builds the programs, runs the passes, counts, and hands over the files.

>>> made = generate(load("puma560"))                             # doctest: +SKIP
>>> made.counts["inverse_dynamics"].total
>>> made.files()                                                 # {"puma560.h": ..., ...}
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

from robodyn.counts import Count, count
from robodyn.dynamics.functions import FORMULATIONS, FUNCTIONS, Choice, build, has_chains, signature
from robodyn.emit import Unit, render
from robodyn.errors import InputError
from robodyn.ir.program import Program
from robodyn.ir.signature import ScalarType, Signature
from robodyn.passes import FAST, FRESH, SPELLING, Pass, run
from robodyn.passes.trig_given import describe, given_layout, trig_given
from robodyn.robot.model import Robot

Level = Literal["none", "fast"]
Trigonometry = Literal["libm", "given"]
Engine = Literal["graph", "sympy"]

LEVELS: tuple[Level, ...] = ("none", "fast")
TRIGONOMETRY: tuple[Trigonometry, ...] = ("libm", "given")
ENGINES: tuple[Engine, ...] = ("graph", "sympy")
LANGUAGES = ("c", "fortran")


@dataclass(frozen=True, slots=True)
class Options:
    """What to generate and how; the defaults are those of ``robodyn gen``.

    ``functions`` None is all that the robot has: an arm with a joint that moves without inertia has no
    forward dynamics.
    ``optimize="none"`` is the recursion as it stands in the book, equal nodes merged and zeros gone;
    ``regroup=False`` leaves out base-parameter regrouping only. ``engine="sympy"`` builds the same model
    through sympy with named intermediates and ``sympy.cse``: a cross-check, slower and no smaller.
    """

    functions: tuple[str, ...] | None = None
    formulation: str = "modified_newton_euler"
    optimize: Level = "fast"
    regroup: bool = True
    scalar: ScalarType = "double"
    trig: Trigonometry = "libm"
    engine: Engine = "graph"

    def __post_init__(self) -> None:
        if self.functions is not None:
            _check_functions(self.functions)
        _one_of("formulation", self.formulation, FORMULATIONS)
        _one_of("level of optimisation", self.optimize, LEVELS)
        _one_of("scalar", self.scalar, ("double", "float"))
        _one_of("kind of sine and cosine", self.trig, TRIGONOMETRY)
        _one_of("engine", self.engine, ENGINES)

    def choices(self) -> tuple[Choice, ...]:
        """The ways of writing the recursion that come into question; ``fast`` takes the cheapest."""
        as_in_the_book = Choice(self.formulation, regroup=False, chains=False)
        if self.formulation != "modified_newton_euler" or self.optimize == "none" or not self.regroup:
            return (as_in_the_book,)
        return (Choice(), Choice(chains=False), as_in_the_book)


def _check_functions(functions: tuple[str, ...]) -> None:
    if not functions:
        raise InputError("no function asked for", expected=f"some of {', '.join(FUNCTIONS)}")
    for function in functions:
        _one_of("function", function, tuple(FUNCTIONS))
    if len(set(functions)) != len(functions):
        raise InputError("a function is asked for twice", found=", ".join(functions))


def _one_of(what: str, found: str, allowed: Sequence[str]) -> None:
    if found not in allowed:
        import difflib

        close = difflib.get_close_matches(found, allowed, n=1)
        raise InputError(
            f"unknown {what} {found!r}",
            expected=f"one of {', '.join(allowed)}",
            remedy=f"did you mean {close[0]!r}?" if close else None,
        )


@dataclass(frozen=True, slots=True)
class Generated:
    """The kernels of a robot: programs and their interfaces, counts, and texts on request."""

    unit: Unit
    options: Options
    counts: dict[str, Count]

    @property
    def left_out(self) -> tuple[str, ...]:
        """Functions that the robot does not have."""
        return () if self.options.functions else tuple(f for f in FUNCTIONS if f not in self.counts)

    @property
    def signatures(self) -> tuple[Signature, ...]:
        """Interfaces of the functions, in order."""
        return tuple(interface for interface, _ in self.unit.functions)

    def files(self, languages: Sequence[str] = LANGUAGES) -> dict[str, str]:
        """Header, source and Fortran module: text by file name. Writes nothing."""
        for language in languages:
            _one_of("language", language, LANGUAGES)
        return render(self.unit, languages)


class SingularArm(InputError):
    """The mass matrix cannot be inverted in any pose: some joint moves without inertia."""


class Drafts:
    """The programs of a robot before the passes, written in the way that takes the fewest operations in
    the inverse dynamics."""

    def __init__(self, robot: Robot, options: Options) -> None:
        self.robot, self.options = robot, options
        choices = options.choices()
        if not has_chains(robot):
            choices = tuple(choice for choice in choices if not choice.chains) or choices
        tried = {c: build(robot, "inverse_dynamics", c) for c in choices} if len(choices) > 1 else {}
        self.choice = min(choices, key=lambda c: count(tried[c]).total) if tried else choices[0]
        self._inverse_dynamics = tried.get(self.choice)

    def draft(self, function: str) -> Program:
        """The program of ``function``, no pass run yet."""
        if self.options.engine == "sympy":
            from robodyn.dynamics.through_sympy import build_through_sympy

            return build_through_sympy(self.robot, function, self.choice)
        if function == "inverse_dynamics" and self._inverse_dynamics is not None:
            return self._inverse_dynamics
        return build(self.robot, function, self.choice)


def program(
    robot: Robot, function: str, options: Options | None = None, drafts: Drafts | None = None
) -> Program:
    """The optimised program of one function of ``robot``; ``drafts`` saves choosing again.

    Raises
    ------
    SingularArm: forward dynamics of an arm in which a joint moves without inertia.
    """
    options = options or Options()
    drafts = drafts or Drafts(robot, options)
    if options.optimize == "none":
        passes: Sequence[Pass] = SPELLING
    else:
        passes = FAST if options.engine == "sympy" else FRESH
    try:
        return run(drafts.draft(function), passes)
    except ZeroDivisionError:
        raise SingularArm(
            f"{robot.name} has no forward dynamics",
            found="a joint that moves without inertia: the mass matrix is singular in every pose",
            remedy="give that joint a motor_inertia, or its link an inertia",
        ) from None


def generate(
    robot: Robot, options: Options | None = None, *, progress: Callable[[str], None] | None = None
) -> Generated:
    """The kernels of ``robot``; ``progress`` is told each function before it is built.

    Raises
    ------
    InputError: a constant of the model does not fit the scalar type, or an option is unknown.
    """
    options = options or Options()
    drafts = Drafts(robot, options)
    programs: dict[str, Program] = {}
    for function in options.functions or FUNCTIONS:
        if progress is not None:
            progress(function)
        try:
            programs[function] = program(robot, function, options, drafts)
        except SingularArm:
            if options.functions is not None:
                raise
    interfaces = {f: signature(robot, f, options.scalar) for f in programs}
    described: tuple[str, ...] = ()
    no_angle = False
    if options.trig == "given":
        layout = given_layout(list(programs.values()))
        no_angle = not layout  # C has no array of no elements: sc has one then
        described = tuple(describe(given) for given in layout)
        programs = {f: trig_given(p, layout) for f, p in programs.items()}
        interfaces = {f: _with_sc(interface, max(1, len(layout))) for f, interface in interfaces.items()}
    unit = Unit(
        robot=robot,
        functions=tuple((interfaces[f], programs[f]) for f in programs),
        sc=described,
        notes=_notes(drafts.choice) + (("sc is not read: there is no angle.",) if no_angle else ()),
    )
    return Generated(unit, options, {f: count(p) for f, p in programs.items()})


def _with_sc(interface: Signature, size: int) -> Signature:
    import dataclasses

    inputs = tuple(("sc", size) if name == "q" else (name, length) for name, length in interface.inputs)
    return dataclasses.replace(interface, inputs=inputs)


_TITLES = {
    "modified_newton_euler": "modified Newton-Euler (lambda matrix)",
    "newton_euler": "Newton-Euler",
    "balafoutis": "Balafoutis's tensor recursion",
    "kane": "Kane's equations",
    "lagrange": "closed-form Lagrange (Uicker, Kahn)",
    "lagrange_4x4": "recursive Lagrange with 4x4 matrices (Hollerbach)",
    "lagrange_3x3": "recursive Lagrange with 3x3 matrices (Hollerbach)",
}


def _notes(choice: Choice) -> tuple[str, ...]:
    method = f"Formulation: {_TITLES[choice.formulation]} in modified Denavit-Hartenberg frames"
    if choice.regroup:
        method += (
            ", on base parameters: fc and nc act at and about the frame's origin, and what of a link's mass "
            "makes no difference is moved to its parent"
        )
    return (method + ".",)
