"""``robodyn verify``: compare the compiled kernels with independent references."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import click

from robodyn.errors import CheckError, InputError
from robodyn_cli.choices import FILE, TRIGONOMETRY
from robodyn_cli.decorators import option, robot_argument
from robodyn_cli.languages import compiled_language_option
from robodyn_cli.options import functions_option, listed, load, model_options, options_of, scalar_option
from robodyn_cli.output import show, wrapped
from robodyn_cli.values import Parameter, unique

if TYPE_CHECKING:
    from robodyn.kernels.generate import Generated
    from robodyn.robot import Robot
    from robodyn.verify.against.arm import PeerArm
    from robodyn.verify.report import VerifyReport


@click.command()
@robot_argument
@option("--states", "Number of states.", click.IntRange(1, 1_000_000), default=200)
@option("--seed", "Seed of the sample.", click.IntRange(min=0), default=0)
@scalar_option
@option("--trig=HOW", "Sine and cosine: libm or builtin.", TRIGONOMETRY, default="libm")
@compiled_language_option
@functions_option()
@option(
    "--against=FILE",
    "Compare with the URDF, xacro or MJCF file that ROBOT comes from, as Pinocchio or MuJoCo reads it.",
    FILE,
)
@option(
    "--lock=JOINT=VALUE",
    "With --against: position of a joint of FILE that ROBOT does not have, as in robodyn import.",
    Parameter(),
    multiple=True,
)
@model_options
def command(robot: str, functions: str | None, **options: Any) -> None:
    """Compare the compiled kernels with independent references.

    The programs must equal plain Newton-Euler in exact fractions. Programs of inverse kinematics must
    reproduce the pose to 60 digits in plain forward kinematics. Compiled kernels are compared with plain
    Newton-Euler in double, with exact torques and, for up to three joints, with the Lagrangian. Solutions of
    inverse kinematics are compared with plain forward kinematics. Prints the largest error and the state
    where it occurs. Errors are relative to the largest torque, those of poses to the arm's reach. Exits with
    1 if an error exceeds 1e-10 (float: 1e-5).

    With --against another library reads FILE: MuJoCo an MJCF, Pinocchio a URDF or an expanded xacro file. Its
    torques, mass matrix, motion of the links, tool frame and gear ratios are compared; joints are matched by
    name. What the library does not model is listed and not compared.
    """
    from robodyn.emit.languages import compiled_language
    from robodyn.kernels.generate import generate
    from robodyn.kernels.kernel import load as load_kernel
    from robodyn.verify import verify
    from robodyn.verify.against import comparable, with_original
    from robodyn_cli.progress import line

    lang = compiled_language(options["lang"])[0].name
    if options["trig"] == "given":
        raise InputError("a kernel with --trig given has no angles to verify", expected="libm or builtin")
    names = None if functions is None else listed(functions)
    model = load(robot, strict=options["strict"])
    original = _original(model, options["against"], unique(options["lock"], "--lock"))
    left_out: dict[str, str] = {}
    if original is not None:
        model, left_out = comparable(model, original)
        if model.couplings:
            left_out["couplings"] = f"{original.title} is asked for the file's joints, each moving by itself"
    generated = generate(model, options_of(names, options, trig=options["trig"], scalar=options["scalar"]))
    kernel = load_kernel(generated.signatures, generated.files((lang,)), language=lang)
    exact, poses = _equal_on_fractions(generated), _reproduce_poses(generated)
    sample = {name: options[name] for name in ("states", "seed")}
    with line() as shown:

        def tell(done: int, of: int) -> None:
            shown.tell(f"robodyn: {model.name}: {done} of {of} comparisons")

        report = verify(model, kernel, progress=tell, original=original, **sample)
    if original is not None:
        report = with_original(report, model.free, original, left_out)
    passed = report.passed and all(exact.values()) and all(poses.values())
    proofs = {"equal_on_fractions": exact, "closing_to_60_digits": poses}
    show(
        lambda: {**report.to_dict(), **proofs, "passed": passed},
        lambda: _lines(report, exact, poses),
    )
    if report.uncompared:
        raise CheckError(
            f"{model.name}: not every function was compared with a reference",
            found=f"nothing to compare {', '.join(report.uncompared)} with",
        )
    if not passed:
        raise CheckError(
            f"{model.name}: the kernel does not agree with the references",
            found=_largest_difference(report, model),
        )


def _lines(report: VerifyReport, exact: dict[str, bool], poses: dict[str, bool]) -> Iterator[str]:
    """The report for people."""
    from robodyn.dynamics.functions import function_named

    yield report.to_text()
    if report.worst is not None:
        state = "; ".join(f"{name} = {list(x)}" for name, x in report.worst.to_dict()["inputs"].items())
        yield from wrapped(f"the largest error occurs at {state}")
    for function, equal in exact.items():
        plain = "products of transforms" if function_named(function).geometric else "plain Newton-Euler"
        yield f"{function}: {'equal to' if equal else 'NOT EQUAL to'} {plain} on fractions"
    for function, right in poses.items():
        verb = "leads" if right else "DOES NOT LEAD"
        yield f"{function}: {verb} back to the pose in plain forward kinematics, at 60 digits"


def _original(robot: Robot, file: str | None, locks: dict[str, float]) -> PeerArm | None:
    """The joints of ``robot`` as another library reads them from ``file``; None without a file."""
    from pathlib import Path

    from robodyn.verify.against import read_original

    if file is not None:
        return read_original(Path(file)).arm(robot, locks)
    if locks:
        raise InputError("--lock is for --against FILE", remedy="remove it, or add --against FILE")
    return None


def _largest_difference(report: VerifyReport, robot: Robot) -> str | None:
    """The largest difference, its joint, and how many other comparisons fail."""
    row, count = report.worst, sum(not row.passed for row in report.comparisons)
    if row is None or not count:
        return None
    joint = "" if row.joint is None else f", most at joint {row.joint} ({robot.links[row.joint - 1].name})"
    more = f"; {count - 1} more rows differ" if count > 1 else ""
    return f"{row.function} differs from {row.against} by {row.error:.1e}{joint}{more}"


def _equal_on_fractions(generated: Generated) -> dict[str, bool]:
    from robodyn.dynamics.equality import equals_recursion
    from robodyn.dynamics.functions import function_named

    robot = generated.unit.robot
    smooth = robot.rest_velocity is not None and any(link.joint.coulomb for link in robot.links)
    if smooth or robot.couplings or not all(entry.definition.traits.body for entry in robot.effects):
        return {}  # tanh, roots and sines of parts of an angle have no exact values
    return {
        interface.function: equals_recursion(robot, interface.function, program)
        for interface, program in generated.unit.functions
        if not function_named(interface.function).of_pose
        and not any(operation.op in ("sqrt", "exp") for operation in program.operations)
    }


def _reproduce_poses(generated: Generated) -> dict[str, bool]:
    from robodyn.dynamics.functions import function_named
    from robodyn.kernels.proof import closes

    return {
        interface.function: closes(generated.unit.robot, interface.function, program, interface.scalar)
        for interface, program in generated.unit.functions
        if function_named(interface.function).of_pose
    }
