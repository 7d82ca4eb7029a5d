"""Where work can run, and what is said where it cannot."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator

import numpy as np  # noqa: F401 - its library is there from the start
import pytest
from threadpoolctl import threadpool_info, threadpool_limits

from cluster.functions import picky, square
from robodyn.cluster import Done, Failed, open_cluster
from robodyn.cluster.opening import compare
from robodyn.cluster.work import ONE_THREAD, WrongWorker, likeness, outcome, work, worker_likeness
from robodyn.errors import InputError, ToolError
from robodyn.toolchain.sources import own_key


@pytest.mark.parametrize(
    "on",
    ["", "there", "local:", "local:0", "local:-1", "local:2x", "here:2", "dask://", "dask://host",
     "dask://host:", "dask://host:port", "dask:host:8786", "tcp://host:8786", "dask://a b:1", "dask://host:1/x",
     "local:1025", "dask://host:0", "dask://host:65536"],
)  # fmt: skip
def test_what_is_no_place(on: str) -> None:
    """Refused at once, and not after the time in which a scheduler would answer."""
    with pytest.raises(InputError, match="no place where work could run") as error, open_cluster(on):
        pass
    assert error.value.found == repr(on)
    assert "dask://HOST:PORT" in str(error.value)


def blas_threads() -> set[int]:
    return {library["num_threads"] for library in threadpool_info() if library["user_api"] == "blas"}


@pytest.mark.parametrize("value", ["3", None])
def test_linear_algebra_has_one_thread_and_then_what_it_had(
    value: str | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Sums depend on the number of threads: in this process they would be others than in one of its own."""
    for name in ONE_THREAD:
        monkeypatch.setenv(name, value) if value else monkeypatch.delenv(name, raising=False)
    with threadpool_limits(2):
        with open_cluster("here"):
            assert {os.environ[name] for name in ONE_THREAD} == {"1"}
            assert blas_threads() == {1}
        assert blas_threads() == {2}
    assert {os.environ.get(name) for name in ONE_THREAD} == {value}


@pytest.mark.parametrize("on", ["local:2", "local", "dask://host:8786"])
def test_without_dask(on: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    missing = pytest.raises(ToolError, match=r"pip install 'robodyn\[fleet\]', or take --on here")
    with missing as error, open_cluster(on):
        pass
    assert error.value.exit_code == 3
    with open_cluster("here") as cluster:
        assert dict(cluster.each(square, [("a", (3,))])) == {"a": Done(9)}


@pytest.mark.parametrize("on", ["here", pytest.param("local:2", marks=pytest.mark.thorough)])
def test_each_result_comes_once_and_tasks_are_taken_as_there_is_room(
    on: str, capfd: pytest.CaptureFixture[str]
) -> None:
    count, ahead = (1, 0) if on == "here" else (2, 6)
    taken: list[int] = []

    def tasks() -> Iterator[tuple[int, tuple[int]]]:
        for k in range(50):
            taken.append(k)
            yield k, (k,)

    results: dict[int, Done | Failed] = {}
    with open_cluster(on) as cluster:
        assert cluster.count == count
        for key, result in cluster.each(picky, tasks()):
            assert key not in results
            results[key] = result
            assert len(taken) <= len(results) + ahead
    failed = results.pop(3)
    assert results == {k: Done(k) for k in range(50) if k != 3}
    assert isinstance(failed, Failed)
    assert isinstance(failed.error, InputError)
    assert (failed.error.found, str(failed.error)) == ("3", "three cannot be used; found 3")
    assert capfd.readouterr() == ("", "")


def raises_odd() -> None:
    class Odd(Exception):
        """Cannot be pickled: nobody else can import it."""

    raise Odd("1 and 2")


def test_an_exception_that_cannot_be_sent_is_sent_as_its_words() -> None:
    done, error = outcome(raises_odd, ())
    assert not done
    assert (type(error), str(error)) == (ToolError, "Odd: 1 and 2")


def test_another_robodyn_does_not_work() -> None:
    assert work(own_key(), square, (3,)) == (True, 9)
    with pytest.raises(WrongWorker, match=r"has another robodyn; found .*; expected the sources 01234567"):
        work("0123456789", square, (3,))


@pytest.mark.parametrize("name", ["robodyn", "Python", "numpy", "distributed"])
def test_other_versions_are_refused(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for variable in ONE_THREAD:
        monkeypatch.setenv(variable, "1")
    compare("the worker tcp://a:1", worker_likeness())
    theirs = {**likeness(), name: "0.1"}
    with pytest.raises(WrongWorker, match=rf"the worker tcp://a:1 has other versions.*found {name} 0\.1;"):
        compare("the worker tcp://a:1", theirs)
    for threads in ({"OMP_NUM_THREADS": "4"}, {}):
        for variable in ONE_THREAD:
            monkeypatch.delenv(variable, raising=False)
        for variable, value in threads.items():
            monkeypatch.setenv(variable, value)
        with pytest.raises(WrongWorker, match="more threads than one; start it with OMP_NUM_THREADS=1"):
            compare("a worker", worker_likeness())
