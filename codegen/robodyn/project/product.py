"""What was generated for a robot, and the store that keeps it: nothing is generated twice."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from robodyn.toolchain.cache import Cache
from robodyn.toolchain.sources import digest

_INDEX: Final = "product.json"
_TEXTS: Final = "texts"

Counts = Mapping[str, Mapping[str, int]]


@dataclass(frozen=True, slots=True)
class Product:
    """The kernels of a robot: ``files`` with their hashes, by path within the folder of the output;
    ``counts`` of operations by function and kind; ``notes`` are what was said when they were generated, and
    ``account`` is what is known of the robot (:func:`~robodyn.robot.account.account_to_dict`)."""

    files: Mapping[str, str]
    counts: Counts
    notes: tuple[str, ...]
    account: Mapping[str, Any]


class Store:
    """Products by the hash of all that they depend on, in a :class:`.Cache`."""

    def __init__(self, root: Path | None = None) -> None:
        self._cache = Cache(root)

    @property
    def root(self) -> Path:
        """Where it lies, for another process to open it."""
        return self._cache.root

    def find(self, key: str) -> Product | None:
        """The product ``key``, if it was generated before."""
        path = self._cache.find(key)
        if path is None:
            return None
        data = json.loads(path.read_text(encoding="utf-8"))
        return Product(data["files"], data["counts"], tuple(data["notes"]), data["account"])

    def save(
        self,
        key: str,
        texts: Mapping[str, str | bytes],
        counts: Counts,
        notes: tuple[str, ...],
        account: Mapping[str, Any],
    ) -> None:
        """Keep the contents of files, by path, and what is to be known of them."""

        def write(folder: Path) -> str:
            hashes = {}
            for name, text in texts.items():
                data = text if isinstance(text, bytes) else text.encode("utf-8")
                path = folder / _TEXTS / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(data)
                hashes[name] = digest(data)
            index = {"files": hashes, "counts": counts, "notes": notes, "account": account}
            (folder / _INDEX).write_text(json.dumps(index, indent=1), encoding="utf-8")
            return _INDEX

        self._cache.fetch(key, write)

    def texts(self, key: str) -> dict[str, bytes] | None:
        """The contents of all files of the product ``key``; None, and the product is gone, where one of them
        is damaged."""
        product, path = self.find(key), self._cache.find(key)
        if product is None or path is None:
            return None
        try:
            texts = {name: (path.parent / _TEXTS / name).read_bytes() for name in product.files}
        except OSError:
            texts = {}
        if {name: digest(data) for name, data in texts.items()} == product.files:
            return texts
        self._cache.discard(key)
        return None
