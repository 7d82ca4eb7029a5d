"""Words on diagnoses and fleets, on a terminal and at the top of their pages: ``lines.txt`` has it all.

``pytest --update -n0 tests/report/test_lines.py`` writes that file anew.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import numpy as np
import pytest

from report.made_up import fleet, made, many, of_one
from report.test_diagnosis_joints import gap, motion
from robodyn.diagnose.result import Diagnosis, Estimate, Finding, Gap
from robodyn.fleet.result import FleetResult, Unused
from robodyn.report import diagnosis_summary, fleet_text
from robodyn.report.diagnosis_headline import LINE, headline, in_a_line, missing_words
from robodyn.report.diagnosis_residual import localised, travelled
from robodyn.robot import load, read_text

FILE: Final = Path(__file__).with_name("lines.txt")


def found(effect: str, *joints: int | None, **values: float) -> list[Finding]:
    numbers = {name: Estimate(value, 0.0, "") for name, value in values.items()}
    return [Finding(effect, j, numbers, 0.95, (), "", None, 1.0, 1.0) for j in joints]


#: What an arm may lack, by kind.
LACKING: Final[Mapping[str, list[Finding]]] = {
    "a stock arm from its drawing": [
        *found("motor_coupling", 6, **{"with": 5.0}), *found("viscous_friction", 1, 2, 4, 5),
        *found("rotor_inertia", 1, 2, 3, 4), *found("power_law_friction", 3, 6),
        *found("coulomb_friction", 1),
    ],
    "all joints": found("viscous_friction", 1, 2, 3, 4, 5, 6),
    "all but one": found("viscous_friction", 1, 2, 4, 5, 6),
    "two of them": found("coulomb_friction", 2, 5),
    "a noun": found("gas_spring", 2),
    "nouns": found("gas_spring", 2, 3),
    "the whole arm": found("payload", None),
    "the whole arm, and a joint": found("base_tilt", None) + found("torque_bias", 4),
    "a link": found("inertial_error", 3),
    "links": found("inertial_error", 2, 4),
    "no wrist": found("motor_coupling", 3, **{"with": 2.0}),
    "one loss": found("transmission_loss", 2),
    "two kinds at all": found("viscous_friction", *range(1, 7)) + found("rotor_inertia", *range(1, 7)),
    "not in the catalogue": found("effect_of_tomorrow", 2),
    "more than a handful": [
        finding
        for k, id in enumerate(
            ("backlash", "spring", "torque_bias", "encoder_offset", "torque_ripple", "joint_elasticity"), 1
        )
        for finding in found(id, k)
    ],
}  # fmt: skip


def diagnoses() -> Iterator[tuple[str, Diagnosis]]:
    arm, puma = (load(name, warn=lambda _: None) for name in ("puma560_3dof", "puma560"))
    one, n = np.ones(3), 12
    quiet = made(arm, verdict="consistent", findings=(), gap=Gap(one, one, 1.2 * one, 1.2 * one, one))
    rough = np.array([1.0, 3.1, 1.7])
    loud = replace(quiet, gap=Gap(rough, rough, rough, rough, one))
    contact = found("external_contact", None, start=5.8, end=6.3, link=2.0)
    snake = read_text("name: snake\nlinks:\n" + "  - {joint: revolute, a: 1, mass: 1}\n" * n)
    ones, before = np.ones(n), np.array([1, 9, 1, 8, 7, 6, 5, 1, 4, 3, 1, 2.0])
    numbers = {f"delta_{k}": Estimate(1.0, 0.1, "kg") for k in range(10)}
    suspicions = tuple(
        Finding("inertial_error", k + 1, numbers, 0.4, (), "where", f"experiment {k}", 1.0, 1.0)
        for k in range(9)
    )
    swinging = motion(lambda q, qd, qdd, load, t: np.sin(3 * q))
    yield "one finding", made(arm)
    yield "its torque not known", made(arm, gap=replace(made(arm).gap, torque=None))
    yield "hardly anything left", made(arm, gap=replace(made(arm).gap, validate_after=1e-3 * one))
    yield "two findings", made(arm, findings=tuple(found("viscous_friction", 1) + found("gas_spring", 2)))
    yield "a long name", made(replace(arm, name="a" * 63))
    yield "a contact", made(arm, findings=tuple(contact))
    yield "a finding and a contact", made(arm, findings=(*made(arm).findings, *contact))
    yield "many findings", made(puma, findings=many(6))
    yield "a long arm", made(snake, gap=Gap(before, ones, before, ones, ones), findings=suspicions)
    yield "consistent", quiet
    yield "consistent, and what would be seen", replace(quiet, detectable=np.array([0.1, 0.3, 0.2]))
    yield "consistent, more is left", loud
    yield "refitted, more is left", replace(loud, extra={"refitted": 0.1})
    yield "refitted", replace(quiet, extra={"refitted": 0.3})
    yield "unexplained", made(arm, verdict="unexplained", findings=())
    yield (
        "unexplained, over the position",
        made(
            arm, verdict="unexplained", findings=(), gap=gap(swinging), series=(swinging,),
            left=np.array([0.1, 7, 0.2]),
        ),
    )  # fmt: skip


def diagnosis_lines(diagnosis: Diagnosis, *, validated: bool) -> Iterator[str]:
    yield headline(diagnosis, validated=validated)
    yield from in_a_line(diagnosis, validated=validated)
    lines = diagnosis_summary.summary(diagnosis, "r.html", validated=validated)
    assert len(lines) <= diagnosis_summary.LINES
    yield from lines
    places = localised(diagnosis)
    for question, answer, remark in diagnosis_summary.tiles(diagnosis, validated, places):
        yield f"{question}: {answer}: {remark}"
    for step in diagnosis_summary.advice(diagnosis, places, travelled(diagnosis.robot, diagnosis.series[0])):
        yield f"{step['title']}: {step['text']}"


def fleets() -> Iterator[tuple[str, FleetResult]]:
    small, alone = fleet(30, 9), of_one()
    unused = [Unused(f"{k}.csv", "a", "b", f"reason {min(k, 5) % 5}") for k in range(10)]
    yield "thirty units", small
    yield "half of the names are false", replace(small, false_names=0.5)
    yield "nothing named", fleet(3, 0)
    yield "one unit", alone
    yield "logs that were not used", replace(alone, unused=tuple(unused))
    yield "nothing to use", replace(alone, units=(), types=())


def figures_of_fleets() -> Iterator[str]:
    claims = {claim.feature: claim for unit in fleet(30, 6).units for claim in unit.claims}
    one = claims["joint1.friction"]
    yield fleet_text.size_text(one)
    yield fleet_text.brief(one)
    yield fleet_text.brief(replace(one, joint=None, share=None, since=None, size=-2.0))
    yield fleet_text.with_error(2e-4, 1e-5, "rad")
    yield fleet_text.with_error(0.3, float("nan"), "kg")
    yield from map(fleet_text.unusual_text, (None, float("nan"), 0.04, -2.04, 3.26, 9.96, -31.2))


def sections() -> Iterator[tuple[str, list[str]]]:
    for name, findings in LACKING.items():
        yield f"lacking: {name}", missing_words(findings, 6)
    for name, diagnosis in diagnoses():
        for validated in (True, False):
            title = f"diagnosis: {name}{'' if validated else ', not validated'}"
            yield title, list(diagnosis_lines(diagnosis, validated=validated))
    puma = made(load("puma560", warn=lambda _: None), findings=many(6))
    rooms = (90, LINE, 55, 40, 35, 30, 10)
    yield "many findings in a line of a length", [in_a_line(puma, room=room)[0] for room in rooms]
    for name, result in fleets():
        yield f"fleet: {name}", fleet_text.summary(result, "index.html")
    yield "figures of fleets", list(figures_of_fleets())


def test_what_is_said(request: pytest.FixtureRequest) -> None:
    parts: dict[str, Any] = {name: "\n".join(lines) for name, lines in sections()}
    if request.config.getoption("--update", default=False):
        text = "\n\n".join(f"# {name}\n{part}" for name, part in parts.items())
        FILE.write_text(text + "\n", encoding="utf-8")
    blocks = FILE.read_text(encoding="utf-8").removesuffix("\n").removeprefix("# ").split("\n\n# ")
    assert parts == dict(block.split("\n", 1) for block in blocks)
