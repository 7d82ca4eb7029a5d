"""The same log in another format, or in other units with a map, gives the same diagnosis."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from logs.files_of_logs import NAMES, bag
from robodyn.logs.log import Log
from robodyn_cli.main import main

MAP = f"joints: [{', '.join(NAMES)}]\nq: position.%s\ntau: effort.%s\n"
FOREIGN = (
    f"joints: [{', '.join(NAMES)}]\nq: {{columns: position.%s, unit: deg, gear: 80}}\n"
    "tau: {columns: effort.%s, unit: A, torque_constant: 1/8, gear: 80}\n"
)


def simulated(capsys: pytest.CaptureFixture[str]) -> Log:
    """A log of an arm with friction that its description lacks."""
    from robodyn.logs.log import read_log

    code = main(["hide", "puma560_3dof", "--effect", "coulomb_friction", "--seed", "5", "-o", "blind"])
    assert code == 0, capsys.readouterr().err
    log = read_log("blind/train.csv")
    return Log(np.round(log.t * 1e9) / 1e9, log.q, None, None, log.tau)


def diagnosed(capsys: pytest.CaptureFixture[str], *arguments: str) -> dict[str, Any]:
    capsys.readouterr()
    main(["diagnose", "blind/given.yaml", *arguments, "--no-kernels", "--json"])
    result: dict[str, Any] = json.loads(capsys.readouterr().out)
    return result


@pytest.mark.thorough
def test_formats_and_units_do_not_change_a_diagnosis(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    log = simulated(capsys)
    Path("log.csv").write_text(log.csv(), encoding="utf-8")
    Path("map.yaml").write_text(MAP)
    Path("foreign.yaml").write_text(FOREIGN)
    recording = bag(log, tmp_path / "bag", ".mcap")
    foreign = Log(log.t, np.degrees(log.q) * 80, None, None, log.tau / 10)
    other = bag(foreign, tmp_path / "other", ".db3")
    first = diagnosed(capsys, "log.csv", "-o", "a")
    same = diagnosed(capsys, str(recording), "--map", "map.yaml", "-o", "b")
    near = diagnosed(capsys, str(other), "--map", "foreign.yaml", "-o", "c")
    assert first["findings"]
    assert same["findings"] == first["findings"]
    assert same["gap"] == first["gap"]
    assert [(f["effect"], f["joint"]) for f in near["findings"]] == [
        (f["effect"], f["joint"]) for f in first["findings"]
    ]
    for one, two in zip(near["findings"], first["findings"], strict=True):
        for name, estimate in one["parameters"].items():
            if isinstance(estimate["value"], float):
                assert math.isclose(estimate["value"], two["parameters"][name]["value"], rel_tol=1e-6), name
