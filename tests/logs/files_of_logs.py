"""The same log in every format that is read, as other programs write them."""

from __future__ import annotations

import io
import json
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn.logs.formats import LogFormat
from robodyn.logs.log import Log
from robodyn.logs.recording import Recording

Floats = NDArray[np.float64]

#: Names of the joints, base to tip, and how messages have them.
NAMES = ("base_joint", "upper_joint", "fore_joint")
SENT = (2, 0, 1)


def read_in_this_process(monkeypatch: pytest.MonkeyPatch) -> None:
    """Have all formats read here, where tests can change the length of a block."""

    def open_here(format: LogFormat, path: Path, file: str, gaps: bool) -> Recording:
        return format.open(path, file, gaps)

    monkeypatch.setattr("robodyn.logs.guard.open_guarded", open_here)


def groups_of(log: Log) -> dict[str, Floats]:
    """The arrays of ``log`` by the names of their columns."""
    groups = {"t": log.t, "q": log.q, "qd": log.qd, "qdd": log.qdd, "tau": log.tau}
    return {name: array for name, array in groups.items() if array is not None}


def write(log: Log, folder: Path, kind: str) -> Path:
    """``log`` in a file of that ``kind``, with the usual names."""
    path = folder / f"log{kind}"
    groups = groups_of(log)
    if kind in (".csv", ".parquet"):
        content = log.files(path.name)[path.name]
        path.write_bytes(content.encode() if isinstance(content, str) else content)
    elif kind == ".npz":
        np.savez(path, **groups)  # type: ignore[arg-type]
    elif kind == ".mat":
        path.write_bytes(matlab(groups))
    elif kind == ".h5":
        import h5py

        with h5py.File(path, "w") as file:
            for name, array in groups.items():
                file[name] = array.T  # as MATLAB has it
    elif kind == ".json":
        path.write_text(
            json.dumps({name: array.tolist() for name, array in groups.items()}), encoding="utf-8"
        )
    else:
        return bag(log, folder / f"bag{kind[1:]}", kind)
    return path


def matlab(groups: Mapping[str, Any], **options: Any) -> bytes:
    """The variables as MATLAB writes them, compressed unless the ``options`` say otherwise."""
    from scipy.io import savemat

    stream = io.BytesIO()
    savemat(stream, dict(groups), **{"do_compression": True, **options})
    return stream.getvalue()


def bag(
    log: Log,
    folder: Path,
    kind: str,
    *,
    stamps: bool = True,
    name_of: Callable[[int], Sequence[int]] = lambda _: SENT,
    packed: bool = False,
) -> Path:
    """``log`` as joint states: a file of that ``kind`` in a folder with metadata. ``name_of``: the order of
    the joints in a message; ``stamps``: whether messages have their own times."""
    from rosbags.rosbag2 import StoragePlugin, Writer
    from rosbags.rosbag2.enums import CompressionFormat, CompressionMode
    from rosbags.typesys import Stores, get_typestore

    store = get_typestore(Stores.ROS2_JAZZY)
    state, header = store.types["sensor_msgs/msg/JointState"], store.types["std_msgs/msg/Header"]
    time = store.types["builtin_interfaces/msg/Time"]
    plugin = StoragePlugin.MCAP if kind == ".mcap" else StoragePlugin.SQLITE3
    writer = Writer(folder, version=9, storage_plugin=plugin)
    if packed:
        mode = CompressionMode.STORAGE if kind == ".mcap" else CompressionMode.MESSAGE
        writer.set_compression(mode, CompressionFormat.ZSTD)
    with writer:
        topic = writer.add_connection("/joint_states", state.__msgtype__, typestore=store)
        for k in range(log.samples):
            nanoseconds = round(float(log.t[k]) * 1e9)
            order = list(name_of(k))
            stamp = time(*divmod(nanoseconds, 10**9)) if stamps else time(0, 0)
            velocity = np.empty(0) if log.qd is None else np.ascontiguousarray(log.qd[k, order])
            message = state(
                header(stamp, "world"), [NAMES[j] for j in order], np.ascontiguousarray(log.q[k, order]),
                velocity, np.ascontiguousarray(log.tau[k, order]),
            )  # fmt: skip
            data = store.serialize_cdr(message, state.__msgtype__)
            writer.write(topic, nanoseconds, data)
    return next(iter(sorted(folder.glob(f"*{kind}*"))))
