"""Programs of robots whose drives have effects: the rigid arm's best program, and the drives on top of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from robodyn.counts import Count, count
from robodyn.drives.drive import layer_of, rigid_part
from robodyn.dynamics.compose import composed
from robodyn.dynamics.functions import FUNCTIONS, Function, function_named
from robodyn.dynamics.functions.record import WRENCH
from robodyn.errors import InputError
from robodyn.ir.field import FINAL_BITS
from robodyn.ir.fingerprint import agree
from robodyn.ir.graph import Graph
from robodyn.ir.program import Program
from robodyn.kernels.condition import meets_condition
from robodyn.kernels.drafts import least
from robodyn.kernels.options import Options
from robodyn.kernels.proof import Unequal
from robodyn.kernels.rigid_programs import RigidPrograms
from robodyn.kernels.with_effects import as_is, check_solvable, is_affine, layered
from robodyn.optimize.programs import Choice, Recursion, recursion_in
from robodyn.passes import FRESH_SAVING
from robodyn.robot.identity import identity
from robodyn.robot.model import Robot
from robodyn.robot.values import circle_point

if TYPE_CHECKING:
    from robodyn.optimize.prune import Pruning


def moving() -> tuple[str, ...]:
    """Torques in which anything moves: else no bearing rubs."""
    return tuple(name for name, f in FUNCTIONS.items() if f.zeros is not None and "qd" not in f.zeros)


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
        self.rigid = RigidPrograms(rigid_part(robot), options)
        layer = layer_of(robot, as_is, lambda _: 1)
        #: Whether bearings feel forces, which regrouped links do not show; whether effects remember.
        self._reactions, self.has_states = bool(layer.needs_reactions), bool(layer.state_names)
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
            self._programs[function] = self._build(function)
        return self._programs[function]

    def _build(self, function: str) -> Program:
        record = function_named(function)
        if record.geometric or not record.drives:
            return self.rigid.best(function)
        check_solvable(self.robot, record)
        try:
            _, passed = least(self.drafts(record), () if self.options.optimize == "none" else FRESH_SAVING)
            self._prove(record, passed)
        except ZeroDivisionError:  # a pivot that is zero as a number or, in a drawn field, as a function
            raise self.rigid.singular(function) from None
        return passed

    def drafts(self, record: Function) -> list[Program]:
        """All ways to write ``record``: from its parts, and straight."""
        writings = range(len(record.writings(self.robot.n)))
        drafts: list[Program] = []
        remembers = any(function_named(part).is_recursion for part in record.parts) and self.has_states
        # A step of what remembers is the inverse dynamics' own: elsewhere effects are in their steady form.
        # Friction that depends on the load feels a wrench: nothing can be taken from torques afterwards.
        felt = WRENCH in record.inputs and not is_affine(self.robot)
        if record.parts and not remembers and not felt:

            def beneath(graph: Graph, inputs: Mapping[str, Sequence[Any]]) -> Recursion:
                return recursion_in(graph, rigid_part(self.robot), Choice(), inputs)

            parts = {part: self.program(part) for part in record.parts}
            drafts = composed(record, parts, self.robot.n, beneath)
            if record.by_parts is None:
                return drafts
        straight = (
            layered(self.robot, record, self._rigid, self.options.formulation, writing=k) for k in writings
        )
        return [*drafts, *straight]

    def _rigid(self, function: str) -> Program | None:
        """The rigid arm's best program, unless bearings feel what moves."""
        return None if self._reactions and function in moving() else self.rigid.best(function)

    def plain(self, record: Function) -> Program:
        """``record`` by the recursion of the book, with the drives on it."""

        def rigid(function: str) -> Program | None:
            # The mass matrix is proven beneath; the rotors are put on it here.
            return None if function_named(function).gives_torques else self.rigid.best(function)

        return layered(self.robot, record, rigid, "newton_euler", writing=None)

    def _prove(self, record: Function, program: Program) -> None:
        """Compare ``program`` with another formula in a finite field, where roots and the like are random
        functions, so that their arguments must be equal as well; or, where there is none, with the condition
        on it at 60 digits.

        Raises
        ------
        Unequal: they differ.
        """
        if record.expected is None:
            same = meets_condition(self.robot, record.name, program)
        else:
            context = (identity(self.robot).encode(), record.name.encode())
            same = agree(program, self.plain(record), circle_point, *context, bits=FINAL_BITS)
        if not same:
            raise Unequal(
                f"{record.name} of {self.robot.name} differs from plain Newton-Euler with its effects; "
                "please report the robot file"
            )

    def rigid_count(self, function: str) -> Count | None:
        """Operations of the rigid arm beneath; None of functions that are composed."""
        record = function_named(function)
        return None if record.parts and record.by_parts is None else count(self.rigid.best(function))

    @property
    def notes(self) -> tuple[str, ...]:
        """What the head of the files says of how the programs were built."""
        if not self._reactions:
            return ()
        return (
            f"Of {' and '.join(moving())} the links are as described, nothing moved to a parent: "
            "bearings feel the forces in the joints.",
        )
