"""What each step of the thesis's two Newton-Euler methods costs a joint: its Table 2.9, counted.

The thesis's convention there: ``R`` is a full matrix (a product with a vector is 9 multiplications and 6
additions, although a DH matrix has a zero), tensors of inertia are diagonal in method I and full in method
II, what depends on the model alone is free, and so is doubling the Coriolis acceleration of a prismatic
joint. Behind such a joint the thesis takes ``R`` for right-angled, so that it costs nothing, in some rows
and for full in others: hence both ways of counting.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal

from robodyn.counts.count import Count
from robodyn.counts.general import Tally
from robodyn.dynamics.arm import Symmetric
from robodyn.dynamics.modified_newton_euler import Lambda
from robodyn.dynamics.transforms import Matrix
from robodyn.dynamics.vectors import ZERO, Vector, plus
from robodyn.thesis import method_steps as steps
from robodyn.thesis.method_steps import Method

#: The rows of Table 2.9.
STEPS = ("omega", "alpha", "lambda", "a", "a_c", "F", "N", "f", "f_rotated", "n")

#: How ``R`` is counted: full, or right-angled, all 0 and 1.
Rotation = Literal["full", "right-angled"]


class _Scratch:
    """Unknown numbers by the dozen, and what is done with them."""

    def __init__(self, rotation: Rotation, revolute: bool) -> None:
        self.ledger: dict[str, int] = {}
        self.rotation, self.revolute = rotation, revolute

    def number(self, fixed: bool = False) -> Any:
        """A number of the state, or of the model where ``fixed``."""
        return Tally(self.ledger, fixed)

    def vector(self, fixed: bool = False) -> Vector:
        """Three numbers."""
        return self.number(fixed), self.number(fixed), self.number(fixed)

    def R(self) -> Matrix:
        """The rotation of a joint."""
        if self.rotation == "right-angled":
            return ((1, 0, 0), (0, 0, -1), (0, 1, 0))
        return tuple(self.vector(not self.revolute) for _ in range(3))

    def lam(self) -> Lambda:
        """A lambda matrix."""
        return Lambda((self.vector(), self.vector(), self.vector()), self.vector())

    def inertia(self, full: bool) -> Symmetric:
        """A tensor of inertia, full or diagonal."""
        products = self.vector(fixed=True) if full else ZERO
        return Symmetric(*self.vector(fixed=True), *products)


def step_counts(method: Method, *, revolute: bool, rotation: Rotation = "full") -> dict[str, Count]:
    """Multiplications and additions of each step for one joint, by the row of Table 2.9."""
    carried_out = _revolute_steps(method) if revolute else _prismatic_steps(method)
    counts = {}
    for row in STEPS:
        scratch = _Scratch(rotation, revolute)
        carried_out[row](scratch)
        counts[row] = Count(**scratch.ledger)
    return counts


_Step = Callable[[_Scratch], object]


def _nothing(x: _Scratch) -> None:
    """What the method does not have."""


def _revolute_steps(method: Method) -> dict[str, _Step]:
    def omega(x: _Scratch) -> object:
        return steps.omega(x.R(), x.vector(), x.number())

    if method == "I":
        return {
            "omega": omega,
            "alpha": lambda x: steps.alpha_I(x.R(), x.vector(), x.vector(), x.number(), x.number()),
            "lambda": lambda x: steps.lambda_I(x.vector(), x.vector()),
            "a": lambda x: steps.a_I(x.R(), x.vector(), x.lam(), x.vector(fixed=True)),
            **_rest(method),
        }
    return {
        "omega": omega,
        "alpha": lambda x: steps.alpha_II(x.R(), x.vector(), x.vector(), x.vector(), x.number()),
        "lambda": _nothing,
        "a": lambda x: steps.a_II(x.R(), x.vector(), x.vector(), x.vector(), x.vector(fixed=True)),
        **_rest(method),
    }


def _prismatic_steps(method: Method) -> dict[str, _Step]:
    def turned_back(x: _Scratch) -> object:
        return steps.turned_back(x.R(), x.vector())

    def lam(x: _Scratch) -> object:
        if x.rotation == "full":  # formed anew, which is cheaper than R^T lambda R
            return steps.lambda_I(x.vector(), x.vector())
        return steps.lambda_carried(x.R(), x.lam())

    def a_I(x: _Scratch) -> object:
        a = steps.a_I(x.R(), x.vector(), x.lam(), x.vector())
        return plus(a, steps.slide_I(x.vector(), x.number(), x.number(), double=1))

    def a_II(x: _Scratch) -> object:
        a = steps.a_II(x.R(), x.vector(), x.vector(), x.vector(), x.vector())
        return plus(a, steps.slide_II(x.vector(), x.vector(), double=1), (0, 0, x.number()))

    first = method == "I"
    return {
        "omega": turned_back,
        "alpha": turned_back,
        "lambda": lam if first else _nothing,
        "a": a_I if first else a_II,
        **_rest(method),
    }


def _rest(method: Method) -> dict[str, _Step]:
    """Steps 4 to 8, which do not ask for the kind of joint."""

    def handed_on(x: _Scratch) -> Vector:
        return steps.turned(x.R(), x.vector())

    def n(x: _Scratch) -> object:
        N, F, f_next = x.vector(), x.vector(), x.vector()
        return steps.moment(N, x.vector(fixed=True), F, x.vector(fixed=True), f_next, handed_on(x))

    common: dict[str, _Step] = {"F": lambda x: steps.inertial_force(x.number(fixed=True), x.vector()), "n": n}
    if method == "I":
        return {
            **common,
            "a_c": lambda x: steps.a_c_I(x.vector(), x.lam(), x.vector(fixed=True)),
            "N": lambda x: steps.euler_I(x.inertia(full=False), x.vector(), x.vector()),
            "f": lambda x: plus(x.vector(), x.vector()),
            "f_rotated": handed_on,
        }
    return {
        **common,
        "a_c": lambda x: steps.a_c_II(x.vector(), x.vector(), x.vector(), x.vector(fixed=True)),
        "N": lambda x: steps.euler_II(x.inertia(full=True), x.vector(), x.vector()),
        "f": lambda x: plus(x.vector(), handed_on(x)),
        "f_rotated": _nothing,
    }
