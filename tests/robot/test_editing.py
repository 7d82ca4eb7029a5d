"""Descriptions edited in place: what an edit does not touch is the same to the byte."""

from __future__ import annotations

import difflib
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
import yaml

from robodyn.robot import Robot, bundled_names, bundled_text, read_text
from robodyn.robot.editing import Editor, NotInPlaceError
from robodyn.robot.rewriting import rewritten

TEXT = """\
# An arm   (odd   spaces)
name:   'arm'   # quoted so
links:   # base to tip
  - joint: revolute
    mass: 1.50   # kg, two places
    limits: {velocity:  3,
             torque: 0x10}   # broken over two lines
    # before the effects
    effects:
      - effect: spring   # a hose
        stiffness: 2.0
      # the last one
      - {effect: torque_bias, bias: 1e-2}

  - {joint: prismatic, mass: 2}   # in one line
# the end"""


def at(editor: Editor, *path: str | int) -> Any:
    """The node at ``path``, keys and indices from the root."""
    node = editor.root
    for step in path:
        node = editor.child(node, step) if isinstance(step, str) else node.value[step]
    return node


def _lines(old: str, new: str) -> list[str]:
    """The lines that go and come."""
    return [line for line in difflib.ndiff(old.splitlines(), new.splitlines()) if line[:1] in "-+"]


def _edited(text: str, edit: Callable[[Editor], object]) -> str:
    editor = Editor(text)
    edit(editor)
    return editor.render([])


@pytest.mark.parametrize(
    ("edit", "lines"),
    [
        (lambda e: None, []),
        (lambda e: e.set_key(at(e, "links", 0), "mass", "1.75", []),
         ["-     mass: 1.50   # kg, two places", "+     mass: 1.75   # kg, two places"]),
        (lambda e: e.set_key(at(e, "links", 0), "d", "0.1", [], ["joint", "d", "mass"]), ["+     d: 0.1"]),
        (lambda e: e.set_key(at(e, "links", 1), "d", "0.1", []),
         ["-   - {joint: prismatic, mass: 2}   # in one line",
          "+   - {joint: prismatic, mass: 2, d: 0.1}   # in one line"]),
        (lambda e: e.set_key(e.root, "title", "t", [], ["name", "title"]), ["+ title: t"]),
        (lambda e: e.change_list(at(e, "links", 0), "effects", [], add=["{effect: backlash, gap: 1}"]),
         ["+       - {effect: backlash, gap: 1}"]),
        (lambda e: e.change_list(e.root, "effects", [], add=["{effect: payload, mass: 1}"]),
         ["+ effects:", "+   - {effect: payload, mass: 1}"]),
        (lambda e: e.change_list(at(e, "links", 1), "effects", [], add=["one", "two"]),
         ["-   - {joint: prismatic, mass: 2}   # in one line",
          "+   - {joint: prismatic, mass: 2, effects: [one, two]}   # in one line"]),
        (lambda e: e.change_list(at(e, "links", 0), "effects", [], delete=[1]),
         ["-       - {effect: torque_bias, bias: 1e-2}"]),
        (lambda e: e.change_list(at(e, "links", 0), "effects", [], delete=[0, 1]),
         ["-     effects:", "-       - effect: spring   # a hose", "-         stiffness: 2.0",
          "-       # the last one", "-       - {effect: torque_bias, bias: 1e-2}", "+     # a hose",
          "+     # the last one"]),
        (lambda e: e.remove_key(at(e, "links", 0, "limits"), "velocity"),
         ["-     limits: {velocity:  3,", "-              torque: 0x10}   # broken over two lines",
          "+     limits: {torque: 0x10}   # broken over two lines"]),
    ],
)  # fmt: skip
@pytest.mark.parametrize("ends", ["\n", "\r\n"])
def test_only_what_is_edited_changes(edit: Callable[[Editor], object], lines: list[str], ends: str) -> None:
    text = TEXT.replace("\n", ends)
    new = _edited(text, edit)
    assert sorted(_lines(text, new)) == sorted(lines)
    assert new.count("\n") == new.count(ends)
    yaml.safe_load(new)


def test_comments_stand_above_the_first_edit_about_their_subject() -> None:
    editor = Editor(TEXT)
    editor.set_key(at(editor, "links", 0), "mass", "2", ["mass"])
    editor.set_key(at(editor, "links", 1), "mass", "3", ["mass", "tip"])
    editor.change_list(editor.root, "effects", ["load"], add=["x"])
    new = editor.render([(frozenset(["mass"]), ["one", "tab\there"]), (frozenset(["load"]), ["two"])])
    assert "  - joint: revolute\n    # one\n    # tab here\n    mass: 2   # kg" in new
    assert "\n# two\neffects:\n  - x\n" in new
    assert new.count("# one") == 1


def test_what_cannot_be_edited_in_place_is_refused() -> None:
    with pytest.raises(NotInPlaceError, match="line 2 is used by an alias too"):
        _edited("a: 1\nb: &x {c: 2}\nd: *x\n", lambda e: e.replace(at(e, "b", "c"), "3", []))

    def twice(e: Editor) -> None:
        for text in ("2", "3"):
            e.set_key(e.root, "a", text, [])

    with pytest.raises(NotInPlaceError, match="line 1 is changed in two ways"):
        _edited("a: 1\n", twice)
    with pytest.raises(NotInPlaceError, match="would be empty"):
        _edited("a:\n  - b: 1\n", lambda e: e.remove_key(at(e, "a", 0), "b"))


def _heavier(robot: Robot) -> Robot:
    links = tuple(replace(link, mass=link.mass + Fraction(1, 8)) for link in robot.links)
    return replace(robot, links=links)


@pytest.mark.parametrize("name", bundled_names())
def test_every_bundled_robot_keeps_its_other_lines(name: str) -> None:
    text = bundled_text(name)
    robot = read_text(text, warn=lambda _: None)
    target = _heavier(robot)
    new = rewritten(text, robot, target, range(len(robot.effects)))
    assert read_text(new, warn=lambda _: None) == target
    changed = _lines(text, new)
    assert len([line for line in changed if line[0] == "+"]) == robot.n
    assert all("mass" in line for line in changed)
