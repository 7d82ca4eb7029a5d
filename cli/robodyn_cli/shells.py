"""Completion in bash, zsh and fish: a script for each, and what it gets from robodyn.

A script hands over the line up to the cursor (``COMP_WORDS``) and gets a line for each candidate, in which a
candidate stands for all of the word that the cursor is at. click's own scripts lose the names beside files
(bash), what follows a comma (fish), every second key (zsh), and values behind ``--option=`` and ``:``.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any, ClassVar, Final

import click
from click.shell_completion import CompletionItem, ShellComplete, add_completion_class, split_arg_string

VARIABLE: Final = "_ROBODYN_COMPLETE"
MARK: Final = 'as "robodyn completion'
_DATA: Final = ("XDG_DATA_HOME", ".local/share")


class Shell(ShellComplete):
    """A shell: its script, and where it looks for scripts."""

    file: ClassVar[str]
    """The name of the script's file."""

    base: ClassVar[tuple[str, str]]
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
        head = option + equals
        return [
            CompletionItem(head + item.value, item.type, item.help) if item.type == "plain" else item
            for item in candidates
        ]


class _Bash(Shell):
    name = "bash"
    file = "robodyn"
    base, below = _DATA, "bash-completion/completions"
    source_template = """\
# Completion of robodyn for bash 4.4 or newer, as "robodyn completion bash" prints it.

%(complete_func)s() {
    local line=${COMP_LINE:0:COMP_POINT}
    local word=${line##*[[:space:]]} breaks=${COMP_WORDBREAKS//[^=:]/} head= type value response
    # What follows an equals sign or a colon is a word of its own for readline, which replaces only that.
    [[ $breaks ]] && head=${word%%"${word##*["$breaks"]}"}
    local path=${word#--*=} path_head=${head#--*=}
    response=$(COMP_WORDS=$line %(complete_var)s=bash_complete "$1" 2>/dev/null)
    COMPREPLY=()
    while IFS=, read -r type value; do
        case $type in
            plain) COMPREPLY+=("${value#"$head"}") ;;
            file | dir)
                compopt -o filenames 2>/dev/null
                while IFS= read -r value; do
                    [[ $value ]] && COMPREPLY+=("${value#"$path_head"}")
                done <<< "$(compgen -"${type:0:1}" -- "$path")" ;;
        esac
    done <<< "$response"
}

complete -o nosort -F %(complete_func)s %(prog_name)s
"""

    @classmethod
    def folder(cls, environment: Mapping[str, str], home: Path) -> Path:
        own = environment.get("BASH_COMPLETION_USER_DIR", "").partition(":")[0]
        return Path(own) / "completions" if own else super().folder(environment, home)

    @staticmethod
    def needed(folder: Path) -> str | None:
        loaders = (
            "/usr/share/bash-completion/bash_completion",
            "/usr/local/share/bash-completion/bash_completion",
            "/opt/homebrew/share/bash-completion/bash_completion",
        )
        if any(Path(path).is_file() for path in loaders):
            return None
        return (
            "bash looks there if the package bash-completion is installed; "
            f"else add to ~/.bashrc: source {folder / _Bash.file}"
        )

    def format_completion(self, item: CompletionItem[Any]) -> str:
        return f"{item.type},{item.value}"


class _Zsh(Shell):
    name = "zsh"
    file = "_robodyn"
    base, below = _DATA, "zsh/site-functions"
    source_template = """\
#compdef %(prog_name)s
# Completion of robodyn for zsh, as "robodyn completion zsh" prints it.

%(complete_func)s() {
    local -a response plain described
    local type value help paths
    response=("${(@f)$(COMP_WORDS="${(j: :)words[1,CURRENT-1]} $PREFIX" \\
        %(complete_var)s=zsh_complete %(prog_name)s 2>/dev/null)}")
    for type value help in "${response[@]}"; do
        case $type in
            file | dir) paths=$type ;;
            plain)
                if [[ $help == _ ]]; then
                    plain+=("$value")
                else
                    described+=("${value//:/\\:}:$help")
                fi ;;
        esac
    done
    (( $#described )) && _describe -V unsorted described -U
    (( $#plain )) && compadd -U -V unsorted -a plain
    if [[ $paths ]]; then
        [[ $PREFIX == --*=* ]] && compset -P '--*='
        _path_files ${${paths:#file}:+-/}
    fi
}

if [[ $funcstack[1] == _%(prog_name)s ]]; then  # from a folder of $fpath, this file is that function
    %(complete_func)s "$@"
else  # with source, or eval
    compdef %(complete_func)s %(prog_name)s
fi
"""

    @staticmethod
    def needed(folder: Path) -> str | None:
        return f"zsh looks there with this line before compinit in ~/.zshrc: fpath=({folder} $fpath)"

    def format_completion(self, item: CompletionItem[Any]) -> str:
        return f"{item.type}\n{item.value}\n{_short(item.help) or '_'}"


class _Fish(Shell):
    name = "fish"
    file = "robodyn.fish"
    base, below = ("XDG_CONFIG_HOME", ".config"), "fish/completions"
    source_template = """\
# Completion of robodyn for fish, as "robodyn completion fish" prints it.

function %(complete_func)s
    set -l response (env COMP_WORDS=(commandline -cp | string collect) \\
        %(complete_var)s=fish_complete %(prog_name)s 2>/dev/null)
    set -l word (commandline -ct | string collect -a)
    set -l head (string match -r -- '^--[^=]*=' $word; or echo)
    set -l path (string replace -r -- '^--[^=]*=' '' $word)
    for candidate in $response
        set -l parts (string split -m 1 -- , $candidate)
        switch $parts[1]
            case plain
                echo $parts[2]
            case file
                printf '%%s\\n' $head(__fish_complete_path $path)
            case dir
                printf '%%s\\n' $head(__fish_complete_directories $path)
        end
    end
end

complete --no-files --command %(prog_name)s --arguments "(%(complete_func)s)"
"""

    def format_completion(self, item: CompletionItem[Any]) -> str:
        help_ = _short(item.help)
        return f"{item.type},{item.value}" + (f"\t{help_}" if help_ else "")


def _short(text: str | None) -> str:
    """The first sentence, which a list of candidates has room for."""
    return " ".join((text or "").split()).partition(". ")[0].rstrip(".")


SHELLS: Final[dict[str, type[Shell]]] = {shell.name: shell for shell in (_Bash, _Zsh, _Fish)}
for _shell in SHELLS.values():
    add_completion_class(_shell)


def script(shell: str) -> str:
    """The script of `shell`."""
    return SHELLS[shell](click.Command("robodyn"), {}, "robodyn", VARIABLE).source()
