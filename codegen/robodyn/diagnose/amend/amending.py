"""Amendments carried out on the data of a model, one after the other."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from robodyn.diagnose.amend.combined import COMBINED, Body, joined, significant, total, waves
from robodyn.diagnose.amend.settings import checked, read_settings, summed
from robodyn.diagnose.limits import WORKED_OUT
from robodyn.effects.catalogue import CATALOGUE, effect
from robodyn.effects.effect import Effect
from robodyn.errors import InputError
from robodyn.robot.effects import belongs
from robodyn.robot.folding import folded
from robodyn.robot.model import AXES, EffectEntry, Inertia, Robot, Vector
from robodyn.robot.rewriting import Place
from robodyn.robot.values import ZERO, Value

#: The key of a joint whose friction a law with a level of its own takes over.
_LEVEL = "coulomb"


def is_of_motor(known: Effect) -> bool:
    """Whether a torque that is measured behind the gear does not have the effect."""
    fold = known.traits.fold
    return known.place in ("motor", "gear", "pair") or (fold is not None and fold.into == "joint")


class Work:
    """A model in the making: its links and gravity, and its effects with where they come from."""

    def __init__(self, robot: Robot) -> None:
        self.robot = replace(robot, effects=())
        self.entries: list[tuple[int | None, EffectEntry]] = list(enumerate(robot.effects))
        self.places: set[Place] = set()
        self.remarks: list[str] = []
        #: Places that an amendment has emptied into another one.
        self.became: dict[Place, Place] = {}

    def add(self, id: str, joint: int | None, parameters: Mapping[str, Any]) -> None:
        """One more amendment; it says in ``places`` and ``remarks`` what became of it."""
        known = effect(id)
        of_robot = joint is None
        if not belongs(known, of_robot=of_robot):
            raise InputError(
                f"{known.id} is an effect of {'a joint' if of_robot else 'the whole robot'}",
                found=f"joint {'null' if of_robot else joint}",
            )
        if joint is not None and not 1 <= joint <= self.robot.n:
            raise InputError(f"{known.id}: no such joint", found=str(joint), expected=f"1 to {self.robot.n}")
        settings = read_settings(known, parameters, self.robot.n)
        fold = known.traits.fold
        if self.robot.torque_side == "link" and is_of_motor(known):
            self._to_motor()
        if known.traits.body:
            self._body(known.id, settings)
        elif fold is not None and fold.into == "gravity":
            self._tilt(known.id, settings)
        elif joint is None:
            self._of_robot(known, settings)
        elif fold is None:
            self._at_joint(known, joint, settings)
        elif fold.into == "link":
            self._inertials(joint, settings)
        elif fold.key == _LEVEL:
            self._level(joint, settings[fold.parameter])
        else:
            self._of_joint(joint, fold.key, settings[fold.parameter])

    def _to_motor(self) -> None:
        """The torque has something of the drive in it after all. What is described of motors was not in it,
        and leaves the model."""
        for index, link in enumerate(self.robot.links, 1):
            for key in ("motor_inertia", "viscous", "coulomb"):
                if getattr(link.joint, key) != ZERO:
                    joint = self.robot.links[index - 1].joint
                    self._link(index, key, joint=replace(joint, **{key: ZERO}))  # type: ignore[arg-type]
        kept = [(origin, entry) for origin, entry in self.entries if not is_of_motor(entry.definition)]
        self.entries[:] = kept
        self.robot = replace(self.robot, torque_side="motor")
        self.places.add((None, "torque_side"))
        self.remarks.append(
            "was torque_side: link; yet this shows in the torque: not all of the drive is before it"
        )

    # --- numbers of the rigid arm -----------------------------------------------------------------------

    def _sum(self, old: Value, added: Value, name: str) -> Value:
        value = total(old, added)
        if isinstance(value, Fraction) and value < 0:
            self.remarks.append(f"the sum of {name} would be {float(value):.3g}, and is 0 instead")
            return ZERO
        return value

    def _link(self, index: int, place: str, **changes: Any) -> None:
        links = list(self.robot.links)
        if changes.get("inertia", links[index - 1].inertia) != links[index - 1].inertia:
            changes["acknowledged"] = ""  # what was said of the old tensor does not hold for the new one
        links[index - 1] = replace(links[index - 1], **changes)
        self.robot = replace(self.robot, links=tuple(links))
        self.places.add((index, place))

    def _of_joint(self, joint: int, key: str, added: Value) -> None:
        at = self.robot.links[joint - 1].joint
        value = self._sum(getattr(at, key), added, key)
        changes: dict[str, Any] = {key: value}
        self._link(joint, key, joint=replace(at, **changes))

    def _level(self, joint: int, level: Value) -> None:
        """The level goes to the law of friction that the joint has."""
        for k, (origin, entry) in enumerate(self.entries):
            levels = entry.definition.traits.levels
            if entry.joint == joint and levels:
                values = dict(entry.settings)
                for name in levels:
                    values[name] = total(values[name], level)  # type: ignore[arg-type]
                self._store(k, origin, entry.effect, joint, values)
                return
        self._of_joint(joint, _LEVEL, level)

    def _inertials(self, joint: int, settings: dict[str, Any]) -> None:
        link = self.robot.links[joint - 1]
        if "delta_mass" in settings:
            self._link(joint, "mass", mass=self._sum(link.mass, settings["delta_mass"], "mass"))
        com = tuple(
            total(old, settings.get(f"delta_com_{axis}", ZERO))
            for old, axis in zip(link.com, "xyz", strict=True)
        )
        if com != link.com:
            self._link(joint, "com", com=com)
        sums = {
            axes: total(getattr(link.inertia, axes), settings[f"delta_{axes}"])
            for axes in AXES
            if f"delta_{axes}" in settings
        }
        if sums:
            self._link(joint, "inertia", inertia=replace(link.inertia, **sums))

    def _tilt(self, id: str, values: dict[str, Any]) -> None:
        settings = (("tilt_x", values.get("tilt_x", ZERO)), ("tilt_y", values.get("tilt_y", ZERO)))
        if any(value for _, value in settings):
            entry = EffectEntry(id, None, settings)
            tilted = folded(replace(self.robot, effects=(entry,))).gravity
            x, y, z = (significant(float(g), WORKED_OUT) for g in tilted)
            self.robot = replace(self.robot, gravity=(x, y, z))
            self.places.add((None, "gravity"))

    def _body(self, id: str, settings: dict[str, Any]) -> None:
        at = self._find(id, None)
        old: dict[str, Any] = dict(self.entries[at][1].settings) if at is not None else {}
        added: Vector = settings.get("com", old.get("com", (ZERO, ZERO, ZERO)))
        load = Body(settings.get("mass", ZERO), added, settings.get("inertia", Inertia()))
        before = Body(old.get("mass", ZERO), old.get("com", added), old.get("inertia", Inertia()))
        both = joined(before, load)
        if both is None:
            self._into_last_link(load)
            return
        values: dict[str, Any] = {"mass": both.mass, "com": both.com}
        if isinstance(both.mass, Fraction) and both.mass < 0:
            values["com"] = before.com  # without mass there is no other
        elif "inertia" in old or both.inertia != Inertia():
            values["inertia"] = both.inertia
        if at is None:
            self._append(id, None, values)
        else:
            self._store(at, self.entries[at][0], id, None, values)

    def _into_last_link(self, load: Body) -> None:
        """A payload with run-time numbers cannot take another one; the link that it is fixed to can."""
        n = self.robot.n
        link = self.robot.links[-1]
        both = joined(Body(link.mass, link.com, link.inertia), load)
        if both is None:
            raise InputError(
                "payload: run-time names stand in the way of the sum",
                remedy="give the payload's numbers, or those of the last link",
            )
        self.remarks.append("the payload has run-time numbers: this one is in the last link")
        self._link(n, "mass", mass=self._sum(both.mass, ZERO, "mass"))
        self._link(n, "com", com=both.com)
        self._link(n, "inertia", inertia=both.inertia)

    # --- entries ----------------------------------------------------------------------------------------

    def _find(self, id: str, joint: int | None, other: object = None) -> int | None:
        for k, (_, entry) in enumerate(self.entries):
            if (entry.effect, entry.joint) == (id, joint) and dict(entry.settings).get("with") == other:
                return k
        return None

    def _of_robot(self, known: Effect, settings: dict[str, Any]) -> None:
        id = known.id
        if known.place == "outside":
            values = checked(known, None, settings, self.robot, self.remarks)
            there = [entry for _, entry in self.entries]
            if EffectEntry(id, None, values) not in there:
                self._append(id, None, settings)
            return
        if any(entry.effect == id and entry.joint is not None for _, entry in self.entries):
            for joint in range(1, self.robot.n + 1):  # of all joints, or at each: never both
                self._merge(id, joint, settings)
            return
        self._merge(id, None, settings)

    def _at_joint(self, known: Effect, joint: int, settings: dict[str, Any]) -> None:
        id = known.id
        of_all = self._find(id, None)
        if of_all is not None:
            values = dict(self.entries.pop(of_all)[1].settings)
            self.became[None, id] = (joint, id)
            for each in range(1, self.robot.n + 1):
                self._merge(id, each, values)
        self._take_level(joint, known, settings)
        # What holds another effect, as backlash with stiff teeth holds an elastic joint, is there alone: the
        # reader allows one of the two at a joint.
        for k, (origin, entry) in enumerate(self.entries):
            if entry.joint == joint and id in entry.definition.traits.absorbs:
                self._store(k, origin, entry.effect, joint, {**dict(entry.settings), **settings})
                return
        for part in known.traits.absorbs:
            at = self._find(part, joint)
            if at is not None:
                settings = {**dict(self.entries.pop(at)[1].settings), **settings}
                self.became[joint, part] = (joint, id)
        self._merge(id, joint, settings)

    def _take_level(self, joint: int, known: Effect, settings: dict[str, Any]) -> None:
        """Coulomb friction of the joint becomes the level of the law that is added."""
        at = self.robot.links[joint - 1].joint
        if at.coulomb == ZERO or not known.traits.levels:
            return
        for name in known.traits.levels:
            if name in settings:
                settings[name] = total(settings[name], at.coulomb)
        self._link(joint, _LEVEL, joint=replace(at, coulomb=ZERO))
        self.became[joint, _LEVEL] = (joint, known.id)

    def _merge(self, id: str, joint: int | None, settings: dict[str, Any]) -> None:
        """Into an entry that is there, or as one more."""
        known = CATALOGUE[id]
        combined = COMBINED.get(known.traits.combines)
        whole: dict[str, Any] = (
            dict(checked(known, joint, settings, self.robot, [], bounds=False))
            if combined
            else dict(settings)
        )
        for k, (origin, entry) in enumerate(self.entries):
            if (entry.effect, entry.joint) != (id, joint):
                continue
            old = dict(entry.settings)
            if old.get("with") != settings.get("with"):
                continue
            values = combined(old, whole, self.remarks) if combined else summed(known, old, settings)
            if values is not None:
                self._store(k, origin, id, joint, values)
                return
        if known.traits.combines == "waves" and whole["amplitude"] < 0:
            settings = waves({**whole, "amplitude": ZERO}, whole, self.remarks) or settings
        self._append(id, joint, settings)

    def _append(self, id: str, joint: int | None, values: dict[str, Any]) -> None:
        self.entries.append((None, EffectEntry(id, joint, ())))
        self._store(len(self.entries) - 1, None, id, joint, values)

    def _store(self, k: int, origin: int | None, id: str, joint: int | None, values: dict[str, Any]) -> None:
        settings = checked(CATALOGUE[id], joint, values, self.robot, self.remarks)
        self.entries[k] = (origin, EffectEntry(id, joint, settings))
        self.places.add((joint, id))
