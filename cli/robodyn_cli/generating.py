"""The kernels that the options of ``gen`` ask for: for ``gen`` itself, and for each robot of a project."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import click

from robodyn_cli.code_options import tolerance
from robodyn_cli.counted import record
from robodyn_cli.decorators import at_most_one
from robodyn_cli.firmware import for_firmware
from robodyn_cli.languages import chosen_languages, tests_of, trig_for
from robodyn_cli.options import listed, load, options_of, with_fused
from robodyn_cli.output import talk
from robodyn_cli.progress import messages
from robodyn_cli.searching import Search

if TYPE_CHECKING:
    from robodyn.kernels.generate import Generated, Options
    from robodyn.robot import Robot


@dataclass(frozen=True, slots=True)
class Kernels:
    """Kernels of a ``robot``, by the ``options`` that were asked for, for ``languages``."""

    robot: Robot
    options: Options
    languages: tuple[str, ...]
    generated: Generated

    def record(self, function: str) -> dict[str, Any]:
        """The count of a ``function`` as ``--json`` prints it."""
        generated = self.generated
        rigid, pruning = generated.rigid_counts.get(function), generated.prunings.get(function)
        count, formulation = generated.counts[function], self.options.formulation
        return record(self.robot, function, formulation, count, rigid, pruning)

    def files(self, *, batch: bool, latex: bool) -> dict[str, str]:
        """Text by file name; with notes on stderr about what cannot be written."""
        files = {
            **self.generated.files(self.languages, batch=batch),
            **tests_of(self.generated, self.languages),
        }
        if batch:
            for interface in self.generated.signatures:
                if interface.states:
                    talk(f"robodyn: note: no batch of {interface.function}, which is stateful")
        if latex:
            files[f"{self.robot.name}.tex"] = _typeset(self.robot, self.options.formulation)
        return files


def kernels(robot: str, **options: Any) -> Kernels:
    """The kernels of the description ``robot`` with the ``options`` of ``gen``, in the current context of
    click. ``derivatives``: with what has those of the functions, as far as the robot has it.

    Raises
    ------
    RobodynError: options that do not go together, or a description that cannot be read.
    """
    from robodyn.kernels.generate import generate

    settings = SimpleNamespace(**{"derivatives": False, "on": None, "seeds": None, **options})
    compiled, firmware = options.get("compile_", False), options.get("firmware", False)
    languages = chosen_languages(settings.lang, compiled=compiled)
    if settings.readable:
        _check_readable(settings)
        settings.optimize, settings.order = "none", "recursion"
    settings.trig = trig_for(languages, settings.trig)
    target = None if firmware else settings.target
    chosen = {
        name: getattr(settings, name)
        for name in ("scalar", "trig", "order", "contraction", "objective")
        if target is None or _is_on_command_line(name) or (name == "order" and settings.readable)
    }  # the others are the target's
    functions = with_fused(
        settings.functions and listed(settings.functions), settings.fuse, wrench=settings.wrench
    )
    plain = {name: getattr(settings, name) for name in ("misra", "readable", "derivatives")}
    kernel_options = options_of(
        functions, vars(settings), target=target, prune=tolerance(settings.prune), **plain, **chosen
    )
    if firmware:
        contracted = settings.contraction == "on"
        unfit = {
            "compile": compiled,
            "latex": settings.latex,
            "batch": settings.batch,
            "contraction on": contracted,
        }
        kernel_options = for_firmware(kernel_options, settings.target, **unfit)
    described = load(robot, strict=settings.strict)
    limits = {name: getattr(settings, name) for name in ("budget_seconds", "seed", "keep", "on", "seeds")}
    search = Search(objective=kernel_options.objective, **limits)
    kernel_options = search.applied(described, kernel_options, kernel_options.function_names)
    with messages() as tell:
        generated = generate(described, kernel_options, progress=_progress(described), pruning=tell)
    for function, reason in generated.left_out.items():
        talk(f"robodyn: note: {described.name} has no {function}: {reason}")
    return Kernels(described, kernel_options, languages, generated)


def _is_on_command_line(name: str) -> bool:
    source = click.get_current_context().get_parameter_source(name)
    return source is not click.core.ParameterSource.DEFAULT


def _check_readable(settings: SimpleNamespace) -> None:
    """Refuse what contradicts --readable."""
    for name, fitting in (("optimize", "none"), ("order", "recursion"), ("batch", False)):
        value = getattr(settings, name)
        spelled = f"--{name}" if value is True else f"--{name} {value}"
        at_most_one({"--readable": True, spelled: value != fitting and _is_on_command_line(name)})


#: From this number of joints on, the progress is shown.
_MANY = 12


def _progress(robot: Robot) -> Callable[[str], None] | None:
    """Progress messages for a long arm on a terminal; None otherwise."""
    if robot.n < _MANY or not sys.stderr.isatty():
        return None
    return lambda function: talk(f"robodyn: {function} of {robot.n} joints ...")


_RIGID = "the rigid arm only; robodyn effects --latex prints the equations of effects"


def _typeset(robot: Robot, formulation: str) -> str:
    """The recursion as LaTeX, under a head; for a robot with effects that of its rigid arm, with a note."""
    from robodyn.drives.drive import has_drive_effects, rigid_part
    from robodyn.emit.head import head_of
    from robodyn.kernels.through_sympy import symbolic
    from robodyn.optimize.programs import Choice

    described, notes = robot, []
    if has_drive_effects(robot):
        described, notes = rigid_part(robot), [_RIGID]
        talk(f"robodyn: note: {robot.name}.tex is {_RIGID}")
    head = "".join(f"% {line}\n" for line in head_of(robot, notes))
    return head + symbolic(described, choice=Choice(formulation, regroup=False)).latex()
