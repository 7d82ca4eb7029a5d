"""MJCF to a tree through the package mujoco, which knows its defaults, angles and inertias of shapes."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

from robodyn.errors import InputError, Place
from robodyn.formats.chain import Body, Pose, Spring, Vector, body_of, composed, tidy, unit
from robodyn.formats.elements import Document
from robodyn.formats.limits import PLACEHOLDER, SAME_INERTIA
from robodyn.formats.mjcf_drives import with_couplings, with_drives
from robodyn.formats.mjcf_input import ModelText
from robodyn.formats.mjcf_text import model_text
from robodyn.formats.tree import JointLimits, Leftovers, Loop, Tree, TreeJoint, TreeLink, checked, names
from robodyn.tools.libraries import MUJOCO, quiet_mujoco

WORLD: Final = "world"
_KINDS: Final = ("floating", "ball", "prismatic", "revolute")
#: Parts of a joint that flags of the simulation switch off: words, the flags, the joint without the part.
_SWITCHED: Final[tuple[tuple[str, tuple[str, str], Callable[[TreeJoint], TreeJoint]], ...]] = (
    ("springs of joints are", ("PASSIVE", "SPRING"), lambda joint: replace(joint, spring=None)),
    (
        "damping of joints is",
        ("PASSIVE", "DAMPER"),
        lambda joint: replace(joint, damping=joint.damping and 0.0),
    ),
    (
        "friction of joints is",
        ("FRICTIONLOSS", "CONSTRAINT"),
        lambda joint: replace(joint, friction=joint.friction and 0.0),
    ),
)


def read_tree(document: Document, path: Path | None, folders: Iterable[str] = ()) -> Tree:
    """The tree of a document whose root is ``<mujoco>`` and that lies at ``path``.

    It may include and attach files beside ``path`` and below it, and those in ``folders``.

    A body with several joints becomes several links, all but the last without mass. Sites become links that
    are fixed to their bodies, so that they can be tips.

    Raises
    ------
    InputError: MuJoCo refuses the file, or a file that it includes cannot be read.
    ToolError: the package is not installed.
    """
    model = _Model(document, path, folders)
    tree = model.tree(document.root.attributes.get("model", ""))
    return checked(replace(tree, unused=model.leftovers.unused(), physics=tuple(model.leftovers.physics)))


def _without_meshes(spec: Any, text: ModelText) -> set[str]:
    """Delete the geoms that stand for meshes; the names of bodies whose inertia depends on them."""
    bare = set()
    for body in spec.bodies:
        heavy = False
        for geom in list(body.geoms):
            rules = text.rules_of(geom.name)
            if rules is not None:
                weightless = geom.mass == 0 or (math.isnan(geom.mass) and geom.density == 0)
                lowest, highest = rules.groups
                counts = lowest <= geom.group <= highest and not weightless
                heavy = heavy or (counts and (rules.always_from_shapes or not body.explicitinertial))
                spec.delete(geom)
        if heavy and body.name != WORLD:
            bare.add(body.name)
            body.mass, body.inertia, body.explicitinertial = PLACEHOLDER, [PLACEHOLDER] * 3, True
            body.ipos, body.fullinertia = [0, 0, 0], [math.nan] * 6
            for geom in list(body.geoms):
                spec.delete(geom)
    if bare and _scales(spec):
        bare.update(body.name for body in spec.bodies if body.name != WORLD)
    return bare


def _scales(spec: Any) -> bool:
    """Whether MuJoCo scales all masses to a total, in which that of each mesh counts."""
    return float(spec.compiler.settotalmass) > 0


class _Model:
    """A compiled model and what it was made of.

    Raises
    ------
    InputError: MuJoCo refuses the file.
    """

    def __init__(self, document: Document, path: Path | None, folders: Iterable[str]) -> None:
        self.mujoco = mujoco = MUJOCO.load(where=Place(document.file))
        self.file, self.leftovers = document.file, Leftovers(document.file)
        self.text = model_text(document, path, self.leftovers, folders)
        try:
            with quiet_mujoco(mujoco):
                files = {name: model.encode() for name, model in self.text.models.items()}
                self.spec = mujoco.MjSpec.from_string(self.text.text, include=files)
                self.bare = _without_meshes(self.spec, self.text)
                self.model = self.spec.compile()
        except (ValueError, mujoco.FatalError) as error:
            message = " ".join(str(error).split())
            where = self.text.place(message, document.file)
            raise InputError("MuJoCo refuses the file", where=where, found=message[:300]) from None

    def tree(self, model_name: str) -> Tree:
        links, joints = [], []
        for index in range(self.model.nbody):
            body = self.model.body(index)
            parts = self.joints(body) if index else []
            links += [TreeLink(joint.child, joint.where) for joint in parts[:-1]]
            links.append(self.link(body))
            joints += parts
        bodies = {link.name for link in links}
        for index in range(self.model.nsite):
            site = self.model.site(index)
            where, in_brackets = self.place("site", site.name), f"{site.name} (site)"
            name = site.name if site.name not in bodies else in_brackets
            links.append(TreeLink(name, where))
            parent, origin = self.model.body(int(site.bodyid[0])).name, pose(site.pos, site.quat)
            joints.append(TreeJoint(in_brackets, "fixed", parent, name, where, origin))
        gravity = (0.0, 0.0, 0.0) if self.is_off("GRAVITY") else vector(self.model.opt.gravity)
        self.note_surroundings(any(gravity))
        joints, ranges = with_drives(self.mujoco, self.model, joints, self.leftovers)
        joints, switched = self.as_switched(joints)  # flags switch the actuators' part off too
        loops: tuple[Loop, ...] = ()
        if self.is_off("CONSTRAINT", "EQUALITY"):
            ties = self.model.neq or self.text.tendons
            switched += ["what ties joints and bodies is switched off (flag)"] if ties else []
        else:
            for where, of in self.text.tendons:
                self.leftovers.changes_torques("equality", of, where)
            joints, loops = with_couplings(self.mujoco, self.model, joints, self.text)
        return Tree(
            model_name,
            "MJCF",
            self.file,
            tuple(links),
            tuple(joints),
            gravity,
            loops,
            remarks=(*self.overruled(), *self.remarks(), *switched, *ranges),
            warnings=tuple(self.text.warnings),
        )

    def is_off(self, *flags: str) -> bool:
        """Whether the file switches one of the ``flags`` of the simulation off."""
        bits = (int(getattr(self.mujoco.mjtDisableBit, f"mjDSBL_{flag}", 0)) for flag in flags)
        return any(int(self.model.opt.disableflags) & bit for bit in bits)

    def as_switched(self, joints: Sequence[TreeJoint]) -> tuple[list[TreeJoint], list[str]]:
        """The joints without what the file's flags switch off, and what was switched off."""
        remarks = ["gravity is switched off (flag)"] if self.is_off("GRAVITY") else []
        for words, flags, without in _SWITCHED:
            if self.is_off(*flags) and (others := [without(joint) for joint in joints]) != list(joints):
                remarks.append(f"{words} switched off (flag)")
                joints = others
        return list(joints), remarks

    def note_surroundings(self, weigh: bool) -> None:
        """Note the fluid around the arm, and forces that take weight off its bodies if they ``weigh``."""
        for name in ("density", "viscosity"):
            if value := getattr(self.model.opt, name):
                self.leftovers.changes_torques(name, f"{value:g}", Place(self.file))
        for index in range(self.model.nbody if weigh else 0):
            share, body = float(self.model.body_gravcomp[index]), self.model.body(index)
            if share and self.model.body_weldid[index] and body.mass[0]:
                where = self.place("body", body.name)
                self.leftovers.changes_torques("gravcomp", f"body {body.name}", where)

    def overruled(self) -> tuple[str, ...]:
        """What a file says of the surroundings and flags where another one's counts: a model has one of each
        with all that is attached to it."""
        remarks = []
        for place, name, text in self.text.settings:
            words = text.split()
            stated = counts = " ".join(words)
            if stated in ("enable", "disable"):
                counts = "disable" if self.is_off(name.upper()) else "enable"
            else:  # MuJoCo reads hexadecimal ones too
                values = [float.fromhex(word) if "x" in word.lower() else float(word) for word in words]
                setting = getattr(self.model.opt, name)
                settings = [setting] if len(words) == 1 else list(setting)
                counts = stated if values == settings else " ".join(f"{value:g}" for value in settings)
            if counts != stated:
                remarks.append(f"{name} is {counts}, and not {stated} ({place}), as MuJoCo reads it")
        return tuple(dict.fromkeys(remarks))

    def remarks(self) -> list[str]:
        """Whose inertia is not stated."""
        if self.bare and _scales(self.spec):
            return ["masses are scaled to settotalmass, and one of a mesh is among them: all are unknown"]
        bodies = [body.name for body in self.spec.bodies if body.name not in {WORLD, *self.bare}]
        shapes = [name for name in bodies if self.of_shapes(name) and self.model.body(name).mass[0]]
        return [f"inertia from shapes, as MuJoCo computes it: {names(shapes)}"] if shapes else []

    def of_shapes(self, body: str) -> bool:
        """Whether MuJoCo takes the inertia of the ``body`` from its shapes."""
        always = int(self.spec.compiler.inertiafromgeom) == 1
        return always or not self.spec.body(body).explicitinertial

    def place(self, tag: str, name: str) -> Place:
        return self.text.place_of(tag, name, self.file)

    def joints(self, body: Any) -> list[TreeJoint]:
        """The joints between a body and its parent: a fixed one, or one or several that move."""
        parent, where = self.model.body(int(body.parentid[0])).name, self.place("body", body.name)
        origin = pose(body.pos, body.quat)
        first, count = int(body.jntadr[0]), int(body.jntnum[0])
        if not count:
            return [TreeJoint(f"{body.name} (fixed)", "fixed", parent, body.name, where, origin)]
        joints = []
        for index in range(first, first + count):
            name = self.model.joint(index).name
            child = body.name if index == first + count - 1 else f"{body.name} before {name}"
            joints.append(self.joint(index, parent, child, origin))
            parent, origin = child, Pose()
        return joints

    def joint(self, index: int, parent: str, child: str, origin: Pose) -> TreeJoint:
        model = self.model
        name, kind = model.joint(index).name, _KINDS[int(model.jnt_type[index])]
        where, dof = self.place("joint", name), int(model.jnt_dofadr[index])
        joint = TreeJoint(name, kind, parent, child, where, origin)
        if kind not in ("revolute", "prismatic"):
            return joint
        stiffness, address = float(model.jnt_stiffness[index]), int(model.jnt_qposadr[index])
        spring = Spring(stiffness, float(model.qpos_spring[address])) if stiffness else None
        damping = float(model.dof_damping[dof])
        if all(self.spec.joint(name).springdamper > 0) and self.moves_with_bare(dof):
            self.leftovers.changes_torques("springdamper", f"joint {name}", where)
            spring, damping = None, 0.0
        for table, at, word in (
            ("jnt_stiffnesspoly", index, "stiffness"),
            ("dof_dampingpoly", dof, "damping"),
        ):
            if (higher := getattr(model, table, None)) is not None and higher[at].any():
                self.leftovers.changes_torques(word, f"joint {name}", where)
        x, y, z = anchor = vector(model.jnt_pos[index])
        is_limited = bool(model.jnt_limited[index])
        lower, upper = map(float, model.jnt_range[index]) if is_limited else (None, None)
        effort = float(abs(model.jnt_actfrcrange[index]).max()) if model.jnt_actfrclimited[index] else None
        return replace(
            joint,
            origin=composed(origin, Pose(anchor)),
            child_pose=Pose((-x, -y, -z)),
            axis=unit(vector(model.jnt_axis[index])),
            reference=float(model.qpos0[address]),
            limits=JointLimits(lower, upper, effort=effort),
            damping=damping or None,  # a 0 may be stated, or MuJoCo's default
            friction=float(model.dof_frictionloss[dof]) or None,
            armature=float(model.dof_armature[dof]) or None,
            spring=spring,
        )

    def moves_with_bare(self, dof: int) -> bool:
        """Whether a body without inertia moves in the tree of that degree of freedom: MuJoCo takes what there
        is to move from the inverse of its whole mass matrix (dof_invweight0)."""
        model = self.model
        welds = {int(model.body_weldid[model.body(name).id]) for name in self.bare} - {0}
        return any(model.dof_treeid[model.body_dofadr[weld]] == model.dof_treeid[dof] for weld in welds)

    def link(self, body: Any) -> TreeLink:
        where = self.place("body", body.name)
        if body.name in self.bare or not body.id:
            is_bare = body.name in self.bare
            return TreeLink(body.name, where, shape=is_bare, unread=is_bare)
        if not body.mass[0] and not body.inertia.any():
            return TreeLink(body.name, where, shape=bool(body.geomnum[0]))
        xx, yy, zz = map(float, body.inertia)
        solid = body_of(float(body.mass[0]), pose(body.ipos, body.iquat), (xx, yy, zz, 0.0, 0.0, 0.0))
        solid = _as_stated(solid, [float(x) for x in self.spec.body(body.name).fullinertia])
        return TreeLink(body.name, where, solid, True, self.of_shapes(body.name))


def _as_stated(body: Body, stated: list[float]) -> Body:
    """``body`` with the entries of its tensor as the file states them, where they are the same: MuJoCo turns
    tensors into principal axes, which costs the last digits."""
    scale = max(map(abs, body.inertia))
    if all(abs(a - b) <= SAME_INERTIA * scale for a, b in zip(body.inertia, stated, strict=True)):
        xx, yy, zz, xy, xz, yz = stated
        return replace(body, inertia=(xx, yy, zz, xy, xz, yz))
    return body


def pose(xyz: Any, wxyz: Any) -> Pose:
    """A position [m] and a quaternion of a compiled model."""
    return tidy(Pose.from_quaternion(vector(xyz), [float(x) for x in wxyz]))


def vector(numbers: Any) -> Vector:
    """Three numbers of a compiled model."""
    x, y, z = (float(entry) for entry in numbers)
    return (x, y, z)
