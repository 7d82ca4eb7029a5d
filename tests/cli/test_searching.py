"""``gen`` and ``flops`` with records and searches: what is used, written, refused, and left behind."""

from __future__ import annotations

import errno
import json
import os
import shutil
from pathlib import Path

import pytest

from cli.searched import NAME, Capture, files, run
from records.made import ELBOW, arm, better, fast, recorded
from robodyn import Options, program
from robodyn.counts import count
from robodyn.dynamics.equality import equals_recursion
from robodyn.optimize.records import FOLDER, bundled_records, parse_record
from robodyn.search.improve import write_record
from robodyn_cli.main import main
from robodyn_testing import representative
from search.arms import search_for_a_moment

pytestmark = pytest.mark.usefixtures("here")

ROBOT = arm(ELBOW)
FAST = count(fast(ROBOT)).total


@pytest.fixture
def moment(monkeypatch: pytest.MonkeyPatch) -> None:
    search_for_a_moment(monkeypatch)


@pytest.fixture
def with_record(here: Path) -> Path:
    """The record of a better program beside the elbow's file."""
    return write_record(better(ROBOT), here / FOLDER)


def total(capsys: Capture, *arguments: str) -> int:
    found = json.loads(run(capsys, "flops", "elbow.yaml", "--json", *arguments)[0])
    return int(found["total"])


# --- records beside the file ------------------------------------------------------------------------------


def test_a_record_beside_the_file_is_used(with_record: Path, here: Path, capsys: Capture) -> None:
    best = count(better(ROBOT).program).total
    assert best < FAST
    assert total(capsys) == total(capsys, "--optimize", "record") == best
    assert total(capsys, "--optimize", "fast") == FAST
    run(capsys, "gen", "elbow.yaml", "-o", "out")
    text = (here / "out" / "elbow.c").read_text()
    assert "the best program known for these parameters" in text
    assert "a test" in text
    for more in (["--functions", "gravity"], ["--functions", "bias,inverse_dynamics"]):
        run(capsys, "gen", "elbow.yaml", "-o", "out", *more)
    run(capsys, "gen", "elbow.yaml", "-o", "out")
    run(capsys, "gen", "elbow.yaml", "-o", "out", "--check")
    run(capsys, "gen", "elbow.yaml", "-o", "out", "--check", "--optimize", "fast", code=1)


