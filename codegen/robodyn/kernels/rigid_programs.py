"""The programs of a robot: the recursion as it is written, the passes, and what records have."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from robodyn.counts import Count
from robodyn.counts.objective import operations_of, parse_objective
from robodyn.dynamics.compose import composed, side_by_side
from robodyn.dynamics.functions import Function, NoSuchFunction, function_named, recursion
from robodyn.dynamics.functions.fusing import AND, one_after_another
from robodyn.dynamics.functions.record import Writing
from robodyn.ir.digits import TooLarge
from robodyn.ir.graph import Graph
from robodyn.ir.program import Input, Program
from robodyn.kernels.drafts import ANEW_JOINTS, CLEARLY, DENSE, OF_PASSES, SMALL, least, total
from robodyn.kernels.options import Options
from robodyn.kernels.proof import prove
from robodyn.optimize.fast import fast_choices
from robodyn.optimize.programs import Choice, NoForwardDynamics, Recursion, build, recursion_in, signature
from robodyn.optimize.records import Record, best_record
from robodyn.optimize.records.rounding import Rounding
from robodyn.optimize.records.validation import adopted, at_rest_of, check_length, check_reading, validated
from robodyn.passes import FAST, FRESH_SAVING, SAVING, SPELLING
from robodyn.robot.masses import unknown_masses
from robodyn.robot.model import Robot

if TYPE_CHECKING:
    from robodyn.optimize.prune import Pruning


class SingularArm(NoForwardDynamics):
    """The mass matrix cannot be inverted in any pose: some joint moves without inertia."""


class RigidPrograms:
    """The programs of a robot before the passes, written in the way that takes the fewest operations in
    the inverse dynamics."""

    def __init__(self, robot: Robot, options: Options, pruning: Callable[[str], None] | None = None) -> None:
        self.robot, self.options = robot, options
        self._pruning = pruning
        choices = options.choices() or fast_choices(robot)
        if unknown_masses(robot):
            choices = choices[:1]  # no torques to compare them by
        #: What a program costs by the objective asked for.
        self._cost: Callable[[Program], float] = total
        if options.objective != "total":
            cost = parse_objective(options.objective).cost
            self._cost = lambda program: cost(operations_of(program))
        self._drafts: dict[str, Program] = {}
        self._after_passes: dict[str, Program] = {}
        self.choice = choices[0] if len(choices) == 1 else self._cheapest(choices)
        self._records: dict[str, Record | None] = {}
        self._best: dict[str, Program] = {}
        self._roundings: dict[str, Rounding] = {}
        #: Functions whose program is a record's, or made of one, and how that was found.
        self.taken: dict[str, str] = {}
        #: Of functions that may be written in several ways the one that takes the fewest operations.
        self._writings: dict[str, Writing] = {}
        #: What pruning did, by function.
        self.prunings: dict[str, Pruning] = {}

    def _cheapest(self, choices: Sequence[Choice]) -> Choice:
        """Of ``choices`` the one whose inverse dynamics takes the fewest operations after the passes."""
        drafts = [build(self.robot, "inverse_dynamics", choice) for choice in choices]
        k, passed = least(drafts, FRESH_SAVING)
        if self.options.engine == "graph":
            self._drafts["inverse_dynamics"], self._after_passes["inverse_dynamics"] = drafts[k], passed
        return choices[k]

    def program(self, function: str) -> Program:
        """The optimised program of ``function``, pruned if that is asked for.

        Raises
        ------
        SingularArm: forward dynamics of an arm in which a joint moves without inertia.
        """
        program = self.best(function)
        if self.options.prune is None or not function_named(function).gives_torques:
            return program
        from robodyn.optimize.prune import prune

        # Without terms that cannot matter; or what the passes alone give without them, where that is less.
        plain = self._passed(function)
        smaller, self.prunings[function] = prune(
            self.robot, function, program, self.options.prune, beside=(plain,), progress=self._pruning
        )
        return smaller

    def rigid_count(self, function: str) -> Count | None:
        """There is nothing on top of the rigid arm."""
        return None

    def best(self, function: str) -> Program:
        """The optimised program of ``function``, exact: from the passes, or what a record has for it if that
        takes fewer operations."""
        if function not in self._best:
            try:
                self._best[function] = self._proven(function)
            except ZeroDivisionError:  # a pivot that is zero, as a number or as a function
                self.taken.pop(function, None)
                raise self.singular(function) from None
            except TooLarge as error:
                raise NoSuchFunction(
                    f"{self.robot.name}: {function} is larger than compilers take",
                    found=f"{self.robot.n} joints, {error.found}",
                    remedy="lock joints or cut the chain, or take a function that grows less: "
                    "forward_dynamics in place of inverse_mass_matrix",
                ) from None
        return self._best[function]

    def _proven(self, function: str) -> Program:
        record = self._recorded(function)
        if record is None or not self._clearly_better(function, record):
            passed = self._passed(function)
            if record is None or self._cost(passed) <= self._cost(record):
                record = passed
                self.taken.pop(function, None)
        prove(self.robot, function, record, self.options.scalar)
        return record

    def _passed(self, function: str) -> Program:
        """The program of ``function`` after the passes of its level."""
        draft = self.draft(function)  # may leave what the passes made of it
        if function not in self._after_passes:
            self._after_passes[function] = draft.changed(lambda part: self._least([part])[1])
        return self._after_passes[function]

    def _least(self, drafts: Sequence[Program]) -> tuple[int, Program]:
        """Which of ``drafts`` costs the least after the passes of the level, and what they make of it."""
        saving = SAVING if self.options.engine == "sympy" else FRESH_SAVING
        return least(drafts, () if self.options.optimize == "none" else saving, self._cost)

    def _clearly_better(self, function: str, program: Program) -> bool:
        """Whether no pass will bring the recursion down to what a record has."""
        if function_named(function).at_rest or self.options.objective != "total":
            return False
        draft = total(self.draft(function))
        return draft > SMALL and total(program) <= OF_PASSES * draft

    def _recorded(self, function: str) -> Program | None:
        """What the records have for ``function``, compared with the recursion: its own, for other torques
        that of the inverse dynamics, for what is composed the parts; None where they have nothing."""
        if not self.options.takes_records:
            return None
        known = function_named(function)
        if known.parts:
            return self._composed(known)
        if known.of_pose:
            return None
        best: Program | None = None
        for source in _sources(known):
            record = self._record(source)
            if record is None:
                continue
            program = record.program if source == function else at_rest_of(record, function)
            passes = SPELLING if source == function else FAST
            inputs = self._inputs(function)
            program = validated(program, self.draft(function), record, passes, inputs, self._rounding(source))
            if best is None or self._cost(program) < self._cost(best):
                best = program
                self.taken[function] = record.origin
        return best

    def _rounding(self, function: str) -> Rounding:
        """What the recursion of ``function`` loses to rounding."""
        if function not in self._roundings:
            self._roundings[function] = Rounding(self.draft(function), self.options.scalar)
        return self._roundings[function]

    def _inputs(self, function: str) -> list[Input]:
        """What the kernel of ``function`` is given."""
        interface = signature(self.robot, function)
        arrays = [Input(name, i) for name, size in interface.inputs for i in range(size)]
        return arrays + [Input(name, None) for name in interface.parameters]

    def _composed(self, function: Function) -> Program | None:
        """A function put together from its parts, if records have any of them."""
        sources = {source for part in function.parts for source in _sources(function_named(part))}
        if all(self._record(source) is None for source in sources):
            return None
        ways = self._of_parts(function)
        origin = next((self.taken[part] for part in function.parts if part in self.taken), None)
        if origin is None:
            return None
        self.taken[function.name] = origin
        return self._least(ways)[1]

    def _of_parts(self, function: Function) -> list[Program]:
        """``function`` put together from the best programs of its parts, in all ways that it has."""

        def beneath(graph: Graph, inputs: Mapping[str, Sequence[Any]]) -> Recursion:
            return recursion_in(graph, self.robot, self.choice, inputs)

        parts = {part: self.best(part) for part in function.parts}
        return composed(function, parts, self.robot.n, beneath)

    def _record(self, function: str) -> Record | None:
        if function not in self._records:
            folders = self.options.record_folders
            given = (record for record in self.options.records if record.function == function)
            record = next(given, None) or best_record(self.robot, function, self.options.objective, folders)
            if record is None and self.options.target is not None:
                record = best_record(self.robot, function, folders=folders)  # fewest operations: close enough
            if record is not None:
                check_length(record, self.draft(function))
                check_reading(record, self._rounding(function))
            else:
                objective = self.options.objective if self.options.target is None else "total"
                record = adopted(self.robot, function, self.draft, self._rounding, objective, folders)
            self._records[function] = record
        return self._records[function]

    def draft(self, function: str) -> Program:
        """The program of ``function``, no pass run yet.

        Raises
        ------
        SingularArm: forward dynamics of an arm in which a joint moves without inertia.
        """
        if function not in self._drafts:
            try:
                self._drafts[function] = self._build(function)
            except ZeroDivisionError:
                raise self.singular(function) from None
        return self._drafts[function]

    def _fused(self, function: Function) -> list[Program]:
        """``function`` written anew as a whole, and put together from the best programs of its parts."""
        alone = "functions that are joined are"
        best = {part.name: self.best(part.name).straight(alone) for part in function.fuses}
        writings = [self._writings.get(part.name, part.outputs) for part in function.fuses]
        # What chooses first should be what has most to lose.
        order = sorted(range(len(writings)), key=lambda k: -self._cost(best[function.fuses[k].name]))
        anew = self._built(function.name, one_after_another(writings, order))
        drafts = [anew, side_by_side(function, list(best.values()))]
        # What records have is as it is; poses and Jacobians, which have none, still share their axes.
        geometric = [part.name for part in function.fuses if part.geometric]
        if len(geometric) > 1 and not self.taken.keys().isdisjoint(best):
            others = [program for name, program in best.items() if name not in geometric]
            drafts.append(side_by_side(function, [self._passed(AND.join(geometric)), *others]))
        return drafts

    def singular(self, function: str) -> SingularArm:
        """The error of an arm in which a joint moves without inertia."""
        return SingularArm(
            f"{self.robot.name} has no {function_named(function).words}",
            found="a joint that moves without inertia: the mass matrix is singular in every pose",
            remedy="give that joint a motor_inertia, or its link an inertia",
        )

    def _build(self, function: str) -> Program:
        if self.options.engine == "sympy":
            from robodyn.kernels.through_sympy import build_through_sympy

            return build_through_sympy(self.robot, function, self.choice)
        known = function_named(function)
        writings: list[Writing] = []
        drafts = self._fused(known) if known.fuses else []
        if not known.fuses and not (known.apart and self.robot.n > ANEW_JOINTS):
            writings, drafts = self._written(known)
        if known.apart:
            drafts += self._of_parts(known)
        k = 0
        if len(drafts) > 1:
            k, self._after_passes[function] = self._least(drafts)
        self._writings[function] = writings[k] if k < len(writings) else known.outputs
        if known.fuses and k == 0:  # the best programs of the parts are not in it
            for part in set(self.taken) - set(self.options.function_names if self.options.functions else ()):
                del self.taken[part]
        return drafts[k]

    def _built(self, function: str, writing: Writing) -> Program:
        return build(self.robot, function, self.choice, writing, scalar=self.options.scalar)

    def _written(self, function: Function) -> tuple[list[Writing], list[Program]]:
        """The ways to write ``function`` that may take the fewest operations, and what they give.

        Of a long arm none over its parts where these alone cost more than another way: mass matrices grow
        with the square of the joints.
        """

        def built(ways: Sequence[Writing]) -> list[Program]:
            return [self._built(function.name, way) for way in ways]

        n = self.robot.n
        others = function.without_effects(n)
        rivals = built(others)
        if rivals and n > ANEW_JOINTS:
            least_of_rivals = min(map(self._cost, rivals))
            if least_of_rivals <= CLEARLY * self._over_parts(function):
                return list(others), rivals
        ways = function.writings(n)
        return [*ways, *others], [*built(ways), *rivals]

    def _over_parts(self, function: Function) -> float:
        """What ``function`` costs over its parts, about and at least; 0 without any."""
        parts = [self.best(part) for part in function.parts]
        results = [x for part in parts for x in part.results()]
        values = sum(type(x) is not Fraction for x in results)
        dense = values >= DENSE * len(results) and self._cost is total
        return sum(map(self._cost, parts)) + (function.beside_parts(self.robot.n) if parts and dense else 0)


def _sources(function: Function) -> tuple[str, ...]:
    """Functions whose records serve ``function``: its own, and for torques those of the inverse dynamics."""
    names = (function.name, recursion().name) if function.gives_torques else (function.name,)
    return tuple(dict.fromkeys(names))
