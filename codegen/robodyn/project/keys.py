"""What a key of robodyn.toml is: an option of a command, with the option's name, check and help."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Final

from robodyn.errors import InputError, did_you_mean
from robodyn.project.tables import shown

#: A budget beyond this is a slip of the keyboard [operations].
LARGEST_BUDGET: Final = 10**9
#: The commands that write the entries of a project.
KERNELS: Final = "gen"
PACKAGE: Final = "package"


@dataclass(frozen=True, slots=True)
class Key:
    """The key ``name`` stands for the option ``--name``.

    ``flag``: true or false. ``several``: a list repeats the option. ``listed``: a list is joined by commas.
    ``words``: all values there are, if they are few. They and the ``help`` are looked up when needed.
    """

    name: str
    help: Callable[[], str]
    flag: bool = False
    several: bool = False
    listed: bool = False
    words: Callable[[], tuple[str, ...]] | None = None

    def arguments(self, value: Any) -> tuple[str, ...]:
        """``value`` as a command line has it.

        Raises
        ------
        InputError: it has another type.
        """
        if self.flag:
            if not isinstance(value, bool):
                raise self._unfit(value, "true or false")
            return (f"--{self.name}",) * value
        if isinstance(value, list) and (self.several or self.listed):
            if not value or not all(isinstance(each, str) and each for each in value):
                raise self._unfit(value, "a list of texts")
            texts = value if self.several else [",".join(value)]
            return tuple(f"--{self.name}={text}" for text in texts)
        if isinstance(value, bool) or not isinstance(value, str | int | float):
            lists = " or a list of texts" if self.several or self.listed else ""
            raise self._unfit(value, f"a text{lists}")
        return (f"--{self.name}={value}",)

    def check(self, value: Any) -> None:
        """Hold ``value`` to the words there are.

        Raises
        ------
        InputError: it is none of them.
        """
        if self.words is None or value in (words := self.words()):
            return
        raise InputError(
            f"unknown {self.name} {str(value)!r}",
            expected=f"one of {', '.join(words)}",
            remedy=did_you_mean(str(value), words),
        )

    def _unfit(self, value: Any, expected: str) -> InputError:
        return InputError(f"{self.name} has the wrong type", found=shown(value), expected=expected)


@dataclass(frozen=True, slots=True)
class Keys:
    """The keys of options, by name: of ``kernels``, which ``gen`` takes, and of ``packages``."""

    kernels: Mapping[str, Key]
    packages: Mapping[str, Key]

    def of(self, command: str) -> Mapping[str, Key]:
        """Those of the command that writes an entry."""
        return self.packages if command == PACKAGE else self.kernels
