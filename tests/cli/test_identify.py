"""``robodyn identify``: what is written and said, exit codes, what is refused."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from benchmarks.blind_arms.arms import bare, perturbed, rubbing

from identify.exact import log_of
from robodyn.robot import load, to_yaml
from robodyn_cli.main import main

Capture = pytest.CaptureFixture[str]


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An arm of three joints whose friction is not described, and logs of it."""
    folder = tmp_path_factory.mktemp("identify")
    truth = rubbing(bare("puma560_3dof"))
    (folder / "arm.yaml").write_text("# ours\n" + to_yaml(perturbed(bare("puma560_3dof"), 0.2, 3)))
    (folder / "a.csv").write_text(log_of(truth, noise=0.01, seconds=6.0).csv())
    (folder / "b.csv").write_text(log_of(truth, noise=0.01, seconds=4.0, seed=2).csv())
    (folder / "short.csv").write_text("t,q1,tau1\n0,0,0\n")
    return folder


@pytest.fixture(autouse=True)
def there(files: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(files)


def test_a_model_and_its_numbers_are_written(capsys: Capture) -> None:
    assert main(["identify", "arm.yaml", "a.csv", "--validate", "b.csv", "-o", "out"]) == 0
    out, err = capsys.readouterr()
    assert "of the torque is left on the validation log" in out.splitlines()[0]
    assert "viscous friction [N m s/rad]: 1: " in out
    assert not [line for line in err.splitlines() if "arm.yaml" not in line]  # the thesis's link 3
    data = json.loads(Path("out/identify.json").read_text(encoding="utf-8"))
    residual = data["residual"]["validate"]
    assert all(a < 0.2 * b for a, b in zip(residual["after"], residual["before"], strict=True))
    assert set(data["parameters"]["joint2.coulomb_friction.level"]) >= {"value", "stderr", "unit"}
    assert data["condition"] > 1
    model = Path("out/identified.yaml").read_text(encoding="utf-8")
    assert model.startswith("# ours\n")
    assert load("out/identified.yaml", strict=True).n == 3


@pytest.mark.thorough
def test_the_same_input_gives_the_same_files(capsys: Capture) -> None:
    for folder in ("one", "two"):
        assert main(["identify", "arm.yaml", "b.csv", "-o", folder, "--json"]) == 0
    first, second = (json.dumps(json.loads(text)) for text in _split(capsys.readouterr().out))
    assert first == second
    for name in ("identify.json", "identified.yaml"):
        assert Path("one", name).read_bytes() == Path("two", name).read_bytes()


def _split(out: str) -> list[str]:
    head, _, tail = out.partition("}\n{")
    return [head + "}", "{" + tail]
