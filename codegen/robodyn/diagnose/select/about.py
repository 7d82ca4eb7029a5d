"""A fit about the arm whose own numbers go best with it.

Torques are in proportion to the numbers of the links; what drives make of them is not. Numbers that are a
tenth wrong leave beside a spring or in a bearing what columns of the described arm do not show, and it would
be taken for a damping or for friction. So the arm's numbers are moved along with those of the findings, step
by step. What they explain is put back into the residuals: they are still held to what is said of them.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.amend.amend import amended
from robodyn.diagnose.select.fit import directions
from robodyn.diagnose.select.limits import REFINE_ROUNDS, REFINE_WORTH
from robodyn.diagnose.select.own_numbers import loaded
from robodyn.diagnose.select.refine import Freed, least_squares, weights
from robodyn.identify.prior import number_of
from robodyn.kernels.array_dynamics import PARAMETERS, Model, physical
from robodyn.robot.model import Inertia, Robot

Floats = NDArray[np.float64]


def fitted_about(freed: Freed, x: Floats) -> tuple[Freed, Floats]:
    """The fit about the arm with the numbers that go best with it, and its values [P], begun at ``x``."""
    for _ in range(REFINE_ROUNDS):
        step = _stepped(freed, x)
        if step is None:
            break
        freed, x, gain = step
        if gain < REFINE_WORTH:
            break
    return freed, x


def shown_numbers(freed: Freed, x: Floats) -> Floats:
    """The directions [count, p] of numbers of the arm that show beside values ``x`` [P]: to these the first
    of the columns of :meth:`Freed.own_numbers` belong."""
    return directions(_loaded(freed, x))


def moved(freed: Freed, changes: Floats) -> Freed:
    """The fit about an arm of which the numbers are by ``changes`` [count] larger than now, as :func:`loaded`
    has them. How links begin is worked out anew for any arm; a body without a mass has no centre of mass."""
    robot, sizes = freed.robot, freed.start.sizes.reshape(-1, len(PARAMETERS))
    total = changes if freed.changes is None else freed.changes + changes
    joints = tuple(Model(amended(robot, freed.amendments)).couplers)
    links = total[: sizes.size].reshape(sizes.shape).copy()
    phi = Model(robot).standard_parameters()
    links[phi[:, 0] + sizes[:, 0] * links[:, 0] <= 0] = 0.0
    rotors = total[sizes.size : sizes.size + len(joints)]
    padded = np.concatenate([links.reshape(-1), rotors, np.zeros(len(total) - sizes.size - len(joints))])
    about = _with_numbers(robot, phi + sizes * links, dict(zip(joints, rotors.tolist(), strict=True)))
    return replace(freed, about=about, changes=padded)


def _stepped(freed: Freed, x: Floats) -> tuple[Freed, Floats, float] | None:
    """The fit and its values ``x`` [P] after a step of Gauss and Newton of all numbers together, and by which
    share less is left; None where no step leaves less."""
    left = freed.missed(x)
    if left is None:
        return None
    columns, prior = freed.own_numbers(x)
    ways = shown_numbers(freed, x)
    p = ways.shape[1]
    weight, _ = weights(left.reshape(-1, freed.start.n), columns, prior)
    both = weight[:, None] * np.concatenate([freed.slopes(x, left), columns], axis=1)
    _, step = least_squares(weight * left, both, prior, free=len(x))
    towards, others = step[len(x) : len(x) + p], step[len(x) + p :]
    begun = np.zeros(p) if freed.changes is None else ways.T @ freed.changes

    def misfit(rest: Floats, numbers: Floats) -> float:
        by_others = weight * (rest - columns[:, p:] @ others)
        penalty = prior @ np.concatenate([numbers, others])
        return float(by_others @ by_others + penalty @ penalty)

    before = misfit(left - freed.put_back, begun)
    for share in (1.0, 0.3, 0.1):
        tried = freed.with_signs(x, x - share * step[: len(x)])
        numbers = begun + share * (towards - begun)
        other = replace(moved(freed, share * (ways @ (towards - begun))), put_back=0.0)
        rest = other.missed(tried)
        now = np.inf if rest is None else misfit(rest, numbers)
        if now < before:
            assert other.changes is not None
            explained = (_loaded(other, tried) @ other.changes).reshape(-1)
            return replace(other.at(tried), put_back=explained), tried, (before - now) / before
    return None


def _loaded(freed: Freed, x: Floats) -> Floats:
    arm = amended(freed.about or freed.robot, freed.changed(x))
    return loaded(arm, freed.robot, freed.contexts, freed.start)


def _with_numbers(robot: Robot, phi: Floats, rotors: dict[int, float]) -> Robot:
    """``robot`` with standard parameters ``phi`` [n, 10], and at joints (from 0) with ``rotors`` that are
    larger by such a share of what is known of them."""
    links = []
    for j, (link, row) in enumerate(zip(robot.links, phi, strict=True)):
        mass, x, y, z, *inertia = (Fraction(float(value)) for value in physical(row))
        joint, more = link.joint, rotors.get(j, 0.0)
        if more:
            rotor = number_of(joint.motor_inertia) * (1 + more * float(link.inertial_share))
            joint = replace(joint, motor_inertia=Fraction(rotor))
        links.append(replace(link, mass=mass, com=(x, y, z), inertia=Inertia(*inertia), joint=joint))
    return replace(robot, links=tuple(links))
