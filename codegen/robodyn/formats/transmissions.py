"""Transmissions of URDF: the reduction of a gear, the rotor behind it."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from robodyn.formats.elements import Element, tag_shown
from robodyn.formats.quantities import Quantities, negative
from robodyn.formats.tree import Leftovers, TreeJoint, near
from robodyn.robot.names import shown

_SIMPLE: Final = "SimpleTransmission"
_REDUCTION: Final = "mechanicalReduction"
_MOTOR_INERTIA: Final = "motorInertia"
_RATIO, _ROTOR = "drake:gear_ratio", "drake:rotor_inertia"


class Transmissions:
    """Collects what transmissions say of joints: those between one motor and one joint."""

    def __init__(self, reader: Quantities, leftovers: Leftovers) -> None:
        self._reader, self._leftovers = reader, leftovers
        self._ratios: dict[str, float] = {}
        self._armatures: dict[str, float] = {}
        self._elements: dict[str, Element] = {}
        self._with_rotor: dict[str, Element] = {}

    def read(self, element: Element) -> None:
        """Take what one ``<transmission>`` says."""
        joints = [joint.attributes.get("name", "") for joint in element.all("joint")]
        actuators = list(element.all("actuator"))
        kind = element.first("type")
        word = element.attributes.get("type", "") if kind is None else kind.text
        if len(joints) != 1 or len(actuators) > 1 or (word and not word.endswith(_SIMPLE)):
            self._leftovers.add("transmissions of more than one motor and one joint", element.line)
            if any(part.tag in (_MOTOR_INERTIA, _ROTOR) for part in element.walk()):
                of = f"transmission {element.attributes.get('name', '')}"
                self._leftovers.changes_torques("transmission", of, self._reader.place(element))
            return
        (joint,) = joints
        self._elements.setdefault(joint, element)
        for part in element.walk():
            if part.tag == _REDUCTION:
                self._ratio(part, joint, part.text, "")
            elif part.tag == _RATIO:
                self._ratio(part, joint, part.attributes.get("value", ""), "value")
            elif part.tag == _MOTOR_INERTIA:
                what = f"joint {shown(joint)}: {tag_shown(part)}"
                (rotor,) = self._reader.numbers(part.text, 1, part, "", what)
                self._rotor(element, part, joint, rotor)
            elif part.tag == _ROTOR:
                rotor = self._reader.number(part, "value", f"joint '{joint}'", bad=negative)
                self._rotor(element, part, joint, rotor)

    def _rotor(self, transmission: Element, part: Element, joint: str, value: float) -> None:
        """Take the rotor inertia; that of a second motor of the joint, even an equal one, is refused."""
        if self._with_rotor.setdefault(joint, transmission) is not transmission:
            raise self._reader.fail(
                part,
                f"joint {shown(joint)}: {tag_shown(part)} is stated by two transmissions",
                found=f"{value:g} after {self._armatures[joint]:g}",
                expected="one motor for a joint",
                remedy="state the sum of their inertias in one of the transmissions",
            )
        self._state(self._armatures, part, joint, value)

    def _ratio(self, part: Element, joint: str, text: str, attribute: str) -> None:
        what = f"joint '{joint}': {tag_shown(part)}"
        (ratio,) = self._reader.numbers(text, 1, part, attribute, what)
        if ratio in (0.0, 1.0):
            self._leftovers.add(f"reductions of {ratio:g}", part.line)
            return
        self._state(self._ratios, part, joint, ratio)

    def _state(self, values: dict[str, float], part: Element, joint: str, value: float) -> None:
        """Take ``value`` for the ``joint``; another one before it is refused."""
        if values.setdefault(joint, value) != value:
            raise self._reader.fail(
                part,
                f"joint {shown(joint)}: {tag_shown(part)} is stated twice",
                found=f"{value:g} after {values[joint]:g}",
                expected="one value for a joint",
            )

    def applied(self, joints: tuple[TreeJoint, ...]) -> tuple[TreeJoint, ...]:
        """The joints with their ratios, and rotor inertias reflected through them; transmissions of joints
        that are not there are noted."""
        names = dict.fromkeys(joint.name for joint in joints)
        for name, element in self._elements.items():
            if name not in names:
                of = f"joint {name}; {near(name, names, 'joint')}"
                self._leftovers.changes_torques("transmission", of, self._reader.place(element))
        return tuple(self._with_transmission(joint) for joint in joints)

    def _with_transmission(self, joint: TreeJoint) -> TreeJoint:
        ratio, rotor = self._ratios.get(joint.name), self._armatures.get(joint.name)
        if ratio is not None:
            joint = replace(joint, ratio=ratio)
        if rotor is not None:
            joint = replace(joint, armature=(joint.armature or 0.0) + rotor * (ratio or 1.0) ** 2)
        return joint
