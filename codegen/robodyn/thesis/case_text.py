"""The case study for a person, as data, and as a file of its samples."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict
from typing import Any, Final

import numpy as np

from robodyn.thesis.case_arm import ROBOT, efficiency_curve, efficiency_points
from robodyn.thesis.case_study import DURATION, KD, KP, LABEL, SAMPLES, SHOWN, START, Study, X, shares
from robodyn.thesis.printed import TABLE_3_4, TABLE_3_5

#: Torques by their names here, and in Table 3.5.
_NAMES: Final = {
    "rigid": "dynamic",
    "bearing": "joint_friction",
    "joint": "joint_total",
    "transmission": "transmission",
    "input": "input",
}
_HEADS: Final = tuple(name.replace("_", " ") for name in _NAMES.values())


def to_text(study: Study) -> str:
    """The study in lines of at most 110 columns."""
    return "\n".join((*_head(study), "", *_shown(study), "", *_sizes(study), "", *_forward(study))) + "\n"


def _head(study: Study) -> Iterator[str]:
    assumed, q = study.assumptions, study.motion.q
    knots = [f"{float(x):g} {float(y):.4f}" for x, y in efficiency_curve()]
    points, beyond = (", ".join(part) for part in (knots[: len(TABLE_3_5)], knots[len(TABLE_3_5) :]))
    yield "The thesis's case study of friction (chapter 3)"
    yield LABEL
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


def _shown(study: Study) -> Iterator[str]:
    t, rates = study.motion.t[SHOWN], study.motion.qd[SHOWN]
    yield f"Torques at {t:.1f} s [N m], Table 3.5 in brackets: another motion, not to be compared"
    signs = " ".join("+" if rate > 0 else "-" for rate in rates)
    yield f"(the joints turn {signs} here; by the signs of joint friction, + - + there)"
    yield _line(20, "", *_HEADS)
    for k, row in enumerate(TABLE_3_5):
        pairs = ((getattr(study.torques, own)[SHOWN, k], getattr(row, of)) for own, of in _NAMES.items())
        yield _line(20, f"joint {k + 1}", *(f"{ours:.4f} ({float(printed):.4f})" for ours, printed in pairs))


def _sizes(study: Study) -> Iterator[str]:
    sizes = shares(study.torques)
    yield "Over the motion: peak and root mean square [N m], efficiency while it moves"
    yield _line(16, "", *_HEADS, "efficiency")
    for k in range(3):
        cells = [f"{sizes[name]['peak'][k]:.3f} {sizes[name]['rms'][k]:.3f}" for name in _NAMES]
        low, high = (sizes["efficiency"][name][k] for name in ("least", "greatest"))
        yield _line(16, f"joint {k + 1}", *cells, f"{low:.3f} {high:.3f}")
    factors = ", ".join(f"{x:.2f}" for x in sizes["factor"])
    yield f"Friction makes the root mean square of the input torque {factors} times that of the rigid arm's."


def _forward(study: Study) -> Iterator[str]:
    yield "Forward check: the input torques fed to the simulated arm, with all its friction"
    closed = f"with PD ({KP:g} N m/rad, {KD:g} N m s/rad)"
    for name, run in (("alone, open loop", study.open_loop), (closed, study.closed_loop)):
        energies = ", ".join(f"{kind} {run.energies[kind]:.2f} J" for kind in ("stored", "work", "loss"))
        yield f"  {name}: {1000 * run.point:.2f} mm off at most; {energies}"


def _line(width: int, name: str, *cells: str) -> str:
    return f"{name:8}" + "".join(cell.rjust(width) for cell in cells)


def to_dict(study: Study) -> dict[str, Any]:
    """The study as JSON holds it, without its samples."""
    motion, torques = study.motion, study.torques
    points = efficiency_points()
    return {
        "label": LABEL,
        "assumptions": {
            **asdict(study.assumptions),
            "stiction": None,
            "efficiency": [[float(x), float(y)] for x, y in efficiency_curve()],
            "efficiency_known": [[float(point.load), float(point.efficiency)] for point in points],
        },
        "robot": ROBOT,
        "x": X,
        "start": START,
        "duration": DURATION,
        "samples": SAMPLES,
        "q_start": motion.q[0].tolist(),
        "q_end": motion.q[-1].tolist(),
        "load_off_the_point": study.load_point,
        "at": {
            "t": float(motion.t[SHOWN]),
            "direction": np.sign(motion.qd[SHOWN]).tolist(),
            **{name: getattr(torques, own)[SHOWN].tolist() for own, name in _NAMES.items()},
        },
        "sizes": shares(torques),
        "forward": {"open_loop": asdict(study.open_loop), "closed_loop": asdict(study.closed_loop)},
    }


def to_csv(study: Study) -> str:
    """All samples, SI units, one row each."""
    motion = study.motion
    columns = {"t": motion.t, **dict(zip("xyz", study.point.T, strict=True))}
    arrays = {name: getattr(motion, name) for name in ("q", "qd", "qdd")}
    names = (*_NAMES, "breakaway", "loss", "load", "efficiency")
    arrays |= {name: getattr(study.torques, name) for name in names}
    for name, values in arrays.items():
        columns |= {f"{name}{k}": column for k, column in enumerate(values.T, 1)}
    rows = np.stack(list(columns.values()), axis=1).tolist()
    return "\n".join([",".join(columns), *(",".join(map(repr, row)) for row in rows)]) + "\n"
