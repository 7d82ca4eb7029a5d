"""What an identification does one after the other, and about how long it takes: for whoever watches."""

from __future__ import annotations

from collections.abc import Sequence

from robodyn.identify.limits import COMPARING_COST, FITTING_COST, LOOKING_COST
from robodyn.logs.log import Log


def stages(n: int, logs: Sequence[Log]) -> dict[str, float]:
    """The stages of the identification of ``n`` joints from ``logs`` in their order, as ``progress`` is told
    of them, and about how long each takes [s]."""
    numbers = n * sum(log.samples for log in logs)
    costs = {
        "looking at the logs": LOOKING_COST,
        "fitting the arm": FITTING_COST,
        "comparing the torques": COMPARING_COST,
    }
    return {name: base + each * numbers for name, (base, each) in costs.items()}
