"""Programs of robots whose joints follow others: those of the joints, each moving by itself, are mapped to
the coordinates before they are optimised; what is solved for is put together of such programs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from robodyn.counts import Count
from robodyn.drives.drive import has_drive_effects, rigid_part
from robodyn.dynamics.compose import side_by_side
from robodyn.dynamics.equality import same_in_field
from robodyn.dynamics.functions import Function, function_named
from robodyn.dynamics.functions.fusing import parts_of
from robodyn.dynamics.functions.record import WRENCH
from robodyn.errors import InputError
from robodyn.ir.field import FINAL_BITS
from robodyn.ir.fingerprint import agree
from robodyn.ir.program import Program
from robodyn.kernels.condition import meets_condition
from robodyn.kernels.drafts import least
from robodyn.kernels.layered import Layered
from robodyn.kernels.options import Options
from robodyn.kernels.proof import Unequal
from robodyn.kernels.rigid_programs import RigidPrograms
from robodyn.kernels.with_effects import check_solvable
from robodyn.optimize.coupled import folded, in_coordinates
from robodyn.optimize.fast import fast_choices
from robodyn.optimize.programs import build, signature
from robodyn.passes import FRESH_SAVING
from robodyn.robot.identity import identity
from robodyn.robot.masses import unknown_masses
from robodyn.robot.model import Robot
from robodyn.robot.values import circle_point

if TYPE_CHECKING:
    from robodyn.optimize.prune import Pruning


class Coupled:
    """The programs of ``robot``, whose joints follow others, in the coordinates that are commanded.

    Raises
    ------
    InputError: an option does not go with joints that follow others.
    """

    def __init__(self, robot: Robot, options: Options) -> None:
        asked = {
            "--prune": options.prune is not None,
            f"--engine {options.engine}": options.engine != "graph",
            f"--optimize {options.optimize}": options.optimize in ("search", "full"),
            "records": bool(options.records),
        }
        if any(asked.values()):
            raise InputError(
                f"{robot.name} has joints that follow others, which go with --optimize none and fast only",
                found=", ".join(option for option, there in asked.items() if there),
                expected="--optimize fast or none, --engine graph, and no --prune",
                remedy="leave the option out",
            )
        self.robot, self.options = robot, options
        free = replace(options, optimize="none" if options.optimize == "none" else "fast")
        layered = Layered(robot.free, free) if has_drive_effects(robot) else None
        #: Of the joints, each moving by itself: the rigid arm's programs.
        self.rigid = RigidPrograms(rigid_part(robot.free), free) if layered is None else layered.rigid
        self._layered = layered
        self._saving = () if options.optimize == "none" else FRESH_SAVING
        self._programs: dict[str, Program] = {}
        #: Nothing is pruned.
        self.prunings: dict[str, Pruning] = {}
        if layered is not None and layered.has_states:
            raise InputError(
                f"{robot.name} has effects that remember, and joints that follow others",
                found="joint_elasticity, backlash or presliding_hysteresis",
                expected="effects without memory, or joints that move by themselves",
                remedy="leave those effects out",
            )
        if layered is None:
            self._choose()

    def _choose(self) -> None:
        """Take the way to write the recursion that takes the fewest operations here, not of the free arm."""
        choices = self.options.choices() or fast_choices(self.rigid.robot)
        if len(choices) > 1 and not unknown_masses(self.robot):
            record = function_named("inverse_dynamics")
            drafts = [
                folded(build(self.rigid.robot, record.name, choice), record, self.robot) for choice in choices
            ]
            self.rigid.choice = choices[least(drafts, self._saving)[0]]

    def program(self, function: str) -> Program:
        """The program of ``function``, compared with plain Newton-Euler at joints that follow.

        Raises
        ------
        NoSuchFunction: the robot has no such function.
        """
        if function not in self._programs:
            record = function_named(function)
            signature(self.robot, function)  # says what there is not
            check_solvable(self.robot.free, record)
            try:
                _, program = least(self._drafts(record), self._saving)
                self._prove(record, program)
            except ZeroDivisionError:  # a pivot that is zero
                raise self.rigid.singular(function) from None
            self._programs[function] = program
        return self._programs[function]

    def _drafts(self, record: Function) -> list[Program]:
        """All ways to write ``record``."""
        if record.in_coordinates is not None:
            return [in_coordinates(record, self.robot, self.program)]
        drafts: list[Program] = []
        if record.fuses:
            drafts = [side_by_side(record, [self.program(part.name) for part in record.fuses])]
            if any(part.in_coordinates for part in record.fuses):
                return drafts
        return drafts + [folded(draft, record, self.robot) for draft in self._of_joints(record)]

    def _of_joints(self, record: Function) -> Sequence[Program]:
        """All ways to write ``record`` of the joints, each moving by itself."""
        if self._layered is not None and record.drives and not record.geometric:
            return self._layered.drafts(record)
        arm, n = self.rigid.robot, self.robot.n
        ways = (*record.writings(n), *record.without_effects(n))
        scalar = self.options.scalar
        return [build(arm, record.name, self.rigid.choice, way, scalar=scalar) for way in ways]

    def _prove(self, record: Function, program: Program) -> None:
        if record.fuses:  # each part by itself
            elements = program.results()
            m, links = len(self.robot.commanded), self.robot.n
            for part, own in parts_of(record.fuses, elements, m, links):
                names = [array.name for array in part.results]
                outputs = tuple(output for output in program.outputs if output[0] in names)
                assert len(own) == sum(len(values) for _, values in outputs)
                self._prove(part, replace(program, outputs=outputs))
            return
        if record.geometric or self._layered is None:
            same = same_in_field(rigid_part(self.robot), record.name, program)
        elif WRENCH in record.inputs and record.in_coordinates is None:
            # What bearings feel of a wrench no condition says: by the recursion of the book with the drives.
            plain = folded(self._layered.plain(record), record, self.robot)
            context = (identity(self.robot).encode(), record.name.encode())
            same = agree(program, plain, circle_point, *context, bits=FINAL_BITS)
        else:
            same = meets_condition(self.robot, record.name, program)
        if not same:
            raise Unequal(
                f"{record.name} of {self.robot.name} differs from plain Newton-Euler at joints that follow "
                "others; please report the robot file"
            )

    def rigid_count(self, function: str) -> Count | None:
        """Not told: there is no rigid arm beneath that has these coordinates."""
        return None

    @property
    def notes(self) -> tuple[str, ...]:
        """What the head of the files says of how the programs were built."""
        return ()
