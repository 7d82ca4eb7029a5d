"""A candidate for what is missing, and the model and the motion it is made from."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from robodyn.arrays import Floats
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect, Site
from robodyn.effects.traits import anything
from robodyn.kernels.array_dynamics import Evaluated, Model, Reuse
from robodyn.logs.signals import Signals


@dataclass(frozen=True, slots=True, eq=False)
class Candidate:
    """An effect at a place, with what is not linear in it fixed.

    ``columns`` [K, rows, c]: torques by the linear parameters, at the joints ``rows`` (from 0); ``signs``
    [c]: +1 for what must not be negative, 0 for what may be anything; ``read`` makes the catalogue's
    parameters of the coefficients, ``feasible`` whether physics allows them. ``coarse``: the columns are of
    coarse signals. ``order`` says which of two that explain alike is the simpler. ``values``: the values of
    what is not linear, by name."""

    effect: str
    joint: int | None
    rows: tuple[int, ...]
    columns: Floats
    signs: tuple[int, ...]
    read: Callable[[Floats], dict[str, float | str]]
    order: int
    coarse: bool = False
    #: Standard deviations [c] of a prior of the coefficients about 0; None: they are free.
    scale: Floats | None = None
    #: Its size is known: the coefficient is 1.
    fixed: bool = False
    #: It shows in few parts of a log only.
    local: bool = False
    #: Factors between which what is not linear is refined, or how far steps in random directions go.
    spread: tuple[float, float] = (1.5, 1.03)
    reach: Mapping[str, float] = field(default_factory=dict)
    #: What it must take away, as a share of the mean square left at a joint, if that is more than usual.
    least_share: float = 0.0
    feasible: Callable[[Floats], bool] = anything
    #: Whether it is so likely that it may be named; a rival of others it is without.
    likely: Callable[[Floats], bool] = anything
    values: Mapping[str, float] = field(default_factory=dict)
    #: Makes the same in a context, with other values of what is not linear.
    again: Callable[[Context, Mapping[str, float]], Candidate] | None = None

    @property
    def name(self) -> str:
        """For people."""
        return f"{self.effect} at joint {self.joint}" if self.joint else self.effect

    @property
    def definition(self) -> Effect:
        """The effect itself."""
        return CATALOGUE[self.effect]


@dataclass(frozen=True, slots=True, eq=False)
class Hints:
    """What all parts of a recording share: top speeds [n], and numbers of waves by joint."""

    top: Floats
    cycles: tuple[tuple[float, ...], ...]


@dataclass(frozen=True, slots=True, eq=False)
class Context:
    """A model along a log, and along its coarse signals; ``plain`` [K, n]: the rigid torques of the latter,
    were all links where the encoders say."""

    model: Model
    signals: Signals
    at: Evaluated
    way: Floats
    slow: Signals
    at_slow: Evaluated
    plain: Floats
    hints: Hints
    #: What candidates of one joint share.
    kept: dict[tuple[str, int], Any] = field(default_factory=dict)
    #: What models of the same rigid arm share along the signals.
    reuse: Reuse = field(default_factory=Reuse)

    @property
    def n(self) -> int:
        """Number of joints."""
        return self.signals.n


def site(c: Context, j: int) -> Site:
    """Joint ``j`` (from 0) along the log, as equations see it."""
    s = c.signals
    m, f = c.at.m[:, j], c.at.f[:, j]
    revolute = c.model.robot.links[j].joint.kind == "revolute"
    return Site(
        revolute, s.q[:, j], s.qd[:, j], s.qdd[:, j], c.way[:, j], c.at.rigid[:, j],
        (f[:, 0], f[:, 1], f[:, 2]), (m[:, 0], m[:, 1], m[:, 2]),
    )  # fmt: skip


def single(
    effect: str, j: int, columns: list[Floats], signs: tuple[int, ...],
    read: Callable[[Floats], dict[str, float | str]], order: int, **more: Any,
) -> Candidate:  # fmt: skip
    """A candidate at joint ``j`` (from 0) that shows there only, of columns [K]."""
    return Candidate(effect, j + 1, (j,), np.stack(columns, axis=1)[:, None, :], signs, read, order, **more)
