"""SDF files for tests, by the semantics of frames since version 1.7: models in models, ``placement_frame``.

Each has two joints or more, and a base that is fixed to the world. What Drake 1.51.1 computes of them is in
``tests/formats/drake.json``, which ``python -m robodyn_testing.sdf_arms`` writes, run in ``tests`` where the
package drake is installed.
"""

from __future__ import annotations

import importlib
import json
from pathlib import Path
from typing import Any, Final

import numpy as np

FIGURES: Final = Path(__file__).parents[1] / "formats" / "drake.json"


def link(name: str, pose: str = "", mass: float = 2.5) -> str:
    """A link with a solid body; ``pose`` is its element."""
    return (
        f'<link name="{name}">{pose}<inertial><pose>0.1 0.02 -0.03 0.2 0.4 -0.6</pose><mass>{mass}</mass>'
        "<inertia><ixx>0.03</ixx><iyy>0.05</iyy><izz>0.04</izz><ixy>0.004</ixy><ixz>-0.003</ixz><iyz>0.002</iyz>"
        "</inertia></inertial></link>"
    )


def joint(name: str, parent: str, child: str, axis: str, pose: str = "", kind: str = "revolute") -> str:
    """A joint; ``axis``: its direction, with or without the tag."""
    xyz = axis if axis.startswith("<") else f"<xyz>{axis}</xyz>"
    return (
        f'<joint name="{name}" type="{kind}">{pose}<parent>{parent}</parent><child>{child}</child>'
        f"<axis>{xyz}<limit><lower>-3</lower><upper>3</upper></limit></axis></joint>"
    )


FIX = '<joint name="fix" type="fixed"><parent>world</parent><child>b</child></joint>'
BASE = link("b") + FIX
L1 = link("l1", "<pose>0.1 0 0.3 0.3 -0.2 0.5</pose>")
L2 = link("l2", '<pose relative_to="l1">0.1 0.2 0.3 0.7 0.2 0.5</pose>', 1.5)
J1 = joint("j1", "b", "l1", "0.36 0.48 0.8")
J2 = joint("j2", "l1", "l2", "-0.6 0 0.8", "<pose>0.05 0.02 -0.01 0.1 0.2 0.3</pose>", "prismatic")
ARM = BASE + L1 + L2 + J1 + J2
HAND = (
    "{pose}"
    + link("palm", "<pose>0.01 0.02 0.03 0.4 0.5 0.6</pose>", 0.8)
    + link("finger", '<pose relative_to="palm">0 0.1 0.1 0 0.3 0</pose>', 0.2)
    + joint(
        "k", "palm", "finger", "<xyz expressed_in='__model__'>0 0.6 0.8</xyz>", "<pose>0.01 0 0 0 0 1</pose>"
    )
    + '<frame name="wrist"><pose relative_to="palm">0 0 -0.05 0.3 0 0.2</pose></frame>'
)


def model(inside: str, attributes: str = "", name: str = "arm") -> str:
    """A model."""
    return f'<model name="{name}" {attributes}>{inside}</model>'


def sdf(inside: str) -> str:
    """The file."""
    return f'<?xml version="1.0"?><sdf version="1.9">{inside}</sdf>'


def world(inside: str) -> str:
    """The file of a world."""
    return sdf(f'<world name="w"><gravity>0 0 -9.81</gravity>{inside}</world>')


