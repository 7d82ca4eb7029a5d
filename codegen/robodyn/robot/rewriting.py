"""From one model to another in the text that describes the first: each number that differs, each effect.

What is written is read again, and is the other model or is not written.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Effect
from robodyn.effects.traits import Fold
from robodyn.errors import InputError
from robodyn.robot import numbers
from robodyn.robot.editing import Comments, Editor, NotInPlaceError
from robodyn.robot.keys import FRICTION, LINK, ROBOT
from robodyn.robot.model import AXES, EffectEntry, Link, Robot
from robodyn.robot.reader import read_text
from robodyn.robot.values import Value
from robodyn.robot.writer import entry_text, number_text, setting_text, to_yaml

#: What of a robot differs: the joint or link (from 1; None: the whole robot), and a key or an effect's id.
Place = tuple[int | None, str]
_ORDER: Mapping[str, Sequence[str]] = {
    "link": [key.name for key in LINK],
    "robot": [key.name for key in ROBOT],
    "inertia": list(AXES),
    "friction": [key.name for key in FRICTION],
}


def rewritten(
    text: str, robot: Robot, target: Robot, origins: Sequence[int | None], comments: Comments = ()
) -> str:
    """``text``, which describes ``robot``, such that it describes ``target``, an arm with as many joints.

    ``origins``: of each effect of ``target`` its index in ``robot``, None where it is new; ``comments`` are
    put above the first line that changes one of their places. Other bytes of the text stay. Where it cannot
    be changed in place (standard DH and new inertials, aliases), it is written anew, and says so.

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
        self.editor = Editor(text)
        self.robot, self.target = robot, target
        self.origins = origins
        self.root = self.editor.root
        convention = self.editor.child(self.root, "convention")
        self.standard = convention is not None and convention.value == "sdh"
        links = self.editor.child(self.root, "links").value
        self.posed = any(self.editor.child(link, "pose") is not None for link in links)

    def text(self, comments: Comments) -> str:
        """The text with all changes and ``comments``."""
        self._gravity()
        if self.robot.torque_side != self.target.torque_side:
            place = (None, "torque_side")
            self.editor.set_key(self.root, "torque_side", self.target.torque_side, [place], _ORDER["robot"])
        self._covariance()
        nodes = self.editor.child(self.root, "links").value
        for i, node in enumerate(nodes, 1):
            self._link(i, node)
        self._effects(None, self.root)
        return self.editor.render(comments)

    # --- numbers ------------------------------------------------------------------------------------------

    def _change(self, parent: Any, level: str, key: str, old: Any, new: Any, place: Place) -> None:
        """What stands at ``key`` such that ``old`` becomes ``new``: a number, three, or a group of numbers by
        name; what else adds to them stays."""
        if old == new:
            return
        node, order = self.editor.child(parent, key), _ORDER.get(level, ())
        if node is not None and isinstance(new, dict):
            for name in new:
                self._change(node, key, name, old[name], new[name], place)
        elif node is not None and isinstance(new, tuple):
            for item, a, b in zip(node.value, old, new, strict=True):
                if a != b:
                    self.editor.replace(item, _changed(item.value, b - a), [place])
        elif node is not None:
            self.editor.set_key(parent, key, _changed(node.value, new - old), [place], order)
        elif isinstance(new, dict):
            stated = (
                f"{name}: {number_text(new[name] - old[name])}" for name in new if new[name] != old[name]
            )
            self.editor.set_key(parent, key, f"{{{', '.join(stated)}}}", [place], order)
        elif isinstance(new, tuple):
            self.editor.set_key(parent, key, f"[{', '.join(map(number_text, new))}]", [place], order)
        else:
            self.editor.set_key(parent, key, number_text(new - old), [place], order)

    def _covariance(self) -> None:
        if self.robot.covariance == self.target.covariance:
            return
        place = (None, "covariance")
        if self.target.covariance is None:
            self.editor.remove_key(self.root, "covariance", [place])
        else:
            file = self.target.covariance.file
            self.editor.set_key(self.root, "covariance", file, [place], _ORDER["robot"])

    def _gravity(self) -> None:
        old, new = self.robot.gravity, self.target.gravity
        if old == new:
            return
        place = (None, "gravity")
        node = self.editor.child(self.root, "gravity")
        if node is None:
            self._change(self.root, "robot", "gravity", old, new, place)
            return
        # Whatever turned it in the text is in the new numbers, and goes.
        for item, value in zip(node.value, new, strict=True):
            if _value(item.value) != value:
                self.editor.replace(item, number_text(value), [place])

    def _link(self, i: int, node: Any) -> None:
        old, new = self.robot.links[i - 1], self.target.links[i - 1]
        if self.standard and (old.com, old.inertia) != (new.com, new.inertia):
            raise NotInPlaceError("in standard DH a link's centre and inertia stand in other frames")
        if self.posed and (old.com, old.inertia) != (new.com, new.inertia):
            raise NotInPlaceError(
                "where links state poses, a link's centre and inertia may stand in other frames"
            )
        self._change(node, "link", "mass", old.mass, new.mass, (i, "mass"))
        self._change(node, "link", "com", old.com, new.com, (i, "com"))
        self._change(node, "link", "inertia", _entries(old.inertia), _entries(new.inertia), (i, "inertia"))
        self._acknowledged(i, node, old.acknowledged, new.acknowledged)
        for effect in _folded(""):
            self._beside(i, node, effect, old, new)
        moved = self._friction(i, node, old, new)
        self._effects(i, node, moved)

    def _acknowledged(self, i: int, node: Any, old: str, new: str) -> None:
        if old and not new:
            self.editor.remove_key(node, "acknowledged")
        elif old != new:
            text = setting_text(new, plain=False)
            self.editor.set_key(node, "acknowledged", text, [(i, "acknowledged")], _ORDER["link"])

    def _beside(self, i: int, node: Any, effect: Effect, old: Link, new: Link) -> None:
        """A number of the joint that is a key of the link, or an effect of its own."""
        fold = _fold(effect.id)
        where, level, key = node, "link", fold.key
        item = self._item(node, effect.id)
        if item is not None and self.editor.child(node, key) is None:
            where, level, key = item, effect.id, fold.parameter
        before, after = getattr(old.joint, fold.key), getattr(new.joint, fold.key)
        self._change(where, level, key, before, after, (i, fold.key))

    def _friction(self, i: int, node: Any, old: Link, new: Link) -> list[Any]:
        """The shorthand ``friction``; entries that go since a law of friction has taken their level."""
        gone: list[Any] = []
        delete: list[int] = []
        add: list[str] = []
        group = self.editor.child(node, "friction")
        laws = any(entry.definition.traits.levels for entry in self.target.effects_at(i))
        for effect in _folded("friction"):
            name = _fold(effect.id).key
            before, after = getattr(old.joint, name), getattr(new.joint, name)
            item = self._item(node, effect.id)
            if before == after:
                continue
            moved = effect.traits.one_way == "level" and laws and after == 0
            if item is not None:
                if moved:
                    gone.append(item)
                else:
                    self._change(item, effect.id, _fold(effect.id).parameter, before, after, (i, name))
            elif group is None or self.editor.child(group, name) is None:
                add.append(f"{name}: {number_text(after - before)}")
            elif moved:
                delete.append(self.editor.index(group, name))
            else:
                self._change(group, "friction", name, before, after, (i, name))
        places: list[Place] = [(i, _fold(effect.id).key) for effect in _folded("friction")]
        if group is None and add:
            self.editor.set_key(node, "friction", f"{{{', '.join(add)}}}", places, _ORDER["link"])
        elif group is not None and len(delete) == len(group.value) and delete and not add:
            self.editor.remove_key(node, "friction", places)
        elif group is not None:
            self.editor.change(group, places, delete=delete, add=add)
        return gone

    # --- effects ------------------------------------------------------------------------------------------

    def _items(self, node: Any) -> list[Any]:
        listed = self.editor.child(node, "effects")
        return [] if listed is None else listed.value

    def _item(self, node: Any, id: str) -> Any:
        return next((item for item in self._items(node) if _id(item) == id), None)

    def _effects(self, joint: int | None, node: Any, gone: Iterable[Any] = ()) -> None:
        items = self._items(node)
        kept = [item for item in items if CATALOGUE[_id(item)].traits.fold is None]
        numbers_ = [k for k, entry in enumerate(self.robot.effects) if entry.joint == joint]
        nodes = dict(zip(numbers_, kept, strict=True))
        stays = set()
        add: list[str] = []
        places: set[Place] = set()
        for entry, origin in zip(self.target.effects, self.origins, strict=True):
            if entry.joint != joint:
                continue
            if origin is None:
                self._refuse_body(entry)
                add.append(entry_text(entry))
                places.add((joint, entry.effect))
            else:
                stays.add(origin)
                self._entry(nodes[origin], self.robot.effects[origin], entry)
        leaving = [id(item) for k, item in nodes.items() if k not in stays] + [id(item) for item in gone]
        if joint is None and self.robot.gravity != self.target.gravity:
            leaving += [id(item) for item in items if _turns_gravity(item)]
        delete = [k for k, item in enumerate(items) if id(item) in leaving]
        order = _ORDER["robot" if joint is None else "link"]
        self.editor.change_list(node, "effects", places, delete=delete, add=add, order=order)

    def _entry(self, node: Any, old: EffectEntry, new: EffectEntry) -> None:
        before, after = dict(old.settings), dict(new.settings)
        if before == after:
            return
        self._refuse_body(new)
        place = (new.joint, new.effect)
        for p in CATALOGUE[new.effect].parameters:
            a, b = before.get(p.name), after.get(p.name)
            at = self.editor.child(node, p.name)
            if a == b:
                continue
            if b is None:
                self.editor.remove_key(node, p.name, [place])
            elif a is None or at is None or p.kind not in ("number", "vector", "inertia"):
                self.editor.set_key(node, p.name, setting_text(b, plain=p.kind != "text"), [place])
            elif p.kind == "inertia":
                self._change(node, new.effect, p.name, _entries(a), _entries(b), place)
            else:
                self._change(node, new.effect, p.name, a, b, place)

    def _refuse_body(self, entry: EffectEntry) -> None:
        if self.standard and entry.definition.traits.body:
            raise NotInPlaceError("in standard DH a payload stands in another frame")


