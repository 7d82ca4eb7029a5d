"""For each element and attribute of MJCF that changes torques a file: as MuJoCo has it, or refused."""

from __future__ import annotations

from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from robodyn import load
from robodyn.formats.elements_of import Entry, table_of
from robodyn.verify.reference import Reference
from robodyn_testing import representative, require_module
from robodyn_testing.mujoco_chains import torques_of_file
from robodyn_testing.refused import check_is_refused

Attributes = dict[str, str]
ARM = """<mujoco model="arm">{compiler}{option}{default}<worldbody>
<body name="b1" pos="0.1 0 0.3" quat="0.9 0.1 0.2 -0.3"><joint name="j1" axis="0.3 0.5 0.8"/>
<geom type="sphere" size="0.1" mass="0.3"/>
<inertial pos="0.1 0.02 -0.03" mass="2.5" diaginertia="0.03 0.05 0.04"/>
<body name="b2" pos="0.1 0.2 0.3" euler="40 20 30">{joint}
<geom type="sphere" size="0.1" mass="0.3" group="0"/>{geom}
{open}<body name="b3" {body}><joint name="j3" axis="0 -1 0" stiffness="3" damping="0.3" frictionloss="0.7"/>
<geom type="sphere" size="0.1" mass="0.2"/>{inertial}{inside}</body>{close}
</body></body></worldbody>{tail}</mujoco>"""
TURN = {
    "pos": {"pos": "0.3 -0.1 0.2"}, "quat": {"quat": "0.9 0.1 0.2 -0.3"},
    "axisangle": {"axisangle": "0.2 0.3 0.5 70"}, "xyaxes": {"xyaxes": "1 0.2 0 0 1 0.3"},
    "zaxis": {"zaxis": "0.1 0.2 0.9"}, "euler": {"euler": "40 10 30"},
}  # fmt: skip
#: Attributes of the elements in the arm that rows are of.
PLAIN: dict[str, Attributes] = {
    "joint": {"axis": "0 0.6 0.8"},
    "geom": {"type": "box", "size": "0.1 0.2 0.3", "pos": "0.1 0.2 0.1", "mass": "2"},
    "inertial": {"pos": "0.02 0.1 0.03", "mass": "0.7", "diaginertia": "0.01 0.02 0.015"},
    "body": {"pos": "0.1 0.2 0.3"},
    "replicate": {"count": "2", "offset": "0.1 0 0"},
}
#: What a row is shown with; "" is left out.
SHOWN: dict[str, dict[str, Attributes]] = {
    "joint": {
        "axis": {"axis": "1 0 0"}, "pos": {"pos": "0.1 0.2 0.3"}, "type": {"type": "slide"},
        "ref": {"ref": "20"}, "armature": {"armature": "0.2"}, "damping": {"damping": "0.4"},
        "frictionloss": {"frictionloss": "0.3"}, "stiffness": {"stiffness": "5"},
        "springref": {"stiffness": "5", "springref": "20"}, "springdamper": {"springdamper": "0.2 0.5"},
    },
    "geom": {
        **TURN, "type": {"type": "ellipsoid"},
        "size": {"size": "0.1 0.1 0.4"}, "mass": {"mass": "5"}, "group": {"group": "3"},
        "fromto": {"type": "capsule", "size": "0.1", "pos": "", "fromto": "0 0 0 0.3 0.2 0.1"},
        "density": {"mass": "", "density": "300"}, "shellinertia": {"shellinertia": "true"},
    },
    "inertial": {
        **TURN, "mass": {"mass": "3"}, "diaginertia": {"diaginertia": "0.03 0.04 0.05"},
        "fullinertia": {"diaginertia": "", "fullinertia": "0.01 0.02 0.015 -0.001 0.001 0.002"},
    },
    "body": TURN, "frame": TURN,
    "replicate": {
        "count": {"count": "3"}, "offset": {"offset": "0 0.2 0.1"}, "euler": {"euler": "0 0 30"},
    },
    "compiler": {
        "angle": {"angle": "radian"}, "eulerseq": {"eulerseq": "zyx"},
        "balanceinertia": {"balanceinertia": "true"}, "boundinertia": {"boundinertia": "0.5"},
        "boundmass": {"boundmass": "4"}, "inertiafromgeom": {"inertiafromgeom": "true"},
        "inertiagrouprange": {"inertiagrouprange": "0 3"}, "settotalmass": {"settotalmass": "10"},
    },
    "flag": {
        name: {name: "disable"}
        for name in ("gravity", "spring", "damper", "frictionloss", "constraint", "equality")
    },
    "option": {"gravity": {"gravity": "1 2 -3"}},
}  # fmt: skip
MOTOR: dict[str, Attributes] = {
    "gear": {"gear": "-3", "armature": "0.1", "damping": "0.2"},
    "armature": {"armature": "0.1"},
    "damping": {"damping": "0.2"},
}
#: What an actuator needs besides.
NEEDS: dict[str, Attributes] = {
    "intvelocity": {"actrange": "-1 1"},
    "damper": {"ctrlrange": "0 1", "kv": "1"},
    "plugin": {"plugin": "mujoco.pid"},
    "muscle": {"lengthrange": "0 1"},
}
#: What is refused of what is modelled otherwise.
BEYOND = {
    "gravcomp": "0.5", "density": "1.2", "viscosity": "2e-5", "stiffness": "3 4", "damping": "3 4",
    "springyield": "0.1", "frictionloss": "0.1", "armature": "0.1", "springdamper": "0.2 0.5",
}  # fmt: skip
ROWS = [
    (path, name, entry)
    for path, row in table_of("MJCF").rows.items()
    for name, entry in row.items()
    if entry.kind in ("torques", "refused")
]
MOTORS = {name.strip("<>") for name in table_of("MJCF").rows["actuator",]}


