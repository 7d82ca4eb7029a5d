"""What a diagnosis does one after the other, and about how long it takes: for whoever watches."""

from __future__ import annotations

from collections.abc import Sequence

from robodyn.diagnose.limits import FITTED_ROWS, LOOKING_COST, STAGE_COSTS
from robodyn.logs.log import Log
from robodyn.logs.signals import thinning


def stages(n: int, logs: Sequence[Log]) -> dict[str, float]:
    """The stages of a diagnosis of ``n`` joints by ``logs`` in their order, as ``progress`` is told of them,
    and about how long each takes [s]; what is found decides how often some of them are done."""
    rows = 0.0
    for log in logs:
        rate = (log.samples - 1) / max(float(log.t[-1] - log.t[0]), 1e-9)
        rows += log.samples / thinning(rate)
    squares = n * n * min(rows, float(FITTED_ROWS))
    base, each = LOOKING_COST
    costs = {"looking at the logs": base + each * n * sum(log.samples for log in logs)}
    return costs | {name: base + each * squares for name, (base, each) in STAGE_COSTS.items()}
