"""A description's text edited in place: every byte that no edit touches stays, comments and spaces too.

PyYAML says where each value begins and ends; edits replace those characters. ``ruamel.yaml``, which writes a
whole text anew from what it has read, was weighed against this in ``docs/decisions/0019``.

The text has been read as a description before: it is small and not nested deep.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Hashable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

#: What an edit is about, so that a comment can be put above the first edit that is about the same.
Subject = Hashable
#: Comments, each by lines, with the subjects of the edits above which it belongs.
Comments = Sequence[tuple[frozenset[Subject], Sequence[str]]]


class NotInPlaceError(Exception):
    """The text cannot be changed where it stands; the message says why."""


@dataclass(frozen=True, slots=True)
class Edit:
    """``text`` in place of the characters ``start`` to ``end``; with an ``indent`` it is lines of their own
    after those. ``subjects``: what it is about."""

    start: int
    end: int
    text: str
    subjects: frozenset[Subject]
    indent: int | None = None


class Editor:
    """A YAML text, its tree of PyYAML nodes, and the edits so far."""

    def __init__(self, text: str) -> None:
        import yaml  # not at the top: who only reads a diagnosis does not need it

        self.text = text
        self.root: Any = yaml.compose(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))
        self.edits: list[Edit] = []
        self._line_end = "\r\n" if "\r\n" in text else "\n"
        self._uses: Counter[int] = Counter()
        self._count(self.root)

    def _count(self, node: Any) -> None:
        self._uses[id(node)] += 1
        for child in node.value if isinstance(node.value, list) else ():
            for part in child if isinstance(child, tuple) else (child,):
                self._count(part)

    def _refuse_alias(self, node: Any) -> None:
        if self._uses[id(node)] > 1:
            raise NotInPlaceError(f"line {node.start_mark.line + 1} is used by an alias too")

    # --- the tree -----------------------------------------------------------------------------------------

    @staticmethod
    def child(mapping: Any, key: str) -> Any:
        """The node of ``key``, or None."""
        return next((value for name, value in mapping.value if name.value == key), None)

    @staticmethod
    def index(mapping: Any, key: str) -> int:
        """Which child of ``mapping`` has the key."""
        return next(k for k, (name, _) in enumerate(mapping.value) if name.value == key)

    def _add_key(
        self, mapping: Any, key: str, text: str, subjects: Iterable[Subject], order: Sequence[str]
    ) -> None:
        """``text``, which begins with a new ``key``, behind the last child of ``mapping`` that comes before
        it in ``order``, else behind the first; a key that is not in ``order`` behind all."""
        place = -1
        if key in order and mapping.value:
            before = order[: order.index(key)]
            place = max((k for k, (name, _) in enumerate(mapping.value) if name.value in before), default=0)
        self.change(mapping, subjects, add=[text], after=place)

    def end(self, node: Any) -> int:
        """Where the characters of ``node`` end, comments and blank lines after it left out."""
        if isinstance(node.value, list) and not node.flow_style:
            last = node.value[-1]
            return self.end(last[1] if isinstance(last, tuple) else last)
        start: int = node.start_mark.index
        end: int = node.end_mark.index
        return start + len(self.text[start:end].rstrip())

    def _span(self, child: Any) -> tuple[int, int]:
        key, value = child if isinstance(child, tuple) else (child, child)
        return key.start_mark.index, self.end(value)

    def _end_of_line(self, position: int) -> int:
        end = self.text.find("\n", position)
        end = len(self.text) if end < 0 else end
        return end - 1 if self.text[:end].endswith("\r") else end

    def _start_of_line(self, position: int) -> int:
        return self.text.rfind("\n", 0, position) + 1

    def _dash(self, item: Any) -> int:
        return self.text.rindex("-", 0, item.start_mark.index)

    def _comments(self, start: int, end: int, indent: int) -> str:
        """The comments between, each behind a line break; what looks like one within quotes does no harm."""
        comments = re.findall(r"(?<!\S)#[^\r\n]*", self.text[start:end])
        return "".join(f"{self._line_end}{' ' * indent}{comment}" for comment in comments)

    # --- edits --------------------------------------------------------------------------------------------

    def replace(self, node: Any, text: str, subjects: Iterable[Subject]) -> None:
        """``text`` in place of the scalar or list ``node``."""
        self._refuse_alias(node)
        start, end = node.start_mark.index, self.end(node)
        if isinstance(node.value, list) and node.flow_style:
            kept = self._comments(start, end, 0)
            text += kept + self._line_end if kept else ""
        elif isinstance(node.value, list):
            end = self._end_of_line(end)
            text = f" {text}{self._comments(start, end, node.start_mark.column)}"
            start = len(self.text[:start].rstrip())
            if self.text[start - 1] != ":":
                raise NotInPlaceError(f"line {node.start_mark.line + 1} begins below a comment")
        if self.text[start:end] != text:
            self.edits.append(Edit(start, end, text, frozenset(subjects)))

    def set_key(
        self, mapping: Any, key: str, text: str, subjects: Iterable[Subject], order: Sequence[str] = ()
    ) -> None:
        """``key: text`` in ``mapping``: in place of the value that is there, else as a new key, behind those
        that come before it in ``order``."""
        node = self.child(mapping, key)
        if node is None:
            self._add_key(mapping, key, f"{key}: {text}", subjects, order)
        else:
            self.replace(node, text, subjects)

    def remove_key(self, mapping: Any, key: str, subjects: Iterable[Subject] = ()) -> None:
        """``mapping`` without ``key``; comments within its value stay."""
        self.change(mapping, subjects, delete=[self.index(mapping, key)])

    def change_list(
        self,
        mapping: Any,
        key: str,
        subjects: Iterable[Subject],
        *,
        delete: Sequence[int] = (),
        add: Sequence[str] = (),
        order: Sequence[str] = (),
    ) -> None:
        """The list at ``key`` of ``mapping`` without the items ``delete`` and with those of ``add`` at its
        end. A list that is not there begins with them, one that would be empty goes."""
        node = self.child(mapping, key)
        if node is not None and delete and len(delete) == len(node.value) and not add:
            self.remove_key(mapping, key, subjects)
        elif node is not None:
            self.change(node, subjects, delete=delete, add=add)
        elif add:
            flow = f"{key}: [{', '.join(add)}]"
            block = "\n".join([f"{key}:", *(f"  - {text}" for text in add)])
            self._add_key(mapping, key, flow if mapping.flow_style else block, subjects, order)

    def change(
        self,
        parent: Any,
        subjects: Iterable[Subject],
        *,
        delete: Sequence[int] = (),
        add: Sequence[str] = (),
        after: int = -1,
    ) -> None:
        """Children of ``parent`` deleted, by number, and others added after the child ``after``: values of a
        list, in a mapping ``key: value``."""
        if not delete and not add:
            return
        self._refuse_alias(parent)
        subjects = frozenset(subjects)
        if parent.flow_style:
            self._change_flow(parent, subjects, delete, add)
            return
        for k in delete:
            self._delete_block(parent, k)
        if add:
            child = parent.value[after]
            is_mapping = isinstance(child, tuple)
            first = parent.value[0]
            column = first[0].start_mark.column if is_mapping else self._column(self._dash(first))
            at = self._end_of_line(self._span(child)[1])
            for text in add:
                line = text if is_mapping else f"- {text}"
                self.edits.append(Edit(at, at, line, subjects, column))

    def _column(self, position: int) -> int:
        return position - self._start_of_line(position)

    def _change_flow(
        self, parent: Any, subjects: frozenset[Subject], delete: Sequence[int], add: Sequence[str]
    ) -> None:
        spans = [self._span(child) for child in parent.value]
        kept = [k for k in range(len(spans)) if k not in delete]
        if spans and not kept:
            self._cut(spans[0][0], spans[-1][1])
        for k in delete if kept else ():
            before = k > kept[0]
            gap = (spans[k - 1][1], spans[k][0]) if before else (spans[k][1], spans[k + 1][0])
            if "#" in self.text[slice(*gap)]:
                comma = gap[0] + _comma(self.text[slice(*gap)])
                self._cut(comma, comma + 1)
                self._cut(*spans[k])
            else:
                self._cut(min(gap[0], spans[k][0]), max(gap[1], spans[k][1]))
        if add:
            bracket = "{" if parent.id == "mapping" else "["
            at = spans[-1][1] if spans else self.text.index(bracket, parent.start_mark.index) + 1
            joined = ", ".join(add)
            self.edits.append(Edit(at, at, f", {joined}" if kept else joined, subjects))

    def _cut(self, start: int, end: int) -> None:
        """Within brackets: all gone but comments, whose lines must end."""
        kept = self._comments(start, end, 0)
        self.edits.append(Edit(start, end, kept + self._line_end if kept else "", frozenset()))

    def _delete_block(self, parent: Any, k: int) -> None:
        child = parent.value[k]
        start, end = self._span(child)
        if not isinstance(child, tuple):
            start = self._dash(child)
        line, margin = self._start_of_line(start), self._column(start)
        if self.text[line:start].strip():  # the first key of a list's item, beside the dash
            if k + 1 == len(parent.value):
                raise NotInPlaceError(f"line {parent.start_mark.line + 1} would be empty")
            following = self._span(parent.value[k + 1])[0]
            kept = self._comments(start, following, margin).lstrip()
            text = f"{kept}{self._line_end}{' ' * margin}" if kept else ""
            self.edits.append(Edit(start, following, text, frozenset()))
            return
        end = self._end_of_line(end)
        before = max(line - (2 if self.text[:line].endswith("\r\n") else 1), 0)
        self.edits.append(Edit(before, end, self._comments(start, end, margin), frozenset()))

    # --- the text -----------------------------------------------------------------------------------------

    def render(self, comments: Comments) -> str:
        """The text with all edits, and each of the ``comments`` above the first line whose edit is about one
        of its subjects."""
        edits = sorted(self.edits, key=lambda edit: (edit.start, edit.end))
        above: dict[int, list[str]] = {}
        for subjects, lines in comments:
            first = next((k for k, edit in enumerate(edits) if edit.subjects & subjects), None)
            if first is not None:
                above.setdefault(first, []).extend(lines)
        notes: list[Edit] = []
        for k, lines in above.items():
            edit = edits[k]
            if edit.indent is None:
                line = self._start_of_line(edit.start)
                while covering := next((one for one in edits if one.start < line < one.end), None):
                    line = self._start_of_line(covering.start)
                margin = re.match("[ ]*", self.text[line:])
                assert margin is not None
                shown = "".join(f"{margin.group()}{_comment(text)}{self._line_end}" for text in lines)
                notes.append(Edit(line, line, shown, frozenset()))
        done, position = [], 0
        numbered = [(edit, above.get(k, [])) for k, edit in enumerate(edits)]
        for edit, lines in sorted(
            [*((note, []) for note in notes), *numbered], key=lambda one: (one[0].start, one[0].end)
        ):
            if edit.start < position:
                raise NotInPlaceError(
                    f"line {self.text.count(chr(10), 0, edit.start) + 1} is changed in two ways"
                )
            done += [self.text[position : edit.start], self._shown(edit, lines)]
            position = edit.end
        return "".join([*done, self.text[position:]])

    def _shown(self, edit: Edit, comments: Sequence[str]) -> str:
        if edit.indent is None:
            return edit.text
        lines = [*(_comment(text) for text in comments), *edit.text.split("\n")]
        return "".join(f"{self._line_end}{' ' * edit.indent}{line}" for line in lines)


def _comma(gap: str) -> int:
    """Where the comma stands in what separates two values."""
    for match in re.finditer(r"#[^\n]*|,", gap):
        if match.group() == ",":
            return match.start()
    raise NotInPlaceError("a list without its comma")


def _comment(text: str) -> str:
    """``text`` as one comment."""
    return "# " + "".join(c if c.isprintable() else " " for c in text)
