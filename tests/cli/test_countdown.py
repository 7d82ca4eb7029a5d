"""How long the rest takes: shown on a terminal, from stages whose usual costs are known."""

from __future__ import annotations

import threading
from pathlib import Path

import pytest
from benchmarks.blind_arms.arms import bare, perturbed, rubbing

from cli.command import on_terminal, python
from identify.exact import log_of
from robodyn.diagnose.run import diagnose
from robodyn.diagnose.run import stages as stages_of_diagnosis
from robodyn.identify.run import identify, stages
from robodyn.logs.log import Log
from robodyn.robot import to_yaml
from robodyn.robot.model import Robot
from robodyn_cli.progress import Countdown, Line, Pace, countdown


@pytest.fixture(scope="module")
def arm() -> tuple[Robot, Log]:
    return perturbed(bare("puma560_3dof"), 0.2, 3), log_of(
        rubbing(bare("puma560_3dof")), noise=0.01, seconds=6.0
    )


def test_what_is_left_of_many_pieces_follows_from_those_that_are_done() -> None:
    pace = Pace()
    assert pace.words("digesting", 5, 105, 10.0) == ""  # how long the first took is not known
    assert pace.words("digesting", 15, 105, 14.0) == "; about 40 s left"  # ten in 4 s, ninety to go
    assert pace.words("diagnosing", 0, 10, 14.0) == ""
    assert pace.words("diagnosing", 1, 10, 44.0) == "; about 5 min left"
    assert pace.words("diagnosing", 10, 10, 300.0) == ""


def test_what_is_left_follows_from_the_pace_of_what_was_done() -> None:
    clock = Countdown({"one": 2.0, "two": 6.0, "three": 2.0}, 0.0)
    assert clock.left(0.0) is None
    assert clock.words(0.0) == ""
    clock.enter("one", 0.0)
    assert clock.left(0.5) == pytest.approx(9.5)
    clock.enter("two", 20.0)  # ten times as slow as usual
    assert clock.left(20.0) == pytest.approx(80.0)
    clock.enter("something in two", 25.0)
    assert clock.left(30.0) == pytest.approx(70.0)
    assert clock.words(30.0) == "; about 70 s left"
    clock.enter("two", 80.0)  # once more
    assert clock.left(80.0) == pytest.approx(80.0)
    clock.enter("three", 140.0)
    assert clock.left(140.0) == pytest.approx(20.0)
    assert clock.left(500.0) == 0.0
    assert clock.words(500.0) == ""


@pytest.mark.parametrize(("left", "words"), [(0.4, ""), (7.2, "8 s"), (61.0, "65 s"), (130.0, "3 min")])
def test_times_are_told_as_people_do(left: float, words: str) -> None:
    clock = Countdown({"all": left}, 0.0)
    clock.enter("all", 0.0)
    assert clock.words(0.0) == (f"; about {words} left" if words else "")


def test_a_pipe_has_no_thread_that_follows() -> None:
    shown, before = Line(), threading.active_count()
    shown.shown = False
    with countdown(shown, "head", {"all": 9.0}) as tell:
        tell("all")
        assert threading.active_count() == before


@pytest.mark.slow
def test_every_stage_is_known_and_comes_in_its_order(arm: tuple[Robot, Log]) -> None:
    robot, log = arm
    for work, known in ((identify, stages(robot.n, [log])), (diagnose, stages_of_diagnosis(robot.n, [log]))):
        heard: list[str] = []
        work(robot, [log], progress=heard.append)
        entered = [what for what in heard if not what.startswith("found ")]
        assert set(entered) <= set(known)
        first = [entered.index(name) for name in known if name in entered]
        assert first == sorted(first)
        assert len(first) >= min(len(known), 4)
        assert all(seconds > 0 for seconds in known.values())


@pytest.mark.parametrize(
    "command",
    [pytest.param("identify", marks=pytest.mark.thorough), pytest.param("diagnose", marks=pytest.mark.slow)],
)
def test_a_terminal_is_told_how_long_it_takes_and_a_pipe_is_not(
    command: str, arm: tuple[Robot, Log], elsewhere: Path
) -> None:
    (elsewhere / "arm.yaml").write_text(to_yaml(arm[0]), encoding="utf-8")
    (elsewhere / "log.csv").write_text(arm[1].csv(), encoding="utf-8")
    line = f"{command} arm.yaml log.csv -o out" + " --no-kernels" * (command == "diagnose")
    code, text = on_terminal(line)
    assert code in (0, 4)
    assert b"puma560_3dof: looking at the logs; about " in text
    assert b" s left" in text
    if command == "identify":
        done = python("-m", "robodyn", *line.split())
        assert (done.returncode, " left" in done.stderr, "\r" in done.stderr) == (0, False, False)
