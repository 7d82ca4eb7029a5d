"""``robodyn diagnose``: what is asked for, what is written and said, exit codes, what is refused."""

from __future__ import annotations

import hashlib
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cli.command import Capture, run, run_json
from robodyn.diagnose.result import Diagnosis, Estimate, Finding, Gap, Series
from robodyn.errors import InputError
from robodyn.logs.log import Log
from robodyn.robot import Robot, bundled_text, read_text

ARM = """\
name: arm
links:
  - {joint: revolute, mass: 1, com: [0.2, 0, 0], inertia: {zz: 0.1}}  # the only one
"""
RUBBING = ARM.replace("zz: 0.1}", "zz: 0.1}, friction: {coulomb: 2}")
LOADED = ARM.replace("name: arm", "name: loaded").replace("mass: 1,", "mass: m_load,")
QUICK = "diagnose arm.yaml a.csv -o out --no-kernels"


def log(samples: int = 50, joints: int = 1) -> Log:
    t = np.linspace(0, 1, samples)
    q = np.repeat(np.sin(t)[:, None], joints, axis=1)
    return Log(t, q, None, None, q)


class Stand:
    """In the place of the diagnosis: keeps what it is given, and gives Coulomb friction, with ``changes``."""

    def __init__(self) -> None:
        self.calls: list[dict[str, Any]] = []
        self.changes: dict[str, Any] = {}
        self.error: Exception | None = None

    def __call__(
        self, robot: Robot, logs: Any, validate: Any = None, *, progress: Any, **more: Any
    ) -> Diagnosis:
        progress("at work")
        if self.error is not None:
            raise self.error
        taken = [hand_over() for hand_over in logs]
        validation = None if validate is None else validate()
        self.calls.append(more | {"logs": taken, "validate": validation})
        level = {"level": Estimate(2.0, 0.01, "N m")}
        finding = Finding("coulomb_friction", 1, level, 0.9, (), "joint 1: a step", None, 10.0, 5.0)
        size, q = np.ones(robot.n), taken[0].q
        found = Diagnosis(
            verdict="missing_effect", findings=(finding,),
            gap=Gap(4 * size, size, 4 * size, size, size, (9 * size, 9 * size)), robot=robot,
            model=read_text(RUBBING), model_text=RUBBING, diff="-a\n+b\n", flags=(), left=size, words=(),
            logs=(), rest=size, series=(Series("train", taken[0].t, q, q, q, q, q, q, q),), operations=(5, 7),
        )  # fmt: skip
        return replace(found, **self.changes)


@pytest.fixture(autouse=True)
def stand(elsewhere: Path, monkeypatch: pytest.MonkeyPatch) -> Stand:
    """Every test works in a folder of its own with robots and logs."""
    for text in (ARM, LOADED):
        (elsewhere / f"{text.split()[1]}.yaml").write_text(text)
    for name, samples in (("a.csv", 50), ("b.csv", 60), ("v.csv", 70)):
        (elsewhere / name).write_text(log(samples).csv())
    stand = Stand()
    monkeypatch.setattr("robodyn.diagnose.run.diagnose", stand)
    return stand


def test_everything_is_handed_over(capsys: Capture, stand: Stand) -> None:
    run(capsys, "diagnose arm.yaml a.csv b.csv --validate v.csv -o out --no-kernels")
    run(capsys, f"{QUICK} --only spring,backlash --except backlash --joints 1,3 --most 2")
    run(capsys, "diagnose loaded.yaml a.csv -o out --param m_load=2 --no-kernels")
    Path("three.csv").write_text(log(9, 3).csv())
    run(capsys, "diagnose puma560_3dof three.csv -o out --no-kernels")
    plain, limited, loaded, bundled = stand.calls
    assert [one.samples for one in plain["logs"]] == [50, 60]
    assert plain["validate"].samples == 70
    assert plain["names"] == ["a.csv", "b.csv", "v.csv"]
    contents = [Path(name).read_bytes() for name in plain["names"]]
    assert plain["hashes"] == [hashlib.sha256(content).hexdigest() for content in contents]
    assert (plain["parameters"], loaded["parameters"]) == (None, {"m_load": 2.0})
    assert (plain["text"], bundled["text"]) == (ARM, bundled_text("puma560_3dof"))
    limits = [[call[key] for key in ("only", "without", "joints", "most")] for call in (plain, limited)]
    assert limits == [[(), (), [], None], [("spring", "backlash"), ("backlash",), [1, 3], 2]]


