"""A folder of modules that define one record each: a module is imported when its record is asked for.

Whoever adds a record writes a module; nothing else has to name it.
"""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Iterator, Mapping
from typing import Generic, Protocol, TypeVar


class _Named(Protocol):
    @property
    def name(self) -> str: ...


Record = TypeVar("Record", bound=_Named)


class Registry(Mapping[str, Record], Generic[Record]):
    """The records of a package's modules by name, in the order of the names.

    Parameters
    ----------
    package: the package, as it is imported; each of its modules defines a record and is called as that is,
        with ``_`` for ``-``.
    attribute: what the record is called in its module.
    kind: the class of all records.
    """

    def __init__(self, package: str, attribute: str, kind: type[Record]) -> None:
        self._package, self._attribute, self._kind = package, attribute, kind
        self._modules: dict[str, str] | None = None
        self._records: dict[str, Record] = {}

    def _by_name(self) -> dict[str, str]:
        """The names of the modules, by those of their records."""
        if self._modules is None:
            paths = importlib.import_module(self._package).__path__
            modules = (module.name for module in pkgutil.iter_modules(paths))
            self._modules = dict(sorted((module.replace("_", "-"), module) for module in modules))
        return self._modules

    def __getitem__(self, name: str) -> Record:
        """The record called ``name``.

        Raises
        ------
        KeyError: no module is called so.
        TypeError: the module defines no record.
        ValueError: the record is called otherwise than the module.
        """
        if name not in self._records:
            module = importlib.import_module(f"{self._package}.{self._by_name()[name]}")
            record = getattr(module, self._attribute, None)
            what = self._attribute.lower()
            if not isinstance(record, self._kind):
                raise TypeError(f"{module.__name__} has no {self._attribute} that is a {what}")
            if record.name != name:
                raise ValueError(f"{module.__name__}: its {what} is called {record.name}, not {name}")
            self._records[name] = record
        return self._records[name]

    def __contains__(self, name: object) -> bool:
        return name in self._by_name()

    def __iter__(self) -> Iterator[str]:
        return iter(self._by_name())

    def __len__(self) -> int:
        return len(self._by_name())
