"""A fleet is worked out once: a second run does what is new, and what cannot be used is named."""

from __future__ import annotations

import json
import shutil
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from fleet.small_fleet import files_of, quick_diagnosis, small_fleet, write_log
from robodyn.cluster import Cluster, Failed
from robodyn.cluster.cluster import ThisProcess
from robodyn.errors import InputError, OutputError, ToolError
from robodyn.fleet import run as run_module
from robodyn.fleet.as_json import document
from robodyn.fleet.result import Claim, FleetResult, UnitResult, unit_folder
from robodyn.fleet.run import run_fleet
from robodyn.fleet.sources.fleet import IN_LOG, Fleet, LogFile
from robodyn.fleet.store import Store, open_store
from robodyn.fleet.units import completed, diagnosed
from robodyn.logs.content import digest
from robodyn.logs.log import Log


class Counting(ThisProcess):
    """This process, with a note of what it did; ``spoil`` may make another outcome of a piece."""

    def __init__(self) -> None:
        self.done: Counter[str] = Counter()
        self.spoil: Callable[[Any, Any], Any] = lambda _, outcome: outcome

    def each(self, function: Any, tasks: Iterable[tuple[Any, tuple[Any, ...]]]) -> Iterator[tuple[Any, Any]]:
        for key, outcome in super().each(function, tasks):
            self.done[function.__name__] += 1
            yield key, self.spoil(key, outcome)


@pytest.fixture
def cluster(monkeypatch: pytest.MonkeyPatch) -> Counting:
    own = Counting()

    @contextmanager
    def opened(on: str, **_: object) -> Iterator[Cluster]:
        own.done["opened"] += 1
        yield own

    monkeypatch.setattr(run_module, "open_cluster", opened)
    return own


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Fleet:
    return small_fleet(tmp_path_factory.mktemp("fleet") / "logs")


@pytest.fixture
def fleet(written: Fleet, tmp_path: Path) -> Fleet:
    """A fleet whose logs this test may change."""
    folder = shutil.copytree(Path(written.logs[0].source).parent, tmp_path / "logs")
    return replace(
        written, logs=tuple(replace(log, source=str(folder / Path(log.source).name)) for log in written.logs)
    )


def said(result: FleetResult) -> str:
    return json.dumps(document(result))


def test_a_second_run_does_what_is_new(fleet: Fleet, tmp_path: Path, cluster: Counting) -> None:
    first = run_fleet(fleet, tmp_path / "out", "here")
    assert sorted(cluster.done.items()) == [("digest_log", 6), ("opened", 1)]
    again = Counter[str]()
    cluster.done = again
    assert said(run_fleet(fleet, tmp_path / "out", "here")) == said(first)
    assert not again["digest_log"]
    moved = Path(fleet.logs[0].source).rename(tmp_path / "moved.csv")
    logs = (replace(fleet.logs[0], source=str(moved)), *fleet.logs[1:])
    assert said(run_fleet(replace(fleet, logs=logs), tmp_path / "out", "here")) == said(first)
    assert not again["digest_log"]
    write_log(Path(logs[1].source), 77)
    assert said(run_fleet(replace(fleet, logs=logs), tmp_path / "out", "here")) != said(first)
    assert again.get("digest_log") == 1


def test_a_date_that_only_the_log_says(fleet: Fleet, tmp_path: Path, cluster: Counting) -> None:
    undated = replace(fleet, logs=tuple(replace(log, date=IN_LOG) for log in fleet.logs))
    with pytest.raises(InputError, match=r"found 6 that cannot.*nothing says when it was recorded"):
        run_fleet(undated, tmp_path / "out", "here")
    for k, log in enumerate(fleet.logs[:4]):
        write_log(Path(log.source), k, began=1.7e9 - k)
    result = run_fleet(undated, tmp_path / "out", "here")
    assert [(unit.first, unit.last) for unit in result.units] == [(1.7e9 - 1, 1.7e9), (1.7e9 - 3, 1.7e9 - 2)]
    assert [log.source for log in result.unused] == [log.source for log in fleet.logs[4:]]


