"""What MJCF states beside bodies and joints: actuators with their gears, joints that follow others, loops."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from robodyn.formats.mjcf_handed import Handed
from robodyn.formats.rigid import composed, motion
from robodyn.formats.tree import Leftovers, Loop, Mimic, TreeJoint, names


def with_drives(
    mujoco: Any, model: Any, joints: Sequence[TreeJoint], leftovers: Leftovers
) -> tuple[list[TreeJoint], list[str]]:
    """The joints with rotor inertia and damping of all their actuators, and with gear ratio and greatest
    torque of the one actuator of each; and which torques are not limited to the same both ways.

    An actuator whose control is limited to -1 and 1 has no gear: its ``gear`` is the greatest torque.
    """
    of_joints = {int(mujoco.mjtTrn.mjTRN_JOINT), int(mujoco.mjtTrn.mjTRN_JOINTINPARENT)}
    motors: dict[str, list[int]] = {}
    for index in range(model.nu):
        if int(model.actuator_trntype[index]) in of_joints:
            motors.setdefault(model.joint(int(model.actuator_trnid[index][0])).name, []).append(index)
    joint_ranges = {
        model.joint(index).name: model.jnt_actfrcrange[index]
        for index in range(model.njnt)
        if model.jnt_actfrclimited[index]
    }
    driven: list[TreeJoint] = []
    remarks: list[str] = []
    for joint in joints:
        indices = motors.get(joint.name, [])
        ranges = [model.actuator_forcerange[index] for index in indices if model.actuator_forcelimited[index]]
        ranges += [force for index in indices if (force := _controlled(mujoco, model, index)) is not None]
        if joint.name in joint_ranges:
            ranges.append(joint_ranges[joint.name])
        remarks += [f"{words}: joint {names([joint.name], 1)}" for words in map(_one_sided, ranges) if words]
        for index in indices:
            joint = _with_passive_part(model, joint, index)
            faster = getattr(model, "actuator_dampingpoly", None)
            if faster is not None and faster[index].any():
                leftovers.changes_torques("damping", f"joint {joint.name}", joint.where)
        if len(indices) == 1:
            joint = _driven(mujoco, model, joint, indices[0])
        elif indices:
            what = f"the actuators of the joint {joint.name}: there are several"
            leftovers.add(what, joint.where.line, joint.where.file)
        driven.append(joint)
    return driven, remarks


def _with_passive_part(model: Any, joint: TreeJoint, index: int) -> TreeJoint:
    """``joint`` with rotor inertia and damping of the actuator, which act on the motor's side of its gear."""
    gear = float(model.actuator_gear[index][0])
    armature, damping = (
        float(getattr(model, f"actuator_{name}", [0.0] * model.nu)[index]) for name in ("armature", "damping")
    )
    return replace(
        joint,
        armature=(joint.armature or 0.0) + armature * gear * gear or None,
        damping=(joint.damping or 0.0) + damping * gear * gear or None,
    )


def _one_sided(force_range: Any) -> str:
    """What is said of a range of forces that is not the same forwards and backwards; "" of others."""
    low, high = map(float, force_range)
    return "" if low == -high else f"forces {low:g} to {high:g} taken as the same both ways, the larger"


def _controlled(mujoco: Any, model: Any, index: int) -> list[float] | None:
    """The range of forces [2] of an actuator that multiplies a control with limits; None of others."""
    plain = int(model.actuator_gaintype[index]) == int(mujoco.mjtGain.mjGAIN_FIXED) and int(
        model.actuator_biastype[index]
    ) == int(mujoco.mjtBias.mjBIAS_NONE)
    if not plain or not model.actuator_ctrllimited[index]:
        return None
    return sorted(float(model.actuator_gainprm[index][0] * end) for end in model.actuator_ctrlrange[index])


def _driven(mujoco: Any, model: Any, joint: TreeJoint, index: int) -> TreeJoint:
    signed = float(model.actuator_gear[index][0])
    gear = abs(signed)
    forces = _controlled(mujoco, model, index)
    efforts = [] if joint.limits.effort is None else [joint.limits.effort]
    if model.actuator_forcelimited[index]:
        efforts.append(gear * float(abs(model.actuator_forcerange[index]).max()))
    if forces is not None:
        efforts.append(gear * max(map(abs, forces)))
    share = forces is not None and [float(x) for x in model.actuator_ctrlrange[index]] == [-1.0, 1.0]
    return replace(
        joint,
        ratio=None if share or signed in (0.0, 1.0) else signed,
        limits=replace(joint.limits, effort=min(efforts, default=None)),
    )


def with_couplings(
    mujoco: Any, model: Any, joints: Sequence[TreeJoint], text: Handed
) -> tuple[list[TreeJoint], tuple[Loop, ...]]:
    """The joints with what they follow, and the constraints that close loops."""
    kinds = mujoco.mjtEq
    held: dict[str, float] = {}
    mimics: dict[str, Mimic] = {}
    loops = []
    for index in range(model.neq):
        if not model.eq_active0[index]:
            continue
        one, other = int(model.eq_obj1id[index]), int(model.eq_obj2id[index])
        kind, name = int(model.eq_type[index]), model.equality(index).name
        where = text.place_of("equality", name, "")
        if kind == int(kinds.mjEQ_JOINT):
            follower = model.joint(one).name
            if other < 0:
                held[follower] = float(model.qpos0[model.jnt_qposadr[one]]) + float(model.eq_data[index][0])
                continue
            c0, c1, *curved = (float(x) for x in model.eq_data[index][:5])
            start, lead = (float(model.qpos0[model.jnt_qposadr[joint]]) for joint in (one, other))
            mimics[follower] = Mimic(model.joint(other).name, c1, c0 + start - c1 * lead, tuple(curved), lead)
        elif kind in (int(kinds.mjEQ_CONNECT), int(kinds.mjEQ_WELD)):
            of_sites = int(model.eq_objtype[index]) == int(mujoco.mjtObj.mjOBJ_SITE)
            owners = [int(model.site(i).bodyid[0]) if of_sites else max(i, 0) for i in (one, other)]
            links = (model.body(owners[0]).name, model.body(owners[1]).name)
            loops.append(Loop(f"the constraint {name}", links, where))
    coupled = [_fixed_at(joint, held[joint.name]) if joint.name in held else joint for joint in joints]
    return [replace(j, mimic=mimics[j.name]) if j.name in mimics else j for j in coupled], tuple(loops)


def _fixed_at(joint: TreeJoint, position: float) -> TreeJoint:
    """A fixed joint in the place of ``joint``, at the ``position`` [rad or m] where an equation holds it."""
    origin = composed(joint.origin, motion(joint, position))
    return TreeJoint(joint.name, "fixed", joint.parent, joint.child, joint.where, origin, joint.child_pose)
