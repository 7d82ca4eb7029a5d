"""What to generate and how."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from robodyn.dynamics.functions import FUNCTIONS, by_default, function_named
from robodyn.errors import InputError, did_you_mean
from robodyn.ir.signature import ScalarType
from robodyn.optimize.programs import FORMULATIONS, Choice
from robodyn.optimize.records import Record

if TYPE_CHECKING:
    from robodyn.targets import Contraction, Target

Level = Literal["none", "fast", "search", "full", "record"]
Trigonometry = Literal["libm", "builtin", "given"]
Engine = Literal["graph", "sympy"]
Order = Literal["auto", "recursion", "registers"]

LEVELS: tuple[Level, ...] = ("none", "fast", "search", "full", "record")
TRIGONOMETRY: tuple[Trigonometry, ...] = ("libm", "builtin", "given")
SCALARS: tuple[ScalarType, ...] = ("double", "float")
CONTRACTIONS: tuple[Contraction, ...] = ("off", "on")
ENGINES: tuple[Engine, ...] = ("graph", "sympy")
ORDERS: tuple[Order, ...] = ("auto", "recursion", "registers")
#: What a target chooses.
CHOSEN = ("scalar", "trig", "order", "contraction", "objective")


#: In place of a function's name: all that the robot has.
ALL = "all"

#: Options that the head of a file names where they are not as usual.
_SHOWN = ("functions", "formulation", "engine", "order", "objective", "target", "contraction", "prune")


@dataclass(frozen=True, slots=True)
class Options:
    """What to generate and how; the defaults are those of ``robodyn gen``.

    ``functions`` None is those that are written by default, ``("all",)`` all there are, as far as the robot
    has them, but ``without`` these: an arm with a joint that moves without inertia has no forward dynamics.
    ``optimize="none"`` is the recursion as it stands in the book, equal nodes merged and zeros gone;
    ``"fast"`` takes milliseconds; ``"record"`` is the committed best for exactly this arm, else
    fast; ``"search"`` and ``"full"`` ask for a better one (:func:`robodyn.search.improve.improved`) and take
    the one in ``records``. ``regroup=False`` leaves out base-parameter regrouping only. ``engine="sympy"``
    builds the same model through sympy with named intermediates and ``sympy.cse``: a cross-check, slower and
    no smaller, without records (``"record"`` becomes ``"fast"``).
    ``order="recursion"`` is the order of the book, ``"registers"`` one in which few values wait in memory
    (:func:`robodyn.passes.registers.registers`); ``"auto"`` is the latter unless sine and cosine are libm's.

    ``records`` are records at hand; ``record_folders`` are looked through for more, before the folder beside
    the robot's file and the bundled one.
    ``misra`` writes C for MISRA C:2012: the same operations, products within sums in parentheses, and every
    rule that is not kept explained in the head.
    ``readable`` writes the book's order, ``optimize="none"`` and ``order="recursion"``, and names every value
    after its step; the defaults of these two give way to it, other values are refused.
    ``target`` names the processor (:meth:`for_target` takes what it chooses); ``contraction``, on or off, is
    whether compilers may fuse products and sums; None leaves that to their flags.
    ``prune`` is the share of each joint's peak torque that may be wrong (:mod:`robodyn.optimize.prune`).
    ``derivatives`` adds the functions that have the derivatives of those asked for, as far as the robot has
    them.
    """

    functions: tuple[str, ...] | None = None
    formulation: str = "modified_newton_euler"
    optimize: Level = "record"
    regroup: bool = True
    scalar: ScalarType = "double"
    trig: Trigonometry = "libm"
    engine: Engine = "graph"
    order: Order = "auto"
    objective: str = "total"
    target: str | None = None
    contraction: Contraction | None = None
    records: tuple[Record, ...] = ()
    record_folders: tuple[Path, ...] = ()
    prune: Fraction | None = None
    misra: bool = False
    readable: bool = False
    without: tuple[str, ...] = ()
    derivatives: bool = False

    def __post_init__(self) -> None:
        if self.functions is not None:
            _check_functions(self.functions)
        _one_of("formulation", self.formulation, tuple(FORMULATIONS))
        _one_of("level of optimisation", self.optimize, LEVELS)
        _one_of("scalar", self.scalar, SCALARS)
        _one_of("kind of sine and cosine", self.trig, TRIGONOMETRY)
        _one_of("engine", self.engine, ENGINES)
        _one_of("order", self.order, ORDERS)
        if self.readable:
            self._as_in_the_book()
        if self.engine == "sympy" and self.optimize == "record":
            object.__setattr__(self, "optimize", "fast")  # what it is: records hold programs of the graph
        if self.target is not None:
            object.__setattr__(self, "target", _target(self.target).name)
        if self.contraction is not None:
            _one_of("contraction", self.contraction, CONTRACTIONS)
        if self.prune is not None:
            from robodyn.optimize.prune import check_asked

            check_asked(self.prune, self.functions and self.function_names)

    @property
    def function_names(self) -> tuple[str, ...]:
        """Names of the functions that are asked for, or would be if the robot had them."""
        if self.functions is None:
            names: tuple[str, ...] = by_default()
        else:
            all_there_are = (name for name in FUNCTIONS if ALL in self.functions and name not in self.without)
            names = (*all_there_are, *(name for name in self.functions if name != ALL))
        if self.derivatives:
            of_each = (function_named(name).derivatives for name in names)
            names = (*names, *(derivative.function for each in of_each for derivative in each))
        return tuple(dict.fromkeys(names))

    def insists_on(self, function: str) -> bool:
        """Whether ``function`` is asked for by its name: a robot that does not have it is refused."""
        return self.functions is not None and function in self.functions

    def _as_in_the_book(self) -> None:
        """Take what ``readable`` stands for, or refuse what contradicts it."""
        contradictions = [
            f"--{name} {value}"
            for name, value, fitting in (
                ("optimize", self.optimize, ("record", "none")),
                ("order", self.order, ("auto", "recursion")),
            )
            if value not in fitting
        ]
        if self.prune is not None:
            contradictions.append("--prune")
        if contradictions:
            raise InputError(
                "--readable writes the recursion as it stands in the book",
                found=", ".join(contradictions),
                expected="--optimize none, --order recursion and no --prune with --readable",
                remedy="remove --readable or what contradicts it",
            )
        object.__setattr__(self, "optimize", "none")
        object.__setattr__(self, "order", "recursion")

    @classmethod
    def for_target(cls, name: str, **chosen: Any) -> Options:
        """What :data:`robodyn.targets.TARGETS` says of ``name``; ``chosen`` goes before it.

        Raises
        ------
        InputError: there is no such target, or a choice is unknown.
        """
        target = _target(name)
        own = {what: getattr(target, what) for what in CHOSEN}
        return cls(**{**own, **chosen, "target": target.name})

    @property
    def profile(self) -> Target | None:
        """The target, if one is named."""
        return None if self.target is None else _target(self.target)

    def choices(self) -> tuple[Choice, ...]:
        """The one way of writing the recursion that is asked for; none where the robot decides."""
        as_in_the_book = Choice(self.formulation, regroup=False, chains=False)
        if self.formulation != "modified_newton_euler" or self.optimize == "none" or not self.regroup:
            return (as_in_the_book,)
        return ()

    @property
    def text(self) -> str:
        """These options as the command line has them: precision, sines and level always, the rest where it
        is not as usual. Records and their folders are not named: the head says which program was taken."""
        usual = Options()
        words = [f"--optimize {self.optimize}", f"--scalar {self.scalar}", f"--trig {self.trig}"]
        for name in _SHOWN:
            value = getattr(self, name)
            if value != getattr(usual, name):
                text = f"{float(value)!r}" if isinstance(value, Fraction) else value
                words.append(f"--{name} {','.join(value) if isinstance(value, tuple) else text}")
        words += (
            ["--no-regroup"] * (not self.regroup) + ["--misra"] * self.misra + ["--readable"] * self.readable
        )
        return " ".join(words)

    @property
    def by_registers(self) -> bool:
        """Whether operations come in the order for registers: unless libm takes most of the time anyway."""
        return self.order == "registers" or (self.order == "auto" and self.trig != "libm")

    @property
    def takes_records(self) -> bool:
        """Whether a record may stand in for the recursion that these options ask for."""
        plain = self.formulation == "modified_newton_euler" and self.regroup and self.engine == "graph"
        return plain and self.optimize not in ("none", "fast")


def _target(name: str) -> Target:
    from robodyn.targets import compiled_targets, target_named

    return target_named(name, compiled_targets())


def _check_functions(functions: tuple[str, ...]) -> None:
    if not functions:
        raise InputError("no function asked for", expected=f"some of {', '.join(FUNCTIONS)}")
    for function in functions:
        if function != ALL:
            function_named(function)
    if len(set(functions)) != len(functions):
        raise InputError("a function is asked for twice", found=", ".join(functions))


def _one_of(what: str, value: str, allowed: Sequence[str]) -> None:
    if value not in allowed:
        raise InputError(
            f"unknown {what} {value!r}",
            expected=f"one of {', '.join(allowed)}",
            remedy=did_you_mean(value, allowed),
        )
