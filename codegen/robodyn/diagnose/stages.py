"""What a diagnosis does one after the other, and about how long it takes: for whoever watches."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from robodyn.diagnose.limits import FITTED_ROWS, LOOKING_COST, STAGE_COSTS
from robodyn.logs.limits import FASTEST_RATE
from robodyn.logs.log import Log
from robodyn.logs.signals import thinning


def stages(n: int, logs: Sequence[Log]) -> dict[str, float]:
    """The stages of a diagnosis of ``n`` joints by ``logs`` in their order, as ``progress`` is told of them,
    and about how long each takes [s]; what is found decides how often some of them are done."""
    rows = sum(log.samples / thinning(_rate(log)) for log in logs)
    squares = n * n * min(rows, float(FITTED_ROWS))
    base, each = LOOKING_COST
    costs = {"looking at the logs": base + each * n * sum(log.samples for log in logs)}
    return costs | {name: base + each * squares for name, (base, each) in STAGE_COSTS.items()}


def _rate(log: Log) -> float:
    """About how many samples a second ``log`` has, which nobody has looked at yet."""
    steps = np.diff(log.t)
    steps = steps[steps > 1 / FASTEST_RATE]
    return 1 / float(np.median(steps)) if len(steps) else FASTEST_RATE
