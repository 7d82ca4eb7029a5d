"""A processor that kernels are made for: its compiler, what operations cost, which board has it; and the
architectures that images are made for, with their emulators.

Every module in ``processors/`` is a target; it is imported when its target is asked for. A module is called
as its target is, ``_`` for ``-``, and has it as ``TARGET``; nothing else has to name it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Final, Literal

from robodyn.errors import InputError, did_you_mean
from robodyn.ir.signature import ScalarType
from robodyn.registry import Registry
from robodyn.tools import Tool, Use

Contraction = Literal["off", "on"]


@dataclass(frozen=True, slots=True)
class Costs:
    """What operations cost on a processor [cycles]; ``fma`` None where products and sums do not fuse."""

    mul: float = 1.0
    add: float = 1.0
    fma: float | None = None
    div: float = 14.0
    sqrt: float = 14.0
    sincos: float = 46.0


@dataclass(frozen=True, slots=True)
class Chip:
    """A chip with the processor, as plans count with it: its clock [MHz], its cores, and how long a value
    takes to get from one core to another, waiting included [ns]. ``source`` says where the figures are from.
    """

    mhz: float
    source: str
    cores: int = 1
    passing_ns: float = 0.0

    @property
    def cycle_ns(self) -> float:
        """Nanoseconds a cycle."""
        return 1e3 / self.mhz


@dataclass(frozen=True, slots=True)
class Architecture:
    """Processors that have their compiler, their emulator and the way an image starts in common.

    ``name`` is the folder in ``templates/firmware`` with what an image needs of the processor: its start,
    output and exit through a debugger, and its counter. ``prefix`` begins the names of the compiler's
    programs, and ``macro`` is what it defines. ``options`` are the emulator's, where an instruction takes
    2^``shift`` ns; ``counter`` is what documents call the processor's counter.
    """

    name: str
    macro: str
    prefix: str
    compiler_package: str
    binutils_package: str
    emulator: Tool
    options: tuple[str, ...]
    counter: str
    shift: int

    @property
    def toolchain(self) -> str:
        """The compiler's triplet: ``arm-none-eabi``."""
        return self.prefix.rstrip("-")

    @property
    def compiler(self) -> Tool:
        """The C compiler, a gcc."""
        return self._tool("gcc", self.compiler_package)

    @property
    def nm(self) -> Tool:
        """What lists the symbols of an object."""
        return self._tool("nm", self.binutils_package)

    @property
    def size(self) -> Tool:
        """What tells the sizes of an object's sections."""
        return self._tool("size", self.binutils_package)

    @property
    def tools(self) -> tuple[Tool, ...]:
        """All programs that build, measure and run an image."""
        return (self.compiler, self.nm, self.size, self.emulator)

    def _tool(self, name: str, package: str) -> Tool:
        return Tool((self.prefix + name,), Use.FIRMWARE, f"images for {self.toolchain}", package)


@dataclass(frozen=True, slots=True)
class Region:
    """Memory of a board from address ``origin`` on, ``length`` as linkers take it: ``4M``."""

    origin: int
    length: str


@dataclass(frozen=True, slots=True)
class Board:
    """A board that the emulator has, by its name there; code and constants are linked into the one region,
    data and stack into the other. The processor's counter runs at ``counter_mhz`` in the emulator, and
    ``options`` are the emulator's for this board."""

    machine: str
    architecture: Architecture
    code: Region
    data: Region
    counter_mhz: float
    options: tuple[str, ...] = ()

    @property
    def ticks(self) -> float:
        """What the counter counts an instruction in the emulator."""
        return (1 << self.architecture.shift) * self.counter_mhz / 1e3

    @property
    def command(self) -> tuple[str, ...]:
        """What runs an image, whose name follows."""
        emulator = self.architecture.emulator.name
        count = ("-icount", f"shift={self.architecture.shift}")
        options = (*self.options, *self.architecture.options, *count)
        return (emulator, "-M", self.machine, *options, "-kernel")


