"""What is verified, proved, planned, raced and compiled is what is written: the records beside a robot's file
count for every command and for the library, and ``--optimize fast`` leaves them out everywhere."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import robodyn
from cli.command import Capture, run, run_json
from records.made import ELBOW, arm, better, fast
from robodyn.counts import count
from robodyn.ir import Input, Operation, Program
from robodyn.ir.evaluate import evaluate
from robodyn.optimize.records import FOLDER, Record
from robodyn.search.improve import write_record
from robodyn_testing import representative, require_tool

ROBOT = arm(ELBOW + "friction_at_rest: exact\n")
FEWEST = count(better(ROBOT).program).total
COMMANDS = [
    "gen elbow.yaml -o out",
    "flops elbow.yaml",
    "verify elbow.yaml",
    "prove elbow.yaml --only stack -o out",
    "schedule elbow.yaml -p 2 --cut 1",
    "plan elbow.yaml --deadline 1s",
    "bench elbow.yaml",
    "simulate elbow.yaml --duration 0.01 -o out.csv",
]


@pytest.fixture(autouse=True)
def record(elsewhere: Path) -> Path:
    """The record of a better program, beside the elbow's file."""
    (elsewhere / "elbow.yaml").write_text(ELBOW)
    return write_record(better(ROBOT), elsewhere / FOLDER)


def falsify(record: Path) -> None:
    """Make it wrong by a sign: whoever looks at it says so."""
    right = better(ROBOT)
    k, wrong = next((k, op) for k, op in enumerate(right.program.operations) if op.op == "add")
    operations = list(right.program.operations)
    operations[k] = Operation("sub", wrong.args)
    made = Program(tuple(operations), right.program.outputs)
    write_record(Record("elbow", right.identity, right.function, "total", "a test", made), record.parent)


def test_every_command_looks_at_the_records(record: Path, capsys: Capture) -> None:
    falsify(record)
    for command in COMMANDS:
        err = run(capsys, command, code=2)[1]
        assert "error: records/elbow.inverse_dynamics.total.record: " in err, command
        assert not Path("out").exists()


@pytest.mark.parametrize("command", representative(COMMANDS[:5], "flops elbow.yaml", "verify elbow.yaml"))
def test_fast_does_not(command: str, record: Path, capsys: Capture) -> None:
    require_tool("cc")
    falsify(record)
    _, err = run(capsys, command, "--optimize", "fast")
    assert "record" not in err


def test_the_library_does(monkeypatch: pytest.MonkeyPatch, capsys: Capture) -> None:
    """From any working folder: a robot knows where it was read."""
    assert run_json(capsys, "flops elbow.yaml")["total"] == FEWEST
    assert run_json(capsys, "schedule elbow.yaml -p 1 --cut 1")["tasks"] == FEWEST
    robot = robodyn.load("elbow.yaml")
    monkeypatch.chdir("/")
    made = robodyn.generate(robot)
    assert made.counts["inverse_dynamics"].total == FEWEST
    assert count(robodyn.program(robot, "inverse_dynamics")).total == FEWEST
    plain = robodyn.generate(robot, robodyn.Options(optimize="fast"))
    assert plain.counts["inverse_dynamics"].total == count(fast(ROBOT)).total > FEWEST


def test_compiled_kernels_are_those_that_are_written() -> None:
    """The library that is compiled and loaded has the same source; a batch of one state the same bits."""
    require_tool("cc")
    robot = robodyn.load("elbow.yaml")
    kernel, plain = robodyn.compile(robot), robodyn.compile(robot, optimize="fast")
    state = [[0.3, -0.7]] * 3
    torques, others = (k.inverse_dynamics(*state) for k in (kernel, plain))
    assert (torques != others).any(), "other operations round otherwise at this state"
    records = robodyn.Options(("inverse_dynamics",), records=(better(ROBOT),))
    inputs = {Input(a, i): x for a in ("q", "qd", "qdd") for i, x in enumerate(state[0])}
    written = evaluate(
        robodyn.program(ROBOT, "inverse_dynamics", records), inputs
    )  # rounds as C's doubles do
    assert (torques == np.array(written["tau"])).all()
    assert (kernel.batch(*([row] for row in state)) == torques).all()


@pytest.mark.parametrize("scalar", ["double", pytest.param("float", marks=pytest.mark.slow)])
def test_what_is_proved_is_what_is_written(scalar: str, capsys: Capture) -> None:
    require_tool("cc")
    options = f"--scalar {scalar} --trig builtin --functions inverse_dynamics,gravity"
    run(capsys, f"gen elbow.yaml --lang c --misra -o written {options}")
    run(capsys, f"prove elbow.yaml --only stack -o proved {options}")
    for name in ("elbow.h", "elbow.c"):
        assert (Path("written") / name).read_bytes() == (Path("proved") / name).read_bytes()
    assert str(FEWEST) in Path("written/elbow.h").read_text()
