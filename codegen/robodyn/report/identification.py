"""What an identification has found, as lines for a terminal."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from robodyn.identify.run import Identification
from robodyn.report.figures import with_error

Floats = NDArray[np.float64]


def summary(outcome: Identification, path: str) -> list[str]:
    """The lines: what is left of the torque, joint by joint; what is seen and what is not; what to do."""
    r = outcome.residual
    unseen = "held-out samples" if outcome.held_out else "the validation log"
    shares = [_share(x, r.validate_torque) for x in (r.validate_after, r.validate_before, r.validate_plain)]
    lines = [
        f"{outcome.robot.name}: {shares[0]} of the torque is left on {unseen} "
        f"(as described {shares[1]}, plain least squares {shares[2]}); wrote {path}",
        "",
        "joint   torque [RMS]   described   identified   least squares   noise floor",
    ]
    for j in range(outcome.robot.n):
        torque = r.validate_torque[j]
        left = (r.validate_before, r.validate_after, r.validate_plain, r.noise_floor)
        cells = zip((9, 10, 13, 11), left, strict=True)
        row = "   ".join(f"{_percent(x[j], torque):>{width}}" for width, x in cells)
        lines.append(f"{j + 1:5d}   {torque:12.4g}   {row}")
    lines += ["", *_joints(outcome)]
    count, unknown = len(outcome.parameters), len(outcome.not_identifiable)
    lines.append(
        f"{count - unknown} of {count} parameters are identified, {unknown} are "
        f"not seen and stay near the description; condition {outcome.condition:.3g}"
    )
    return [*lines, *outcome.words]


def _joints(outcome: Identification) -> list[str]:
    """Friction, rotors and sensors, a line each with its error."""
    lines = []
    names: dict[str, list[str]] = {}
    for name, one in outcome.parameters.items():
        place, _, what = name.partition(".")
        if not place.startswith("joint"):
            continue
        value = "not seen" if one.stderr is None else with_error(one.value, one.stderr)
        names.setdefault(f"{what.split('.')[0].replace('_', ' ')} [{one.unit}]", []).append(
            f"{place.removeprefix('joint')}: {value}"
        )
    for what, cells in names.items():
        lines.append(f"{what}: {', '.join(cells)}")
    return lines


def _share(left: Floats, torque: Floats) -> str:
    """The mean over joints of what is left of the torque, in per cent."""
    return f"{100 * float(np.mean(left / np.maximum(torque, 1e-300))):.3g} %"


def _percent(left: float, torque: float) -> str:
    return f"{100 * left / max(torque, 1e-300):.3g} %"
