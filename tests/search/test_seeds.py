"""Many seeds, wherever they are searched: the best of them, and no other, in whatever order they come."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from records.made import ELBOW, arm, better, fast, recorded
from robodyn.cluster import Cluster
from robodyn.cluster.cluster import ThisProcess
from robodyn.counts import count
from robodyn.counts.objective import Objective
from robodyn.errors import ToolError
from robodyn.optimize.records import Record, parse_record
from robodyn.search import seeds as seeds_module
from robodyn.search.seeds import best_of_seeds, searched
from search.arms import search_for_a_moment

ROBOT = arm(ELBOW)
GOOD, PLAIN = better(ROBOT), recorded(ROBOT, fast(ROBOT))


@pytest.fixture(autouse=True)
def own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("ROBODYN_CACHE", str(tmp_path / "cache"))
    (tmp_path / "cache").mkdir(mode=0o700)
    return tmp_path / "cache"


class Scripted(ThisProcess):
    """Pieces come to what ``outcome`` says of their seed, the last one first."""

    def __init__(self, outcome: Callable[[int], str | Exception]) -> None:
        self.outcome = outcome

    def each(self, function: Any, tasks: Iterable[tuple[Any, tuple[Any, ...]]]) -> Iterator[tuple[Any, Any]]:
        def answer(seed: int) -> str:
            result = self.outcome(seed)
            if isinstance(result, Exception):
                raise result
            return result

        return super().each(answer, [(key, (key,)) for key, _ in reversed(list(tasks))])


def found_by(
    outcome: Callable[[int], str | Exception], monkeypatch: pytest.MonkeyPatch
) -> Callable[[Iterable[int]], Record]:
    @contextmanager
    def opened(on: str) -> Iterator[Cluster]:
        yield Scripted(outcome)

    monkeypatch.setattr(seeds_module, "open_cluster", opened)
    return lambda seeds: best_of_seeds(ROBOT, "anywhere", seeds, seconds=1.0)


def test_the_best_of_all_is_kept_whichever_comes_first(
    monkeypatch: pytest.MonkeyPatch, own_cache: Path
) -> None:
    for best in (0, 2):
        texts = {seed: (GOOD if seed == best else PLAIN).text() for seed in range(3)}
        search = found_by(texts.__getitem__, monkeypatch)
        record = search(range(3))
        assert count(record.program) == count(GOOD.program) != count(PLAIN.program)
    assert [path.suffix for path in (own_cache / "records").iterdir()] == [".record"]


def test_a_seed_that_fails_does_not_end_the_others(monkeypatch: pytest.MonkeyPatch) -> None:
    search = found_by(lambda seed: ToolError("no compiler") if seed == 1 else GOOD.text(), monkeypatch)
    assert count(search(range(3)).program) == count(GOOD.program)


def test_what_cannot_be_proven_is_not_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        seeds_module, "proved", lambda robot, function, program, *_: None if _is_good(program) else PLAIN
    )
    search = found_by(lambda seed: (GOOD if seed == 0 else PLAIN).text(), monkeypatch)
    assert search(range(2)) == PLAIN


def _is_good(program: Any) -> bool:
    return len(program.operations) == len(GOOD.program.operations)


@pytest.mark.thorough
def test_a_piece_searches_and_says_what_it_found(monkeypatch: pytest.MonkeyPatch) -> None:
    search_for_a_moment(monkeypatch)
    text = searched(ROBOT, "search", "inverse_dynamics", 1.0, 3, Objective(), [GOOD.text()])
    assert text.startswith("robodyn record")
    assert len(parse_record(text, "x").program.operations) <= len(GOOD.program.operations)
