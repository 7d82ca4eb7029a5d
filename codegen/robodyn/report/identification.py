"""What an identification has found, as lines for a terminal."""

from __future__ import annotations

import numpy as np

from robodyn.identify.run import Identification
from robodyn.report.figures import with_error


def summary(outcome: Identification, path: str) -> list[str]:
    """The lines: what is left of the torque, joint by joint; what is seen and what is not; what to do."""
    r = outcome.residual
    torque = np.maximum(r.validate_torque, 1e-300)
    left = {9: r.validate_before, 10: r.validate_after, 13: r.validate_plain, 11: r.noise_floor}
    described, share, plain, _ = (f"{100 * float(np.mean(x / torque)):.3g} %" for x in left.values())
    lines = [
        f"{outcome.robot.name}: {share} of the torque is left on "
        f"{'held-out samples' if outcome.held_out else 'the validation log'} (as described {described}, "
        f"plain least squares {plain}); wrote {path}",
        "",
        "joint   torque [RMS]   described   identified   least squares   noise floor",
    ]
    for j in range(outcome.robot.n):
        cells = (f"{100 * x[j] / torque[j]:.3g} %".rjust(width) for width, x in left.items())
        lines.append(f"{j + 1:5d}   {r.validate_torque[j]:12.4g}   {'   '.join(cells)}")
    names: dict[str, list[str]] = {}  # friction, rotors and sensors, a line each with its error
    for name, one in outcome.parameters.items():
        place, _, what = name.partition(".")
        if place.startswith("joint"):
            value = "not seen" if one.stderr is None else with_error(one.value, one.stderr)
            if one.only_in_combination:
                value = "in combination"
            title = f"{what.split('.')[0].replace('_', ' ')} [{one.unit}]"
            names.setdefault(title, []).append(f"{place.removeprefix('joint')}: {value}")
    lines += ["", *(f"{what}: {', '.join(cells)}" for what, cells in names.items())]
    for sum_ in outcome.combinations:
        if " " in sum_.expression and "joint" in sum_.expression:
            lines.append(f"{sum_.expression} = {with_error(sum_.value, sum_.stderr)} {sum_.unit}")
    resting = [f"{j}: {100 * x:.2g} %" for j, x in enumerate(r.rest_share.tolist(), 1) if x > 0]
    if resting:
        lines.append(f"at rest, where the torque says only that friction holds: {', '.join(resting)}")
    count, unknown = len(outcome.parameters), len(outcome.not_identifiable)
    lines.append(
        f"{count - unknown} of {count} parameters are identified, {unknown} are "
        f"not seen and stay near the description; condition {outcome.condition:.3g}"
    )
    return [*lines, *outcome.words]
