"""Run the search of ``--optimize search`` and ``full``."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Final

from robodyn.errors import InputError

if TYPE_CHECKING:
    from robodyn.kernels.generate import Options
    from robodyn.optimize.records import Record
    from robodyn.robot import Robot
    from robodyn.search.improve import Progress
    from robodyn_cli.progress import Line

#: With --on, so many seeds are tried unless --seeds says otherwise.
SEEDS: Final = 8
#: Share of the time for the inverse dynamics if other functions are searched for as well.
_FIRST = 0.8


@dataclass(frozen=True, slots=True)
class Search:
    """The options of a search: see :func:`robodyn_cli.options.search_options`."""

    budget_seconds: float | None
    seed: int
    objective: str
    keep: bool
    on: str | None = None
    seeds: int | None = None

    def applied(self, robot: Robot, options: Options, functions: Sequence[str]) -> Options:
        """``options`` with the records that a search for ``functions`` finds, if they request one.

        Raises
        ------
        InputError: options that cannot be combined.
        """
        if self.objective != "total":
            from robodyn.counts.objective import parse_objective

            options = replace(options, objective=parse_objective(self.objective).key)
        if options.optimize not in ("search", "full"):
            for name in ("budget_seconds", "keep", "on", "seeds"):
                if getattr(self, name) not in (None, False):
                    found, expected = f"--optimize {options.optimize}", "--optimize search or full"
                    option = f"--{name.replace('_', '-')}"
                    raise InputError(f"{option} requires a search", found=found, expected=expected)
            return options
        if self.seeds is not None and self.on is None:
            raise InputError("--seeds says nothing without --on", remedy="add --on local")
        from robodyn.robot.coupling import no_couplings

        if not options.takes_records:
            regroup = "" if options.regroup else " --no-regroup"
            raise InputError(
                "a search supports only modified_newton_euler with regrouping and the graph engine",
                found=f"--formulation {options.formulation} --engine {options.engine}{regroup}",
                remedy="remove these options, or use --optimize fast",
            )
        no_couplings(robot, "a search")
        return self._searched(robot, options, functions)

    def _searched(self, robot: Robot, options: Options, functions: Sequence[str]) -> Options:
        from robodyn.files import cannot_write
        from robodyn.optimize.records import folder_beside
        from robodyn.resources import from_here
        from robodyn.search.improve import BUDGET, write_record
        from robodyn_cli.output import printable, talk
        from robodyn_cli.progress import line

        folder = folder_beside(robot)
        wanted = _searchable(functions, options.optimize)
        budget = BUDGET[options.optimize] if self.budget_seconds is None else self.budget_seconds
        records = []
        for k, function in enumerate(wanted):
            share = 1.0 if len(wanted) == 1 else _FIRST if k == 0 else (1 - _FIRST) / (len(wanted) - 1)
            with line() as shown:
                records.append(self._record(robot, options, function, share * budget, shown))
            record = records[-1]
            if self.keep:
                try:
                    talk(f"robodyn: wrote {printable(from_here(write_record(record, folder)))}")
                except OSError as error:
                    raise cannot_write(
                        f"to {printable(from_here(folder))}", error, "remove --keep, or free some space there"
                    ) from error
        return replace(options, records=tuple(records))

    def _record(self, robot: Robot, options: Options, function: str, seconds: float, shown: Line) -> Record:
        """What a search for a ``function`` finds in ``seconds``, or many of them on other processes."""
        from robodyn.counts.objective import parse_objective
        from robodyn.drives.drive import rigid_part
        from robodyn.search.improve import improved
        from robodyn.search.seeds import best_of_seeds

        work: dict[str, Any] = {
            "level": options.optimize, "function": function, "seconds": seconds,
            "objective": parse_objective(self.objective),
        }  # fmt: skip
        head = f"robodyn: {robot.name} {function}"
        if self.on is None:

            def tell(at: Progress) -> None:
                time = f"{at.seconds:.0f} of {at.of:.0f} s"
                shown.tell(f"{head}: {at.stage}, {time}, {self.objective} {at.best:.6g}")

            return improved(rigid_part(robot), seed=self.seed, progress=tell, **work)
        count = self.seeds or SEEDS

        def tell_seeds(done: int, best: float) -> None:
            shown.tell(f"{head}: {done} of {count} searches, {self.objective} {best:.6g}", at_once=True)

        seeds = range(self.seed, self.seed + count)
        return best_of_seeds(rigid_part(robot), self.on, seeds, progress=tell_seeds, **work)


def _searchable(functions: Sequence[str], level: str) -> list[str]:
    """The functions to search for. The other torques follow from the
    inverse dynamics if it is among them, and formulation variants exist for the inverse dynamics only."""
    from robodyn.dynamics.functions import function_named, recursion

    wanted = [f for f in functions if function_named(f).searchable]
    if recursion().name in wanted:
        others = [f for f in wanted if not function_named(f).gives_torques]
        wanted = [recursion().name, *(others if level == "full" else [])]
    return wanted
