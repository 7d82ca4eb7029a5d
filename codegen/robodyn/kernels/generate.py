"""From a robot to its kernels: builds the programs, runs the passes, counts, and hands over the files.

>>> made = generate(load("puma560"))                             # doctest: +SKIP
>>> made.counts["inverse_dynamics"].total
>>> made.files()                                                 # {"puma560.h": ..., ...}
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from os import PathLike
from typing import TYPE_CHECKING, Any

from robodyn.counts import Count, count
from robodyn.dynamics.functions import NoSuchFunction, emitted_name, function_named
from robodyn.emit import Unit, render
from robodyn.emit.languages import languages_named, require
from robodyn.formats.loading import robot_of
from robodyn.ir.program import Program, rarely_collected
from robodyn.ir.signature import Signature
from robodyn.kernels.options import CHOSEN, TRIGONOMETRY, Engine, Level, Options
from robodyn.kernels.rigid_programs import RigidPrograms, SingularArm
from robodyn.optimize.programs import FORMULATIONS, Choice, NoForwardDynamics, base_set_of, signature
from robodyn.passes.order import angles_first, arctangents_together
from robodyn.passes.registers import registers
from robodyn.passes.trig_given import describe, given_layout, trig_given
from robodyn.robot.model import Robot

if TYPE_CHECKING:
    from robodyn.kernels.coupled import Coupled
    from robodyn.kernels.layered import Layered
    from robodyn.optimize.prune import Pruning

__all__ = [
    "CHOSEN", "TRIGONOMETRY", "Engine", "Generated", "Level", "NoForwardDynamics", "Options", "SingularArm",
    "generate", "maker", "program",
]  # fmt: skip


@dataclass(frozen=True, slots=True)
class Generated:
    """The kernels of a robot: programs and their interfaces, counts, and texts on request."""

    unit: Unit
    options: Options
    counts: dict[str, Count]
    prunings: dict[str, Pruning] = field(default_factory=dict)
    #: Of fused functions the operations of their parts, each in a function of its own.
    alone: dict[str, tuple[Count, ...]] = field(default_factory=dict)
    #: Functions that the robot does not have, and why.
    left_out: dict[str, str] = field(default_factory=dict)
    #: Of a robot with effects: the operations of the rigid arm alone.
    rigid_counts: dict[str, Count | None] = field(default_factory=dict)

    @property
    def zeros(self) -> dict[str, dict[str, tuple[int, ...]]]:
        """By function and result the elements (from 0, row by row) that are 0 at every state."""
        return {interface.function: program.zeros() for interface, program in self.unit.functions}

    @property
    def signatures(self) -> tuple[Signature, ...]:
        """Interfaces of the functions, in order."""
        return tuple(interface for interface, _ in self.unit.functions)

    def base_parameters(self) -> dict[str, Any]:
        """What the columns of a regressor are, as JSON has it; nothing without base parameters."""
        if not any(signature.columns for signature in self.signatures):
            return {}
        return {"base_parameters": [parameter.to_dict() for parameter in base_set_of(self.unit.robot)]}

    @rarely_collected()
    def files(self, languages: Sequence[str] | None = None, *, batch: bool = False) -> dict[str, str]:
        """The files in ``languages`` (default: C and Fortran): text by file name;
        with ``batch`` those of batches too. Writes nothing.

        Raises
        ------
        InputError: there is no such language, or none of them has what is asked for.
        """
        chosen = languages_named(languages)
        for language in chosen:
            language.check(self.options.scalar, self.options.trig, self.signatures)
        if self.unit.misra:
            require("misra", "MISRA C:2012 is", chosen)
        if batch:
            require("batch", "batches are", chosen)
        names = tuple(language.name for language in chosen)
        files = render(self.unit, names)
        for language in chosen:
            if batch and language.batch is not None:
                files.update(language.batch(self.unit))
        return files


@rarely_collected()
def generate(
    robot: Robot | str | PathLike[str],
    options: Options | None = None,
    *,
    progress: Callable[[str], None] | None = None,
    pruning: Callable[[str], None] | None = None,
) -> Generated:
    """The kernels of ``robot`` (or of that path or name); ``progress`` is told each function before it is
    built, ``pruning`` how far that is.

    Raises
    ------
    InputError: a constant of the model does not fit the scalar type, or an option is unknown.
    """
    robot, options = robot_of(robot), options or Options()
    builder = maker(robot, options, pruning)
    drafts = builder if isinstance(builder, RigidPrograms) else builder.rigid
    programs: dict[str, Program] = {}
    left_out: dict[str, str] = {}
    for function in options.function_names:
        if progress is not None:
            progress(function)
        try:
            programs[function] = builder.program(function)
        except NoSuchFunction as reason:
            if options.insists_on(function):
                raise
            left_out[function] = (reason.found or reason.what).partition(":")[0]
    interfaces = {
        f: replace(signature(robot, f, options.scalar), alias=emitted_name(f, tuple(programs)))
        for f in programs
    }
    described: tuple[str, ...] = ()
    no_angle = False
    if options.trig == "given":
        for f in [f for f, p in programs.items() if p.iteration is not None]:
            if options.insists_on(f) or len(programs) == 1:
                programs[f].straight("given sines and cosines (--trig given) are")
            left_out[f] = "it repeats a step, whose angles are not given"
            del programs[f], interfaces[f]
        layout = given_layout(list(programs.values()))
        no_angle = not layout  # C has no array of no elements: sc has one then
        described = tuple(describe(angle) for angle in layout)
        programs = {f: trig_given(p, layout) for f, p in programs.items()}
        size = max(1, len(layout))
        for f, interface in interfaces.items():
            inputs = tuple(("sc", size) if array[0] == "q" else array for array in interface.inputs)
            interfaces[f] = replace(interface, inputs=inputs)
    if options.trig == "builtin":
        programs = {f: p.changed(angles_first) for f, p in programs.items()}
    if options.by_registers:
        allocate = partial(registers, available=options.profile.registers) if options.profile else registers
        programs = {f: p.changed(allocate) for f, p in programs.items()}
    if options.trig == "builtin":
        programs = {f: p.changed(arctangents_together) for f, p in programs.items()}
    pruned: tuple[str, ...] = ()
    if drafts.prunings:
        from robodyn.optimize.prune import notes_of

        pruned = notes_of(tuple(drafts.prunings.values()))
    target = options.profile
    target_note = None
    if target is not None:
        flags = target.compiled(options.contraction or "off")
        target_note = f"Target: {target.name} ({target.why}); compile C with {flags}."
    unit = Unit(
        robot=robot,
        functions=tuple((interfaces[f], programs[f]) for f in programs),
        sc=described,
        notes=_notes(drafts, programs)
        + (() if isinstance(builder, RigidPrograms) else builder.notes)
        + pruned
        + (("sc is not read: there is no angle.",) if no_angle else ())
        + _columns(tuple(interfaces.values())),
        target=target_note,
        options=options.text,
        misra=options.misra,
        readable=options.readable,
        builtin=options.trig == "builtin",
        early_writes=options.by_registers,
        contraction=options.contraction or ("off" if options.trig == "builtin" else None),
        lanes=4 if options.profile is None else options.profile.lanes,
    )
    alone = {
        f: tuple(count(builder.program(part.name)) for part in function_named(f).fuses)
        for f in programs
        if function_named(f).fuses
    }
    counts = {f: count(p) for f, p in programs.items()}
    rigid = {f: builder.rigid_count(f) for f in programs}
    return Generated(unit, options, counts, drafts.prunings, alone, left_out, rigid)


def maker(
    robot: Robot, options: Options, pruning: Callable[[str], None] | None = None
) -> RigidPrograms | Layered | Coupled:
    """What makes the programs of ``robot``: the recursion, or the recursion beneath its effects."""
    if robot.couplings:
        from robodyn.kernels.coupled import Coupled

        return Coupled(robot, options)
    if robot.effects:
        from robodyn.drives.drive import has_drive_effects, rigid_part

        if has_drive_effects(robot):
            from robodyn.kernels.layered import Layered

            return Layered(robot, options)
        robot = rigid_part(robot)  # what sensors do is in no kernel, and no reason to miss a record
    return RigidPrograms(robot, options, pruning)


@rarely_collected()
def program(robot: Robot | str | PathLike[str], function: str, options: Options | None = None) -> Program:
    """The optimised program of one function of ``robot`` (or of that path or name), with its effects.

    Raises
    ------
    InputError: there is no such robot or function.
    NoForwardDynamics: there is none.
    """
    return maker(robot_of(robot), options or Options()).program(function)


def _notes(drafts: RigidPrograms, functions: Iterable[str]) -> tuple[str, ...]:
    """What the head of the files says of how the programs were built."""
    if all(function_named(function).geometric for function in functions):
        return ()  # they are of no formulation of the dynamics
    if not drafts.taken:
        return _method(drafts.choice)
    notes: dict[str, list[str]] = {}
    for function, record in drafts.taken.items():
        notes.setdefault(record, []).append(function)
    return _method(drafts.choice) + tuple(
        f"Of {', '.join(functions)} the best program known for these parameters, equal to the recursion "
        f"without being written like it: {record}."
        for record, functions in notes.items()
    )


def _columns(interfaces: Sequence[Signature]) -> tuple[str, ...]:
    """What the head of the files says of base parameters."""
    columns = next((interface.columns for interface in interfaces if interface.columns), ())
    if not columns:
        return ()
    return (
        "Base parameters, from masses m, first moments mx my mz and second moments Kxx .. Kyz of the links "
        "about the origins of their frames (inertia: xx = Kyy + Kzz, xy = -Kxy ...), rotors and friction:",
        *(f"  {k}: {text}" for k, text in enumerate(columns, 1)),
    )


def _method(choice: Choice) -> tuple[str, ...]:
    method = f"Formulation: {FORMULATIONS[choice.formulation]} in modified Denavit-Hartenberg frames"
    if choice.regroup:
        method += (
            ", on base parameters: fc and nc act at and about the frame's origin, and what of a link's mass "
            "makes no difference is moved to its parent"
        )
    return (method + ".",)
