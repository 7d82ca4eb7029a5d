"""What MJCF states beside bodies and joints: actuators with their gears, joints that follow others, loops."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from robodyn.formats.mjcf_handed import Handed
from robodyn.formats.tree import Leftovers, Loop, Mimic, TreeJoint


def with_drives(
    mujoco: Any, model: Any, joints: Sequence[TreeJoint], leftovers: Leftovers
) -> list[TreeJoint]:
    """The joints with gear ratio, rotor inertia and greatest torque of the one actuator of each.

    An actuator whose control is limited to -1 and 1 has no gear: its ``gear`` is the greatest torque.
    """
    motors: dict[str, list[int]] = {}
    for index in range(model.nu):
        if int(model.actuator_trntype[index]) == int(mujoco.mjtTrn.mjTRN_JOINT):
            motors.setdefault(model.joint(int(model.actuator_trnid[index][0])).name, []).append(index)
    driven = []
    for joint in joints:
        indices = motors.get(joint.name, [])
        if len(indices) == 1:
            joint = _driven(mujoco, model, joint, indices[0])
        elif indices:
            what = f"the actuators of the joint {joint.name}: there are several"
            leftovers.add(what, joint.where.line, joint.where.file)
        driven.append(joint)
    return driven


def _driven(mujoco: Any, model: Any, joint: TreeJoint, index: int) -> TreeJoint:
    gear = abs(float(model.actuator_gear[index][0]))
    control = model.actuator_ctrlrange[index] if model.actuator_ctrllimited[index] else None
    plain = int(model.actuator_gaintype[index]) == int(mujoco.mjtGain.mjGAIN_FIXED) and int(
        model.actuator_biastype[index]
    ) == int(mujoco.mjtBias.mjBIAS_NONE)
    efforts = [] if joint.limits.effort is None else [joint.limits.effort]
    if model.actuator_forcelimited[index]:
        efforts.append(gear * float(abs(model.actuator_forcerange[index]).max()))
    if control is not None and plain:
        gain = abs(float(model.actuator_gainprm[index][0]))
        efforts.append(gear * gain * float(abs(control).max()))
    share = plain and control is not None and [float(x) for x in control] == [-1.0, 1.0]
    armature = float(getattr(model, "actuator_armature", [0.0] * model.nu)[index])
    return replace(
        joint,
        ratio=None if share or gear in (0.0, 1.0) else gear,
        armature=joint.armature + armature * gear**2,
        limits=replace(joint.limits, effort=min(efforts, default=None)),
    )


def with_couplings(
    mujoco: Any, model: Any, joints: Sequence[TreeJoint], text: Handed, leftovers: Leftovers
) -> tuple[list[TreeJoint], tuple[Loop, ...]]:
    """The joints with what they follow, and the constraints that close loops."""
    kinds = mujoco.mjtEq
    mimics: dict[str, Mimic] = {}
    loops = []
    for index in range(model.neq):
        if not model.eq_active0[index]:
            continue
        one, other = int(model.eq_obj1id[index]), int(model.eq_obj2id[index])
        kind, name = int(model.eq_type[index]), model.equality(index).name
        where = text.place_of("equality", name, "")
        line, file = where.line, where.file
        if kind == int(kinds.mjEQ_JOINT):
            follower = model.joint(one).name
            if other < 0:
                leftovers.add(f"what holds the joint {follower}", line, file)
                continue
            c0, c1, *curved = (float(x) for x in model.eq_data[index][:5])
            if any(curved):
                leftovers.add(f"the curved part of what the joint {follower} follows", line, file)
            start, lead = (float(model.qpos0[model.jnt_qposadr[joint]]) for joint in (one, other))
            mimics[follower] = Mimic(model.joint(other).name, c1, c0 + start - c1 * lead)
        elif kind in (int(kinds.mjEQ_CONNECT), int(kinds.mjEQ_WELD)):
            of_sites = int(model.eq_objtype[index]) == int(mujoco.mjtObj.mjOBJ_SITE)
            owners = [int(model.site(i).bodyid[0]) if of_sites else max(i, 0) for i in (one, other)]
            links = (model.body(owners[0]).name, model.body(owners[1]).name)
            loops.append(Loop(f"the constraint {name}", links, where))
    return [replace(j, mimic=mimics[j.name]) if j.name in mimics else j for j in joints], tuple(loops)
