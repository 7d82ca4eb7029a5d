"""A simulated run in words and figures: what each joint did, and what there is to doubt."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from robodyn.report.figures import UNITS, aligned
from robodyn.simulate.simulation import Simulation
from robodyn.simulate.trajectories.trajectory import Trajectory

#: Energies below this share of what is stored, or below as many J, are rounding.
_ROUNDING = 1e-12
#: A joint that is to stand still may be so far off [rad or m].
_NOTHING = 0.02
_HEADS = ("joint", "lowest", "highest", "peak speed", "peak torque", "rms torque", "stuck", "peak error")


def joint_rows(run: Simulation, reference: Trajectory | None = None) -> list[dict[str, Any]]:
    """What each joint did, SI units.

    ``lowest``, ``highest`` and ``peak_speed`` are the link's; torques as the drive gave them; ``stuck`` the
    share of samples at which dry friction holds the joint (None where there is none, or it is smoothed);
    ``limited`` the share at which the drive gave less than was commanded; ``peak_error`` how far the encoder
    was from ``reference`` (None without).
    """
    record, system = run.record, run.plant.system
    error = None
    if reference is not None:
        q, _, _ = reference.at(np.minimum(run.t, reference.duration))
        error = np.abs(record.y[:, list(system.encoders)] - q).max(axis=0)
    rows = []
    for j, link in enumerate(run.plant.robot.links):
        elements = [
            k
            for k, element in enumerate(system.elements)
            if element.what.split()[0] != "pair" and int(element.what.split()[1]) == j + 1
        ]
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
                "peak_error": None if error is None else float(error[j]),
            }
        )
    return rows


def to_text(summary: Mapping[str, Any]) -> list[str]:
    """Lines for what ``robodyn simulate --json`` prints: files, solver, energies, and a row a joint."""
    solver, energy, drive = summary["solver"], summary["energy"], summary["drive"]
    name = summary["robot"]
    lines = [f"{name}: wrote {', '.join(map(repr_of, summary['files']))}"] if summary["files"] else []
    lines.append(
        f"{summary['duration']:g} s, {summary['samples']} samples at {summary['rate']:g} Hz; "
        f"{solver['method']}: {solver['steps']} steps, {solver['rejected']} rejected, "
        f"{solver['evaluations']} evaluations, "
        f"{solver['events']} events"
    )
    if "kp" in drive:
        gains = (f"{key} {', '.join(f'{x:.4g}' for x in drive[key])}" for key in ("kp", "kd"))
        lines.append(f"{drive['controller']} at {drive['control_rate']:g} Hz: {'; '.join(gains)}")
    floor = _ROUNDING * max(abs(energy[key]) for key in ("stored", "work", "loss"))
    stored, work, loss = (
        0.0 if abs(energy[key]) <= floor else energy[key] for key in ("stored", "work", "loss")
    )
    lines.append(
        f"energy: stored {stored:.6g} J, work {work:.6g} J, loss {loss:.6g} J; "
        f"the balance is off by {energy['error']:.1e} of the largest"
    )
    rows: list[Sequence[str]] = [_HEADS]
    for row in summary["joints"]:
        unit, force = (UNITS[row["kind"]][name] for name in ("position", "torque"))
        rows.append(
            (
                str(row["joint"]),
                f"{row['lowest']:.4g} {unit}",
                f"{row['highest']:.4g} {unit}",
                f"{row['peak_speed']:.4g} {unit}/s",
                f"{row['peak_torque']:.4g} {force}",
                f"{row['rms_torque']:.4g} {force}",
                "-" if row["stuck"] is None else f"{100 * row['stuck']:.3g} %",
                "-" if row["peak_error"] is None else f"{row['peak_error']:.2g} {unit}",
            )
        )
    return lines + aligned(rows)


def repr_of(path: str) -> str:
    """``path`` for a line of text: what a terminal does not print is escaped."""
    return path if path.isprintable() else ascii(path)


def warnings_of(run: Simulation, balanced: float, reference: Trajectory | None = None) -> list[str]:
    """What about ``run`` a reader should know: energies off by more than the share ``balanced``, joints that
    run away from their ``reference``, drives at their limits, torques above what the description allows."""
    warnings = []
    if reference is not None:
        way = np.ptp(reference.q, axis=0)
        for j, row in enumerate(joint_rows(run, reference)):
            if row["peak_error"] > max(float(way[j]), _NOTHING):
                warnings.append(
                    f"joint {j + 1} is up to {row['peak_error']:.3g} away from its reference, which moves by "
                    f"{way[j]:.3g}: the controller does not hold it; give --kp and --kd"
                )
    balance = run.balance()
    rounding = _ROUNDING * max(1.0, float(np.abs(balance.kinetic + balance.potential).max()))
    if balance.error > balanced and float(np.abs(balance.residual).max()) > rounding:
        warnings.append(
            f"the energies do not balance: off by {balance.error:.2g} of the largest, more than "
            f"{balanced:g}; take a shorter --step, or --solver adaptive with a smaller --rtol"
        )
    for j, link in enumerate(run.plant.robot.links):
        short = float(np.mean(run.applied[:, j] != run.command[:, j]))
        if short:
            warnings.append(f"the drive of joint {j + 1} is at its limit {100 * short:.3g} % of the time")
        limit, peak = link.joint.limits.torque, float(np.abs(run.applied[:, j]).max())
        if limit is not None and peak > float(limit) * (1 + 1e-9):
            unit = UNITS[link.joint.kind]["torque"]
            warnings.append(
                f"joint {j + 1} takes {peak:.4g} {unit}, more than its limit of {float(limit):.4g}"
            )
    return warnings