def test_logs_that_cannot_be_used_are_named_and_remembered(
    fleet: Fleet, tmp_path: Path, cluster: Counting
) -> None:
    without = run_fleet(replace(fleet, logs=fleet.logs[:4]), tmp_path / "four", "here")
    corrupt, gone = (Path(log.source) for log in fleet.logs[4:])
    corrupt.write_bytes(corrupt.read_bytes()[:3000] + b"\xff\x00garbage")
    gone.unlink()
    copy = shutil.copy(fleet.logs[0].source, tmp_path / "copy.csv")
    logs = (*fleet.logs, replace(fleet.logs[5], source=str(copy)))
    cluster.done.clear()
    for count in (5, 0):
        result = run_fleet(replace(fleet, logs=logs), tmp_path / "out", "here")
        assert cluster.done["digest_log"] == count
        cluster.done.clear()
        reasons = {Path(log.source).name: log.why for log in result.unused}
        assert set(reasons) == {corrupt.name, gone.name, "copy.csv"}
        assert str(tmp_path) not in reasons[corrupt.name]
        assert reasons[gone.name] == "the file cannot be read: no such file or directory"
        assert reasons["copy.csv"] == f"it is a copy of {fleet.logs[0].source}"
        assert said(replace(result, unused=())) == said(without)


@pytest.mark.thorough
def test_what_is_not_the_logs_fault_is_tried_again(fleet: Fleet, tmp_path: Path, cluster: Counting) -> None:
    bad = fleet.logs[2].source
    lost = Failed(ToolError("the process that works on it ends, time and again"))
    calls = iter(range(6))
    cluster.spoil = lambda _, outcome: lost if next(calls) == 2 else outcome
    result = run_fleet(fleet, tmp_path / "out", "here")
    assert [(log.source, log.why) for log in result.unused] == [(bad, str(lost.error))]
    cluster.spoil = lambda _, outcome: outcome
    cluster.done.clear()
    assert not run_fleet(fleet, tmp_path / "out", "here").unused
    assert cluster.done["digest_log"] == 1


def failing_after(count: int, error: BaseException) -> Callable[[Store, str, Any], None]:
    """A way to keep results that works so often."""
    keep, kept = Store.keep, list[str]()

    def fails(store: Store, key: str, value: Any) -> None:
        is_digest = not isinstance(value, bytes) or len(value) > 64  # others are hashes
        if is_digest and len(kept) == count:
            raise error
        keep(store, key, value)
        kept.extend([key] * is_digest)

    return fails


