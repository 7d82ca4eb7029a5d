"""The same log is the same log, whatever the format of its file and the units of its columns."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from logs.files_of_logs import NAMES, bag, groups_of, matlab, read_in_this_process, write
from recipes.copies import source_in_recipe
from robodyn.errors import InputError
from robodyn.logs import formats
from robodyn.logs.log import Log, read_log
from robodyn.logs.mapping import map_of_columns, map_of_text
from robodyn.registry import Registry

FORMATS = (".csv", ".parquet", ".npz", ".mat", ".h5", ".json", ".mcap", ".db3")
#: Joint states have their own names, and no accelerations.
JOINTS = f"joints: [{', '.join(NAMES)}]\nq: position.%s\nqd: velocity.%s\ntau: effort.%s\n"


def motion(samples: int = 300, seed: int = 1) -> Log:
    """Three joints that move, at times of whole nanoseconds."""
    rng = np.random.default_rng(seed)
    t = np.arange(samples) / 500.0
    phase = rng.uniform(0, 6, (3, 3))
    q = np.stack(
        [sum(np.sin((i + 1) * t * (j + 1) + phase[i, j]) for i in range(3)) for j in range(3)], axis=1
    )
    qd = np.gradient(q, t, axis=0)
    tau = rng.normal(size=q.shape) + 5 * q
    return Log(t, q, qd, None, tau)


def assert_same(one: Log, other: Log) -> None:
    assert groups_of(one).keys() == groups_of(other).keys()
    for name, array in groups_of(one).items():
        assert array.tobytes() == groups_of(other)[name].tobytes(), name


@pytest.fixture(scope="module")
def log() -> Log:
    return motion()


@pytest.mark.parametrize("kind", FORMATS)
def test_every_format_gives_the_same_arrays(kind: str, log: Log, tmp_path: Path) -> None:
    path = write(log, tmp_path, kind)
    mapping = map_of_text(JOINTS) if kind in (".mcap", ".db3") else None
    assert_same(read_log(path, 3, mapping=mapping), log)


def test_a_format_is_one_file(log: Log, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The recipe of CONTRIBUTING.md."""
    source = source_in_recipe("Add a format of logs", "codegen/robodyn/logs/formats/raw.py")
    (tmp_path / "raw.py").write_text(source, encoding="utf-8")
    monkeypatch.setattr(formats, "__path__", [*formats.__path__, str(tmp_path)])
    monkeypatch.setattr(formats, "FORMATS", Registry(formats.__name__, "FORMAT", formats.LogFormat))
    path = tmp_path / "log.raw"
    np.column_stack([log.t, log.q, log.tau]).tofile(path)
    assert formats.is_log(path)
    assert_same(read_log(path), replace(log, qd=None))


# --- recordings of ROS 2 ----------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", [".mcap", ".db3"])
@pytest.mark.parametrize("packed", [False, True])
def test_a_folder_and_its_file_alone_are_the_same(kind: str, packed: bool, log: Log, tmp_path: Path) -> None:
    path = bag(log, tmp_path / "bag", kind, packed=packed)
    mapping = map_of_text(JOINTS)
    assert_same(read_log(path, mapping=mapping), log)
    assert_same(read_log(path.parent, mapping=mapping), log)
    (path.parent / "metadata.yaml").unlink()
    assert_same(read_log(path.parent, mapping=mapping), log)


@pytest.mark.parametrize("kind", [".mcap", ".db3"])
def test_joints_go_by_their_names_in_every_message(kind: str, log: Log, tmp_path: Path) -> None:
    orders = [(0, 1, 2), (2, 1, 0), (1, 0, 2)]
    path = bag(log, tmp_path / "bag", kind, name_of=lambda k: orders[k % 7 % 3])
    assert_same(read_log(path, mapping=map_of_text(JOINTS)), log)


def test_messages_of_others_are_left_out(log: Log, tmp_path: Path) -> None:
    """A gripper that publishes on the same topic."""
    path = bag(log, tmp_path / "bag", ".mcap", name_of=lambda k: (0,) if k % 5 == 4 else (2, 0, 1))
    read = read_log(path, mapping=map_of_text(JOINTS))
    rows = np.arange(log.samples) % 5 != 4
    np.testing.assert_array_equal(read.q, log.q[rows])
    np.testing.assert_array_equal(read.t, log.t[rows])
    assert "60 of 300 rows lack these columns" in read.notes[0]


def test_without_stamps_the_times_of_recording_hold(log: Log, tmp_path: Path) -> None:
    path = bag(log, tmp_path / "bag", ".db3", stamps=False)
    assert_same(read_log(path, mapping=map_of_text(JOINTS)), log)
    stamped = bag(replace(log, t=log.t + 1.7e9), tmp_path / "dated", ".mcap")
    read = read_log(stamped, mapping=map_of_text(JOINTS + "t: received\n"))
    np.testing.assert_allclose(read.t, log.t, atol=3e-7)  # dates count from the first sample


