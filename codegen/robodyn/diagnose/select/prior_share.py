"""How exact the logs show a description to be: as what share of what it says its numbers are wrong.

A description states by how much its numbers may be wrong, or nothing, which counts as a tenth. What is said
of a load or of a wrong link would be no surer than that, though the arm may be as described to a thousandth,
as the logs show. So the prior of the arm's own numbers gets a scale of its own, by its marginal likelihood
beside all that was named (empirical Bayes: MacKay 1992), averaged over what is likely of it.
"""

from __future__ import annotations

import numpy as np

from robodyn.diagnose.select.fit import Fit, Problem, share_taken
from robodyn.diagnose.select.limits import LEAST_PRIOR_SHARE, PRIOR_SHARES, TIGHT_EVIDENCE


def prior_share(p: Problem, fit: Fit) -> float:
    """As what share of what is said of them the arm's own numbers are wrong, at most as is taken: the root
    mean square over its posterior. ``p``: with all that was named, ``fit``: its fit."""
    assumed = share_taken(p)
    if not p.nuisance or assumed <= LEAST_PRIOR_SHARE:
        return assumed
    left = p.rest - p.A @ fit.known
    floor = np.maximum(np.mean(left**2, axis=0), 1.0) * p.thin
    gram = np.einsum("bjpq,j->pq", p.gram, 1 / floor)
    right = np.einsum("bjp,j->p", p.right, 1 / floor)
    shares = np.geomspace(assumed, LEAST_PRIOR_SHARE, PRIOR_SHARES)
    evidence = np.zeros(len(shares))
    for k, share in enumerate(shares):
        precision = p.prior / p.thin
        precision[: p.nuisance] *= (assumed / share) ** 2
        system = gram + np.diag(precision)
        evidence[k] = right @ np.linalg.solve(system, right) - np.linalg.slogdet(system)[1]
        evidence[k] -= 2 * p.nuisance * np.log(share)
    evidence[0] += 2 * TIGHT_EVIDENCE  # what is said holds until the logs speak against it
    likely = np.exp((evidence - evidence.max()) / 2)
    return float(np.sqrt(likely @ shares**2 / likely.sum()))