def test_a_run_that_ends_in_the_middle_goes_on_there(
    fleet: Fleet, tmp_path: Path, cluster: Counting, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = run_fleet(fleet, tmp_path / "whole", "here")
    for error in (KeyboardInterrupt(), OutputError("results cannot be kept")):
        with monkeypatch.context() as patch:
            patch.setattr(Store, "keep", failing_after(2, error))
            with pytest.raises(type(error)):
                run_fleet(fleet, tmp_path / "out", "here")
    cluster.done.clear()
    assert said(run_fleet(fleet, tmp_path / "out", "here")) == said(whole)
    assert cluster.done["digest_log"] == 2


@pytest.mark.thorough
def test_a_log_that_is_written_while_it_is_read(fleet: Fleet, tmp_path: Path, cluster: Counting) -> None:
    growing = Path(fleet.logs[3].source)

    def grows(_: Any, outcome: Any) -> Any:
        if cluster.done["digest_log"] == 1:  # another one, and its content is known
            growing.write_text(growing.read_text() + "\n")
        return outcome

    cluster.spoil = grows
    result = run_fleet(fleet, tmp_path / "out", "here")
    assert [(log.source, "was written while it was read" in log.why) for log in result.unused] == [
        (str(growing), True)
    ]


def test_a_fleet_of_which_nothing_can_be_used(tmp_path: Path, cluster: Counting, written: Fleet) -> None:
    nowhere = LogFile(str(tmp_path / "no.csv"), written.logs[0].type, "a", 0.0, {})
    with pytest.raises(InputError, match=r"no log of the fleet small can be used; found 1 that cannot, the"):
        run_fleet(replace(written, logs=(nowhere,)), tmp_path / "out", "here")
    with pytest.raises(InputError, match="the fleet small has no logs"):
        run_fleet(replace(written, logs=()), tmp_path / "out", "here")


def test_units_are_diagnosed_once(
    fleet: Fleet, tmp_path: Path, cluster: Counting, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("robodyn.diagnose.run.diagnose", quick_diagnosis)
    out = tmp_path / "out"
    stages = list[str]()
    told = lambda stage, done, of: stages.append(stage)  # noqa: E731
    for count in (3, 0):
        result = run_fleet(fleet, out, "here", diagnose="all", files_of=files_of, progress=told)
        assert cluster.done["diagnose_unit"] == count
        cluster.done.clear()
        assert [unit.diagnosis for unit in result.units] == [
            f"units/stanford_3dof/unit {k}/report.html" for k in range(3)
        ]
        for unit in result.units:
            page = out / str(unit.diagnosis)
            assert page.read_text().startswith("<p>torques of ")
            assert (page.parent / "diagnosis.json").read_text() == "2"
            page.unlink()
    assert list(dict.fromkeys(stages))[:2] == ["looking for new logs", "digesting logs"]
    assert "diagnosing units" in stages
    assert run_fleet(fleet, out, "here", files_of=files_of).units[0].diagnosis is None


# --- what a diagnosis adds --------------------------------------------------------------------------------


def claim(joint: int, *effects: str) -> Claim:
    """A claim about ``joint``."""
    return Claim(
        effects, joint, f"feature_{joint}", "drift", 1e9, (9e8, 1.1e9), None, 1.0, 0.1, "-", 1.7, 1e-6, 1e-5
    )


def unit(*claims: Claim) -> UnitResult:
    """A unit of which so much is claimed."""
    return UnitResult("arm", "one", 9, 0.0, 1e9, claims, {}, {}, {})


def test_what_nothing_explained_is_called_what_is_new_at_its_joint() -> None:
    new = {"units/arm/one": [("payload", None), ("backlash", 3), ("a spring", 3)]}
    after = completed(unit(claim(3), claim(2), claim(1, "coulomb_friction")), new)
    assert [one.effects for one in after.claims] == [("backlash",), (), ("coulomb_friction",)]
    assert after.diagnosis == "units/arm/one/report.html"
    assert completed(unit(claim(3)), {}) == unit(claim(3))


def test_what_was_there_before_a_change_is_not_new(
    fleet: Fleet, tmp_path: Path, cluster: Counting, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Three logs after the day of a change, of which the last two count, and one before it."""

    def diagnose(robot: object, logs: Sequence[Log], **_: object) -> Any:
        effects = [("payload", None), *[("backlash", 3)] * (len(logs) == 2)]
        findings = [SimpleNamespace(effect=effect, joint=joint) for effect, joint in effects]
        return SimpleNamespace(findings=findings, verdict="missing_effect", logs=logs)

    monkeypatch.setattr("robodyn.diagnose.run.diagnose", diagnose)
    logs = tuple(replace(log, unit="one", date=k * 5e8) for k, log in enumerate(fleet.logs[:4]))
    one = replace(unit(replace(claim(3), since=4e8)), type=logs[0].type)
    by_path = {log.source: log for log in logs}
    hashes = {path: digest(path) for path in by_path}
    with open_store(tmp_path / "store") as store:

        def work(tasks: Mapping[str, Any], function: Callable[..., bytes]) -> dict[str, str]:
            for key, task in tasks.items():
                store.keep(key, function(*task))
            return {}

        new = diagnosed(fleet.types, by_path, hashes, [one], store, tmp_path, files_of, work)
    place = unit_folder(one.type, "one")
    assert new == {place: [("backlash", 3)]}
    assert (tmp_path / place / "before" / "report.html").is_file()
