"""Find the system's compilers and run them.

The compiler is the one that the environment names (``CC``, ``FC``), else the first of the usual names
on the ``PATH``. A command may carry arguments (``CC="gcc -m64"``). No shell is ever involved.
"""

from __future__ import annotations

import functools
import os
import re
import shlex
import shutil
import sys
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from robodyn.emit.languages import compiled_language, language_named
from robodyn.errors import ToolError
from robodyn.toolchain.running import SECONDS, run

#: Default flags of the emitted C. Contraction is off, so that ``a * b + c`` is rounded twice everywhere and
#: all languages give the same bits; nothing here lets the compiler reorder arithmetic.
C_FLAGS = compiled_language("c")[1].flags

#: How long a compiler may take to say who it is [s].
ANSWER = 60.0


@dataclass(frozen=True, slots=True)
class Compiler:
    """A compiler that answers: its command as a list, and what it says about itself.

    ``version`` is the first line of ``--version``, ``identity`` all of it with the target machine.
    """

    language: str
    command: tuple[str, ...]
    version: str
    identity: str

    def run(self, arguments: Sequence[str], *, folder: Path, doing: str, target: str | None = None) -> str:
        """Run the compiler in ``folder`` and return what it said.

        ``doing`` names the job in the error ("puma560.c"), ``target`` the file in ``folder`` that must be
        there afterwards.

        Raises
        ------
        ToolError: the compiler cannot be started, does not come to an end, or refuses, with the first lines
            of what it said; or it is content and has not written the target.
        """
        command = [*self.command, *arguments]
        code, output = _execute(command, folder, SECONDS)
        if code != 0:
            raise ToolError(
                f"the {language_named(self.language).title} compiler failed at {doing}",
                found=first_lines(output) or f"exit status {code} and no message",
                remedy=f"the command was: {shlex.join(command)}",
            )
        if target is not None and not (folder / target).is_file():
            title = language_named(self.language).title
            raise ToolError(
                f"the {title} compiler {self.command[0]} wrote no file at {doing}",
                found=first_lines(output) or "exit status 0 and no message",
                expected=target,
                remedy=f"the command was: {shlex.join(command)}",
            )
        return output

    def compile(self, source: str, *, flags: Sequence[str], folder: Path) -> str:
        """Compile ``source`` (a path in ``folder``) to a position-independent object; the object's name."""
        target = f"{source}.o"
        arguments = [*flags, "-fPIC", "-c", source, "-o", target]
        self.run(arguments, folder=folder, doing=source, target=target)
        return target

    def link(
        self, objects: Sequence[str], library: str, *, flags: Sequence[str], folder: Path, extension: bool
    ) -> None:
        """Link ``objects`` to the shared library ``library``; ``extension``: one that Python itself loads."""
        if sys.platform == "darwin":
            kind = ["-bundle", "-undefined", "dynamic_lookup"] if extension else ["-dynamiclib"]
        elif sys.platform == "win32":
            kind = ["-shared"]
        else:  # calls inside the library stay inside: another loaded kernel of the same robot is no matter
            kind = ["-shared", "-Wl,-Bsymbolic"]
        arguments = [*flags, *kind, *objects, "-o", library, "-lm"]
        self.run(arguments, folder=folder, doing=library, target=library)


def find_c(cc: str | None = None) -> Compiler:
    """The C compiler: ``cc`` if given, else the environment's ``CC``, else ``cc``, ``gcc`` or ``clang``.

    Raises
    ------
    ToolError: there is none, or the one that is named does not run.
    """
    return find_compiler("c", cc)


def split_flags(flags: str | Sequence[str]) -> tuple[str, ...]:
    """Flags as a tuple; a string is split as a shell would (without running one)."""
    return tuple(shlex.split(flags)) if isinstance(flags, str) else tuple(flags)


def first_lines(output: str, count: int = 3) -> str:
    """The lines of a compiler's output that matter: the first ``count`` errors, else the first lines."""
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    errors = [k for k, line in enumerate(lines) if re.search(r"\b(error|undefined|multiple def)", line, re.I)]
    if not errors:
        return " | ".join(lines[:count])
    chosen = [lines[k] for k in errors[:count]]
    # gfortran gives the place on a line before the message.
    if errors[0] > 0 and re.match(r"[^\s|]+:\d+", lines[0]) and not re.match(r"[^\s|]+:\d+", chosen[0]):
        chosen.insert(0, lines[0])
    return " | ".join(chosen)