def test_from_another_folder_and_under_another_name(
    with_record: Path, here: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    (here / "copy.yaml").write_text(ELBOW.replace("name: elbow", "name: copy"))
    (here / "far").mkdir()
    monkeypatch.chdir(here / "far")
    for file in ("../elbow.yaml", str(here / "copy.yaml")):
        found = json.loads(run(capsys, "flops", file, "--json")[0])
        assert found["total"] == count(better(ROBOT).program).total
    shutil.copy(here / "elbow.yaml", here / "far" / "elbow.yaml")
    assert total(capsys) == FAST


def test_other_numbers_have_no_record(with_record: Path, here: Path, capsys: Capture) -> None:
    (here / "elbow.yaml").write_text(ELBOW.replace("mass: 1.5", "mass: 1.6"))
    assert total(capsys) == total(capsys, "--optimize", "fast")


def test_the_cache_is_not_looked_at(here: Path, capsys: Capture) -> None:
    """The bytes of a kernel must not depend on what was searched for on this machine."""
    write_record(better(ROBOT), Path(os.environ["ROBODYN_CACHE"]) / FOLDER)
    assert total(capsys) == FAST


def test_a_worse_record_is_not_used(here: Path, capsys: Capture) -> None:
    worse = program(ROBOT, "inverse_dynamics", Options(optimize="none"))
    write_record(recorded(ROBOT, worse), here / FOLDER)
    assert total(capsys) == FAST
    run(capsys, "gen", "elbow.yaml", "-o", "out")
    assert "best program known" not in (here / "out" / "elbow.c").read_text()


@pytest.mark.parametrize(
    ("old", "new", "hint"),
    [
        ("%5 = ", "%6 = ", f"records/{NAME}:14: "),
        (" = sub ", " = add ", f"records/{NAME}: the record of elbow does not compute its inverse_dynamics"),
        ("tau = ", "tau = $other ", f"records/{NAME}: the record of elbow does not compute"),
        ("tau = ", "tau = \x00 ", f"records/{NAME}:"),
    ],
)
def test_a_damaged_record_writes_nothing(
    old: str, new: str, hint: str, with_record: Path, here: Path, capsys: Capture
) -> None:
    text = with_record.read_text()
    assert old in text
    with_record.write_text(text.replace(old, new, 1))
    before = files(here)
    for command in (["gen", "elbow.yaml", "-o", "out"], ["flops", "elbow.yaml"]):
        out, err = run(capsys, *command, code=2)
        assert out == ""
        assert len(err.splitlines()) == 1
        assert err.startswith("robodyn: error: ")
        assert hint in err
    assert files(here) == before
    assert total(capsys, "--optimize", "fast") == FAST


# --- searching --------------------------------------------------------------------------------------------


@pytest.mark.usefixtures("moment")
@pytest.mark.parametrize("level", ["search", pytest.param("full", marks=pytest.mark.thorough)])
def test_a_short_search(level: str, here: Path, capsys: Capture) -> None:
    out, err = run(
        capsys, "gen", "elbow.yaml", "-o", "out", "--optimize", level, "--budget-seconds", "0.5", "--json"
    )
    assert err == "", "no progress where nobody watches"
    counts = {found["function"]: found["total"] for found in json.loads(out)["functions"]}
    assert counts["inverse_dynamics"] < FAST
    assert counts["gravity"] <= count(fast(ROBOT, "gravity")).total
    text = " ".join((here / "out" / "elbow.h").read_text().replace(" *", " ").split())
    assert f"robodyn --optimize {level}, seed 0" in text
    assert files(here) == {"elbow.yaml", "out/elbow.c", "out/elbow.h", "out/elbow.f90"}, "no record unasked"


@pytest.mark.usefixtures("moment")
@pytest.mark.thorough
def test_a_search_goes_on_from_the_last_one(capsys: Capture) -> None:
    first = total(capsys, "--optimize", "full", "--budget-seconds", "0.1")
    assert total(capsys, "--optimize", "search", "--budget-seconds", "0.01", "--seed", "7") <= first


@pytest.mark.usefixtures("moment")
def test_keep_writes_beside_the_file(here: Path, capsys: Capture) -> None:
    out, err = run(
        capsys, "flops", "elbow.yaml", "--optimize", "full", "--budget-seconds", "0.5", "--keep", "--json"
    )
    found = json.loads(out)["total"]
    assert err == f"robodyn: wrote {FOLDER}/{NAME}\n"
    record = parse_record((here / FOLDER / NAME).read_text(), "")
    assert equals_recursion(ROBOT, "inverse_dynamics", record.program)
    assert files(here) == {"elbow.yaml", f"{FOLDER}/{NAME}"}
    assert total(capsys) == found < FAST
    assert total(capsys, "--objective", "mul") >= found


@pytest.mark.thorough
def test_keep_where_it_cannot(here: Path, capsys: Capture) -> None:
    (here / FOLDER).write_text("in the way")
    more = ["--optimize", "search", "--budget-seconds", "0.1", "--keep"]
    _, err = run(capsys, "gen", "elbow.yaml", "-o", "out", *more, code=2)
    assert "cannot write to records" in err
    assert files(here) == {"elbow.yaml", FOLDER}


@pytest.mark.thorough
def test_keep_on_a_full_disk(here: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(record: object, folder: Path) -> Path:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr("robodyn.search.improve.write_record", full)
    more = ["--optimize", "search", "--budget-seconds", "0.1", "--keep"]
    _, err = run(capsys, "gen", "elbow.yaml", "-o", "out", *more, code=74)
    assert "cannot write to records: No space left on device; remove --keep" in err
    assert files(here) == {"elbow.yaml"}


@pytest.mark.parametrize("objective", representative(["depth", "weighted:cortex-m4f"], "weighted:cortex-m4f"))
@pytest.mark.thorough
def test_objectives(objective: str, here: Path, capsys: Capture) -> None:
    more = ["--optimize", "search", "--budget-seconds", "0.1", "--objective", objective, "--keep"]
    total(capsys, *more)
    (path,) = (here / FOLDER).iterdir()
    assert f"\nobjective {objective}\n" in path.read_text()
    assert total(capsys, "--objective", objective) == count(parse_record(path.read_text(), "").program).total
    assert total(capsys) == FAST


def test_an_objective_written_otherwise_is_the_same(with_record: Path, capsys: Capture) -> None:
    assert total(capsys, "--objective", "total:") == total(capsys) < FAST


@pytest.mark.parametrize(
    "function", ["forward_dynamics", "gravity", pytest.param("mass_matrix", marks=pytest.mark.thorough)]
)
def test_functions_that_have_no_writings(function: str, capsys: Capture) -> None:
    found = total(capsys, "--functions", function, "--optimize", "search", "--budget-seconds", "0.3")
    assert found <= total(capsys, "--functions", function, "--optimize", "fast")


@pytest.mark.thorough
def test_bundled_records_stay_as_they_are(capsys: Capture) -> None:
    before = contents(bundled_records())
    main(["flops", "stanford_3dof_d3", "--optimize", "search", "--budget-seconds", "0.1"])
    assert before == contents(bundled_records())


def contents(folder: Path) -> dict[Path, bytes]:
    return {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
