"""Pictures of the case study: new curves, in the place of Figures 3.6 to 3.13, whose data are not at hand."""

from __future__ import annotations

from robodyn.draw.panels import Curve, Panel, figure
from robodyn.effects import thesis_friction as friction
from robodyn.effects.efficiency import efficiency_at
from robodyn.thesis.case_arm import efficiency_curve, efficiency_points
from robodyn.thesis.case_study import LABEL, Floats, Study
from robodyn.thesis.printed import TABLE_3_4

_JOINTS = (1, 2, 3)
_TIME = "t [s]"
_LOADS = [k / 200 for k in range(201)]


def pictures(study: Study) -> dict[str, str]:
    """SVGs by file name."""
    files = {
        "path.svg": path(study),
        "joints.svg": joints(study),
        "efficiency.svg": efficiency(),
        "transmission.svg": transmission(),
        "following.svg": following(study),
    }
    return files | {f"joint-{k}.svg": torques(study, k) for k in _JOINTS}


def path(study: Study) -> str:
    """The line, and how far along it the point is."""
    t, point = study.motion.t.tolist(), study.point
    speed = study.led.kinematics.jacobian(study.motion.q)[:, :3] @ study.motion.qd[:, :, None]
    return figure(
        "Path of the point",
        LABEL,
        (
            Panel("The line, at x = 0.4 m", "y [m]", "z [m]", (_curve("", point[:, 1], point[:, 2]),)),
            Panel(
                "Along the line",
                _TIME,
                "y = z [m], and its rate [m/s]",
                (
                    Curve("y = z", t, point[:, 1].tolist()),
                    Curve("rate", t, speed[:, 1, 0].tolist(), dashed=True),
                ),
            ),
        ),
    )


def joints(study: Study) -> str:
    """Positions, velocities and accelerations of the joints."""
    motion = study.motion
    panels = tuple(
        Panel(title, _TIME, unit, tuple(_over(study, f"joint {k}", values[:, k - 1]) for k in _JOINTS))
        for title, unit, values in (
            ("Positions", "position [rad]", motion.q),
            ("Velocities", "velocity [rad/s]", motion.qd),
            ("Accelerations", "acceleration [rad/s^2]", motion.qdd),
        )
    )
    return figure("Joint trajectories", LABEL, panels)


def torques(study: Study, joint: int) -> str:
    """All torques of ``joint`` (from 1)."""
    series, k = study.torques, joint - 1
    ends = _ends(series.joint[1:-1, k])
    return figure(
        f"Torques of joint {joint}",
        LABEL,
        (
            Panel(
                f"Joint {joint}: with and without friction",
                _TIME,
                "torque [N m]",
                (
                    _over(study, "without friction", series.rigid[:, k]),
                    _over(study, "with joint friction", series.joint[:, k]),
                    _over(study, "with transmission as well", series.input[:, k]),
                ),
            ),
            Panel(
                f"Joint {joint}: parts of the friction",
                _TIME,
                "torque [N m]",
                (
                    _over(study, "bearings, Eq 3.3", series.bearing[:, k]),
                    _over(study, "breakaway torque", series.breakaway[:, k]),
                    _over(study, "loss of the transmission", series.loss[:, k]),
                ),
            ),
            Panel(
                f"Joint {joint}: through the transmission",
                "torque at the joint [N m]",
                "torque that goes in [N m]",
                (
                    _curve("input torque", series.joint[1:-1, k], series.input[1:-1, k]),
                    Curve("without loss", ends, ends, dashed=True),
                ),
            ),
            Panel(
                f"Joint {joint}: efficiency",
                _TIME,
                "share",
                (
                    _over(study, "efficiency", series.efficiency[:, k]),
                    _over(study, "load, share of the largest torque", series.load[:, k]),
                ),
            ),
        ),
    )


def efficiency() -> str:
    """The efficiency curve: what Table 3.5 gives away, and what is assumed."""
    knots = [(float(x), float(y)) for x, y in efficiency_curve()]
    known = sorted((float(point.load), float(point.efficiency)) for point in efficiency_points())
    curve = [float(efficiency_at(x, knots, "cubic")) for x in _LOADS]
    panel = Panel(
        "Efficiency of the transmissions",
        "load, as a share of the largest torque",
        "efficiency",
        (
            Curve("assumed: through the points, load^0.2 above, level below", _LOADS, curve),
            Curve("three points of Table 3.5", [x for x, _ in known], [y for _, y in known]),
        ),
    )
    return figure("Efficiency curve", LABEL, (panel,))


def transmission() -> str:
    """Figure 3.5: what goes into the transmission over what it gives, moving either way, in all quadrants."""
    knots = [(float(x), float(y)) for x, y in efficiency_curve()]
    panels = []
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
        panels.append(
            Panel(f"Joint {joint}", "torque at the joint [N m]", "torque that goes in [N m]", tuple(curves))
        )
    return figure(
        "Figure 3.5, redrawn: the transmission, driving where torque and motion agree, else braking",
        LABEL,
        panels,
    )


def following(study: Study) -> str:
    """How far the simulated arm is from its motion."""
    t, off = study.deviation
    panel = Panel(
        "Forward check: PD controller and fed torques", _TIME, "deviation of the point [mm]",
        (_curve("", t[::10], 1000 * off[::10]),),
    )  # fmt: skip
    return figure("The simulated arm on the line", LABEL, (panel,))


def _over(study: Study, name: str, values: Floats) -> Curve:
    return _curve(name, study.motion.t, values)


def _curve(name: str, x: Floats, y: Floats) -> Curve:
    return Curve(name, x.tolist(), y.tolist())


def _ends(values: Floats) -> list[float]:
    return [float(values.min()), float(values.max())]
