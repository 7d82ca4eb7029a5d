"""The thesis's folding of the rotors into the links, as a named option."""

from __future__ import annotations

from dataclasses import replace

from robodyn.robot.model import Link, Robot
from robodyn.robot.values import ZERO


def fold_rotor(robot: Robot) -> Robot:
    """``robot`` with every ``motor_inertia`` moved into its link, as the thesis's programs do it.

    Revolute: added to the link's Izz. The rotor then takes part in the whole rotation of the link, not
    only in the joint's own: not the right physics (it is off by several N m on a moving PUMA 560), but what
    the printed figures were computed with.

    Prismatic: added to the link's mass [kg] at its centre, the nearest thing that a rigid body allows.
    The joint's own acceleration meets the same inertia as before; in addition the lump weighs, and is
    swung about by the other joints. The thesis never does this: its listings drop the number (0.782 kg of
    the Stanford arm), and so do the bundled ``stanford_d3`` and ``stanford_3dof_d3``.
    """
    return replace(robot, links=tuple(_folded(link) for link in robot.links))


def _folded(link: Link) -> Link:
    rotor = link.joint.motor_inertia
    joint = replace(link.joint, motor_inertia=ZERO)
    if link.joint.kind == "revolute":
        return replace(link, joint=joint, inertia=replace(link.inertia, zz=link.inertia.zz + rotor))
    return replace(link, joint=joint, mass=link.mass + rotor)
