"""Registries: one record a module, imported when it is asked for."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from robodyn.registry import Registry
from robodyn.targets.target import Target


class Fruit:
    def __init__(self, name: str) -> None:
        self.name = name


MODULES = {
    "__init__": "",
    "plum": "from test_registry import Fruit\nFRUIT = Fruit('plum')\n",
    "sweet_plum": "from test_registry import Fruit\nFRUIT = Fruit('sweet-plum')\n",
    "sweeter": "from test_registry import Fruit\nFRUIT = Fruit('sour')\n",
    "empty": "",
}


@pytest.fixture
def fruits(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Registry[Fruit]:
    folder = tmp_path / "fruit_of_a_test"
    folder.mkdir()
    for name, text in MODULES.items():
        (folder / f"{name}.py").write_text(text, encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setitem(sys.modules, "test_registry", sys.modules[__name__])
    for name in [name for name in sys.modules if name.startswith(folder.name)]:
        monkeypatch.delitem(sys.modules, name)
    return Registry(folder.name, "FRUIT", Fruit)


def test_records_by_name(fruits: Registry[Fruit]) -> None:
    """A hyphen in a name is an underscore in the module's; only what is asked for is imported."""
    assert list(fruits) == ["empty", "plum", "sweet-plum", "sweeter"]
    assert len(fruits) == 4
    assert fruits["sweet-plum"] is fruits["sweet-plum"]
    assert fruits["sweet-plum"].name == "sweet-plum"
    assert "sweet_plum" not in fruits
    assert "fruit_of_a_test.sweet_plum" in sys.modules
    assert "fruit_of_a_test.plum" not in sys.modules
    with pytest.raises(KeyError):
        fruits["pear"]


def test_a_module_without_a_record(fruits: Registry[Fruit]) -> None:
    with pytest.raises(TypeError, match=r"^fruit_of_a_test.empty has no FRUIT that is a fruit$"):
        fruits["empty"]


def test_a_record_of_another_name(fruits: Registry[Fruit]) -> None:
    with pytest.raises(ValueError, match=r"^fruit_of_a_test.sweeter: its fruit is called sour, not sweeter$"):
        fruits["sweeter"]


def test_a_record_of_another_class(fruits: Registry[Fruit]) -> None:
    targets = Registry("fruit_of_a_test", "FRUIT", Target)
    assert list(targets) == list(fruits)
    with pytest.raises(TypeError, match="plum has no FRUIT that is a"):
        targets["plum"]