def shown(path: tuple[str, ...]) -> dict[str, Attributes]:
    return MOTOR if path[-1] in MOTORS else SHOWN.get(path[-1], {})


MODELLED = [
    (path, name)
    for path, name, entry in ROWS
    if entry.kind == "torques"
    and (not entry.physics or name in shown(path))
    and entry.source != "before MuJoCo 4"
]
#: Of each attribute one, of each place that attributes may be in one, all kinds of motors being alike.
FEW = {("motor" if path[-1] in MOTORS else path[-1], name): (path, name) for path, name in reversed(MODELLED)}
PLACES_OF_ROWS = {path[0]: (path, name) for path, name in MODELLED}
REFUSED = [(path, name, entry) for path, name, entry in ROWS if entry.physics]


def path_shown(part: object) -> str:
    return "/".join(part) if isinstance(part, tuple) else str(part) if isinstance(part, str) else "row"


def element(tag: str, attributes: Attributes) -> str:
    words = " ".join(f'{name}="{text}"' for name, text in attributes.items() if text)
    return f"<{tag} {words}/>"


def arm(path: tuple[str, ...], attributes: Attributes) -> str:
    """The arm with ``attributes`` in the element that has this path in the table."""
    place, tag = path[0], path[-1]
    slots = {name: element(name, PLAIN[name]) for name in ("joint", "inertial")}
    slots |= dict.fromkeys(("compiler", "option", "default", "geom", "open", "close", "inside", "tail"), "")
    slots["body"] = element("", PLAIN["body"])[2:-2]
    plain = {**PLAIN.get(tag, {}), **attributes}
    if tag == "tendon" or place == "default":
        classes = f'<default class="c">{element(tag, plain)}</default>'
        slots["default"] = f"<default>{classes}</default>"
    if tag == "tendon":
        fixed = f'<fixed name="t" {element("", attributes)[2:-2] if place != "default" else ""}>'
        slots["tail"] = f'<tendon>{fixed}<joint joint="j1" coef="1"/></fixed></tendon>'
        slots["default"] = slots["default"] if place == "default" else ""
    elif tag in MOTORS:
        stated = {"class": "c"} if place == "default" else attributes
        plugin = '<extension><plugin plugin="mujoco.pid"/></extension>' if tag == "plugin" else ""
        motor = element(tag, {"joint": "j1", **NEEDS.get(tag, {}), **stated})
        slots["tail"] = f"{plugin}<actuator>{motor}</actuator>"
    elif tag in ("joint", "geom"):
        slots["compiler"] = '<compiler inertiagrouprange="0 1"/>' if "group" in attributes else ""
        inner = element(tag, {"class": "c"} if place == "default" else plain)
        around = {"frame": "<frame>{}</frame>", "replicate": '<replicate count="1">{}</replicate>'}
        slots[tag] = around.get(place, "{}").format(inner)
    elif tag == "compiler":
        slots["compiler"] = element(tag, attributes)
        slots["geom"] = element("geom", {**PLAIN["geom"], "group": "4"})
        if "balanceinertia" in attributes:
            slots["inertial"] = element("inertial", {**PLAIN["inertial"], "diaginertia": "0.01 0.02 0.06"})
    elif tag == "flag":
        slots["option"] = f"<option>{element(tag, attributes)}</option>"
        if "equality" in attributes:
            slots["tail"] = '<equality><joint joint1="j3" polycoef="0.25 0 0 0 0"/></equality>'
    elif tag == "frame":
        slots["open"], slots["close"] = element(tag, attributes).replace("/>", ">"), "</frame>"
    elif tag == "replicate":
        slots["geom"] = (
            element(tag, plain).replace("/>", ">") + element("geom", PLAIN["geom"]) + "</replicate>"
        )
    elif tag == "body":
        slots["body"] = element("", plain)[2:-2]
    else:
        slots[tag] = element(tag, plain)
    return ARM.format(**slots)


