"""What is verified, proved, planned, raced and compiled is what is written: the records beside a robot's file
count for every command and for the library, and ``--optimize fast`` leaves them out everywhere."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import robodyn
from records.made import ELBOW, arm, better, fast
from robodyn.counts import count
from robodyn.ir import Input, Operation, Program
from robodyn.ir.evaluate import evaluate
from robodyn.optimize.records import FOLDER, Record
from robodyn.search.improve import write_record
from robodyn_cli.main import main
from robodyn_testing import require_tool

Capture = pytest.CaptureFixture[str]
ROBOT = arm(ELBOW + "friction_at_rest: exact\n")
LIMITS = "qd=1,qdd=1,q=-pi:pi"


@pytest.fixture
def cc() -> str:
    """A C compiler."""
    return require_tool("cc")


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "elbow.yaml").write_text(ELBOW)
    return tmp_path


@pytest.fixture
def with_record(here: Path) -> Path:
    return write_record(better(ROBOT), here / FOLDER)


@pytest.fixture
def with_false_record(here: Path) -> Path:
    """A record that is wrong by a sign: whoever looks at it says so."""
    record = better(ROBOT)
    k, wrong = next((k, op) for k, op in enumerate(record.program.operations) if op.op == "add")
    operations = list(record.program.operations)
    operations[k] = Operation("sub", wrong.args)
    made = Program(tuple(operations), record.program.outputs)
    false = Record("elbow", record.identity, record.function, "total", "a test", made)
    return write_record(false, here / FOLDER)


COMMANDS = [
    ("gen", "elbow.yaml", "-o", "out"),
    ("flops", "elbow.yaml"),
    ("verify", "elbow.yaml"),
    ("prove", "elbow.yaml", "--only", "stack", "-o", "out"),
    ("plan", "elbow.yaml", "--deadline", "1s"),
    ("bench", "elbow.yaml"),
    ("schedule", "elbow.yaml", "-p", "2", "--cut", "1"),
    ("simulate", "elbow.yaml", "--duration", "0.01", "-o", "out.csv"),
]


@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: command[0])
def test_every_command_looks_at_the_records(
    command: tuple[str, ...], with_false_record: Path, capsys: Capture
) -> None:
    assert main(list(command)) == 2
    assert "error: records/elbow.inverse_dynamics.total.record: " in capsys.readouterr().err
    assert not Path("out").exists()


@pytest.mark.usefixtures("cc")
@pytest.mark.parametrize(
    "command",
    [c for c in COMMANDS if c[0] not in ("plan", "simulate", "bench")],
    ids=lambda command: command[0],
)
def test_fast_does_not(command: tuple[str, ...], with_false_record: Path) -> None:
    assert main([*command, "--optimize", "fast"]) == 0


def test_the_library_does(with_record: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """From any working folder: a robot knows where it was read."""
    robot = robodyn.load("elbow.yaml")
    fewest = count(better(ROBOT).program).total
    monkeypatch.chdir("/")
    made = robodyn.generate(robot)
    assert made.counts["inverse_dynamics"].total == fewest
    assert count(robodyn.program(robot, "inverse_dynamics")).total == fewest
    plain = robodyn.generate(robot, robodyn.Options(optimize="fast"))
    assert plain.counts["inverse_dynamics"].total == count(fast(ROBOT)).total > fewest


def evaluated(program: Program, at: Sequence[Sequence[float]]) -> NDArray[np.float64]:
    """``program`` in Python's floats, which round as C's doubles do."""
    inputs = {
        Input(a, i): x for a, row in zip(("q", "qd", "qdd"), at, strict=True) for i, x in enumerate(row)
    }
    return np.array(evaluate(program, inputs)["tau"])


@pytest.mark.usefixtures("cc")
def test_compiled_kernels_are_those_that_are_written(with_record: Path) -> None:
    """The library that is compiled and loaded has the same source; a batch of one state the same bits."""
    robot = robodyn.load("elbow.yaml")
    kernel, plain = robodyn.compile(robot), robodyn.compile(robot, optimize="fast")
    at = [[0.3, -0.7]] * 3
    torques = [k.inverse_dynamics(*at) for k in (kernel, plain)]
    assert (torques[0] != torques[1]).any(), "other operations round otherwise at this state"
    records = robodyn.Options(("inverse_dynamics",), records=(better(ROBOT),))
    assert (torques[0] == evaluated(robodyn.program(ROBOT, "inverse_dynamics", records), at)).all()
    assert (kernel.batch(*([row] for row in at)) == torques[0]).all()


@pytest.mark.usefixtures("cc")
@pytest.mark.parametrize("scalar", ["float", "double"])
def test_what_is_proved_is_what_is_written(with_record: Path, scalar: str, capsys: Capture) -> None:
    options = ["--scalar", scalar, "--trig", "builtin", "--functions", "inverse_dynamics,gravity"]
    assert main(["gen", "elbow.yaml", "--lang", "c", "--misra", "-o", "written", *options]) == 0
    assert main(["prove", "elbow.yaml", "--only", "stack", "-o", "proved", *options]) == 0
    for name in ("elbow.h", "elbow.c"):
        assert (Path("written") / name).read_bytes() == (Path("proved") / name).read_bytes()
    assert str(count(better(ROBOT).program).total) in Path("written/elbow.h").read_text()


def test_counts_are_the_same_everywhere(with_record: Path, capsys: Capture) -> None:
    def said(*arguments: str) -> dict[str, object]:
        capsys.readouterr()
        assert main([*arguments, "--json"]) == 0
        result: dict[str, object] = json.loads(capsys.readouterr().out)
        return result

    fewest = count(better(ROBOT).program).total
    assert said("flops", "elbow.yaml")["total"] == fewest
    assert said("schedule", "elbow.yaml", "-p", "1", "--cut", "1")["tasks"] == fewest
