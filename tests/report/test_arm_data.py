"""An arm as data: what its page shows is what other parts of the project compute."""

from __future__ import annotations

import html
import json
import re
from fractions import Fraction
from xml.dom import minidom

import numpy as np
import pytest

from robodyn.counts.peers import operations_of_peers
from robodyn.draw.markup import json_text, script_text
from robodyn.draw.mathml import of_expression, of_latex, of_name
from robodyn.effects.catalogue import CATALOGUE
from robodyn.emit.statements import Apply
from robodyn.errors import InputError
from robodyn.ir.program import Input
from robodyn.report.arm_data import Arm, arm_of
from robodyn.report.arm_page import highlighted, page
from robodyn.report.arm_parts import ellipsoid, links
from robodyn.robot import load, read_text
from robodyn.robot.model import Inertia
from robodyn.verify.reference import Reference

HOSTILE = "</script><script>alert(1)</script><!-- \" onload='alert(2)' & <b>"
RUBBING = f"""
name: rubbing
title: {json.dumps(HOSTILE)}
source: {json.dumps(HOSTILE)}
confidence: unknown
links:
  - {{name: {json.dumps(HOSTILE)}, joint: revolute, d: 0.4, mass: 6, com: [0, 0.05, -0.1],
     inertia: {{xx: 0.02, yy: 0.1, zz: 0.5}}, acknowledged: {json.dumps(HOSTILE)},
     friction: {{viscous: 1.5, coulomb: 3}}, limits: {{position: [1, 2.9], torque: 80}}}}
  - joint: revolute
    alpha: pi/2
    mass: 5
    com: [0.2, 0, 0.02]
    inertia: {{xx: 0.2, yy: 0.2, zz: 0.2}}
    effects: [{{effect: stribeck_friction, level: 3, static: 4.9, velocity: 0.2}}]
  - joint: prismatic
    alpha: pi/2
    a: 0.1
    mass: 2
    effects: [{{effect: presliding_hysteresis, stiffness: 2e4, level: 4, damping: 50}}]
"""


@pytest.fixture(scope="module")
def rubbing() -> Arm:
    return arm_of(read_text(RUBBING, warn=lambda _: None))


@pytest.fixture(scope="module")
def stanford() -> Arm:
    return arm_of(load("stanford_3dof", warn=lambda _: None))


def test_its_torques_are_those_of_the_reference(stanford: Arm) -> None:
    """At home, and along the motion to the six digits that are drawn."""
    reference = Reference(stanford.robot)
    data, path = stanford.data, stanford.data["motion"]
    still = np.zeros(3)
    home = reference.inverse_dynamics(np.array(data["home"]["position"]), still, still)
    np.testing.assert_allclose(data["home"]["torque"], home, rtol=1e-12, atol=1e-12)
    w = 2 * np.pi / path["period"]
    for k in (0, 57, 200):
        t = path["times"][k]
        q, qd, qdd = np.array(path["mean"]), np.zeros(3), np.zeros(3)
        for j in range(3):
            for h, (s, c) in enumerate(zip(path["sines"][j], path["cosines"][j], strict=True), 1):
                q[j] += s * np.sin(h * w * t) + c * np.cos(h * w * t)
                qd[j] += h * w * (s * np.cos(h * w * t) - c * np.sin(h * w * t))
                qdd[j] -= (h * w) ** 2 * (s * np.sin(h * w * t) + c * np.cos(h * w * t))
        expected = reference.inverse_dynamics(q, qd, qdd)
        np.testing.assert_allclose([x[k] for x in path["torque"]], expected, rtol=1e-5, atol=1e-5)


def test_counts_stand_beside_the_thesis_and_other_tools(stanford: Arm) -> None:
    rows = {row["function"]: row for row in stanford.data["counts"]["functions"]}
    assert rows["inverse_dynamics"]["total"] == stanford.generated.counts["inverse_dynamics"].total
    assert rows["inverse_dynamics"]["thesis"]["total"] == 81
    assert rows["mass_matrix"]["peers"] == operations_of_peers(stanford.robot)["mass_matrix"]
    totals = [bar["total"] for bar in stanford.data["counts"]["bars"]]
    assert totals == sorted(totals)
    assert len(totals) == 6


def test_nothing_is_said_of_an_arm_that_others_were_not_given() -> None:
    """One number of the bundled arm is another one, under the same name."""
    robot = load("stanford_3dof", warn=lambda _: None)
    assert operations_of_peers(robot)
    assert not operations_of_peers(read_text("name: stanford_3dof\nlinks: [{joint: revolute, mass: 1}]"))


def test_doubts_ranges_and_effects(rubbing: Arm) -> None:
    data = rubbing.data
    first, second, third = data["links"]
    assert [doubt["what"][:30] for doubt in first["doubts"]] == [
        "the inertia is not physical: I", "mass, centre of mass and inert",
    ]  # fmt: skip
    assert len(second["doubts"]) == len(third["doubts"]) == 1
    assert first["confidence"] == {"share": 1.0, "stated": True, "unknown": True}
    assert [joint["range"] for joint in data["joints"]] == [
        [1.0, 2.9],
        pytest.approx([-np.pi, np.pi]),
        [-0.5, 0.5],
    ]
    assert data["home"]["position"] == [1.0, 0.0, 0.0]
    curves = {effect["title"]: effect["curves"] for effect in data["effects"]}
    assert curves["Viscous friction"] == []  # a straight line: the number says it
    (step,) = curves["Coulomb friction"]
    assert step["torque"][0][0] == -3.0
    assert step["torque"][0][40] == 0.0
    stribeck = next(
        curve for title, (curve, *_) in ((t, c) for t, c in curves.items() if c) if "Stribeck" in title
    )
    assert max(stribeck["torque"][0]) == pytest.approx(4.9, rel=0.1)
    assert data["kernel"]["functions"]["inverse_dynamics"]["remembers"]


