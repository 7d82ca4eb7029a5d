"""What MJCF states beside bodies and joints: actuators with their gears, joints that follow others, loops."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from robodyn.formats.chain import composed
from robodyn.formats.mjcf_input import ModelText
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
        ranges = [force for index in indices for force in _forces(mujoco, model, index)]
        ranges += [joint_ranges[joint.name]] if joint.name in joint_ranges else []
        remarks += [
            f"forces {low:g} to {high:g} taken as the same both ways, the larger: joint {names([joint.name])}"
            for low, high in ranges
            if low != -high
        ]
        for index in indices:
            # rotor inertia and damping act on the motor's side of the gear
            gear = float(model.actuator_gear[index][0])
            armature, damping = (
                float(getattr(model, f"actuator_{name}", [0.0] * model.nu)[index]) * gear * gear
                for name in ("armature", "damping")
            )
            armature, damping = (joint.armature or 0.0) + armature, (joint.damping or 0.0) + damping
            joint = replace(joint, armature=armature or None, damping=damping or None)
            faster = getattr(model, "actuator_dampingpoly", None)
            if faster is not None and faster[index].any():
                leftovers.changes_torques("damping", f"joint {joint.name}", joint.where)
        if len(indices) == 1:
            joint = _with_motor(mujoco, model, joint, indices[0])
        elif indices:
            what = f"the actuators of the joint {joint.name}: there are several"
            leftovers.add(what, joint.where.line, joint.where.file)
        driven.append(joint)
    return driven, remarks


def _forces(mujoco: Any, model: Any, index: int) -> list[list[float]]:
    """The ranges of forces [2] of an actuator: its own, and that of the control that it multiplies."""
    ranges = []
    if model.actuator_forcelimited[index]:
        ranges.append([float(end) for end in model.actuator_forcerange[index]])
    is_fixed = int(model.actuator_gaintype[index]) == int(mujoco.mjtGain.mjGAIN_FIXED)
    is_plain = is_fixed and int(model.actuator_biastype[index]) == int(mujoco.mjtBias.mjBIAS_NONE)
    if is_plain and model.actuator_ctrllimited[index]:
        gain = model.actuator_gainprm[index][0]
        ranges.append(sorted(float(gain * end) for end in model.actuator_ctrlrange[index]))
    return ranges


def _with_motor(mujoco: Any, model: Any, joint: TreeJoint, index: int) -> TreeJoint:
    gear = float(model.actuator_gear[index][0])
    forces = _forces(mujoco, model, index)
    efforts = [abs(gear) * max(map(abs, force)) for force in forces]
    efforts += [] if joint.limits.effort is None else [joint.limits.effort]
    is_controlled = len(forces) > bool(model.actuator_forcelimited[index])
    share = is_controlled and [float(x) for x in model.actuator_ctrlrange[index]] == [-1.0, 1.0]
    return replace(
        joint,
        ratio=None if share or gear in (0.0, 1.0) else gear,
        limits=replace(joint.limits, effort=min(efforts, default=None)),
    )


def with_couplings(
    mujoco: Any, model: Any, joints: Sequence[TreeJoint], text: ModelText
) -> tuple[list[TreeJoint], tuple[Loop, ...]]:
    """The joints with what they follow, and the constraints that close loops."""
    kinds = mujoco.mjtEq
    free = {joint.name: joint for joint in joints}
    coupled, loops = dict(free), []
    for index in range(model.neq):
        if not model.eq_active0[index]:
            continue
        one, other = int(model.eq_obj1id[index]), int(model.eq_obj2id[index])
        kind, name = int(model.eq_type[index]), model.equality(index).name
        if kind == int(kinds.mjEQ_JOINT):
            joint = free[model.joint(one).name]
            c0, c1, *curved = (float(x) for x in model.eq_data[index][:5])
            start = float(model.qpos0[model.jnt_qposadr[one]])
            if other >= 0:
                lead = float(model.qpos0[model.jnt_qposadr[other]])
                leader = model.joint(other).name
                mimic = Mimic(leader, c1, c0 + start - c1 * lead, tuple(curved), lead)
                coupled[joint.name] = replace(coupled[joint.name], mimic=mimic)
            else:  # an equation holds it: a fixed joint in its place
                origin = composed(joint.origin, joint.motion(start + c0))
                ends = (joint.parent, joint.child, joint.where, origin, joint.child_pose)
                coupled[joint.name] = TreeJoint(joint.name, "fixed", *ends, mimic=coupled[joint.name].mimic)
        elif kind in (int(kinds.mjEQ_CONNECT), int(kinds.mjEQ_WELD)):
            of_sites = int(model.eq_objtype[index]) == int(mujoco.mjtObj.mjOBJ_SITE)
            owners = [int(model.site(i).bodyid[0]) if of_sites else max(i, 0) for i in (one, other)]
            links = (model.body(owners[0]).name, model.body(owners[1]).name)
            loops.append(Loop(f"the constraint {name}", links, text.place_of("equality", name, "")))
    return list(coupled.values()), tuple(loops)
