"""``robodyn.lock``: the same text from the same content, and back."""

from __future__ import annotations

from pathlib import Path

from robodyn.project.lock import Locked, lock_text, read_lock

LOCK = {
    "b": Locked("out/b", {"gravity": {"mul": 2, "total": 3}}, {"b.h": "00", 'src/"é\x7f".rs': "11"}),
    "a.1": Locked("generated/a", {"bias": {"mul": 1, "total": 1}, "gravity": {"mul": 2, "total": 2}}, {}),
}


def test_what_is_written_is_read(tmp_path: Path) -> None:
    path = tmp_path / "robodyn.lock"
    assert read_lock(path) is None
    path.write_text(lock_text(LOCK), encoding="utf-8")
    assert read_lock(path) == LOCK


def test_one_line_a_function_and_robots_in_order() -> None:
    text = lock_text(LOCK)
    assert text == lock_text(dict(reversed(LOCK.items())))
    assert text.index('[robots."a.1"]') < text.index("[robots.b]")
    assert "\ngravity = { mul = 2, total = 3 }\n" in text
    assert text.endswith("\n")
    assert not text.endswith("\n\n")
