"""What a kernel looks like from outside: its name, its arrays, its run-time parameters."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

ScalarType = Literal["double", "float"]


@dataclass(frozen=True, slots=True)
class Signature:
    """The interface of one emitted function.

    ``inputs`` and ``outputs`` are ``(name, length)`` in the order of the C arguments; a matrix is one
    row-major array. ``parameters`` are the members of ``NAME_params``, which comes last if there are any.
    """

    robot: str
    function: str
    inputs: tuple[tuple[str, int], ...]
    outputs: tuple[tuple[str, int], ...]
    parameters: tuple[str, ...] = ()
    scalar: ScalarType = "double"
    #: Members of ``NAME_state``: a function that has any takes ``NAME_state *state, NAME_real dt`` last.
    states: tuple[str, ...] = ()
    #: How many joints the robot has; 0 where it is not known.
    joints: int = 0
    #: What each base parameter is, where a function has any: a column of the regressor.
    columns: tuple[str, ...] = ()

    #: What the function is called in emitted code, if not by its own name.
    alias: str = ""

    @property
    def called(self) -> str:
        """What the function is called in emitted code."""
        return self.alias or self.function

    @property
    def symbol(self) -> str:
        """The C symbol."""
        return f"{self.robot}_{self.called}"