#: Files by what is in them, with the model that is read and the link at its tip.
ARMS: Final[dict[str, tuple[str, str, str]]] = {
    "placement of a frame": (
        sdf(
            model(
                f'<pose degrees="true">0.1 0 0 20 30 40</pose>{ARM}<frame name="f" attached_to="l2">'
                '<pose relative_to="l1">0.3 0 0 0 0.4 0</pose></frame>',
                'placement_frame="f"',
            )
        ),
        "", "l2",
    ),
    "the model as a parent": (
        sdf(
            model(
                f"<pose>0 0 0.5 0.1 0 0</pose>{L1}"
                + link("b", "<pose>0.2 0.1 0 0 0 0.4</pose>") + FIX + L2 + J2
                + joint("j1", "__model__", "l1", "0.36 0.48 0.8"),
                'canonical_link="b"',
            )
        ),
        "", "l2",
    ),
    "frames as parent and child": (
        sdf(
            model(
                BASE + L1 + L2
                + '<frame name="f"><pose>0.1 0 0.2 0 0.5 0</pose></frame>'
                '<frame name="g" attached_to="l1"><pose>0.05 0 0 0 0 0.7</pose></frame>'
                '<frame name="h" attached_to="g"><pose relative_to="f">0.05 0 0.1 0 0.2 0</pose></frame>'
                '<frame name="r" attached_to="j1"><pose>0 0.1 0 0.3 0 0</pose></frame>'
                + joint("j1", "f", "g", "<xyz expressed_in='h'>0 0.6 0.8</xyz>", '<pose relative_to="h"/>')
                + joint("j2", "r", "l2", "0 1 0", '<pose relative_to="r">0 0 0.1 0.2 0 0</pose>'),
            )
        ),
        "", "l2",
    ),
    "a model in a model, placed by a frame, moved by its frame": (
        sdf(
            model(
                ARM
                + model(
                    HAND.format(pose='<pose relative_to="l2">0.1 0.05 0.2 0.2 0 0.3</pose>'),
                    'placement_frame="wrist" canonical_link="palm"', "hand",
                )
                + joint("turn", "l2", "hand", "0 0.8 0.6", "<pose relative_to='hand::wrist'/>")
            )
        ),
        "", "hand::finger",
    ),
    "models in models": (
        sdf(
            model(
                ARM
                + model(
                    link("rod", "<pose>0 0 0.1 0 0 0</pose>", 0.4)
                    + model(HAND.format(pose='<pose relative_to="rod">0.1 0 0.2 0 0 0.3</pose>'),
                            'placement_frame="finger"', "hand")
                    + joint("slide", "rod", "hand", "0 0 1", "", "prismatic"),
                    'placement_frame="hand::wrist"', "extension",
                )
                + '<frame name="end" attached_to="l2"><pose>0 0 0.3 0.5 0 0</pose></frame>'
                '<joint name="hold" type="fixed"><parent>end</parent><child>extension</child></joint>',
                'placement_frame="extension::hand"',
            )
        ),
        "", "extension::hand::finger",
    ),
    "links without inertia": (
        sdf(
            model(
                BASE + L1 + J1 + J2
                + '<link name="l2"><pose relative_to="l1">0.1 0.2 0.3 0.7 0.2 0.5</pose></link>'
                '<link name="c"><pose relative_to="l1">0 0 0.2 0 0 0</pose>'
                '<inertial><mass>2</mass></inertial></link>'
                '<joint name="hold" type="fixed"><parent>l1</parent><child>c</child></joint>',
            )
        ),
        "", "l2",
    ),
    "relative to another model of the world": (
        world(
            '<frame name="corner"><pose>1 2 0 0 0 0.5</pose></frame>'
            + model(
                '<static>true</static><pose relative_to="corner">0.5 0 0 0 0 0.2</pose>'
                + link("board", "<pose>0 0 0.7 0 0.1 0</pose>"),
                'placement_frame="board"', "table",
            )
            + model(f'<pose relative_to="table::board">0.1 0 0.1 0.4 0 0</pose>{ARM}', 'placement_frame="l1"')
        ),
        "", "l2",
    ),
    "one of two": (
        world(
            model(f"<pose>0 0 0 0 0.2 0</pose>{ARM}", "", "left")
            + model(f"<pose>0 -1 0 0.5 0 0</pose>{ARM}", 'placement_frame="l2"', "right")
        ),
        "right", "l2",
    ),
    "a model in another, chosen": (
        sdf(
            model(
                BASE
                + model(f"<pose>0.3 0.2 0.1 0.4 0.5 0</pose>{ARM}", 'placement_frame="l1"', "left"),
                'placement_frame="left::l2"', "torso",
            )
        ),
        "torso::left", "l2",
    ),
}  # fmt: skip
STATE: Final = ([0.3, -0.2, 0.5, 0.7], [0.4, 0.9, -0.6, 0.3], [1.1, -0.7, 0.2, 0.5])
"""Positions, velocities and accelerations of the first joints from the base on."""


JOINTS: Final = {
    "a model in a model, placed by a frame, moved by its frame": ("j1", "j2", "turn", "hand::k"),
    "models in models": ("j1", "j2", "extension::slide", "extension::hand::k"),
}
"""The joints of an arm from the base to the tip, where they are not j1 and j2."""


def joints_of(name: str) -> tuple[str, ...]:
    """The joints of the arm of that name, from the base to the tip."""
    return JOINTS.get(name, ("j1", "j2"))


def by_drake(
    text: str, name: str, tip: str, joints: tuple[str, ...], gravity: tuple[float, ...] = (0, 0, -9.81)
) -> dict[str, Any]:
    """Torques [n], mass matrix [n, n] and the pose of the tip [3, 4] that Drake computes at :data:`STATE`; it
    reads no ``gravity`` [m/s^2] of files."""
    drake: Any = importlib.import_module("pydrake.all")
    plant = drake.MultibodyPlant(0.0)
    drake.Parser(plant).AddModelsFromString(text, "sdf")
    plant.mutable_gravity_field().set_gravity_vector(gravity)
    plant.Finalize()
    context, outer = plant.CreateDefaultContext(), name or "arm"
    all_joints = [plant.get_joint(index) for index in plant.GetJointIndices()]
    moving = {
        joint.name(): joint
        for joint in all_joints
        if f"{plant.GetModelInstanceName(joint.model_instance())}::".startswith(f"{outer}::")
    }
    chain = [moving[joint.rpartition("::")[2]] for joint in joints]
    columns = [joint.velocity_start() for joint in chain]
    q, (v, vdot) = plant.GetPositions(context), np.zeros((2, plant.num_velocities()))
    n = len(chain)
    q[[joint.position_start() for joint in chain]] = STATE[0][:n]
    v[columns], vdot[columns] = STATE[1][:n], STATE[2][:n]
    plant.SetPositions(context, q)
    plant.SetVelocities(context, v)
    forces = drake.MultibodyForces(plant)
    plant.CalcForceElementsContribution(context, forces)
    instance, _, body = f"{outer}::{tip}".rpartition("::")
    pose = plant.GetBodyByName(body, plant.GetModelInstanceByName(instance)).EvalPoseInWorld(context)
    return {
        "torques": plant.CalcInverseDynamics(context, vdot, forces)[columns].tolist(),
        "mass_matrix": plant.CalcMassMatrix(context)[np.ix_(columns, columns)].tolist(),
        "tip": pose.GetAsMatrix34().tolist(),
    }


if __name__ == "__main__":
    figures = {name: by_drake(*arm, joints_of(name)) for name, arm in ARMS.items()}
    FIGURES.write_text(json.dumps(figures, indent=1) + "\n")