def test_what_is_written_and_said(capsys: Capture) -> None:
    out, err = run(capsys, "diagnose arm.yaml a.csv -o deep/out")
    folder = Path("deep/out")
    files = {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    kernels = {f"kernels/arm.{ending}" for ending in ("c", "h", "f90")}
    assert set(files) == {".robodyn.sha256", "diagnosis.json", "model.yaml", "report.html", *kernels}
    assert files["model.yaml"] == RUBBING.encode()
    findings = json.loads(files["diagnosis.json"])["findings"]
    assert findings[0]["parameters"]["level"] == {
        "value": 2.0, "stderr": 0.01, "unit": "N*m", "interval": [1.9804, 2.0196], "identifiable": True
    }  # fmt: skip
    assert b"<h1>arm: Coulomb friction at joint 1 is missing</h1>" in files["report.html"]
    lines = out.splitlines()
    assert 5 <= len(lines) <= 10
    assert lines[0].startswith("missing effect: arm: Coulomb friction at joint 1 is missing; ")
    assert lines[0].endswith("% of the torque stays unexplained.")
    assert lines[-1].startswith("report: deep/out/report.html")
    assert err == ""
    run(capsys, "diagnose arm.yaml a.csv -o two")
    assert files == {name: Path("two", name).read_bytes() for name in files}
    assert not any(str(Path.cwd()).encode() in content for content in files.values())


def test_the_kernels_are_of_the_amended_model(capsys: Capture, stand: Stand) -> None:
    run(capsys, "diagnose arm.yaml a.csv -o one")
    stand.changes = {"model": read_text(ARM)}
    run(capsys, "diagnose arm.yaml a.csv -o two")
    assert Path("one/kernels/arm.c").read_text() != Path("two/kernels/arm.c").read_text()


def test_json_is_the_file_and_what_is_no_number_is_null(capsys: Capture, stand: Stand) -> None:
    lost = {"level": Estimate(2.0, np.inf, "N m")}
    finding = Finding("coulomb_friction", 1, lost, 0.9, (), "", None, 1.0, 1.0)
    stand.changes = {"findings": (finding,), "left": np.array([np.nan])}
    out, _ = run(capsys, f"{QUICK} --json")
    assert out == Path("out/diagnosis.json").read_text(encoding="utf-8")
    assert not Path("out/kernels").exists()
    told = json.loads(out)
    assert told["findings"][0]["parameters"]["level"]["stderr"] is None
    assert told["left_over_threshold"] == [None]


@pytest.mark.parametrize(
    ("before", "after", "share"),
    [
        (4, 2, 0.2), (4, 4, 1.0), (4, 0.5, 0.0), (4, 9, 1.0), (1.1, 1.1, None), (np.nan, 1, None),
        (5, np.nan, None),
    ],
)  # fmt: skip
def test_an_unexplained_share_is_a_share_or_nothing_with_a_reason(
    capsys: Capture, stand: Stand, before: float, after: float, share: float | None
) -> None:
    was, now, noise = (np.array([x]) for x in (before, after, 1.0))
    stand.changes = {"gap": Gap(was, now, was, now, noise), "left": np.array([4225.0])}
    told = run_json(capsys, QUICK)
    assert told["unexplained_share"] == [share if share is None else pytest.approx(share)]
    assert (told["unexplained_share_reason"] is None) == (share is not None)
    assert told["left_over_threshold"] == [4225.0]


@pytest.mark.parametrize(("verdict", "code"), [("consistent", 0), ("unexplained", 4)])
def test_exit_codes(capsys: Capture, stand: Stand, verdict: str, code: int) -> None:
    stand.changes = {"verdict": verdict}
    out, err = run(capsys, "diagnose arm.yaml a.csv -o out", code=code)
    assert out.startswith(verdict)
    assert err == ""
    assert Path("out/kernels/arm.c").exists()


def test_all_or_nothing(capsys: Capture, stand: Stand, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(*_: Any) -> None:
        raise InputError("no kernel of this")

    command = "diagnose arm.yaml a.csv -o out"
    with monkeypatch.context() as patch:
        patch.setattr("robodyn.kernels.generate.generate", broken)
        assert "no kernel" in run(capsys, command, code=2)[1]
    assert not Path("out").exists()
    Path("out/report.html").mkdir(parents=True)
    run(capsys, command, code=2)
    assert [path.name for path in Path("out").rglob("*")] == ["report.html"]
    stand.error = InputError("the log is of another robot")
    assert "another robot" in run(capsys, "diagnose arm.yaml a.csv -o new", code=2)[1]
    assert not Path("new").exists()


def test_what_is_read_is_not_written_over(capsys: Capture, stand: Stand) -> None:
    run(capsys, QUICK)
    assert "would be overwritten" in run(capsys, "diagnose out/model.yaml a.csv -o out", code=2)[1]
    assert Path("out/model.yaml").read_text() == RUBBING
    run(capsys, "diagnose out/model.yaml a.csv -o again --no-kernels")
    assert stand.calls[1]["text"] == RUBBING


def test_what_proves_nothing_is_said(capsys: Capture) -> None:
    Path("c.csv").write_bytes(Path("a.csv").read_bytes())
    _, err = run(capsys, "diagnose arm.yaml a.csv --validate c.csv -o out")
    assert "c.csv is identical to a.csv and adds no evidence" in err
    assert "kernels is from an earlier run" in run(capsys, QUICK)[1]
