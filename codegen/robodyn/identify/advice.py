"""What to record next, where logs show too little of an arm."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from robodyn.gate.gate import Gate
from robodyn.identify.fit import Fit, still_joints
from robodyn.identify.limits import POOR_CONDITION, WORTH_T
from robodyn.identify.outcome import Identified


def remarks(fit: Fit, outcome: Identified, gates: Sequence[Gate]) -> tuple[str, ...]:
    """Remarks for people, most important first."""
    words = []
    still = [j + 1 for j in still_joints(gates)]
    if still:
        verb = "does" if len(still) == 1 else "do"
        words.append(f"{_named('joint', still)} {verb} not move in these logs: friction and rotor stay")
    if fit.condition > POOR_CONDITION:
        words.append(
            f"the motion excites the arm poorly (condition {fit.condition:.3g}; below {POOR_CONDITION:g} is "
            f"good): record one of `robodyn excite {fit.robot.name}`"
        )
    offsets = fit.layout.joint("offset") if "offset" in fit.layout.own else np.zeros(0, dtype=np.intp)
    shown = [j + 1 for j, at in enumerate(offsets.tolist()) if fit.unknowns.free[at]]
    if shown:
        words.append(f"the torque of {_named('joint', shown)} is off by a constant, also on held-out samples")
    wide = [
        k + 1
        for k in range(fit.robot.n)
        if fit.solution.prior[fit.layout.link(k)[0]] * fit.unknowns.sd[fit.layout.link(k)[0]] ** 2 < 0.5
    ]
    if wide:
        words.append(
            f"{_named('link', wide)}: farther from the description than its confidence says; a spring, load "
            "or a coupling may be behind that: `robodyn diagnose` looks for it"
        )
    if outcome.robot.torque_side != fit.robot.torque_side:
        words.append(
            "the torque is described as measured behind the gear, and has friction in it all the same: "
            f"identified.yaml says torque_side: {outcome.robot.torque_side}"
        )
    if "rotor" in fit.layout.own:
        weak = [j + 1 for j in np.flatnonzero(fit.worth_t("rotor") < -WORTH_T).tolist()]
        if weak:
            words.append(f"the rotor of {_named('joint', weak)} does not help on held-out samples")
    return tuple(words)


def _named(what: str, places: Sequence[int]) -> str:
    """``joint 2``, ``joints 2, 3 and 5``."""
    *several, last = map(str, places)
    return f"{what}s {', '.join(several)} and {last}" if several else f"{what} {last}"
