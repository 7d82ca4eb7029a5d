"""The command ``robodyn logs``, and the options of logs of the other commands."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
import pytest

from robodyn.logs.log import read_log
from robodyn.logs.mapping import read_map
from robodyn_cli.main import main

ROWS = 400


@pytest.fixture
def foreign(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A log in degrees and milliseconds."""
    monkeypatch.chdir(tmp_path)
    t = np.arange(ROWS) * 5.0
    q = np.degrees(np.sin(t / 300))
    path = tmp_path / "log.csv"
    rows = (f"{a!r};{b!r};{3 * b!r}" for a, b in zip(t.tolist(), q.tolist(), strict=True))
    path.write_text("time [ms];pos_1;trq_1 [mNm]\n" + "\n".join(rows).replace(".", ",") + "\n")
    return path


def test_a_map_is_proposed_and_written(foreign: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["logs", "log.csv", "-o", "map.yaml"]) == 0
    out, err = capsys.readouterr()
    assert "Proposed map:" in out
    assert "400 samples of 1 joint" in out
    assert "wrote map.yaml" in err
    log = read_log("log.csv", mapping=read_map("map.yaml"))
    assert log.t[1] == 0.005
    assert np.abs(log.q).max() == pytest.approx(1, abs=1e-3)
    assert main(["logs", "log.csv", "--map", "map.yaml"]) == 0
    assert "Map:" in capsys.readouterr().out


def test_as_json(foreign: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["logs", "log.csv", "--json"]) == 0
    result = json.loads(capsys.readouterr().out)
    assert [column["name"] for column in result["streams"][0]["columns"]] == ["time", "pos_1", "trq_1"]
    assert result["log"]["rate"] == pytest.approx(200)
    assert result["needs_map"] is True


def test_columns_on_the_command_line_go_before_the_map(
    foreign: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    Path("map.yaml").write_text("t: time\nq: pos_1[rad]\ntau: trq_1\n")
    assert main(["logs", "log.csv", "--map", "map.yaml", "--columns", "q=-pos_1[deg]", "--json"]) == 0
    ranges = json.loads(capsys.readouterr().out)["log"]["ranges"]
    assert ranges["q1"] == [pytest.approx(-1, abs=1e-3), pytest.approx(1, abs=1e-3)]


@pytest.mark.parametrize(
    ("name", "module", "extra"),
    [("log.mcap", "rosbags", "ros"), ("log.db3", "rosbags", "ros"), ("log.mat", "h5py", "mat")],
)
def test_a_library_that_is_missing(
    name: str,
    module: str,
    extra: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    path = tmp_path / name
    path.write_bytes(b"MATLAB 7.3 MAT-file".ljust(512) + b"\x89HDF\r\n\x1a\n")
    assert main(["logs", str(path)]) == 3
    assert f"pip install 'robodyn[{extra}]'" in capsys.readouterr().err
