"""A comparison shown: for programs as JSON, and from that as text, as JUnit's XML and as Markdown; and an
error that left nothing to compare, in the same formats."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, Final

from robodyn.errors import RobodynError, escaped
from robodyn.project.compare import Comparison, Counted, RobotState

Report = dict[str, Any]

_KINDS: Final = ("mul", "add", "div", "total", "sincos")
_HEADS: Final = ("robot", "function", *_KINDS, "change", "budget")


def report(comparison: Comparison, written: Sequence[str] = ()) -> Report:
    """All that is shown of ``comparison``, as JSON has it, and the paths of files that were ``written``."""
    return {
        "project": comparison.project,
        "passed": not comparison.faults,
        "robots": [_robot(robot) for robot in comparison.robots],
        "written": list(written),
        "faults": [
            {"kind": fault.kind, "robot": fault.robot, "subject": fault.subject, "text": fault.text}
            for fault in comparison.faults
        ],
    }


def _robot(robot: RobotState) -> Report:
    return {
        "robot": robot.name,
        "package": robot.package,
        "gone": robot.gone,
        "files": [{"path": path, "fault": why} for path, why in robot.files.items()],
        "functions": [_function(counted) for counted in robot.functions],
        "account": [] if robot.account is None else [robot.account],
    }


def _function(counted: Counted) -> Report:
    same = counted.now == counted.before
    return {
        "function": counted.function,
        "count": counted.now,
        "locked": counted.before,
        "status": "same" if same else "worse" if counted.grown else _change(counted),
        "budget": dict(counted.budget) or None,
    }


def _change(counted: Counted) -> str:
    if counted.before is None:
        return "new"
    return "gone" if counted.now is None else "better"


def as_json(shown: Report) -> str:
    """``shown`` as indented JSON."""
    return json.dumps(shown, indent=2, ensure_ascii=False) + "\n"


def as_text(shown: Report) -> str:
    """The counts that changed as a table, and how many did not; lines of a terminal."""
    rows = [_HEADS, *_rows(shown)]
    lines = []
    if len(rows) > 1:
        widths = [max(len(row[k]) for row in rows) for k in range(len(_HEADS))]
        for row in rows:
            cells = (
                cell.ljust(width) if k < 2 or k > 6 else cell.rjust(width)
                for k, (cell, width) in enumerate(zip(row, widths, strict=True))
            )
            lines.append("  ".join(cells).rstrip())
    lines += [f"wrote {path}" for path in shown["written"]]
    return "".join(f"{line}\n" for line in (*lines, _summary(shown)))


def as_markdown(shown: Report) -> str:
    """The same for the comment of a pull request: verdict, faults, table."""
    verdict = "passed" if shown["passed"] else "failed"
    lines = [f"### robodyn: {shown['project']} {verdict}", ""]
    lines += [f"- {_escaped(fault['text'])}" for fault in shown["faults"]]
    lines += [""] if shown["faults"] else []
    rows = list(_rows(shown))
    if rows:
        lines += [f"| {' | '.join(_HEADS)} |", f"|---|---|{'---:|' * len(_KINDS)}---|---|"]
        lines += [f"| {' | '.join(_escaped(cell) for cell in row)} |" for row in rows]
        lines.append("")
    return "\n".join([*lines, _summary(shown)]) + "\n"


def as_junit(shown: Report) -> str:
    """A test suite for each robot, of its files and its functions; and one of the lock file."""
    from xml.sax.saxutils import quoteattr

    lock = [fault for fault in shown["faults"] if fault["kind"] == "lock"]
    suites = [(robot["robot"], list(_cases(robot, shown["faults"]))) for robot in shown["robots"]]
    suites.append(("robodyn.lock", [("up to date", [fault["text"] for fault in lock])]))
    lines = [
        _XML,
        f"<testsuites {_totals([c for _, s in suites for c in s])}>",
    ]
    for name, cases in suites:
        lines.append(f"  <testsuite name={quoteattr(name)} {_totals(cases)}>")
        for case, faults in cases:
            head = f"    <testcase classname={quoteattr(name)} name={quoteattr(case)}"
            if not faults:
                lines.append(f"{head}/>")
                continue
            lines.append(f"{head}>")
            lines.append(f"      <failure message={quoteattr('; '.join(faults))}/>")
            lines.append("    </testcase>")
        lines.append("  </testsuite>")
    return "\n".join([*lines, "</testsuites>"]) + "\n"


_XML: Final = '<?xml version="1.0" encoding="UTF-8"?>'


def error_as_json(error: RobodynError) -> str:
    """``{"error": ...}``, as every command prints it with ``--json``."""
    return json.dumps({"error": error.to_dict()}, indent=2, ensure_ascii=False) + "\n"


def error_as_markdown(error: RobodynError) -> str:
    """A verdict and the message."""
    return f"### robodyn: nothing was compared\n\n- {_escaped(error.message())}\n"


def error_as_junit(error: RobodynError) -> str:
    """One test that could not be carried out."""
    from xml.sax.saxutils import quoteattr

    count = 'tests="1" failures="0" errors="1"'
    return (
        f"{_XML}\n<testsuites {count}>\n"
        f'  <testsuite name="robodyn build" {count}>\n'
        '    <testcase classname="robodyn build" name="project">\n'
        f"      <error message={quoteattr(escaped(error.message()))}/>\n"
        "    </testcase>\n"
        "  </testsuite>\n"
        "</testsuites>\n"
    )


def _cases(robot: Report, faults: list[Report]) -> Iterator[tuple[str, list[str]]]:
    """What is tested of ``robot``, with the texts of its faults."""
    of_robot = [fault for fault in faults if fault["robot"] == robot["robot"]]
    subjects = [file["path"] for file in robot["files"]] + [each["function"] for each in robot["functions"]]
    for subject in subjects:
        yield subject, [fault["text"] for fault in of_robot if fault["subject"] == subject]


def _totals(cases: list[tuple[str, list[str]]]) -> str:
    return f'tests="{len(cases)}" failures="{sum(bool(faults) for _, faults in cases)}"'


def _rows(shown: Report) -> Iterator[tuple[str, ...]]:
    """The functions whose counts changed or are over their budgets."""
    over = {(fault["robot"], fault["subject"]) for fault in shown["faults"] if fault["kind"] == "budget"}
    for robot in shown["robots"]:
        for each in robot["functions"]:
            name, function = robot["robot"], each["function"]
            if each["status"] == "same" and (name, function) not in over:
                continue
            counts = [_cell(each["count"], each["locked"], kind) for kind in _KINDS]
            budget = ", ".join(f"{kind} {most}" for kind, most in (each["budget"] or {}).items())
            yield (
                name,
                function,
                *counts,
                each["status"],
                f"{budget or '-'}{' over' * ((name, function) in over)}",
            )


def _cell(now: Mapping[str, int] | None, before: Mapping[str, int] | None, kind: str) -> str:
    """``262``, or ``260 -> 262`` where it was another."""
    texts = [str(counts.get(kind, 0)) for counts in (before, now) if counts is not None]
    return " -> ".join(dict.fromkeys(texts))


def _summary(shown: Report) -> str:
    robots = [robot for robot in shown["robots"] if not robot["gone"]]
    functions = [each for robot in robots for each in robot["functions"] if each["count"] is not None]
    total = sum(each["count"]["total"] for each in functions)
    changed = sum(each["status"] != "same" for robot in shown["robots"] for each in robot["functions"])
    packages = sum(robot["package"] is not None for robot in robots)
    words = ", ".join(
        (
            _many(len(robots) - packages, "robot"),
            *([_many(packages, "package")] if packages else []),
            _many(len(functions), "function"),
            _many(total, "operation"),
        )
    )
    return f"{words}; {changed} changed" if changed else f"{words}; no count changed"


def _many(amount: int, noun: str) -> str:
    return f"{amount} {noun}{'s' * (amount != 1)}"


def _escaped(text: str) -> str:
    return "".join(f"\\{letter}" if letter in "\\`*_<>|[]#" else letter for letter in text)


#: By name of a format: what writes it.
FORMATS: Final[Mapping[str, Callable[[Report], str]]] = {
    "text": as_text,
    "json": as_json,
    "junit": as_junit,
    "markdown": as_markdown,
}

#: The same of an error that left nothing to compare.
ERRORS: Final[Mapping[str, Callable[[RobodynError], str]]] = {
    "text": lambda error: f"error: {error}\n",
    "json": error_as_json,
    "junit": error_as_junit,
    "markdown": error_as_markdown,
}