def _folded(group: str) -> Iterator[Effect]:
    """The effects that are numbers of a joint, whose keys stand in that group of a link ("": in itself)."""
    for effect in CATALOGUE.values():
        fold = effect.traits.fold
        if fold is not None and fold.into == "joint" and fold.group == group:
            yield effect


def _fold(id: str) -> Fold:
    fold = CATALOGUE[id].traits.fold
    assert fold is not None
    return fold


def _turns_gravity(item: Any) -> bool:
    fold = CATALOGUE[_id(item)].traits.fold
    return fold is not None and fold.into == "gravity"


def _entries(inertia: Any) -> dict[str, Value]:
    return dict(zip(AXES, inertia.entries, strict=True))


def _id(item: Any) -> str:
    return str(Editor.child(item, "effect").value)


def _value(text: str) -> Value:
    """A number of the description, as the reader takes it."""
    read = numbers.parse(text, names=True)
    return numbers.rounded(read.value) if read.has_pi else read.value


def _changed(text: str, added: Value) -> str:
    """The number ``text`` with ``added``: a new one, or behind a run-time name the sum."""
    old = _value(text)
    new = old + added
    if isinstance(old, Fraction) or not isinstance(added, Fraction):
        return number_text(new)
    longer = f"{text} {'-' if added < 0 else '+'} {number_text(abs(added))}"
    return longer if len(longer) <= numbers.LENGTH and _value(longer) == new else number_text(new)