@pytest.mark.parametrize(
    ("path", "name"), representative(MODELLED, *FEW.values(), *PLACES_OF_ROWS.values()), ids=path_shown
)
def test_what_changes_torques_is_mujocos(path: tuple[str, ...], name: str, tmp_path: Path) -> None:
    require_module("mujoco")
    file, plain = tmp_path / "arm.xml", tmp_path / "plain.xml"
    file.write_text(arm(path, shown(path)[name]))
    plain.write_text(arm(path, {name: "enable"} if path == ("flag",) else {}))
    states = np.random.default_rng(3).uniform(-1.5, 1.5, (5, 3, 3))
    expected = torques_of_file(file, states)
    torques = Reference(load(file, warn=lambda _: None)).inverse_dynamics(*states.swapaxes(0, 1))
    scale = np.abs(expected).max()
    assert np.abs(torques - expected).max() <= 1e-9 * scale
    robot = load(plain, warn=lambda _: None)
    if robot.n == 3:  # of two joints where the third one is held
        others = Reference(robot).inverse_dynamics(*states.swapaxes(0, 1))
        assert np.abs(others - expected).max() > 1e-6 * scale


def beyond(path: tuple[str, ...], name: str) -> str:
    """The arm with what is refused of a row."""
    if not name.startswith("<"):
        text = arm(path, {**shown(path).get(name, {}), name: BEYOND[name]})
        mesh = '<body><geom type="mesh" mesh="m"/></body>' if name == "springdamper" else ""
        return text.replace("</body>", f"{mesh}</body>", 1)
    part = {"<tendon>": '<tendon tendon1="t"/>', "<dcmotor>": '<dcmotor joint="j1"/>'}.get(
        name, f"{name[:-1]}/>"
    )
    words = f"<{path[-1]}>{part}</{path[-1]}>"
    text = arm(("option",), {})
    if path == ("worldbody",):
        return text.replace("<worldbody>", f"<worldbody>{part}")
    if path == ("default",):
        return text.replace("<worldbody>", f"{words}<worldbody>")
    if path in (("body",), ("frame",), ("replicate",)):
        inside = part if path == ("body",) else words.replace("<replicate", '<replicate count="1"')
        return text.replace("</body>", f"{inside}</body>", 1)
    return text.replace("</mujoco>", f"{words}</mujoco>")


@pytest.mark.parametrize(("path", "name", "entry"), REFUSED, ids=path_shown)
def test_what_is_not_modelled_is_refused_by_its_name(
    path: tuple[str, ...], name: str, entry: Entry, tmp_path: Path
) -> None:
    require_module("mujoco")
    file = tmp_path / "arm.xml"
    file.write_text(beyond(path, name))
    check_is_refused(file, entry.physics)


#: Words of which attributes take some.
WORDS = (
    "enable", "disable", "true", "false", "3", "0.1 0.2", "0.1 0.2 0.3", "1 0.2 0.3 0.4", "-1 1", "RK4",
    "dense", "elliptic", "Newton", "ellipsoid", "0.9 0.95 0.001 0.5 2", "never", "1 2 3 4 5",
)  # fmt: skip
PLACES = (
    ("flag",), ("option",), ("compiler",), ("body", "joint"), ("body", "geom"), ("body",),
    ("actuator", "motor"), ("actuator", "position"), ("actuator", "pid"),
)  # fmt: skip


@pytest.mark.thorough
@pytest.mark.parametrize(
    "path",
    [pytest.param(path, marks=[pytest.mark.slow] * bool(k % 4)) for k, path in enumerate(PLACES)],
    ids=path_shown,
)
def test_what_is_said_to_be_of_no_effect_has_none_in_mujoco(
    path: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    require_module("mujoco")
    monkeypatch.chdir(tmp_path)  # MuJoCo leaves a log
    file = tmp_path / "arm.xml"
    states = np.random.default_rng(4).uniform(-1.5, 1.5, (3, 3, 3))

    def torques(attributes: Attributes) -> Any:
        file.write_text(arm(path, {**(MOTOR["gear"] if path[0] == "actuator" else {}), **attributes}))
        return torques_of_file(file, states)

    plain, row = torques({}), table_of("MJCF").rows[path]
    without_effect = [name for name, entry in row.items() if entry.kind in ("none", "silent")]
    taken = set()
    for name, word in product(without_effect, WORDS):
        try:
            with_it = torques({name: word})
        except ValueError:  # MuJoCo takes no such word there
            continue
        assert np.abs(with_it - plain).max() <= 1e-12 * np.abs(plain).max(), (name, word)
        taken.add(name)
    assert 3 * len(taken) >= len(without_effect), taken
