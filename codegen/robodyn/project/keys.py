"""The keys of robodyn.toml. Each stands for an option of a command and has its name, check and help."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Final

from robodyn.errors import InputError, did_you_mean
from robodyn.project.tables import shown

#: Largest budget [operations]; a larger one is taken for a typing error.
LARGEST_BUDGET: Final = 10**9
#: The commands that build the entries of a project: kernels with ``gen``, packages with ``package``.
KERNELS: Final = "gen"
PACKAGE: Final = "package"


@dataclass(frozen=True, slots=True)
class Key:
    """The key ``name`` stands for the option ``--name``.

    ``flag``: the value is true or false. ``several``: each text of a list becomes an option of its own.
    ``listed``: the texts of a list are joined by commas. ``words``: the allowed values, if there are few.
    ``words`` and ``help`` are functions: they are computed only when needed.
    """

    name: str
    help: Callable[[], str]
    flag: bool = False
    several: bool = False
    listed: bool = False
    words: Callable[[], tuple[str, ...]] | None = None

    def arguments(self, value: Any) -> tuple[str, ...]:
        """The command-line arguments for ``value``.

        Raises
        ------
        InputError: ``value`` has the wrong type.
        """
        if self.flag:
            if not isinstance(value, bool):
                raise self._type_error(value, "true or false")
            return (f"--{self.name}",) * value
        if isinstance(value, list) and (self.several or self.listed):
            if not value or not all(isinstance(each, str) and each for each in value):
                raise self._type_error(value, "a list of texts")
            texts = value if self.several else [",".join(value)]
            return tuple(f"--{self.name}={text}" for text in texts)
        if isinstance(value, bool) or not isinstance(value, str | int | float):
            lists = " or a list of texts" if self.several or self.listed else ""
            raise self._type_error(value, f"a text{lists}")
        return (f"--{self.name}={value}",)

    def check(self, value: Any) -> None:
        """Check that ``value`` is one of the allowed ``words``.

        Raises
        ------
        InputError: ``value`` is not one of them.
        """
        if self.words is None or value in (words := self.words()):
            return
        raise InputError(
            f"unknown {self.name} {str(value)!r}",
            expected=f"one of {', '.join(words)}",
            remedy=did_you_mean(str(value), words),
        )

    def _type_error(self, value: Any, expected: str) -> InputError:
        return InputError(f"{self.name} has the wrong type", found=shown(value), expected=expected)


@dataclass(frozen=True, slots=True)
class Keys:
    """The keys by name: ``kernels`` are those of ``robodyn gen``, ``packages`` of ``robodyn package``."""

    kernels: Mapping[str, Key]
    packages: Mapping[str, Key]

    def of(self, command: str) -> Mapping[str, Key]:
        """The keys of ``command``, :data:`KERNELS` or :data:`PACKAGE`."""
        return self.packages if command == PACKAGE else self.kernels
