"""What every arm has at every joint, all at once: dry and viscous friction, and a rotor.

Where a description has none of it, effects that come in one by one come in wrong: what two joints rub shows
at each of them, and a coupling of both, or wrong masses, explain more than the friction of either. So all of
it is a candidate too, before any other, and what is too much is taken out again.
"""

from __future__ import annotations

from robodyn.diagnose.select.compare import rubs_at
from robodyn.diagnose.select.members import Fit, fitted
from robodyn.diagnose.select.nuisance import widened
from robodyn.diagnose.select.score import Trial, foretold_by, log_likelihood
from robodyn.diagnose.select.steps import Steps


def with_baseline(search: Steps, fit: Fit, best: Trial | None) -> Fit | None:
    """The fit with what of the baseline is worth a name, where that is at most joints and foretells more than
    the ``best`` of all candidates, each name at its price."""
    least = float(log_likelihood(fit).sum()) if best is None else foretold_by(fit, best) - search.threshold
    before = search.rows, search.dry.copy(), search.families, set(search.banned)
    full = _with_joint_terms(search, fit)
    if float(log_likelihood(full).sum()) > least:
        full = widened(full, search.threshold) or full
        reduced = search.reviewed(full, range(search.rows.n))
        search.banned.clear()
        price = search.threshold * len(reduced.model.members)
        joints = {one.key[1] for one in reduced.model.members} - {None}
        if 2 * len(joints) > search.rows.n and float(log_likelihood(reduced).sum()) - price > least:
            return reduced
    search.rows, search.dry, search.families, search.banned = before
    return None


def _with_joint_terms(search: Steps, fit: Fit) -> Fit:
    """With friction and rotors of all joints that help; where a joint rubs, its rows at rest say a set."""
    folds = ((one, one.first.definition.traits.fold) for one in search.families)
    families = [one for one, fold in folds if fold is not None and fold.into == "joint"]
    for family in sorted(families, key=lambda one: not one.second):  # both frictions of a joint at once
        if not any(family is one for one in search.open_to(fit)):
            continue
        (one,) = search.trials(fit, [family])
        more = search.with_family(fit, one, 0) if one.is_possible and one.gain > 0 else None
        if more is None:
            continue
        (j,) = family.rows
        resting = search.with_rest_set(more, j) if rubs_at(one, j) else None
        fit = more if resting is None else search.adopt_rest_set(resting, j)
    return fitted(fit.model) or fit
