"""What is known of the arm's own numbers before a log is looked at."""

from __future__ import annotations

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.select.library.several import usual_sizes
from robodyn.diagnose.select.limits import LEAST_CENTRE, LEAST_INERTIA
from robodyn.kernels.array_dynamics import Model


def prior_scales(model: Model, unstated: float = 0.0) -> Floats:
    """Standard deviations [n, 10] of the links' standard parameters about the description: by the share that
    is stated of each, or by the share ``unstated`` of those of which nothing is."""
    phi = model.standard_parameters()
    scales, usual = np.zeros_like(phi), usual_sizes(model)
    for k, link in enumerate(model.robot.links):
        share = unstated if link.confidence is None else float(link.inertial_share)
        is_free = link.confidence in ("unknown", None)
        size = np.abs(phi[k])
        floor = np.concatenate(
            [[0.0], np.full(3, LEAST_CENTRE * size[0]), np.full(6, LEAST_INERTIA * size[4:7].max())]
        )
        scales[k] = share * np.maximum(size, usual[k] if is_free else floor)
    return scales
