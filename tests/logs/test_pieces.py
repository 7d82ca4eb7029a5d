"""Logs in pieces have the samples of the log as a whole, whatever the format and the length of a piece."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from logs.files_of_logs import bag, read_in_this_process, write
from robodyn.errors import InputError
from robodyn.logs import arrays, windows
from robodyn.logs.formats import parquet, ros2
from robodyn.logs.formats import text as text_format
from robodyn.logs.log import Log, read_log
from robodyn.logs.mapping import LogMap, map_of_text
from robodyn.logs.pieces import pieces
from robodyn.logs.streams import together
from robodyn_testing import representative

K = 403
FORMATS = (".csv", ".npz", ".parquet", ".mat", ".h5", ".json", ".mcap", ".db3")
MAP = map_of_text("joints: [base_joint, upper_joint, fore_joint]\ntopic: /joint_states\n"
                  "q: position.%s\nqd: velocity.%s\ntau: effort.%s\n")  # fmt: skip


@pytest.fixture(autouse=True)
def short_blocks(monkeypatch: pytest.MonkeyPatch) -> None:
    """Blocks and windows of a few rows, as long files have many of."""
    monkeypatch.setattr(text_format, "BLOCK", 1 << 10)
    monkeypatch.setattr(parquet, "BATCH", 32)
    monkeypatch.setattr(arrays, "BLOCK", 256)
    monkeypatch.setattr(ros2, "BATCH", 16)
    read_in_this_process(monkeypatch)


def a_log(samples: int = K, linked: bool = False) -> Log:
    rng = np.random.default_rng(7)
    q, qd, tau = rng.normal(size=(3, samples, 3))
    ql = np.full((samples, 3), np.nan) if linked else None
    if ql is not None:
        ql[:, 1] = q[:, 1]
    return Log(np.arange(samples) / 125, q, qd, None, tau, ql=ql)


def same(whole: Log, parts: list[Log], most: int) -> None:
    assert [part.samples for part in parts[:-1]] == [most] * (len(parts) - 1)
    assert 1 <= parts[-1].samples <= most
    for name in ("t", "q", "qd", "qdd", "tau", "ql"):
        array = getattr(whole, name)
        if array is None:
            assert all(getattr(part, name) is None for part in parts)
            continue
        np.testing.assert_array_equal(np.concatenate([getattr(part, name) for part in parts]), array)
    assert {part.ignored for part in parts} == {whole.ignored}
    assert sorted(note for part in parts for note in part.notes) == sorted(whole.notes)
    assert {part.began for part in parts} == {whole.began}
    means = together(part.conditions for part in parts)
    assert means.keys() == whole.conditions.keys()
    for name, mean in whole.conditions.items():
        assert means[name].count == mean.count
        assert means[name].value == pytest.approx(mean.value, rel=1e-12)


@pytest.mark.parametrize("kind", representative(FORMATS, ".csv", ".npz"))
def test_every_format(kind: str, tmp_path: Path) -> None:
    path = write(a_log(), tmp_path, kind)
    mapping = MAP if kind in (".mcap", ".db3") else None
    whole = read_log(path, 3, mapping=mapping)
    for most in (1, 100, K, 10**9):
        parts = list(pieces(path, 3, mapping=mapping, most=most))
        same(whole, parts, most)
        assert sum(len(part.t) for part in parts) == K


def test_two_files_of_the_same_samples(tmp_path: Path) -> None:
    log = a_log(linked=True)
    assert log.ql is not None
    (tmp_path / "a.csv").write_text(a_log().csv(), encoding="utf-8")
    rows = [f"{t!r},{x!r}" for t, x in zip(log.t.tolist(), log.ql[:, 1].tolist(), strict=True)]
    second = tmp_path / "b.csv"
    second.write_text("\n".join(["t,ql2", *rows, ""]), encoding="utf-8")
    name = f"{tmp_path}/a.csv+{second}"
    same(read_log(name), list(pieces(name, most=50)), 50)
    for bad, words in (
        (rows[:-1], rf"b\.csv: .*found {K - 1} rows; expected {K}, as"),
        ([*rows, "9,1"], rf"b\.csv: .*found {K + 1} rows; expected {K}, as"),
        ([*rows[:300], "9,1", *rows[301:]], r"b\.csv: .* not of the same times; found t = 9 s in row 301;"),
    ):
        second.write_text("\n".join(["t,ql2", *bad, ""]), encoding="utf-8")
        for read in (read_log, lambda each: list(pieces(each, most=50))):
            with pytest.raises(InputError, match=words):
                read(name)


def streams(folder: Path, times: Callable[[np.ndarray], np.ndarray]) -> tuple[Path, LogMap]:
    """Positions in one file, torques at other ``times`` in another."""
    log = a_log()
    (folder / "log.csv").write_text(
        "t,q1,temp\n" + "".join(f"{t!r},{x!r},{30 + t!r}\n" for t, x in
                                zip(log.t.tolist(), log.q[:, 0].tolist(), strict=True)), encoding="utf-8"
    )  # fmt: skip
    t = times(log.t)
    (folder / "log_u.csv").write_text(
        "t,u\n" + "".join(f"{x!r},{float(np.sin(x))!r}\n" for x in t.tolist()), encoding="utf-8"
    )
    text = "q: q1\ntau: {columns: u, file: '%s_u.csv'}\nconditions: {temperature: 'temp[K]'}\n"
    return folder / "log.csv", map_of_text(text)


TIMES: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "same": lambda t: t,
    "nearly the same": lambda t: t + 1e-4,
    "as many, others": lambda t: t * 0.9 + 0.1,
    "slower": lambda t: t[5::7] + 1e-3,
    "faster, with a gap": lambda t: np.delete(np.arange(0.05, 3.0, 1e-3), slice(1000, 1200)),
    "longer": lambda t: np.arange(-1.0, 9.0, 0.01),
    "out of order": lambda t: (t + 1e-3)[np.arange(len(t) - 1) ^ 1],
    "one": lambda t: t[200:201],
}


@pytest.mark.parametrize("times", TIMES)
def test_streams_of_other_times(times: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(windows, "WINDOW", 64)
    path, mapping = streams(tmp_path, TIMES[times])
    whole = read_log(path, 1, mapping=mapping)
    for most in (17, 10**6):
        same(whole, list(pieces(path, 1, mapping=mapping, most=most)), most)
    assert whole.conditions["temperature"].value == pytest.approx(30 - 273.15 + whole.t.mean())


def test_rows_that_are_far_too_late_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path, mapping = streams(tmp_path, lambda t: np.concatenate([t[200:], t[:200], t[-1:] + 0.1]))
    whole = read_log(path, 1, mapping=mapping)
    same(whole, list(pieces(path, 1, mapping=mapping, most=50)), 50)
    monkeypatch.setattr(windows, "WINDOW", 64)
    with pytest.raises(InputError, match=r"log\.csv: the rows are too far out of order"):
        list(pieces(path, 1, mapping=mapping, most=50))


def test_a_second_file_without_times_has_as_many_rows(tmp_path: Path) -> None:
    path, mapping = streams(tmp_path, lambda t: t)
    lines = (tmp_path / "log_u.csv").read_text(encoding="utf-8").splitlines()
    (tmp_path / "log_u.csv").write_text(
        "\n".join(["x,u", *(f"0,{line.partition(',')[2]}" for line in lines[1:]), ""]), encoding="utf-8"
    )
    whole = read_log(path, 1, mapping=mapping)
    np.testing.assert_array_equal(whole.tau[:, 0], np.sin(whole.t))
    same(whole, list(pieces(path, 1, mapping=mapping, most=50)), 50)


@pytest.mark.parametrize("unit", ["s", "ns"])
def test_dates_count_from_the_first_sample(unit: str, tmp_path: Path) -> None:
    path = tmp_path / "log.csv"
    factor = {"s": 1, "ns": 10**9}[unit]
    rows = [f"{(1777809600 + k) * factor},{k},{k}" for k in range(300)]
    path.write_text("\n".join(["when,q1,tau1", *rows, ""]), encoding="utf-8")
    mapping = map_of_text(f"t: 'when[{unit}]'\n")
    whole = read_log(path, 1, mapping=mapping)
    assert whole.date == 1777809600.0
    assert whole.t[0] == 0.0
    same(whole, list(pieces(path, 1, mapping=mapping, most=70)), 70)
    path.write_text(path.read_text(encoding="utf-8").replace("when", "t"), encoding="utf-8")
    assert read_log(path, 1).date == (1777809600.0 if unit == "s" else None)


@pytest.mark.thorough
def test_a_bag_of_several_writers(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Messages of two files that overlap come in the order of their recording."""
    monkeypatch.setattr(windows, "WINDOW", 512)
    folder = tmp_path / "all"
    folder.mkdir()
    for k in (0, 1):
        log = a_log(60)
        late = Log(log.t + 0.2 * k + 0.001, log.q, log.qd, None, log.tau)
        path = bag(late, tmp_path / f"part{k}", ".mcap")
        path.rename(folder / f"part_{k}.mcap")
    whole = read_log(folder, 3, mapping=MAP)
    assert (np.diff(whole.t) >= 0).all()
    same(whole, list(pieces(folder, 3, mapping=MAP, most=25)), 25)


@pytest.mark.skipif(not hasattr(os, "posix_spawn"), reason="missing: os.posix_spawn; only POSIX has it")
@pytest.mark.thorough
def test_memory_does_not_grow(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import tracemalloc

    monkeypatch.undo()
    peaks = []
    for samples in (60_000, 240_000):
        path = tmp_path / "log.csv"
        path.write_text(a_log(samples).csv(), encoding="utf-8")
        tracemalloc.start()
        assert sum(part.samples for part in pieces(path, 3, most=5000)) == samples
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    assert peaks[1] < 1.2 * peaks[0]
