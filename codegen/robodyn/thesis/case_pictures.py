"""Pictures of the case study: new curves, in the place of Figures 3.6 to 3.13, whose data are not at hand."""

from __future__ import annotations

from typing import Final

from robodyn.arrays import Floats
from robodyn.draw.panels import Curve, Panel, figure
from robodyn.effects import thesis_friction as friction
from robodyn.effects.efficiency import efficiency_at
from robodyn.thesis.case_arm import efficiency_curve, efficiency_points
from robodyn.thesis.case_study import LABEL, Study
from robodyn.thesis.printed import TABLE_3_4

_TIME: Final = "t [s]"
_OUT_AND_IN: Final = ("torque at the joint [N m]", "torque that goes in [N m]")


def pictures(study: Study) -> dict[str, str]:
    """SVGs by file name: the line and how far along it the point is; positions, velocities and accelerations
    of the joints; the efficiency curve; Figure 3.5; how far the simulated arm is from its motion; and all
    torques of each joint."""
    motion, (x, y) = study.motion, (study.point[:, 1], study.point[:, 2])
    rate = (study.led.kinematics.jacobian(motion.q)[:, :3] @ motion.qd[:, :, None])[:, 1, 0]
    path = (
        Panel("The line, at x = 0.4 m", "y [m]", "z [m]", (_curve("", x, y),)),
        Panel(
            "Along the line", _TIME, "y = z [m], and its rate [m/s]",
            (_curve("y = z", motion.t, x), Curve("rate", motion.t.tolist(), rate.tolist(), dashed=True)),
        ),
    )  # fmt: skip
    joints = tuple(
        Panel(title, _TIME, unit, tuple(_curve(f"joint {k}", motion.t, values[:, k - 1]) for k in (1, 2, 3)))
        for title, unit, values in (
            ("Positions", "position [rad]", motion.q),
            ("Velocities", "velocity [rad/s]", motion.qd),
            ("Accelerations", "acceleration [rad/s^2]", motion.qdd),
        )
    )
    t, off = study.deviation
    following = Panel(
        "Forward check: PD controller and fed torques", _TIME, "deviation of the point [mm]",
        (_curve("", t[::10], 1000 * off[::10]),),
    )  # fmt: skip
    return {
        "path.svg": figure("Path of the point", LABEL, path),
        "joints.svg": figure("Joint trajectories", LABEL, joints),
        "efficiency.svg": _efficiency(),
        "transmission.svg": transmission(),
        "following.svg": figure("The simulated arm on the line", LABEL, (following,)),
        **{f"joint-{k}.svg": _torques(study, k) for k in (1, 2, 3)},
    }


def _torques(study: Study, joint: int) -> str:
    """All torques of ``joint`` (from 1)."""
    series, k, moving = study.torques, joint - 1, slice(1, -1)
    given, taken = series.joint[moving, k], series.input[moving, k]
    ends = [float(given.min()), float(given.max())]
    through = (_curve("input torque", given, taken), Curve("without loss", ends, ends, dashed=True))
    over_time = (
        ("with and without friction", "torque [N m]", (
            ("without friction", series.rigid),
            ("with joint friction", series.joint),
            ("with transmission as well", series.input),
        )),
        ("parts of the friction", "torque [N m]", (
            ("bearings, Eq 3.3", series.bearing),
            ("breakaway torque", series.breakaway),
            ("loss of the transmission", series.loss),
        )),
        ("efficiency", "share", (
            ("efficiency", series.efficiency),
            ("load, share of the largest torque", series.load),
        )),
    )  # fmt: skip
    panels = [
        Panel(f"Joint {joint}: {title}", _TIME, unit,
              tuple(_curve(name, study.motion.t, values[:, k]) for name, values in curves))
        for title, unit, curves in over_time
    ]  # fmt: skip
    panels.insert(2, Panel(f"Joint {joint}: through the transmission", *_OUT_AND_IN, through))
    return figure(f"Torques of joint {joint}", LABEL, panels)


def _efficiency() -> str:
    """The efficiency curve: what Table 3.5 gives away, and what is assumed."""
    loads, knots = [k / 200 for k in range(201)], _knots()
    curve = [float(efficiency_at(x, knots, "cubic")) for x in loads]
    x, y = zip(
        *sorted((float(point.load), float(point.efficiency)) for point in efficiency_points()), strict=True
    )
    panel = Panel(
        "Efficiency of the transmissions", "load, as a share of the largest torque", "efficiency",
        (
            Curve("assumed: through the points, load^0.2 above, level below", loads, curve),
            Curve("three points of Table 3.5", x, y),
        ),
    )  # fmt: skip
    return figure("Efficiency curve", LABEL, (panel,))


def transmission() -> str:
    """Figure 3.5: what goes into the transmission over what it gives, moving either way, in all quadrants."""
    knots, panels = _knots(), []
    for joint, drive in enumerate(TABLE_3_4, 1):
        largest, breakaway = float(drive.largest), float(drive.breakaway)
        outputs = [largest * k / 100 for k in range(-100, 101)]
        curves = []
        for direction, name in ((1, "moving forward"), (-1, "moving backward")):
            inputs = []
            for torque in outputs:
                efficiency = efficiency_at(friction.load_fraction(torque, largest), knots, "cubic")
                law = friction.driving if torque * direction > 0 else friction.braking
                inputs.append(float(law(torque, efficiency, breakaway, direction)))
            curves.append(Curve(name, outputs, inputs))
        curves.append(Curve("without loss", outputs, outputs, dashed=True))
        panels.append(Panel(f"Joint {joint}", *_OUT_AND_IN, tuple(curves)))
    title = "Figure 3.5, redrawn: the transmission, driving where torque and motion agree, else braking"
    return figure(title, LABEL, panels)


def _knots() -> list[tuple[float, float]]:
    return [(float(x), float(y)) for x, y in efficiency_curve()]


def _curve(name: str, x: Floats, y: Floats) -> Curve:
    return Curve(name, x.tolist(), y.tolist())
