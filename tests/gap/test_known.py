"""What is known of real logs is judged by what was said: right, wrong and not at all."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from robodyn.robot import load, to_yaml
from robodyn_testing import require_module

require_module("pinocchio")

from benchmarks.gap.known import (  # noqa: E402
    RUNS,
    Answer,
    certain,
    claimed,
    flagged,
    half_jumps,
    jumps,
    kinds,
    mass,
    silent,
    stiffness,
)
from benchmarks.gap.tables import known_table  # noqa: E402


def claim(
    effect: str, joint: int | None, confidence: float = 0.9, **values: tuple[float, float]
) -> dict[str, Any]:
    parameters = {name: {"value": value, "stderr": error} for name, (value, error) in values.items()}
    return {"effect": effect, "joint": joint, "confidence": confidence, "parameters": parameters}


def answer(*findings: dict[str, Any], flags: tuple[str, ...] = (), folder: Path = Path()) -> Answer:
    return Answer({"findings": list(findings), "flags": list(flags)}, folder)


def test_names() -> None:
    one = answer(claim("spring", 2), claim("payload", None, confidence=0.3))
    assert claimed(2, "gas_spring", "spring")(one) == ("spring@2", True)
    assert claimed(3, "spring")(one) == ("not claimed", False)
    assert silent("payload")(one) == ("not claimed", True)
    assert silent("spring")(one) == ("spring@2", False)
    assert kinds(one) == ("spring", True)
    assert not kinds(answer(*(claim(f"e{k}", 1) for k in range(9))))[1]
    assert flagged("late", "lag")(answer(flags=("q1: fine", "qd1: late by 20 ms"))) == (
        "qd1: late by 20 ms",
        True,
    )
    assert flagged("late")(one) == ("no flag", False)


def test_numbers() -> None:
    assert certain(answer(claim("spring", 2, stiffness=(4.0, 1.0)))) == ("none", True)
    assert certain(answer(claim("spring", 2, stiffness=(4.0, 3.0)))) == ("spring@2 stiffness", False)
    assert mass(150.0)(answer(claim("payload", None, mass=(140.0, 1.0)))) == ("140 kg", True)
    assert mass(150.0)(answer(claim("payload", None, mass=(120.0, 1.0)))) == ("120 kg", False)
    assert mass(150.0)(answer()) == ("no payload", False)


def test_stiffness() -> None:
    soft = answer(claim("joint_elasticity", 1, stiffness=(4e6, 1.0)))
    wrong = answer(claim("joint_elasticity", 1, stiffness=(1e6, 1.0)))
    wanted = {1: 3.9e6, 2: 5.3e6}
    assert not stiffness(wanted, needed=True)(soft)[1]
    assert stiffness(wanted, needed=False)(soft)[1]
    assert stiffness(wanted, needed=False)(answer())[1]
    assert not stiffness(wanted, needed=False)(wrong)[1]
    assert stiffness({1: 3.9e6}, needed=True)(soft)[1]


def test_jumps_are_those_of_the_model_whatever_its_laws(tmp_path: Path) -> None:
    robot = load("puma560_3dof", warn=lambda _: None)
    text = to_yaml(robot)
    text += "" if text.endswith("\n") else "\n"
    head, *links = text.split("  - ")
    laws = (
        "    friction: {viscous: 5.0, coulomb: 3.0}\n",
        "    effects: [{effect: asymmetric_friction, positive: 2.0, negative: 4.0}]\n",
        "    effects: [{effect: presliding_hysteresis, level: 5.0, stiffness: 800.0}]\n",
    )
    (tmp_path / "model.yaml").write_text(
        head + "".join(f"  - {link}{law}" for link, law in zip(links, laws, strict=True)), encoding="utf-8"
    )
    assert half_jumps(tmp_path / "model.yaml") == pytest.approx([3.0, 3.0, 5.0], rel=1e-3)
    seen = answer(folder=tmp_path)
    assert jumps({1: 3.5, 3: 4.5}, 0.3)(seen) == ("1: 3, 3: 5", True)
    assert not jumps({1: 5.0}, 0.3)(seen)[1]
    assert jumps({1: 10.0}, None)(seen)[1]
    assert not jumps({1: 20.0}, None)(seen)[1]
    assert np.isfinite(half_jumps(tmp_path / "model.yaml")).all()


def test_runs_have_their_files() -> None:
    for run in RUNS.values():
        assert run.robot.is_file()
        assert run.logs
        for log in run.logs:
            assert all((run.robot.parent / name).is_file() for name in log.split("+"))


def test_a_row_for_each_fact() -> None:
    text = known_table({"a": {"facts": [["x is 2", "2", True], ["y is 3", "4", False]]}})
    assert text.splitlines()[2:] == ["| a | x is 2 | 2 | yes |", "| a | y is 3 | 4 | **no** |"]