@dataclass(frozen=True, slots=True)
class Target:
    """A processor, and what is chosen for it where no option says otherwise.

    ``flags`` choose the processor for gcc and clang; None: there is no compiler, and it is for plans only.
    ``level`` is that of their optimisation.
    ``scalar``, ``contraction``, ``trig`` and ``order`` are the defaults of generation and ``why`` the reason
    for the contraction; ``lanes`` how many sines its vectors take at once (1: no vectors); ``registers`` how
    many values it keeps at hand. ``hardware`` names the scalar types that its floating-point unit has: for
    the others the compiler calls its own library. ``single`` and ``double`` are the costs of operations on
    float and on double; None: the same. ``costs_as`` names another target that has the same costs, so that
    searches share their records. Without a ``board`` there is no firmware image, without a ``chip`` no plan.
    """

    name: str
    title: str
    single: Costs
    double: Costs | None = None
    why: str = ""
    aliases: tuple[str, ...] = ()
    flags: tuple[str, ...] | None = None
    level: Literal["-O2", "-O3"] = "-O2"
    scalar: ScalarType = "double"
    contraction: Contraction = "off"
    trig: Literal["builtin"] = "builtin"
    order: Literal["registers"] = "registers"
    lanes: int = 1
    registers: int = 16
    hardware: tuple[ScalarType, ...] = ("float", "double")
    costs_as: str = ""
    chip: Chip | None = None
    board: Board | None = None

    def costs_of(self, scalar: ScalarType) -> Costs:
        """What operations on ``scalar`` cost."""
        return self.single if scalar == "float" or self.double is None else self.double

    @property
    def costs(self) -> Costs:
        """What operations on its own scalar type cost: what searches weigh."""
        return self.costs_of(self.scalar)

    @property
    def objective(self) -> str:
        """What searches make small for it, as ``--objective`` has it."""
        return f"weighted:{self.costs_as or self.name}"

    def compiled(self, contraction: Contraction) -> str:
        """The flags of gcc and clang, for ``contraction``."""
        contract = f"-ffp-contract={'fast' if contraction == 'on' else 'off'}"
        return " ".join(("-std=c99", self.level, *(self.flags or ()), contract, "-fno-math-errno"))


#: Targets by name, in the order of their names.
TARGETS: Final[Mapping[str, Target]] = Registry(f"{__package__}.processors", "TARGET", Target)


def all_targets() -> tuple[Target, ...]:
    """All of them; each has costs, so that searches can weigh operations for it."""
    return tuple(TARGETS.values())


def compiled_targets() -> tuple[Target, ...]:
    """Those that kernels are compiled for."""
    return tuple(target for target in all_targets() if target.flags is not None)


def firmware_targets() -> tuple[Target, ...]:
    """Those that have a board, hence a firmware image."""
    return tuple(target for target in all_targets() if target.board is not None)


def planned_targets() -> tuple[Target, ...]:
    """Those whose clock is known, so that a plan can be made for them."""
    return tuple(target for target in all_targets() if target.chip is not None)


def target_named(
    name: str,
    among: Iterable[Target] | None = None,
    *,
    what: str = "unknown target",
    others: str = "",
) -> Target:
    """The target called ``name``, or by one of its other names; ``among`` is all of them where it is None.

    Raises
    ------
    InputError: there is none. ``what`` begins the message, and ``others`` ends the list of what is expected.
    """
    if among is None and name in TARGETS:
        return TARGETS[name]
    known = {target.name: target for target in (all_targets() if among is None else among)}
    spellings = {alias: target for target in known.values() for alias in (target.name, *target.aliases)}
    if name not in spellings:
        raise InputError(
            f"{what} {name!r}",
            expected=f"one of {', '.join(known)}{others}",
            remedy=did_you_mean(name, spellings),
        )
    return spellings[name]


#: An image is run without a screen, and talks through the debugger.
_QUIET = (
    "-display", "none", "-monitor", "none", "-serial", "none", "-semihosting-config",
    "enable=on,target=native",
)  # fmt: skip

#: Cortex-M. SysTick has 24 bits: instructions are slow, lest it runs over.
CORTEX_M = Architecture(
    name="arm",
    macro="__arm__",
    prefix="arm-none-eabi-",
    compiler_package="gcc-arm-none-eabi",
    binutils_package="binutils-arm-none-eabi",
    emulator=Tool(
        ("qemu-system-arm",), Use.FIRMWARE, "images run and measured without a board", "qemu-system-arm"
    ),
    options=_QUIET,
    counter="SysTick",
    shift=5,
)


def mps2(machine: str) -> Board:
    """One of Arm's boards MPS2, with a Cortex-M3, M4 or M7."""
    return Board(machine, CORTEX_M, Region(0x0000_0000, "4M"), Region(0x2000_0000, "4M"), counter_mhz=25.0)


#: RISC-V with 32 bits, where an image has the machine to itself; mcycle then counts nanoseconds.
RISCV = Architecture(
    name="riscv",
    macro="__riscv",
    prefix="riscv64-unknown-elf-",
    compiler_package="gcc-riscv64-unknown-elf",
    binutils_package="binutils-riscv64-unknown-elf",
    emulator=Tool(
        ("qemu-system-riscv32",), Use.FIRMWARE, "images run and measured without a board", "qemu-system-misc"
    ),
    options=(*_QUIET, "-bios", "none"),
    counter="mcycle",
    shift=0,
)
