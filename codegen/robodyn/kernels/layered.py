"""Programs of robots whose drives have effects: the rigid arm's best program, and the drives on top of it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from robodyn.counts import Count, count
from robodyn.drives.drive import rigid_part
from robodyn.errors import InputError
from robodyn.ir.fingerprint import agree
from robodyn.ir.program import Program
from robodyn.kernels.drafts import Drafts
from robodyn.kernels.options import Options
from robodyn.kernels.proof import Unequal
from robodyn.kernels.with_effects import REACTIONS, forward_dynamics, needs_reactions, with_effects
from robodyn.optimize.programs import FORMULATIONS
from robodyn.passes import FRESH, SPELLING, run, unchecked
from robodyn.robot.identity import identity
from robodyn.robot.model import Robot
from robodyn.robot.values import circle_point

if TYPE_CHECKING:
    from robodyn.optimize.prune import Pruning

#: Functions in which anything moves: else no bearing rubs.
_MOVING = ("inverse_dynamics", "bias")


class Layered:
    """The programs of a robot with effects; ``rigid`` makes those of the rigid arm beneath.

    Raises
    ------
    InputError: an option does not go with effects.
    """

    def __init__(self, robot: Robot, options: Options) -> None:
        if options.prune is not None:
            raise InputError(
                f"{robot.name} has effects, whose errors --prune cannot bound",
                remedy="leave out --prune, or the effects",
            )
        if options.engine != "graph":
            raise InputError("effects go with the engine graph only", found=options.engine)
        self.robot, self.options = robot, options
        self.rigid = Drafts(rigid_part(robot), options)
        self._reactions = needs_reactions(robot)
        self._programs: dict[str, Program] = {}
        #: Nothing is pruned.
        self.prunings: dict[str, Pruning] = {}

    def program(self, function: str) -> Program:
        """The program of ``function``, compared with plain Newton-Euler and the same drives.

        Raises
        ------
        SingularArm, ImplicitDynamics: there is no forward dynamics.
        """
        if function not in self._programs:
            self._programs[function] = self._made(function)
        return self._programs[function]

    def _made(self, function: str) -> Program:
        if function == "forward_dynamics":
            parts = self.program("bias"), self.program("mass_matrix")
            try:
                composed = forward_dynamics(self.robot, *parts)
                made = unchecked(composed, FRESH)
                self._compare(function, made, composed)
            except ZeroDivisionError:  # a pivot that is zero as a number or, in a drawn field, as a function
                raise self.rigid.singular() from None
            return made
        inside = self._reactions and function in _MOVING
        rigid = None if inside else self.rigid.best(function)
        formulation = self.options.formulation
        if inside and formulation not in REACTIONS:
            raise InputError(
                f"the formulation {formulation} has no forces in the joints, which bearings feel",
                expected=" or ".join(name for name in FORMULATIONS if name in REACTIONS),
            )
        draft = with_effects(self.robot, function, rigid, formulation)
        made = run(draft, SPELLING if self.options.optimize == "none" else FRESH)
        self._prove(function, made)
        return made

    def _prove(self, function: str, made: Program) -> None:
        """Compare with the recursion of the book: in finite fields, where roots and the like are random
        functions, so that their arguments must be equal as well."""
        rigid = None
        if function == "mass_matrix":
            rigid = self.rigid.best(function)  # proven there; the rotors are put on it here
        plain = with_effects(self.robot, function, rigid, "newton_euler")
        self._compare(function, made, plain)

    def _compare(self, function: str, made: Program, plain: Program) -> None:
        context = (identity(self.robot).encode(), function.encode())
        if not all(agree(made, plain, circle_point, *context, tag) for tag in (b"one", b"two")):
            raise Unequal(f"{function} of {self.robot.name} differs from plain Newton-Euler with its effects")

    def rigid_count(self, function: str) -> Count | None:
        """Operations of the rigid arm beneath; None of functions that are composed."""
        return None if function == "forward_dynamics" else count(self.rigid.best(function))

    @property
    def notes(self) -> tuple[str, ...]:
        """What the head of the files says of the effects."""
        lines = [
            f"{entry.effect}" + (f" at joint {entry.joint}" if entry.joint else "")
            for entry in self.robot.effects
        ]
        told = ["Effects: " + ", ".join(lines) + "."]
        if self._reactions:
            told.append(
                f"Of {' and '.join(_MOVING)} the links are as described, nothing moved to a parent: bearings "
                "feel the forces in the joints."
            )
        return tuple(told)
