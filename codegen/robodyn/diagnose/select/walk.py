"""Springs between motor and link, sought along their stiffness.

A link on the teeth of its gear runs out of phase when the stiffness is a fifth off, and then fits worse the
nearer it comes: the misfit has many minima along the stiffness, and a grid with steps from each of its places
ends in the nearest. Along the stiffness, all other numbers refitted from step to step, the lowest is reached.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.amend.amend import Amendment
from robodyn.diagnose.select.fit import Problem
from robodyn.diagnose.select.library import Context
from robodyn.diagnose.select.limits import (
    REFINE_WORTH,
    WALK_DAMPED,
    WALK_FARTHEST,
    WALK_LOST,
    WALK_ROUNDS,
    WALK_STEP,
    WALK_STEPS,
)
from robodyn.diagnose.select.local_fit import LocalFit
from robodyn.diagnose.select.refine import Freed
from robodyn.effects.catalogue import CATALOGUE
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]


def walked(
    robot: Robot,
    amendments: Sequence[Amendment],
    contexts: Sequence[Context],
    start: Problem,
    springs: Sequence[tuple[str, int | None]],
) -> list[Amendment]:
    """``amendments`` with better numbers for those of the ``springs`` (effect and joint)."""
    freed = Freed.of(robot, amendments, contexts, start)
    x = freed.x
    for i, (k, name) in enumerate(freed.places):
        one = amendments[k]
        is_spring = CATALOGUE[one.effect].coupler is not None and name == "stiffness"
        if is_spring and (one.effect, one.joint) in springs:
            fit = LocalFit.of(freed, x)
            if fit is not None:
                x = _along(fit, i)
    return freed.changed(x)


def _along(fit: LocalFit, i: int) -> Floats:
    """The best values [P] along the value ``i``, in steps both ways."""
    least, best = fit.misfit, fit.x
    for factor, steps in zip((1 / WALK_STEP, WALK_STEP), WALK_STEPS, strict=True):
        x = fit.x
        for _ in range(steps):
            x = x.copy()
            x[i] *= factor
            misfit, x = _settled(fit, x, held=i)
            if misfit < least:
                least, best = misfit, x
            if not misfit < WALK_LOST * least:
                break
    return best if best is fit.x else _settled(fit, best, held=None)[1]


def _settled(fit: LocalFit, x: Floats, held: int | None) -> tuple[float, Floats]:
    """The misfit, and values [P], all but the one ``held`` refitted from ``x`` by Gauss and Newton, the arm's
    own numbers eliminated."""
    free = np.array([i for i in range(len(x)) if i != held])
    sizes = fit.freed.sizes[free] if len(free) else free
    outcome = fit.misfit_at(x)
    least = np.inf if outcome is None else outcome[0]
    for _ in range(WALK_ROUNDS):
        left = fit.freed.missed(x)
        if left is None or not len(free):
            break
        J, left = fit.weight[:, None] * fit.freed.slopes(x, left)[:, free], fit.weight * left
        cross = fit.A.T @ J
        curvature = J.T @ J - cross.T @ fit.inverse @ cross
        pull = J.T @ left - cross.T @ (fit.inverse @ (fit.A.T @ left))
        scale = np.sqrt(np.maximum(np.diag(curvature), 1e-300))
        damped = curvature / np.outer(scale, scale) + WALK_DAMPED * np.eye(len(free))
        step = np.linalg.solve(damped, pull / scale) / scale
        before = least
        for share in (1.0, 0.3, 0.1):
            tried = x.copy()
            factors = np.exp(np.clip(-share * step / x[free], -WALK_FARTHEST, WALK_FARTHEST))
            tried[free] = np.where(sizes, x[free] * factors, x[free] - share * step)
            outcome = fit.misfit_at(tried)
            if outcome is not None and outcome[0] < least:
                least, x = outcome[0], tried
                break
        if not before - least > REFINE_WORTH * least:
            break
    return least, x
