"""What this machine has of the programs and libraries that robodyn can use, and in which version."""

from __future__ import annotations

import importlib.metadata
import re
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any, Final

from robodyn.errors import InputError, did_you_mean
from robodyn.toolchain.running import end_all, run
from robodyn.tools import Library, Tool, Use
from robodyn.tools.libraries import OPTIONAL, REQUIRED
from robodyn.tools.programs import PROGRAMS

#: How long a program may take to say its version [s].
SECONDS: Final = 10.0
#: How many are asked at a time.
_AT_ONCE: Final = 8


@dataclass(frozen=True, slots=True)
class ToolState:
    """What this machine has of a tool: ``where`` it is (None: nowhere), its ``version`` if it says one, and
    the ``fault`` of one that is there and does not answer."""

    tool: Tool | Library
    where: str | None = None
    version: str | None = None
    fault: str | None = None

    @property
    def works(self) -> bool:
        """Whether it is there and answers."""
        return self.where is not None and self.fault is None

    def to_dict(self) -> dict[str, Any]:
        """As ``robodyn doctor --json`` has it."""
        return {
            "name": self.tool.name,
            "kind": "library" if isinstance(self.tool, Library) else "program",
            "use": str(self.tool.use),
            "enables": self.tool.enables,
            **{key: getattr(self, key) for key in ("works", "version", "where", "fault")},
            "install": self.tool.install,
        }


def known() -> tuple[Tool | Library, ...]:
    """All tools, in the order of their uses; only those of every installation where one of these is missing,
    since languages and processors cannot be read then."""
    if not all(library.present() for library in REQUIRED):
        return REQUIRED
    from robodyn.emit.languages import LANGUAGES
    from robodyn.targets import firmware_targets

    compilers = [language.compiled.compiler for language in LANGUAGES.values() if language.compiled]
    takers = [tool for language in LANGUAGES.values() for tool in language.takers]
    boards = [target.board for target in firmware_targets() if target.board is not None]
    images = [tool for board in boards for tool in board.architecture.tools]
    every: list[Tool | Library] = [*REQUIRED, *compilers, *takers, *images, *PROGRAMS, *OPTIONAL]
    uses = list(Use)
    return tuple(sorted(dict.fromkeys(every), key=lambda tool: uses.index(tool.use)))


def names() -> tuple[str, ...]:
    """What messages call all tools."""
    return tuple(tool.name for tool in known())


def named(name: str) -> Tool | Library:
    """The tool that is called ``name``, or may be; of a library, its module or what PyPI calls it.

    Raises
    ------
    InputError: there is none.
    """
    tools = known()
    others = {other: tool for tool in reversed(tools) for other in _other_names(tool)}
    called = others | {tool.name: tool for tool in reversed(tools)}
    if name in called:
        return called[name]
    raise InputError(
        f"robodyn uses no tool {name!r}",
        expected="a name that robodyn doctor --all lists",
        remedy=did_you_mean(name, called),
    )


def _other_names(tool: Tool | Library) -> tuple[str, ...]:
    return tool.names if isinstance(tool, Tool) else (tool.module, tool.distribution)


def examine(tools: Iterable[Tool | Library]) -> tuple[ToolState, ...]:
    """Look for ``tools`` and ask each for its version, several at a time; each has :data:`SECONDS`."""
    workers = ThreadPoolExecutor(_AT_ONCE)
    try:
        return tuple(workers.map(_state, tools))
    except BaseException:  # Ctrl-C
        end_all()
        raise
    finally:
        workers.shutdown(wait=False, cancel_futures=True)


def _state(tool: Tool | Library) -> ToolState:
    if isinstance(tool, Tool):
        return _program(tool)
    if not tool.present():
        return ToolState(tool)
    try:
        return ToolState(tool, tool.module, importlib.metadata.version(tool.distribution))
    except importlib.metadata.PackageNotFoundError:  # a folder on PYTHONPATH
        return ToolState(tool, tool.module)


def _program(tool: Tool) -> ToolState:
    command = tool.command()
    if command is None or not tool.version_arguments:
        return ToolState(tool, None if command is None else command[0])
    where = command[0]
    try:
        done = run([*command, *tool.version_arguments], seconds=SECONDS)
    except OSError as error:
        return ToolState(tool, where, fault=error.strerror or str(error))
    lines = done.output.strip().splitlines()
    if done.code == 0:
        return ToolState(tool, where, next(filter(None, map(version_in, lines)), None))
    fault = lines[0].strip() if lines else f"exit status {done.code}"
    return ToolState(tool, where, fault=f"no answer within {SECONDS:g} s" if done.code is None else fault)


def version_in(line: str) -> str | None:
    """The version in a line that a program says of itself; what stands in parentheses is a distribution's."""
    version = re.search(r"\d+\.\d[\w.+-]*", re.sub(r"\([^)]*\)", "", line))
    return version[0] if version else None
