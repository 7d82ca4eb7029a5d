"""``robodyn diagnose``: what is asked for, what is written and said, exit codes, what is refused."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from robodyn.diagnose import run
from robodyn.diagnose.result import Diagnosis, Estimate, Finding, Gap, Series
from robodyn.errors import InputError
from robodyn.logs.log import Log
from robodyn.robot import Robot, read_text
from robodyn_cli.main import main

Capture = pytest.CaptureFixture[str]

ARM = """\
name: arm
links:
  - {joint: revolute, mass: 1, com: [0.2, 0, 0], inertia: {zz: 0.1}}  # the only one
"""
RUBBING = ARM.replace("zz: 0.1}", "zz: 0.1}, friction: {coulomb: 2}")
LOADED = ARM.replace("name: arm", "name: loaded").replace("mass: 1,", "mass: m_load,")


def log(samples: int = 50) -> Log:
    t = np.linspace(0, 1, samples)
    q = np.sin(t)[:, None]
    return Log(t, q, None, None, q)


def found(robot: Robot, log: Log, **changes: Any) -> Diagnosis:
    """Coulomb friction that would be found."""
    level = {"level": Estimate(2.0, 0.01, "N m")}
    finding = Finding("coulomb_friction", 1, level, 0.9, (), "joint 1: a step", None, 10.0, 5.0)
    size = np.ones(robot.n)
    q = log.q
    made = Diagnosis(
        verdict="missing_effect", findings=(finding,),
        gap=Gap(4 * size, size, 4 * size, size, size, (9 * size, 9 * size)),
        robot=robot,
        model=read_text(RUBBING), model_text=RUBBING, diff="-a\n+b\n", flags=(), left=size, words=(),
        logs=(), series=(Series("train", log.t, q, q, q, q, q, q, q),), operations=(5, 7),
    )  # fmt: skip
    return replace(made, **changes)


class Stand:
    """In the place of the diagnosis: keeps what it is given, and gives what it is told to."""

    def __init__(self) -> None:
        self.calls: list[dict[str, Any]] = []
        self.changes: dict[str, Any] = {}
        self.error: Exception | None = None

    def __call__(
        self,
        robot: Robot,
        logs: Sequence[Callable[[], Log]],
        validate: Callable[[], Log] | None = None,
        *,
        text: str | None = None,
        names: Sequence[str] = (),
        hashes: Sequence[str] = (),
        parameters: Mapping[str, float] | None = None,
        progress: Callable[[str], object] | None = None,
        only: Sequence[str] = (),
        without: Sequence[str] = (),
        joints: Sequence[int] = (),
        most: int | None = None,
    ) -> Diagnosis:
        assert progress is not None
        progress("at work")
        if self.error is not None:
            raise self.error
        taken = [hand_over() for hand_over in logs]
        validation = None if validate is None else validate()
        self.calls.append(locals() | {"logs": taken, "validate": validation})
        return found(robot, taken[0], **self.changes)


@pytest.fixture(autouse=True)
def stand(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Stand:
    """Every test works in a folder of its own with robots and logs."""
    for text in (ARM, LOADED):
        (tmp_path / f"{text.split()[1]}.yaml").write_text(text)
    for name, samples in (("a.csv", 50), ("b.csv", 60), ("v.csv", 70)):
        (tmp_path / name).write_text(log(samples).csv())
    monkeypatch.chdir(tmp_path)
    stand = Stand()
    monkeypatch.setattr(run, "diagnose", stand)
    return stand


def diagnose(capsys: Capture, command: str, code: int = 0) -> tuple[str, str]:
    """Standard output and standard error."""
    assert main(["diagnose", *command.split()]) == code, capsys.readouterr().err
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    return out, err


def test_everything_is_handed_over(capsys: Capture, stand: Stand, tmp_path: Path) -> None:
    diagnose(capsys, "arm.yaml a.csv b.csv --validate v.csv -o out --no-kernels")
    (call,) = stand.calls
    assert [one.samples for one in call["logs"]] == [50, 60]
    assert call["validate"].samples == 70
    assert call["text"] == ARM
    assert call["names"] == ["a.csv", "b.csv", "v.csv"]
    contents = [(tmp_path / name).read_bytes() for name in call["names"]]
    assert call["hashes"] == [hashlib.sha256(content).hexdigest() for content in contents]
    assert call["parameters"] is None


def test_what_is_looked_for_is_handed_over(capsys: Capture, stand: Stand) -> None:
    diagnose(
        capsys,
        "arm.yaml a.csv -o out --no-kernels --only spring,backlash --except backlash --joints 1,3 --most 2",
    )
    diagnose(capsys, "arm.yaml a.csv -o out --no-kernels")
    first, plain = stand.calls
    assert (first["only"], first["without"]) == (("spring", "backlash"), ("backlash",))
    assert (first["joints"], first["most"]) == ([1, 3], 2)
    assert (plain["only"], plain["without"], plain["joints"], plain["most"]) == ((), (), [], None)


def test_a_bundled_robot_keeps_its_text(capsys: Capture, stand: Stand, tmp_path: Path) -> None:
    from robodyn.robot import bundled_text

    n = 3
    t, q = np.arange(9.0), np.ones((9, n))
    (tmp_path / "three.csv").write_text(Log(t, q, None, None, q).csv())
    diagnose(capsys, "puma560_3dof three.csv -o out --no-kernels")
    assert stand.calls[0]["text"] == bundled_text("puma560_3dof")


def test_what_is_written_and_said(capsys: Capture, tmp_path: Path) -> None:
    out, err = diagnose(capsys, "arm.yaml a.csv -o deep/out")
    folder = tmp_path / "deep" / "out"
    files = {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()}
    kernels = {f"kernels/arm.{ending}" for ending in ("c", "h", "f90")}
    assert files == {".robodyn.sha256", "diagnosis.json", "model.yaml", "report.html", *kernels}
    assert (folder / "model.yaml").read_text() == RUBBING
    level = {
        "value": 2.0, "stderr": 0.01, "unit": "N*m", "interval": [1.9804, 2.0196], "identifiable": True
    }  # fmt: skip
    findings = json.loads((folder / "diagnosis.json").read_text())["findings"]
    assert findings[0]["parameters"] == {"level": level}
    assert "<h1>arm: Coulomb friction at joint 1 is missing</h1>" in (folder / "report.html").read_text(
        encoding="utf-8"
    )
    lines = out.splitlines()
    assert 5 <= len(lines) <= 10
    assert lines[0].startswith("missing effect: arm: Coulomb friction at joint 1 is missing; ")
    assert lines[0].endswith("% of the torque stays unexplained.")
    assert lines[-1].startswith("report: deep/out/report.html")
    assert err == ""


def test_the_kernels_are_of_the_amended_model(capsys: Capture, stand: Stand, tmp_path: Path) -> None:
    diagnose(capsys, "arm.yaml a.csv -o one")
    stand.changes = {"model": read_text(ARM)}
    diagnose(capsys, "arm.yaml a.csv -o two")
    one, two = ((tmp_path / name / "kernels" / "arm.c").read_text() for name in ("one", "two"))
    assert one != two


def test_json_is_the_file(capsys: Capture, tmp_path: Path) -> None:
    out, _ = diagnose(capsys, "arm.yaml a.csv -o out --no-kernels --json")
    assert out == (tmp_path / "out" / "diagnosis.json").read_text(encoding="utf-8")
    assert json.loads(out)["verdict"] == "missing_effect"
    assert not (tmp_path / "out" / "kernels").exists()


def test_what_is_no_number_is_null(capsys: Capture, stand: Stand) -> None:
    lost = {"level": Estimate(2.0, np.inf, "N m")}
    finding = Finding("coulomb_friction", 1, lost, 0.9, (), "", None, 1.0, 1.0)
    stand.changes = {"findings": (finding,), "left": np.array([np.nan])}
    told = json.loads(diagnose(capsys, "arm.yaml a.csv -o out --no-kernels --json")[0])
    assert told["findings"][0]["parameters"]["level"]["stderr"] is None
    assert told["left_over_threshold"] == [None]


def gap(before: float, after: float, floor: float = 1.0) -> Gap:
    was, now, noise = (np.array([x]) for x in (before, after, floor))
    return Gap(was, now, was, now, noise)


@pytest.mark.parametrize(
    ("before", "after", "share"),
    [
        (4, 2, 0.2),
        (4, 4, 1.0),
        (4, 0.5, 0.0),
        (4, 9, 1.0),
        (1.1, 1.1, None),
        (np.nan, 1, None),
        (5, np.nan, None),
    ],
)
def test_an_unexplained_share_is_a_share_or_nothing_with_a_reason(
    capsys: Capture, stand: Stand, before: float, after: float, share: float | None
) -> None:
    stand.changes = {"gap": gap(before, after), "left": np.array([4225.0])}
    told = json.loads(diagnose(capsys, "arm.yaml a.csv -o out --no-kernels --json")[0])
    assert told["unexplained_share"] == [share if share is None else pytest.approx(share)]
    assert (told["unexplained_share_reason"] is None) == (share is not None)
    assert told["left_over_threshold"] == [4225.0]


@pytest.mark.parametrize(("verdict", "code"), [("missing_effect", 0), ("consistent", 0), ("unexplained", 4)])
def test_exit_codes(capsys: Capture, stand: Stand, tmp_path: Path, verdict: str, code: int) -> None:
    stand.changes = {"verdict": verdict}
    out, err = diagnose(capsys, "arm.yaml a.csv -o out", code)
    assert out.startswith(verdict.replace("_", " "))
    assert err == ""
    assert (tmp_path / "out" / "kernels" / "arm.c").exists()


def test_the_same_bytes_again(capsys: Capture, tmp_path: Path) -> None:
    for name in ("one", "two"):
        diagnose(capsys, f"arm.yaml a.csv -o {name}")
    one, two = (
        {path.name: path.read_bytes() for path in (tmp_path / name).rglob("*.*")} for name in ("one", "two")
    )
    assert one == two
    assert not any(str(tmp_path).encode() in content for content in one.values())


def test_run_time_parameters(capsys: Capture, stand: Stand) -> None:
    diagnose(capsys, "loaded.yaml a.csv -o out --param m_load=2 --no-kernels")
    assert stand.calls[0]["parameters"] == {"m_load": 2.0}


def test_a_refused_log_leaves_nothing(capsys: Capture, stand: Stand) -> None:
    stand.error = InputError("the log is of another robot")
    _, err = diagnose(capsys, "arm.yaml a.csv -o out", 2)
    assert "another robot" in err
    assert not Path("out").exists()


def test_all_or_nothing(capsys: Capture, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from robodyn.kernels import generate as generation

    def broken(*_: Any) -> None:
        raise InputError("no kernel of this")

    with monkeypatch.context() as patch:
        patch.setattr(generation, "generate", broken)
        assert "no kernel" in diagnose(capsys, "arm.yaml a.csv -o out", 2)[1]
    assert not Path("out").exists()
    (tmp_path / "out" / "report.html").mkdir(parents=True)
    diagnose(capsys, "arm.yaml a.csv -o out", 2)
    assert [path.name for path in (tmp_path / "out").rglob("*")] == ["report.html"]


def test_what_is_read_is_not_written_over(capsys: Capture, stand: Stand, tmp_path: Path) -> None:
    diagnose(capsys, "arm.yaml a.csv -o out --no-kernels")
    _, err = diagnose(capsys, "out/model.yaml a.csv -o out", 2)
    assert "would be overwritten" in err
    assert (tmp_path / "out" / "model.yaml").read_text() == RUBBING
    diagnose(capsys, "out/model.yaml a.csv -o again --no-kernels")
    assert stand.calls[1]["text"] == RUBBING


def test_what_proves_nothing_is_said(capsys: Capture) -> None:
    (Path("c.csv")).write_bytes(Path("a.csv").read_bytes())
    _, err = diagnose(capsys, "arm.yaml a.csv --validate c.csv -o out")
    assert "c.csv is identical to a.csv and adds no evidence" in err
    _, err = diagnose(capsys, "arm.yaml a.csv -o out --no-kernels")
    assert "kernels is from an earlier run" in err
