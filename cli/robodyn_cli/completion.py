"""``robodyn completion``: what lets bash, zsh and fish complete commands, options and names.

The script of a shell (``templates/completion``) hands over the line up to the cursor (``COMP_WORDS``) and
gets a line for each candidate, which stands for all of the word that the cursor is at. click's own scripts
lose the names beside files (bash), what follows a comma (fish), every second key (zsh), and values
behind ``--option=`` and ``:``.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any, ClassVar, Final

import click
from click.shell_completion import CompletionItem, ShellComplete, add_completion_class, split_arg_string

from robodyn.errors import InputError
from robodyn.outputs import write_files
from robodyn_cli.choices import SHELL_NAMES
from robodyn_cli.decorators import flag
from robodyn_cli.output import printable, show

_DATA: Final = ("XDG_DATA_HOME", ".local/share")


class Shell(ShellComplete):
    """A shell: its script, and where it looks for scripts."""

    source_template = ""  # the script is a file
    file: ClassVar[str]
    """The name of the script's file."""
    base: ClassVar[tuple[str, str]] = _DATA
    """The variable that names the folder it is in (XDG base directories), and that folder below the user's
    home where the variable names none."""
    below: ClassVar[str]
    """The user's folder of completions, below that."""

    @classmethod
    def folder(cls, environment: Mapping[str, str], home: Path) -> Path:
        """The user's folder of completions. A variable whose path is not absolute does not count."""
        variable, default = cls.base
        stated = Path(environment.get(variable, ""))
        return (stated if stated.is_absolute() else home / default) / cls.below

    @staticmethod
    def needed(folder: Path) -> str | None:
        """What the user has to do for the shell to look into `folder`, if anything."""
        return None

    def get_completion_args(self) -> tuple[list[str], str]:
        """The words before the cursor's word, without the program; and that word, up to the cursor."""
        line = os.environ.get("COMP_WORDS", "")
        words = split_arg_string(line)
        begun = words.pop() if words and not line[-1:].isspace() else ""
        return words[1:], begun

    def get_completions(self, args: list[str], incomplete: str) -> list[CompletionItem[str]]:
        """The candidates, each for all of the word ``incomplete``."""
        candidates = super().get_completions(args, incomplete)
        option, equals, _ = incomplete.partition("=")
        if not equals or not option.startswith("--"):
            return candidates
        return [
            CompletionItem(f"{option}={item.value}", item.type, item.help) if item.type == "plain" else item
            for item in candidates
        ]


class _Bash(Shell):
    name, file, below = "bash", "robodyn", "bash-completion/completions"

    @classmethod
    def folder(cls, environment: Mapping[str, str], home: Path) -> Path:
        chosen = environment.get("BASH_COMPLETION_USER_DIR", "").partition(":")[0]
        return Path(chosen) / "completions" if chosen else super().folder(environment, home)

    @staticmethod
    def needed(folder: Path) -> str | None:
        prefixes = ("/usr", "/usr/local", "/opt/homebrew")
        if any(Path(prefix, "share/bash-completion/bash_completion").is_file() for prefix in prefixes):
            return None
        return (
            "bash looks there if the package bash-completion is installed; "
            f"else add to ~/.bashrc: source {folder / _Bash.file}"
        )

    def format_completion(self, item: CompletionItem[Any]) -> str:
        return f"{item.type},{item.value}"


class _Zsh(Shell):
    name, file, below = "zsh", "_robodyn", "zsh/site-functions"

    @staticmethod
    def needed(folder: Path) -> str | None:
        return f"zsh looks there with this line before compinit in ~/.zshrc: fpath=({folder} $fpath)"

    def format_completion(self, item: CompletionItem[Any]) -> str:
        return f"{item.type}\n{item.value}\n{_first_sentence(item.help) or '_'}"


class _Fish(Shell):
    name, file, below = "fish", "robodyn.fish", "fish/completions"
    base = ("XDG_CONFIG_HOME", ".config")

    def format_completion(self, item: CompletionItem[Any]) -> str:
        return f"{item.type},{item.value}\t{_first_sentence(item.help)}".rstrip("\t")


def _first_sentence(text: str | None) -> str:
    """The first sentence, which a list of candidates has room for."""
    return " ".join((text or "").split()).partition(". ")[0].rstrip(".")


SHELLS: Final[dict[str, type[Shell]]] = {shell.name: shell for shell in (_Bash, _Zsh, _Fish)}
for _shell in SHELLS.values():
    add_completion_class(_shell)


def script(shell: str) -> str:
    """The script of `shell`."""
    from robodyn.resources import data_dir

    return (data_dir("templates") / "completion" / SHELLS[shell].file).read_text(encoding="utf-8")


@click.command()
@click.argument("shell", type=SHELL_NAMES, metavar="[SHELL]", required=False)
@flag("--install", "Write the script to your folder of SHELL's completions.")
def command(shell: str | None, install: bool) -> None:
    """Print or install the script with which a shell completes robodyn.

    SHELL is bash, zsh or fish; without it, the one that the environment variable SHELL names. Commands,
    options, robots, functions, effects, targets, languages and files are completed. --install writes one
    file, and changes none of yours: to undo it, remove that file.
    """
    name = shell if shell is not None else Path(os.environ.get("SHELL", "")).name
    if name not in SHELLS:
        raise InputError(
            f"there is no completion for the shell {name!r}" if name else "no shell is named",
            expected=f"one of {', '.join(SHELLS)}",
            remedy="name it: robodyn completion bash" if shell is None else None,
        )
    text = script(name)
    if not install:
        show(lambda: {"shell": name, "script": text}, text.splitlines)
        return
    path = _path(name)
    write_files(path.parent, {path.name: text}, remedy="print it: robodyn completion SHELL")
    wrote = (f"wrote {printable(path)}", SHELLS[name].needed(path.parent), "new shells complete robodyn")
    show(lambda: {"shell": name, "path": str(path)}, lambda: (line for line in wrote if line is not None))


def _path(shell: str) -> Path:
    """Where the script of `shell` goes.

    Raises
    ------
    InputError: there is no home folder.
    """
    try:
        home = Path.home()
    except RuntimeError:
        raise InputError(
            "there is no home folder to install into", remedy=f"robodyn completion {shell} > FILE"
        ) from None
    return SHELLS[shell].folder(os.environ, home) / SHELLS[shell].file