def test_joints_of_unknown_order_are_refused_and_named(log: Log, tmp_path: Path) -> None:
    path = bag(log, tmp_path / "bag", ".db3")
    with pytest.raises(InputError, match="found 'fore_joint', 'base_joint', 'upper_joint'"):
        read_log(path, 3)


def test_a_recording_that_was_cut_off_is_read_to_there(log: Log, tmp_path: Path) -> None:
    path = bag(log, tmp_path / "bag", ".mcap")
    whole = path.read_bytes()
    path.write_bytes(whole[:-2000])
    read = read_log(path, mapping=map_of_text(JOINTS))
    np.testing.assert_array_equal(read.q, log.q[: read.samples])
    path.write_bytes(whole[: len(whole) // 2])
    with pytest.raises(InputError):  # nothing of its one chunk is there
        read_log(path, mapping=map_of_text(JOINTS))


# --- MATLAB -----------------------------------------------------------------------------------------------


def test_structures_cells_and_integers_of_matlab(tmp_path: Path) -> None:
    counts = np.arange(30, dtype=np.int16)[:, None] * np.array([1, 10], dtype=np.int16)
    cell = np.empty((1, 2), dtype=object)
    cell[0, 0], cell[0, 1] = np.arange(30.0), "words"
    data = {"log": {"q": counts, "inner": {"t": np.arange(30) * 0.1}}, "c": cell, "word": "hello"}
    for options in ({"do_compression": True}, {"do_compression": False}):
        path = tmp_path / "log.mat"
        path.write_bytes(matlab(data, **options))
        mapping = map_of_text("t: log.inner.t\nq: {columns: log.q, factor: 0.5}\ntau: [log.q.1, c.0]\n")
        read = read_log(path, mapping=mapping)
        np.testing.assert_array_equal(read.q, counts * 0.5)
        np.testing.assert_array_equal(read.tau, np.column_stack([counts[:, 1], np.arange(30.0)]))
        np.testing.assert_array_equal(read.t, np.arange(30) * 0.1)


def test_rows_and_columns_may_be_exchanged(tmp_path: Path) -> None:
    log = motion(50)
    path = tmp_path / "log.npz"
    np.savez(path, t=log.t[None, :], q=log.q.T, tau=log.tau)
    read = read_log(path)
    np.testing.assert_array_equal(read.q, log.q)
    np.testing.assert_array_equal(read.t, log.t)


def test_arrays_longer_than_any_is_wide(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("robodyn.logs.arrays.WIDEST", 20)
    read_in_this_process(monkeypatch)
    log = motion(50)
    path = tmp_path / "log.npz"
    np.savez(path, t=log.t, q=log.q, tau=log.tau, image=np.zeros((50, 30)))
    assert_same(read_log(path), replace(log, qd=None))


# --- several streams --------------------------------------------------------------------------------------


def test_streams_of_other_times_are_interpolated_at_those_of_q(tmp_path: Path) -> None:
    k = np.arange(400)
    (tmp_path / "a.csv").write_text(
        "t,q1\n" + "".join(f"{t!r},{x!r}\n" for t, x in zip((k * 0.01).tolist(), k.tolist(), strict=True))
    )
    late = 0.5 + np.arange(300) * 0.02 * (1 + 0 * k[:300])
    (tmp_path / "b.csv").write_text(
        "t,u\n" + "".join(f"{t!r},{3 * t!r}\n" for t in late.tolist() if not 1.0 < t < 1.2)
    )
    mapping = map_of_text("q: q1\ntau: {columns: u, file: '%s.csv'}\n")
    mapping = replace(
        mapping,
        groups={**mapping.groups, "tau": replace(mapping.groups["tau"], file=str(tmp_path / "b.csv"))},
    )
    read = read_log(tmp_path / "a.csv", mapping=mapping)
    assert read.t[0] == 0.5
    assert np.isnan(read.tau[(read.t > 1.01) & (read.t < 1.19)]).all()  # nothing is made up over a gap
    there = np.isfinite(read.tau[:, 0])
    np.testing.assert_allclose(read.tau[there, 0], 3 * read.t[there], rtol=1e-9)
    assert "interpolated" in read.notes[0]


def test_a_log_without_times_has_a_rate(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text("q_0,q_1,tau_0,tau_1\n" + "1,2,3,4\n" * 50)
    read = read_log(tmp_path / "a.csv", mapping=map_of_text("t: {rate: 100}\nq: q_%d\ntau: tau_%d[mNm]\n"))
    np.testing.assert_array_equal(read.t, np.arange(50) / 100.0)
    np.testing.assert_array_equal(read.tau[0], [0.003, 0.004])
    with pytest.raises(InputError, match="which columns of the file are t is not known"):
        read_log(tmp_path / "a.csv", mapping=map_of_columns("q=q_%d,tau=tau_%d"))
