"""From a robot to its kernels: builds the programs, runs the passes, counts, and hands over the files.

>>> made = generate(load("puma560"))                             # doctest: +SKIP
>>> made.counts["inverse_dynamics"].total
>>> made.files()                                                 # {"puma560.h": ..., ...}
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from robodyn.counts import Count, count
from robodyn.dynamics.functions import FUNCTIONS, Choice, signature
from robodyn.emit import Unit, render
from robodyn.generation.drafts import Drafts, SingularArm, program
from robodyn.generation.options import (
    ENGINES,
    LANGUAGES,
    LEVELS,
    TRIGONOMETRY,
    Engine,
    Level,
    Options,
    Trigonometry,
    check_languages,
)
from robodyn.ir.program import Program
from robodyn.ir.signature import Signature
from robodyn.passes.trig_given import describe, given_layout, trig_given
from robodyn.prune import Pruning, notes_of
from robodyn.robot.model import Robot

__all__ = [
    "ENGINES",
    "LANGUAGES",
    "LEVELS",
    "TRIGONOMETRY",
    "Drafts",
    "Engine",
    "Generated",
    "Level",
    "Options",
    "SingularArm",
    "Trigonometry",
    "check_languages",
    "generate",
    "program",
]


@dataclass(frozen=True, slots=True)
class Generated:
    """The kernels of a robot: programs and their interfaces, counts, and texts on request."""

    unit: Unit
    options: Options
    counts: dict[str, Count]
    prunings: dict[str, Pruning] = field(default_factory=dict)

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
        check_languages(languages)
        return render(self.unit, languages)


def generate(
    robot: Robot,
    options: Options | None = None,
    *,
    progress: Callable[[str], None] | None = None,
    pruning: Callable[[str], None] | None = None,
) -> Generated:
    """The kernels of ``robot``; ``progress`` is told each function before it is built, ``pruning`` how far
    that is.

    Raises
    ------
    InputError: a constant of the model does not fit the scalar type, or an option is unknown.
    """
    options = options or Options()
    drafts = Drafts(robot, options, pruning)
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
        notes=_notes(drafts)
        + notes_of(tuple(drafts.prunings.values()))
        + (("sc is not read: there is no angle.",) if no_angle else ()),
    )
    return Generated(unit, options, {f: count(p) for f, p in programs.items()}, drafts.prunings)


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


def _notes(drafts: Drafts) -> tuple[str, ...]:
    if not drafts.taken:
        return _method(drafts.choice)
    told: dict[str, list[str]] = {}
    for function, found in drafts.taken.items():
        told.setdefault(found, []).append(function)
    return _method(drafts.choice) + tuple(
        f"Of {', '.join(functions)} the best program known for these parameters, equal to the recursion "
        f"without being written like it: {found}."
        for found, functions in told.items()
    )


def _method(choice: Choice) -> tuple[str, ...]:
    method = f"Formulation: {_TITLES[choice.formulation]} in modified Denavit-Hartenberg frames"
    if choice.regroup:
        method += (
            ", on base parameters: fc and nc act at and about the frame's origin, and what of a link's mass "
            "makes no difference is moved to its parent"
        )
    return (method + ".",)