def find_compiler(language: str, choice: str | None = None) -> Compiler:
    """The compiler of ``language``: ``choice`` if there is one, else the one that the environment names, else
    the first of the usual ones.

    Raises
    ------
    InputError: the language is not compiled here.
    ToolError: there is no compiler, or the one that is named does not run.
    """
    spoken, compiled = compiled_language(language)
    title, compiler, variable = spoken.title, compiled.compiler, compiled.compiler.variable or ""
    remedy = f"install one ({compiler.install}) or name one in {variable}"
    named, by = (choice, "it was asked for") if choice else (os.environ.get(variable), f"{variable} names it")
    if named and named.strip():
        try:
            command = shlex.split(named)
        except ValueError as error:
            raise ToolError(
                f"the command of the {title} compiler cannot be read ({by})",
                found=f"{named!r}: {error}",
                expected="a program and its arguments, quoted as in a shell",
            ) from None
        program = shutil.which(command[0])
        if program is None:
            raise ToolError(f"there is no {title} compiler {command[0]!r} ({by})", remedy=remedy)
        return _identify(language, (str(Path(program).absolute()), *command[1:]))
    program = compiler.path()
    if program is not None:
        return _identify(language, (str(Path(program).absolute()),))
    raise ToolError(
        f"no {title} compiler was found",
        found=f"none of {', '.join(compiler.names)} on the PATH, and {variable} is not set",
        remedy=remedy,
    )


@functools.lru_cache(maxsize=32)
def _identify(language: str, command: tuple[str, ...]) -> Compiler:
    code, output = _execute([*command, "--version"], None, ANSWER)
    if code != 0 or not output.strip():
        raise ToolError(
            f"the {language_named(language).title} compiler does not work",
            found=first_lines(output) or f"exit status {code} and no message",
            expected="its version",
            remedy=f"the command was: {shlex.join([*command, '--version'])}",
        )
    code, machine = _execute([*command, "-dumpmachine"], None, ANSWER)
    identity = output.strip() + (f"\n{machine.strip()}" if code == 0 else "")
    return Compiler(language, command, output.strip().splitlines()[0], identity)


def _execute(command: Sequence[str], folder: Path | None, seconds: float) -> tuple[int, str]:
    """Exit status and all that was said; the messages in English, whatever the user's language."""
    try:
        done = run(command, folder=folder, seconds=seconds)
    except OSError as error:
        raise ToolError(
            f"{command[0]} cannot be started", found=error.strerror or str(error), expected="a compiler"
        ) from None
    if done.code is None:
        raise ToolError(
            f"{command[0]} does not come to an end",
            found=first_lines(done.output) or "no message",
            expected=f"{seconds:g} s at most",
            remedy=f"the command was: {shlex.join(command)}",
        )
    return done.code, done.output


#: How names of shared libraries end, by the system.
_SUFFIXES: Final = {"darwin": ".dylib", "win32": ".dll"}


def library_suffix() -> str:
    """How the name of a shared library ends on this system."""
    return _SUFFIXES.get(sys.platform, ".so")


def shared_library(
    files: Mapping[str, str],
    name: str,
    *,
    cc: str | None = None,
    flags: Sequence[str] = C_FLAGS,
    extension: bool = False,
) -> bytes:
    """The shared library ``name`` of the C sources among ``files`` ({path: text}), for this machine.

    Paths may have folders; each source finds headers in its own, others by ``-I`` in ``flags``.
    ``extension``: a module that Python loads. No path of this machine is in it, so that the same compiler
    gives the same bytes.

    Raises
    ------
    ToolError: there is no compiler, or it refuses the files.
    """
    compiler = find_c(cc)
    with tempfile.TemporaryDirectory(prefix="robodyn-") as place:
        folder = Path(place)
        for path, text in files.items():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_text(text, encoding="utf-8", newline="\n")
        sources = [path for path in files if path.endswith(".c")]
        objects = [compiler.compile(source, flags=flags, folder=folder) for source in sources]
        compiler.link(objects, name, flags=flags, folder=folder, extension=extension)
        return (folder / name).read_bytes()
