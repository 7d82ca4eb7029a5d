"""The kernels that the options of ``gen`` ask for: for ``gen`` itself, and for each robot of a project."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import click

from robodyn_cli.code_options import pruning_progress, tolerance
from robodyn_cli.common import talk
from robodyn_cli.firmware import for_firmware
from robodyn_cli.languages import chosen_languages, tests_of, trig_for
from robodyn_cli.options import kernel_options, listed, load, with_fused
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


def kernels(
    robot: str,
    *,
    lang: str | None,
    scalar: str,
    trig: str,
    batch: bool,
    order: str,
    contraction: str | None,
    target: str | None,
    functions: str | None,
    fuse: tuple[str, ...],
    wrench: bool,
    misra: bool,
    readable: bool,
    formulation: str,
    optimize: str,
    no_regroup: bool,
    engine: str,
    strict: bool,
    budget_seconds: float | None,
    seed: int,
    objective: str,
    keep: bool,
    prune: str | None,
    latex: bool,
    on: str | None = None,
    seeds: int | None = None,
    compiled: bool = False,
    firmware: bool = False,
    derivatives: bool = False,
) -> Kernels:
    """The kernels of the description ``robot`` with the options of ``gen`` in the current context of click;
    ``compiled``: for languages that can be called from here; ``derivatives``: with what has those of the
    functions, as far as the robot has it.

    Raises
    ------
    RobodynError: options that do not go together, or a description that cannot be read.
    """
    from robodyn.kernels.generate import generate

    languages = chosen_languages(lang, compiled=compiled)
    if readable:
        optimize, order = _in_the_books_order(optimize, order, batch=batch)
    options = kernel_options(
        None if firmware else target,
        {
            "scalar": scalar,
            "trig": trig_for(languages, trig),
            "order": order,
            "contraction": contraction,
            "objective": objective,
        },
        functions=with_fused(functions and listed(functions), fuse, wrench=wrench),
        formulation=formulation,
        optimize=optimize,
        regroup=not no_regroup,
        engine=engine,
        prune=tolerance(prune),
        misra=misra,
        readable=readable,
        derivatives=derivatives,
    )
    if firmware:
        unfit = {"compile": compiled, "latex": latex, "batch": batch, "contraction on": contraction == "on"}
        options = for_firmware(options, target, **unfit)
    described = load(robot, strict=strict)
    options = Search(budget_seconds, seed, options.objective, keep, on, seeds).applied(
        described, options, options.function_names
    )
    with pruning_progress() as tell:
        generated = generate(described, options, progress=_progress(described), pruning=tell)
    for function, reason in generated.left_out.items():
        talk(f"robodyn: note: {described.name} has no {function}: {reason}")
    return Kernels(described, options, languages, generated)


def _in_the_books_order(optimize: str, order: str, *, batch: bool) -> tuple[str, str]:
    """What --readable stands for, where the command line says nothing else; contradictions are refused."""
    from click.core import ParameterSource

    from robodyn.errors import InputError

    context = click.get_current_context()
    contradictions = [
        f"--{name} {value}"
        for name, value, fitting in (("optimize", optimize, "none"), ("order", order, "recursion"))
        if value != fitting and context.get_parameter_source(name) is not ParameterSource.DEFAULT
    ]
    if contradictions or batch:
        raise InputError(
            "--readable writes the recursion as it stands in the book, one state at a time",
            found=", ".join([*contradictions, *["--batch"] * batch]),
            expected="--optimize none and --order recursion, without --batch",
            remedy="remove --readable or what contradicts it",
        )
    return "none", "recursion"


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
    from robodyn.emit.lines import head_of
    from robodyn.kernels.through_sympy import symbolic
    from robodyn.optimize.programs import Choice

    described, notes = robot, []
    if has_drive_effects(robot):
        described, notes = rigid_part(robot), [_RIGID]
        talk(f"robodyn: note: {robot.name}.tex is {_RIGID}")
    head = "".join(f"% {line}\n" for line in head_of(robot, notes))
    return head + symbolic(described, choice=Choice(formulation, regroup=False)).latex()
