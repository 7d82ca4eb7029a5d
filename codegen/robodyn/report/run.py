"""A simulated run in words, figures and pictures: what each joint did, and what there is to doubt."""

from __future__ import annotations

import io
from collections.abc import Mapping
from typing import Any, Final

import numpy as np

from robodyn.draw import style
from robodyn.draw.tables import aligned
from robodyn.logs.log import Log
from robodyn.report.figures import UNITS
from robodyn.robot.model import Robot
from robodyn.simulate.simulation import Simulation
from robodyn.simulate.trajectories.trajectory import Trajectory
from robodyn.tools.libraries import MATPLOTLIB

#: Energies below this share of what is stored, or below as many J, are rounding.
_ROUNDING = 1e-12
#: A joint that is to stand still may be so far off [rad or m].
_NOTHING = 0.02


def joint_rows(run: Simulation, reference: Trajectory | None = None) -> list[dict[str, Any]]:
    """What each joint did, SI units.

    ``lowest``, ``highest`` and ``peak_speed`` are the link's; torques as the drive gave them; ``stuck`` the
    share of samples at which dry friction holds the joint (None where there is none, or it is smoothed);
    ``limited`` the share at which the drive gave less than was commanded; ``peak_error`` how far the encoder
    was from ``reference`` (None without).
    """
    record, system = run.record, run.plant.system
    errors: Any = [None] * run.plant.robot.n
    if reference is not None:
        q, _, _ = reference.at(np.minimum(run.t, reference.duration))
        errors = np.abs(record.y[:, list(system.encoders)] - q).max(axis=0).tolist()
    rows = []
    for j, link in enumerate(run.plant.robot.links):
        places = [element.what.split() for element in system.elements]
        elements = [k for k, place in enumerate(places) if place[0] != "pair" and int(place[1]) == j + 1]
        applied = run.applied[:, j]
        rows.append(
            {
                "joint": j + 1,
                "kind": link.joint.kind,
                "lowest": float(run.q[:, j].min()),
                "highest": float(run.q[:, j].max()),
                "peak_speed": float(np.abs(run.qd[:, j]).max()),
                "peak_torque": float(np.abs(applied).max()),
                "rms_torque": float(np.sqrt(np.mean(applied**2))),
                "stuck": float(np.mean((record.s[:, elements] == 0).any(axis=1))) if elements else None,
                "limited": float(np.mean(applied != run.command[:, j])),
                "peak_error": errors[j],
            }
        )
    return rows


def to_text(summary: Mapping[str, Any]) -> list[str]:
    """Lines for what ``robodyn simulate --json`` prints: files, solver, energies, and a row a joint."""
    solver, energy, drive = summary["solver"], summary["energy"], summary["drive"]
    files = [path if path.isprintable() else ascii(path) for path in summary["files"]]
    lines = [f"{summary['robot']}: wrote {', '.join(files)}"] if files else []
    lines.append(
        f"{summary['duration']:g} s, {summary['samples']} samples at {summary['rate']:g} Hz; "
        f"{solver['method']}: {solver['steps']} steps, {solver['rejected']} rejected, "
        f"{solver['evaluations']} evaluations, {solver['events']} events"
    )
    if "kp" in drive:
        gains = (f"{key} {', '.join(f'{x:.4g}' for x in drive[key])}" for key in ("kp", "kd"))
        lines.append(f"{drive['controller']} at {drive['control_rate']:g} Hz: {'; '.join(gains)}")
    energies = {key: energy[key] for key in ("stored", "work", "loss")}
    floor = _ROUNDING * max(map(abs, energies.values()))
    figures = ", ".join(f"{key} {0.0 if abs(x) <= floor else x:.6g} J" for key, x in energies.items())
    lines.append(f"energy: {figures}; the balance is off by {energy['error']:.1e} of the largest")
    rows = [["joint", "lowest", "highest", "peak speed", "peak torque", "rms torque", "stuck", "peak error"]]
    for row in summary["joints"]:
        unit, force = (UNITS[row["kind"]][name] for name in ("position", "torque"))
        columns = {"lowest": unit, "highest": unit, "peak_speed": f"{unit}/s", "peak_torque": force}
        cells = [f"{row[key]:.4g} {unit}" for key, unit in (columns | {"rms_torque": force}).items()]
        stuck = "-" if row["stuck"] is None else f"{100 * row['stuck']:.3g} %"
        error = "-" if row["peak_error"] is None else f"{row['peak_error']:.2g} {unit}"
        rows.append([str(row["joint"]), *cells, stuck, error])
    return lines + aligned(rows)


def warnings_of(run: Simulation, balanced: float, reference: Trajectory | None = None) -> list[str]:
    """What about ``run`` a reader should know: energies off by more than the share ``balanced``, joints that
    run away from their ``reference``, drives at their limits, torques above what the description allows."""
    followed, limited = [], []
    for j, row in enumerate(joint_rows(run, reference)):
        way = 0.0 if reference is None else float(np.ptp(reference.q[:, j]))
        if row["peak_error"] is not None and row["peak_error"] > max(way, _NOTHING):
            followed.append(
                f"joint {j + 1} is up to {row['peak_error']:.3g} away from its reference, which moves by "
                f"{way:.3g}: the controller does not hold it; give --kp and --kd"
            )
        if row["limited"]:
            share = f"{100 * row['limited']:.3g} %"
            limited.append(f"the drive of joint {j + 1} is at its limit {share} of the time")
        limit, peak = run.plant.robot.links[j].joint.limits.torque, row["peak_torque"]
        if limit is not None and peak > float(limit) * (1 + 1e-9):
            text = f"{peak:.4g} {UNITS[row['kind']]['torque']}, more than its limit of {float(limit):.4g}"
            limited.append(f"joint {j + 1} takes {text}")
    balance = run.balance()
    rounding = _ROUNDING * max(1.0, float(np.abs(balance.kinetic + balance.potential).max()))
    if balance.error > balanced and float(np.abs(balance.residual).max()) > rounding:
        followed.append(
            f"the energies do not balance: off by {balance.error:.2g} of the largest, more than "
            f"{balanced:g}; take a shorter --step, or --solver adaptive with a smaller --rtol"
        )
    return followed + limited


