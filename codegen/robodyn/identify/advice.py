"""What to record next, where logs show too little of an arm."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from robodyn.gate.gate import Gate
from robodyn.identify.fit import Fit
from robodyn.identify.limits import POOR_CONDITION, WORTH_T
from robodyn.identify.outcome import Identified


def remarks(fit: Fit, outcome: Identified, gates: Sequence[Gate]) -> tuple[str, ...]:
    """Remarks for people, most important first."""
    words = []
    still = [j + 1 for j in range(fit.robot.n) if not any(gate.joints[j].moves for gate in gates)]
    if still:
        words.append(f"joint {_listed(still)} does not move in these logs: nothing is known of its friction")
    if fit.condition > POOR_CONDITION:
        words.append(
            f"the motion excites the arm poorly (condition {fit.condition:.3g}; below {POOR_CONDITION:g} is "
            f"good): record one of `robodyn excite {fit.robot.name}`"
        )
    offsets = fit.layout.joint("offset") if "offset" in fit.layout.own else np.zeros(0, dtype=np.intp)
    shown = [j + 1 for j, at in enumerate(offsets.tolist()) if fit.unknowns.free[at]]
    if shown:
        words.append(f"the torque of joint {_listed(shown)} is off by a constant, also on held-out samples")
    wide = [
        k + 1
        for k in range(fit.robot.n)
        if fit.solution.prior[fit.layout.link(k)[0]] * fit.unknowns.sd[fit.layout.link(k)[0]] ** 2 < 0.5
    ]
    if wide:
        words.append(
            f"link {_listed(wide)} is farther from its description than its confidence says: something else "
            "may be behind it (a spring, a load, a coupling); `robodyn diagnose` looks for it"
        )
    if outcome.robot.torque_side != fit.robot.torque_side:
        words.append(
            "the torque is described as measured behind the gear, and has friction in it all the same: "
            f"identified.yaml says torque_side: {outcome.robot.torque_side}"
        )
    if "rotor" in fit.layout.own:
        weak = [j + 1 for j in np.flatnonzero(fit.worth_t("rotor") < -WORTH_T).tolist()]
        if weak:
            words.append(f"the rotor of joint {_listed(weak)} makes predictions worse on held-out samples")
    return tuple(words)


def _listed(joints: Sequence[int]) -> str:
    *several, last = map(str, joints)
    return f"{', '.join(several)} and {last}" if several else last
