"""The case study for a person, as data, and as a file of its samples."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from robodyn.thesis.case_arm import ROBOT, efficiency_curve, efficiency_points
from robodyn.thesis.case_study import (
    DURATION,
    KD,
    KP,
    LABEL,
    SAMPLES,
    SHOWN,
    START,
    Following,
    Study,
    X,
    shares,
)
from robodyn.thesis.printed import TABLE_3_4, TABLE_3_5

_COLUMNS = ("rigid", "bearing", "joint", "transmission", "input")
_HEADS = ("dynamic", "joint friction", "joint total", "transmission", "input")
_PRINTED = ("dynamic", "joint_friction", "joint_total", "transmission", "input")


def to_text(study: Study) -> str:
    """The study in lines of at most 110 columns."""
    return "\n".join((*_head(study), "", *_shown(study), "", *_sizes(study), "", *_forward(study))) + "\n"


def _head(study: Study) -> Iterable[str]:
    assumed, q = study.assumptions, study.motion.q
    knots = [f"{float(x):g} {float(y):.4f}" for x, y in efficiency_curve()]
    points, beyond = (", ".join(part) for part in (knots[: len(TABLE_3_5)], knots[len(TABLE_3_5) :]))
    yield "The thesis's case study of friction (chapter 3)"
    yield f"{LABEL}"
    yield ""
    yield "From the thesis"
    yield f"  line        y = z at x = {X:g} m, from y = z = {START:g} m; {SAMPLES} samples in {DURATION:g} s"
    yield f"  dynamics    program D.1.2 ({ROBOT})"
    for k, drive in enumerate(TABLE_3_4, 1):
        yield (
            f"  joint {k}     mu {float(drive.mu):g}, journal radius {float(drive.radius):g} m, breakaway "
            f"{float(drive.breakaway):g} N m, largest torque {float(drive.largest):g} N m (Table 3.4)"
        )
    yield f"  efficiency  {points} by load fraction (out of Table 3.5)"
    yield "Assumed"
    yield (
        f"  motion      {assumed.profile}, rest to rest; end y = z = {assumed.end:g} m; "
        f"payload {assumed.payload:g} kg"
    )
    yield f"  bearings    {assumed.span:g} m apart"
    yield f"  efficiency  {beyond} beyond, as load^0.2; level below {knots[0].split()[0]}"
    yield "  stiction    none"
    if assumed.arm == "programs":
        yield "  arm         joint angles of D.1.3 (offset 0.127 m, point along +y of frame 3),"
        yield "              dynamics of D.1.2 (offset 0.1501 m, load along -y of frame 3):"
        yield f"              that load is {study.load_point:.4f} m off the point at the start"
    else:
        yield "  arm         D.1.2's all the way (offset 0.1501 m): its load is led along the line"
    for name, row in (("start", q[0]), ("end", q[-1])):
        yield f"  {name:10}  q = ({', '.join(f'{x:.4f}' for x in row)}) rad"


def _shown(study: Study) -> Iterable[str]:
    torques = study.torques
    t = study.motion.t[SHOWN]
    yield f"Torques at {t:.1f} s [N m], Table 3.5 in brackets: another motion, not to be compared"
    signs = " ".join("+" if rate > 0 else "-" for rate in study.motion.qd[SHOWN])
    yield f"(the joints turn {signs} here; by the signs of joint friction, + - + there)"
    yield _line(20, "", *_HEADS)
    for k, printed in enumerate(TABLE_3_5):
        cells = [
            f"{getattr(torques, own)[SHOWN, k]:.4f} ({float(getattr(printed, theirs)):.4f})"
            for own, theirs in zip(_COLUMNS, _PRINTED, strict=True)
        ]
        yield _line(20, f"joint {k + 1}", *cells)


def _sizes(study: Study) -> Iterable[str]:
    sizes = shares(study.torques)
    yield "Over the motion: peak and root mean square [N m], efficiency while it moves"
    yield _line(16, "", *_HEADS, "efficiency")
    for k in range(3):
        cells = [f"{sizes[name]['peak'][k]:.3f} {sizes[name]['rms'][k]:.3f}" for name in _COLUMNS]
        low, high = (sizes["efficiency"][name][k] for name in ("least", "greatest"))
        yield _line(16, f"joint {k + 1}", *cells, f"{low:.3f} {high:.3f}")
    factors = ", ".join(f"{x:.2f}" for x in sizes["factor"])
    yield f"Friction makes the root mean square of the input torque {factors} times that of the rigid arm's."


def _forward(study: Study) -> Iterable[str]:
    yield "Forward check: the input torques fed to the simulated arm, with all its friction"
    for name, run in (
        ("alone, open loop", study.open_loop),
        (f"with PD ({KP:g} N m/rad, {KD:g} N m s/rad)", study.closed_loop),
    ):
        yield (
            f"  {name}: {1000 * run.point:.2f} mm off at most; stored {run.energies['stored']:.2f} J, "
            f"work {run.energies['work']:.2f} J, loss {run.energies['loss']:.2f} J"
        )


def _line(width: int, name: str, *cells: str) -> str:
    return f"{name:8}" + "".join(cell.rjust(width) for cell in cells)


def to_dict(study: Study) -> dict[str, Any]:
    """The study as JSON holds it, without its samples."""
    assumed, torques = study.assumptions, study.torques
    return {
        "label": LABEL,
        "assumptions": {
            **asdict(assumed),
            "stiction": None,
            "efficiency": [[float(x), float(y)] for x, y in efficiency_curve()],
            "efficiency_known": [[float(p.load), float(p.efficiency)] for p in efficiency_points()],
        },
        "robot": ROBOT,
        "x": X,
        "start": START,
        "duration": DURATION,
        "samples": SAMPLES,
        "q_start": study.motion.q[0].tolist(),
        "q_end": study.motion.q[-1].tolist(),
        "load_off_the_point": study.load_point,
        "at": {
            "t": float(study.motion.t[SHOWN]),
            "direction": np.sign(study.motion.qd[SHOWN]).tolist(),
            **{
                name: getattr(torques, own)[SHOWN].tolist()
                for name, own in zip(_PRINTED, _COLUMNS, strict=True)
            },
        },
        "sizes": shares(torques),
        "forward": {"open_loop": _run(study.open_loop), "closed_loop": _run(study.closed_loop)},
    }


def _run(run: Following) -> dict[str, Any]:
    return {"joints": list(run.joints), "point": run.point, "energies": dict(run.energies)}


def to_csv(study: Study) -> str:
    """All samples, SI units, one row each."""
    motion, torques = study.motion, study.torques
    parts: list[tuple[Sequence[str], Any]] = [(("t",), motion.t[:, None]), (("x", "y", "z"), study.point)]
    for name, values in (("q", motion.q), ("qd", motion.qd), ("qdd", motion.qdd)):
        parts.append(([f"{name}{k}" for k in (1, 2, 3)], values))
    for name in (*_COLUMNS, "breakaway", "loss", "load", "efficiency"):
        parts.append(([f"{name}{k}" for k in (1, 2, 3)], getattr(torques, name)))
    rows = np.hstack([values for _, values in parts])
    head = ",".join(name for names, _ in parts for name in names)
    return "\n".join([head, *(",".join(map(repr, row)) for row in rows.tolist())]) + "\n"
