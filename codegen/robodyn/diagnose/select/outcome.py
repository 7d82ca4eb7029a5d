"""What a search comes to."""

from __future__ import annotations

from dataclasses import dataclass

from robodyn.arrays import Floats
from robodyn.diagnose.select.members import Fit, Member
from robodyn.diagnose.select.score import Trial


@dataclass(frozen=True, slots=True, eq=False)
class Found:
    """A member of the model that was found, its own trial beside the others, and the trials of all families
    there, best first; what the arm's numbers foretell [B] in its place if they are wrong ``throughout``."""

    member: Member
    trial: Trial
    beside: tuple[Trial, ...]
    throughout: Floats | None


@dataclass(frozen=True, slots=True, eq=False)
class Outcome:
    """What a search has found: the ``fit`` with it and that of the model as described, ``begun``."""

    found: tuple[Found, ...]
    fit: Fit
    begun: Fit
    last: tuple[Trial, ...]
