"""From one model to another in the text that describes the first: each number that differs, each effect."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from robodyn.diagnose.amend.combined import AXES
from robodyn.diagnose.amend.values import (
    changed_text,
    entry_text,
    number_text,
    setting_text,
    value_of,
)
from robodyn.diagnose.amend.yaml_patch import Document, NotInPlaceError, Place
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect
from robodyn.effects.traits import Fold
from robodyn.errors import InputError
from robodyn.robot.keys import LINK, ROBOT
from robodyn.robot.model import EffectEntry, Link, Robot
from robodyn.robot.reader import read_text
from robodyn.robot.values import ZERO, Value
from robodyn.robot.writer import to_yaml

_ORDER = {
    "link": [key.name for key in LINK],
    "robot": [key.name for key in ROBOT],
    "inertia": list(AXES),
    "friction": ["viscous", "coulomb"],
}
Comments = Sequence[tuple[frozenset[Place], Sequence[str]]]


def written(text: str, robot: Robot, target: Robot, origins: Sequence[int | None], comments: Comments) -> str:
    """``text``, which describes ``robot``, such that it describes ``target``; ``origins``: of each effect of
    ``target`` its number in ``robot``. Written anew where it cannot be changed in place.

    Raises
    ------
    InputError: ``text`` does not describe ``robot``.
    """
    if _read(text) != robot:
        raise InputError("the text does not describe this robot", remedy="read the robot from the same text")
    if robot == target:
        return text
    mark = "\ufeff" if text.startswith("\ufeff") else ""
    try:
        new = mark + _Patch(text.removeprefix(mark), robot, target, origins).text(comments)
        if _read(new) == target:
            return new
        reason = "its layout leaves no place for the changes"
    except NotInPlaceError as error:
        reason = str(error)
    except InputError as error:
        reason = error.what
    lines = [f"Written anew, without the comments that were here: {reason}."]
    lines += [line for _, several in comments for line in several]
    head = "".join("# " + "".join(c if c.isprintable() else " " for c in line) + "\n" for line in lines)
    return head + to_yaml(target)


def _read(text: str) -> Robot:
    return read_text(text, warn=lambda _: None)


class _Patch:
    """The edits from ``robot`` to ``target``, base to tip."""

    def __init__(self, text: str, robot: Robot, target: Robot, origins: Sequence[int | None]) -> None:
        self.document = Document(text)
        self.robot, self.target = robot, target
        self.origins = origins
        self.root = self.document.root
        convention = self.document.child(self.root, "convention")
        self.standard = convention is not None and convention.value == "sdh"

    def text(self, comments: Comments) -> str:
        """The text with all changes and ``comments``."""
        self._gravity()
        nodes = self.document.child(self.root, "links").value
        for i, node in enumerate(nodes, 1):
            self._link(i, node)
        self._effects(None, self.root)
        return self.document.render(comments)

    # --- numbers ------------------------------------------------------------------------------------------

    def _put(self, parent: Any, level: str, key: str, text: str, place: Place) -> None:
        """A key that is not there, behind those that come before it."""
        order = _ORDER.get(level, [])
        after = -1
        if key in order:
            before = order[: order.index(key)]
            known = [k for k, (name, _) in enumerate(parent.value) if name.value in before]
            after = known[-1] if known else (0 if parent.value else -1)
        self.document.change(parent, [place], add=[f"{key}: {text}"], after=after)

    def _number(
        self, parent: Any, level: str, key: str, old: Value, new: Value, place: Place, absent: Value = ZERO
    ) -> None:
        """The number at ``key`` such that ``old`` becomes ``new``; what else adds to it stays."""
        if old == new:
            return
        node = self.document.child(parent, key)
        if node is None:
            self._put(parent, level, key, number_text(absent + (new - old)), place)
        else:
            self.document.replace(node, changed_text(node.value, new - old), [place])

    def _vector(self, parent: Any, level: str, key: str, old: Any, new: Any, place: Place) -> None:
        if old == new:
            return
        node = self.document.child(parent, key)
        if node is None:
            listed = ", ".join(number_text(value) for value in new)
            self._put(parent, level, key, f"[{listed}]", place)
            return
        for item, a, b in zip(node.value, old, new, strict=True):
            if a != b:
                self.document.replace(item, changed_text(item.value, b - a), [place])

    def _group(
        self,
        parent: Any,
        level: str,
        key: str,
        old: Mapping[str, Value],
        new: Mapping[str, Value],
        place: Place,
    ) -> None:
        if old == new:
            return
        node = self.document.child(parent, key)
        if node is None:
            stated = ", ".join(
                f"{name}: {number_text(value - old[name])}"
                for name, value in new.items()
                if value != old[name]
            )
            self._put(parent, level, key, "{" + stated + "}", place)
            return
        for name in new:
            self._number(node, key, name, old[name], new[name], place)

    def _gravity(self) -> None:
        old, new = self.robot.gravity, self.target.gravity
        if old == new:
            return
        place = (None, "gravity")
        node = self.document.child(self.root, "gravity")
        if node is None:
            listed = ", ".join(number_text(value) for value in new)
            self._put(self.root, "robot", "gravity", f"[{listed}]", place)
            return
        # Whatever turned it in the text is in the new numbers, and goes.
        for item, value in zip(node.value, new, strict=True):
            if value_of(item.value) != value:
                self.document.replace(item, number_text(value), [place])

    def _link(self, i: int, node: Any) -> None:
        old, new = self.robot.links[i - 1], self.target.links[i - 1]
        if self.standard and (old.com, old.inertia) != (new.com, new.inertia):
            raise NotInPlaceError("in standard DH a link's centre and inertia stand in other frames")
        self._number(node, "link", "mass", old.mass, new.mass, (i, "mass"))
        self._vector(node, "link", "com", old.com, new.com, (i, "com"))
        self._group(node, "link", "inertia", _entries(old.inertia), _entries(new.inertia), (i, "inertia"))
        for known, fold in _folds(""):
            item = self._item(node, known.id)
            where, level, key = (node, "link", fold.key)
            if item is not None and self.document.child(node, key) is None:
                where, level, key = (item, known.id, fold.parameter)
            before, after = getattr(old.joint, fold.key), getattr(new.joint, fold.key)
            self._number(where, level, key, before, after, (i, fold.key))
        moved = self._friction(i, node, old, new)
        self._effects(i, node, moved)

    def _friction(self, i: int, node: Any, old: Link, new: Link) -> list[Any]:
        """The two shorthands; entries that go since a law of friction has taken their level."""
        gone: list[Any] = []
        delete: list[int] = []
        add: list[str] = []
        group = self.document.child(node, "friction")
        laws = any(entry.definition.traits.levels for entry in self.target.effects_at(i))
        for known, fold in _folds("friction"):
            name = fold.key
            before, after = getattr(old.joint, name), getattr(new.joint, name)
            item = self._item(node, known.id)
            if before == after:
                continue
            moved = name == "coulomb" and laws and after == 0
            if item is not None:
                if moved:
                    gone.append(item)
                else:
                    self._number(item, known.id, fold.parameter, before, after, (i, name))
            elif group is None or self.document.child(group, name) is None:
                add.append(f"{name}: {number_text(after - before)}")
            elif moved:
                delete.append(_index(group, name))
            else:
                self._number(group, "friction", name, before, after, (i, name))
        places: list[Place] = [(i, "viscous"), (i, "coulomb")]
        if group is None and add:
            self.document.change(
                node, places, add=[f"friction: {{{', '.join(add)}}}"], after=self._before(node, "friction")
            )
        elif group is not None and len(delete) == len(group.value) and delete and not add:
            self.document.change(node, places, delete=[_index(node, "friction")])
        elif group is not None:
            self.document.change(group, places, delete=delete, add=add)
        return gone

    def _before(self, parent: Any, key: str) -> int:
        before = _ORDER["link"][: _ORDER["link"].index(key)]
        return max((k for k, (name, _) in enumerate(parent.value) if name.value in before), default=0)

    # --- effects ------------------------------------------------------------------------------------------

    def _items(self, node: Any) -> list[Any]:
        listed = self.document.child(node, "effects")
        return [] if listed is None else listed.value

    def _item(self, node: Any, id: str) -> Any:
        return next((item for item in self._items(node) if _id(item) == id), None)

    def _effects(self, joint: int | None, node: Any, gone: Iterable[Any] = ()) -> None:
        items = self._items(node)
        kept = [item for item in items if _fold(item) is None]
        numbers_ = [k for k, entry in enumerate(self.robot.effects) if entry.joint == joint]
        nodes = dict(zip(numbers_, kept, strict=True))
        stays = set()
        add: list[str] = []
        places: set[Place] = set()
        for entry, origin in zip(self.target.effects, self.origins, strict=True):
            if entry.joint != joint:
                continue
            if origin is None:
                self._refuse_payload(entry)
                add.append(entry_text(entry))
                places.add((joint, entry.effect))
            else:
                stays.add(origin)
                self._entry(nodes[origin], self.robot.effects[origin], entry)
        leaving = [id(item) for k, item in nodes.items() if k not in stays] + [id(item) for item in gone]
        if joint is None and self.robot.gravity != self.target.gravity:
            leaving += [id(item) for item in items if _turns_gravity(item)]
        delete = [k for k, item in enumerate(items) if id(item) in leaving]
        listed = self.document.child(node, "effects")
        if listed is not None:
            if delete and len(delete) == len(items) and not add:
                self.document.change(node, places, delete=[_index(node, "effects")])
            else:
                self.document.change(listed, places, delete=delete, add=add)
        elif add and node.flow_style:
            self.document.change(node, places, add=[f"effects: [{', '.join(add)}]"])
        elif add:
            lines = "\n".join(["effects:", *(f"  - {line}" for line in add)])
            after = -1 if joint is None else self._before(node, "effects")
            self.document.change(node, places, add=[lines], after=after)

    def _entry(self, node: Any, old: EffectEntry, new: EffectEntry) -> None:
        before, after = dict(old.settings), dict(new.settings)
        if before == after:
            return
        self._refuse_payload(new)
        place = (new.joint, new.effect)
        for p in CATALOGUE[new.effect].parameters:
            a, b = before.get(p.name), after.get(p.name)
            at = self.document.child(node, p.name)
            if a == b:
                continue
            if b is None:
                self.document.change(node, [place], delete=[_index(node, p.name)])
            elif a is None or at is None or p.kind not in ("number", "vector", "inertia"):
                text = setting_text(b, plain=p.kind != "text")
                if at is None:
                    self.document.change(node, [place], add=[f"{p.name}: {text}"])
                else:
                    self.document.replace(at, text, [place])
            elif p.kind == "vector":
                self._vector(node, new.effect, p.name, a, b, place)
            elif p.kind == "inertia":
                self._group(node, new.effect, p.name, _entries(a), _entries(b), place)
            else:
                self._number(node, new.effect, p.name, a, b, place)  # type: ignore[arg-type]

    def _refuse_payload(self, entry: EffectEntry) -> None:
        if self.standard and entry.definition.traits.body:
            raise NotInPlaceError("in standard DH a payload stands in another frame")


def _folds(group: str) -> list[tuple[Effect, Fold]]:
    """The effects that numbers of a joint in that group of a link take, and how."""
    folds = [(known, known.traits.fold) for known in CATALOGUE.values()]
    return [(known, fold) for known, fold in folds if fold and fold.into == "joint" and fold.group == group]


def _fold(item: Any) -> Fold | None:
    return CATALOGUE[_id(item)].traits.fold


def _turns_gravity(item: Any) -> bool:
    fold = _fold(item)
    return fold is not None and fold.into == "gravity"


def _entries(inertia: Any) -> dict[str, Value]:
    return {axes: getattr(inertia, axes) for axes in AXES}


def _index(mapping: Any, key: str) -> int:
    return next(k for k, (name, _) in enumerate(mapping.value) if name.value == key)


def _id(item: Any) -> str:
    return str(Document.child(item, "effect").value)