@pytest.mark.parametrize(
    "wrong",
    ["limits: {position: [-180, 180]}", "inertia: {xx: -1, yy: 1, zz: 1}", "inertia: {xx: 1, yy: 1, zz: 3}"],
)
def test_what_strict_refuses_is_a_doubt_of_the_page(wrong: str) -> None:
    text = f"name: arm\nlinks: [{{joint: revolute, mass: 1}}, {{joint: revolute, mass: 1, {wrong}}}]"
    warnings: list[str] = []
    first, second = links(read_text(text, warn=warnings.append))
    (doubt,) = second["doubts"]
    assert not first["doubts"]
    (warning,) = warnings
    assert doubt["what"].rpartition(": ")[2].partition(" rad")[0] in warning
    with pytest.raises(InputError):
        read_text(text, strict=True)


def test_the_ellipsoid_of_a_body_is_the_body() -> None:
    """Of a homogeneous ellipsoid, I = m/5 (b^2 + c^2) about each axis."""
    a, b, c, mass = 0.3, 0.2, 0.1, 5
    squares = [Fraction(str(x)) ** 2 for x in (a, b, c)]
    moments = [Fraction(mass, 5) * (sum(squares) - x) for x in squares]
    made = ellipsoid(mass, Inertia(*moments))
    assert made is not None
    assert sorted(made["semi_axes"]) == pytest.approx([c, b, a])
    assert ellipsoid(0, Inertia(*moments)) is None


def test_run_time_parameters_need_values() -> None:
    robot = read_text("name: arm\nlinks: [{joint: revolute, mass: m_tool, com: [1, 0, 0]}]")
    with pytest.raises(InputError, match="--param m_tool=VALUE"):
        arm_of(robot)
    assert arm_of(robot.at({"m_tool": 2.0})).data["links"][0]["mass"] == 2.0


# --- the page ---------------------------------------------------------------------------------------------


def test_texts_of_a_description_stay_texts(rubbing: Arm) -> None:
    """No script, no attribute and no element comes of them, wherever they stand."""
    text = page([rubbing])
    document = re.sub(r"<script type=\"[a-z/]+\"[^>]*>.*?</script>", "", text, flags=re.DOTALL)
    assert text.count("<script") == text.count("</script>") == 3
    assert "alert(1)" in document
    assert "<script" not in document
    assert "<!--" not in text
    assert not re.search(r"<[^>]*(?<!&#34;) onload=", document)
    assert "default-src 'none'; script-src 'sha256-" in html.unescape(text)
    assert "unsafe-inline" not in text.partition("script-src")[2].partition(";")[0]


def test_json_and_scripts_do_not_end_their_element() -> None:
    assert json.loads(json_text([HOSTILE])) == [HOSTILE]
    assert not re.search("[<>&\u2028]", json_text([HOSTILE]))
    assert "</script" not in script_text(f"// {HOSTILE}")
    assert "<!--" not in script_text(f"// {HOSTILE}")


def test_highlighted_c_is_the_c() -> None:
    code = '/* <b> & */\n#include "a.h"\nstatic const double x = 1e-5*t2; /* end */\n'
    marked = highlighted(code)
    assert marked.striptags() == re.sub(r"\s+", " ", code).strip()
    assert '<i class="n">1e-5</i>*t2' in marked
    assert '<i class="c">/* &lt;b&gt; &amp; */</i>' in marked


# --- equations --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("effect", CATALOGUE.values(), ids=lambda effect: effect.id)
def test_the_equation_of_every_effect_is_typeset(effect: object) -> None:
    text = of_latex(effect.latex)  # type: ignore[attr-defined]
    minidom.parseString(text)
    assert "\\" not in text


def test_latex_that_is_not_known_is_an_error() -> None:
    with pytest.raises(ValueError, match="oint"):
        of_latex(r"\oint x")
    with pytest.raises(ValueError, match="no }"):
        of_latex(r"\frac{1")


def test_names_and_expressions() -> None:
    assert of_name("w2_x") == "<msub><mi>ω</mi><mrow><mn>2</mn><mi>x</mi></mrow></msub>"
    assert of_name("neg_lam3_12").startswith("<mrow><mo>−</mo><msub><mi>Λ</mi>")
    assert "<mo>′</mo>" in of_name("t1_x_2")
    q = Input("q", 0)
    difference = Apply("sub", (q, Apply("add", ("s2", Fraction(-1, 2)))))
    text = of_expression(Apply("mul", (difference, Fraction(5, 2))))
    assert re.sub("<[^>]*>", "", text) == "(q1−(s2+(−0.5)))·2.5"
    signed = Apply("sub", (Apply("mul", (Fraction(-2), "s2")), Apply("mul", ("neg_c2", q))))
    assert re.sub("<[^>]*>|&#x2062;", "", of_expression(signed)) == "−2s2−(−c2q1)"
