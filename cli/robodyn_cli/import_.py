"""``robodyn import``: a description out of URDF, MJCF, SDF or xacro."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from robodyn_cli.choices import FILE
from robodyn_cli.decorators import flag, option
from robodyn_cli.file_options import file_options
from robodyn_cli.log_files import spare_inputs
from robodyn_cli.output import as_json, echo_json, talk
from robodyn_cli.output_files import FORCE_FILE, new_file, write_or_echo
from robodyn_cli.values import Parameter, Point, unique

if TYPE_CHECKING:
    from robodyn.formats.arm import Imported


@click.command()
@click.argument("file", type=FILE, metavar="FILE")
@option("--base=LINK", "Link that is fixed; default: the root.", default="", show_default=False)
@option("--tip=LINK", "Link at the end; default: the only one there is.", default="", show_default=False)
@option(
    "--lock=JOINT=VALUE", "Fix a joint at a position (rad or m); may be repeated.", Parameter(), multiple=True
)
@file_options
@option(
    "--snap=RAD",
    "Make angles of axes within RAD of a multiple of pi/2 exactly that, at most 0.01.",
    click.FloatRange(0, 0.01),
    default=0.0,
    show_default=False,
)
@option(
    "--gravity=X,Y,Z",
    "Gravity in the file's root frame, m/s^2; default: what the file says, else 0,0,-9.81.",
    Point(),
)
@option("--name=NAME", "Name of the robot; default: the one in the file.", default="", show_default=False)
@flag("--strict", "Refuse inertias that no body has.")
@option("-o --output=ARM.yaml", "Output file; default: stdout.", FILE)
@flag("--force", FORCE_FILE)
def command(file: str, snap: float, output: str | None, force: bool, **options: Any) -> None:
    """Import a serial arm from URDF, MJCF, SDF or xacro as a description.

    Fixed joints are merged. Links beside the chain are locked, at 0 or as --lock says, and lumped into the
    links that carry them. Torques and poses are those of the file, in its joint coordinates. What the file
    says and the description does not hold is listed at the head of the YAML and on stderr.
    """
    from robodyn.formats.arm import description_text, import_arm
    from robodyn.robot.masses import unknown_masses

    path = None if output in (None, "-") else new_file(str(output), force=force)
    if path is not None:
        spare_inputs([path], [file])
    options |= {
        "locks": unique(options.pop("lock"), "--lock"), "arguments": unique(options.pop("arg"), "--arg"),
        "model": options.pop("file_model"), "without": options.pop("left_out"),
    }  # fmt: skip
    imported = import_arm(file, snap=snap, **options)
    text = description_text(imported)
    for where, words in imported.implausible:
        talk(f"robodyn: warning: {where}: {words}")
    assert imported.robot.account is not None
    for line in imported.robot.account.lines():
        talk(f"robodyn: note: {imported.file}: {line}")
    if imported.near and not unknown_masses(imported.robot):
        _tell_angles(imported, import_arm(file, snap=_widest(imported), **options))
    write_or_echo(text, path, force=force, joints=imported.robot.n)
    if as_json():
        echo_json(_data(imported, str(path) if path else None, text))


def _widest(imported: Imported) -> float:
    """The power of ten [rad] that snaps all angles that were reported."""
    import math

    return float(10.0 ** math.ceil(math.log10(max(abs(angle.error) for angle in imported.near))))


def _tell_angles(imported: Imported, snapped: Imported) -> None:
    """Say which angles are nearly multiples of pi/2, and what snapping them saves."""
    from robodyn.kernels.robot_kernel import count

    before, after = count(imported.robot).total, count(snapped.robot).total
    if after < before:
        error = max(abs(angle.error) for angle in imported.near)
        many, first = len(imported.near) > 1, imported.near[0].where
        talk(
            f"robodyn: note: {len(imported.near)} angle{'s are multiples' if many else ' is a multiple'} of "
            f"pi/2 but for {error:.1e} rad{', such as' if many else ':'} {first}; with --snap "
            f"{_widest(imported):g} the inverse dynamics takes {after} operations, not {before}"
        )


def _data(imported: Imported, path: str | None, text: str) -> dict[str, Any]:
    from robodyn.robot.account import account_to_dict

    robot = imported.robot
    return {
        "name": robot.name, "file": imported.file, "format": imported.format,
        "joints": [link.name for link in robot.links], "path": path, "remarks": list(imported.remarks),
        "unused": [
            {"what": part.what, "file": part.file, "lines": list(part.lines)} for part in imported.unused
        ],
        "warnings": [{"where": str(where), "what": words} for where, words in imported.warnings],
        "implausible": [{"where": str(where), "what": words} for where, words in imported.implausible],
        "near_right_angles": [
            {"where": angle.where, "value": angle.radians, "quarter_turns": angle.quarter}
            for angle in imported.near
        ],
        "text": text, "account": [account_to_dict(robot)],
    }  # fmt: skip
