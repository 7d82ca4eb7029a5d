"""The recipe "Add an effect" of CONTRIBUTING.md: one file, and every room knows the effect."""

from __future__ import annotations

import json

import pytest

from recipes.copies import Copy, source_in_recipe

DRAG = "codegen/robodyn/effects/drag.py"
#: Coulomb friction to the letter, under a name that nobody knows; no key of a description takes it.
SEAL = """
from dataclasses import replace

from robodyn.effects.friction import COULOMB
from robodyn.effects.traits import Traits

EFFECTS = (replace(COULOMB, id="seal_friction", title="Friction of a seal", traits=Traits()),)
"""
ARM = """\
name: swimmer
links:
  - joint: revolute
    mass: 4
    com: [0.2, 0, 0]
    inertia: {xx: 0.02, yy: 0.1, zz: 0.1}
    motor_inertia: 0.3
  - joint: revolute
    a: 0.4
    mass: 2
    com: [0.15, 0, 0]
    inertia: {xx: 0.01, yy: 0.05, zz: 0.05}
    motor_inertia: 0.2
"""
#: A pendulum whose weight the friction holds at first, or does not.
PENDULUM = """\
name: pendulum
gravity: [0, -9.81, 0]
links:
  - {{joint: revolute, mass: 1, com: [0.5, 0, 0], effects: [{{effect: {id}, level: 2.5}}]}}
"""


def with_drag(text: str) -> str:
    return text + "    effects: [{effect: fluid_drag, coefficient: 0.4}]\n"


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Copy:
    files = {
        DRAG: source_in_recipe("Add an effect", DRAG),
        "codegen/robodyn/effects/seal.py": SEAL,
    }
    made = Copy(tmp_path_factory.mktemp("effect"), files)
    (made.work / "arm.yaml").write_text(ARM)
    (made.work / "drag.yaml").write_text(with_drag(ARM))
    for id in ("coulomb_friction", "seal_friction"):
        (made.work / f"{id}.yaml").write_text(PENDULUM.format(id=id))
    return made


def test_documented_and_in_the_schema(copy: Copy) -> None:
    page = copy.robodyn("effects", "fluid_drag")
    assert "## fluid_drag" in page
    assert r"$$\tau = c\,\dot q\,|\dot q|$$" in page
    assert "seal_friction" in copy.robodyn("effects")
    assert '"fluid_drag"' in copy.robodyn("schema")


def test_emitted_and_verified(copy: Copy) -> None:
    copy.robodyn("verify", "drag.yaml")
    copy.python(
        "-c",
        "import numpy as np, robodyn\n"
        "from robodyn.robot import load\n"
        "kernels = [robodyn.compile(load(f)) for f in ('arm.yaml', 'drag.yaml')]\n"
        "q, qd, qdd = np.random.default_rng(1).uniform(-3, 3, (3, 50, 2))\n"
        "without, drag = (k.inverse_dynamics(q, qd, qdd) for k in kernels)\n"
        "added = np.column_stack([0 * qd[:, 0], 0.4 * qd[:, 1] * np.abs(qd[:, 1])])\n"
        "np.testing.assert_allclose(drag - without, added, atol=1e-12)\n",
    )
    # What `verify` compares with is the equation as it is printed: another one is found out.
    definition = copy.folder / DRAG
    source = definition.read_text()
    definition.write_text(source.replace(r"c\,\dot q\,|\dot q|", r"2\,c\,\dot q\,|\dot q|"))
    try:
        assert "does not agree with the references" in copy.robodyn("verify", "drag.yaml", code=1)
        definition.write_text(source.replace(r"\tau = c", r"T = c"))
        assert "there is no reference for fluid_drag" in copy.robodyn("verify", "drag.yaml", code=2)
    finally:
        definition.write_text(source)


@pytest.mark.thorough
def test_a_dry_one_sticks_and_loses_what_its_like_does(copy: Copy) -> None:
    said = copy.python(
        "-c",
        "import json, numpy as np\n"
        "from robodyn.robot import load\n"
        "from robodyn.simulate.simulation import simulate\n"
        "for id in ('coulomb_friction', 'seal_friction'):\n"
        "    robot = load(f'{id}.yaml')\n"
        "    held = simulate(robot, start=np.array([1.3]), duration=0.5)\n"
        "    let_go = simulate(robot, start=np.array([0.1]), duration=3.0)\n"
        "    q = let_go.q[:, 0]\n"
        "    print(json.dumps([held.q[-1, 0], held.qd[-1, 0], q[-1], let_go.qd[-1, 0],\n"
        "                      let_go.balance().loss[-1], let_go.balance().error]))\n",
    )
    known, seal = (json.loads(line) for line in said.splitlines())
    assert seal == known
    held, held_speed, _, speed, loss, error = seal
    assert (held, held_speed, speed) == (1.3, 0.0, 0.0)
    assert loss > 2.5
    assert error < 1e-3


@pytest.mark.thorough
def test_hidden_and_named(copy: Copy) -> None:
    copy.robodyn(
        "hide", "arm.yaml", "--effect", "fluid_drag@2", "--duration", "6", "--rate", "500", "-o", "blind"
    )
    logs = ("blind/train.csv", "--validate", "blind/validate.csv")
    copy.robodyn("diagnose", "blind/given.yaml", *logs, "-o", "found")
    diagnosis = json.loads((copy.work / "found" / "diagnosis.json").read_text())
    (finding,) = diagnosis["findings"]
    assert (finding["effect"], finding["joint"]) == ("fluid_drag", 2)
    # A power law of the exponent 2 is the same torque, with one number more.
    assert finding["confidence"] > 0.5
    answer = json.loads(copy.robodyn("hide", "--open", "blind/answer.sealed"))
    (hidden,) = answer["effects"]
    size = finding["parameters"]["coefficient"]
    assert size["value"] == pytest.approx(hidden["parameters"]["coefficient"], rel=0.1)
    assert size["unit"] == "N*m*s^2/rad^2"
    assert "fluid_drag" in (copy.work / "found" / "model.yaml").read_text()
    assert "Drag of a fluid" in (copy.work / "found" / "report.html").read_text()


def test_two_effects_of_one_name_are_refused(copy: Copy) -> None:
    double = copy.folder / "codegen/robodyn/effects/double.py"
    double.write_text("from robodyn.effects.friction import VISCOUS\n\nEFFECTS = (VISCOUS,)\n")
    try:
        assert "two effects are called 'viscous_friction'" in copy.robodyn("effects", code=70)
    finally:
        double.unlink()