# --- the picture of a motion ------------------------------------------------------------------------------

#: Points of a line at most.
POINTS: Final = 2000
#: Sizes in px: a panel, what is between panels, and the margins of the picture.
_PANEL, _BETWEEN = (290, 84), (70, 22)
_LEFT, _RIGHT, _TOP, _BOTTOM = 118, 20, 84, 52
#: What is left of the panels where joints of both kinds have their units there.
_LEFT_MIXED: Final = 178


def motion_picture(robot: Robot, log: Log, kind: str, reference: Trajectory | None = None) -> bytes:
    """The picture of ``log`` as ``kind`` svg or png, the same bytes for the same log: a row a joint with its
    position, velocity and torque over time.

    Each panel has a scale of its own; the positions of ``reference`` are dashed. A log without velocities
    gets no velocities.

    Raises
    ------
    ToolError: matplotlib is missing.
    """
    figures, styles = MATPLOTLIB.load("figure"), MATPLOTLIB.load("style")
    columns = {"position": log.q, "velocity": log.qd, "torque": log.tau}
    shown = {name: values for name, values in columns.items() if values is not None}
    left = _LEFT if len({link.joint.kind for link in robot.links}) == 1 else _LEFT_MIXED
    width = left + len(shown) * (_PANEL[0] + _BETWEEN[0]) - _BETWEEN[0] + _RIGHT
    height = _TOP + robot.n * (_PANEL[1] + _BETWEEN[1]) - _BETWEEN[1] + _BOTTOM
    with styles.context(["default", style.matplotlib_settings()]):
        figure = figures.Figure(figsize=[style.PX * width, style.PX * height])
        grid = figure.add_gridspec(
            robot.n, len(shown), left=left / width, right=1 - _RIGHT / width,
            top=1 - _TOP / height, bottom=_BOTTOM / height,
            wspace=_BETWEEN[0] / _PANEL[0], hspace=_BETWEEN[1] / _PANEL[1],
        )  # fmt: skip
        axes = grid.subplots(sharex=True, squeeze=False)
        _label(figure, axes, robot, list(shown), left, reference is not None)
        for j in range(robot.n):
            for panel, (name, values) in zip(axes[j], shown.items(), strict=True):
                if name == "position" and reference is not None:
                    (line,) = _plot(panel, reference.t, reference.q[:, j], style.VERMILION)
                    line.set(dashes=(4, 2), zorder=3)
                _plot(panel, log.t, values[:, j], style.BLUE)
                panel.margins(x=0)
                panel.locator_params(axis="y", nbins=4, min_n_ticks=3)
        stream = io.BytesIO()
        metadata = {"Date": None} if kind == "svg" else {"Software": None}
        figure.savefig(stream, format=kind, metadata=metadata, dpi=1.25 / style.PX)
    return stream.getvalue()


def _plot(panel: Any, t: Any, values: Any, colour: str) -> Any:
    """The line of :data:`POINTS` samples at most, first and last among them."""
    places = np.unique(np.linspace(0, len(t) - 1, min(len(t), POINTS)).astype(int))
    return panel.plot(t[places], values[places], color=colour)


def _label(figure: Any, axes: Any, robot: Robot, names: list[str], left: int, followed: bool) -> None:
    """Title, what each column and each row is, units and time."""
    high = figure.get_figheight()
    x, right = style.PX * 16 / figure.get_figwidth(), 1 - style.PX * _RIGHT / figure.get_figwidth()
    title = (robot.title or robot.name).replace("$", r"\$")  # $ begins a formula
    figure.suptitle(title, x=x, y=1 - style.PX * 14 / high, ha="left", va="top")
    if followed:
        looks = {"size": style.POINT * style.TEXT, "color": style.SOFT, "ha": "right", "va": "top"}
        figure.text(right, 1 - style.PX * 18 / high, "dashed: the reference", **looks)
    kinds = {link.joint.kind for link in robot.links}
    for panel, name in zip(axes[0], names, strict=True):
        what = "torque, force" if name == "torque" and "prismatic" in kinds else name
        unit = f" [{UNITS[next(iter(kinds))][name]}]" if len(kinds) == 1 else ""
        panel.set_title(f"{what}{unit}", pad=style.POINT * 12)
    for j, link in enumerate(robot.links):
        units = ", ".join(UNITS[link.joint.kind][name] for name in names)
        text = f"joint {j + 1}" if len(kinds) == 1 else f"joint {j + 1}\n[{units}]"
        axes[j][0].set_ylabel(text, rotation=0, ha="left", va="center", color=style.INK)
        axes[j][0].yaxis.set_label_coords((16 - left) / _PANEL[0], 0.5)
    for panel in axes[-1]:
        panel.set_xlabel("t [s]")
