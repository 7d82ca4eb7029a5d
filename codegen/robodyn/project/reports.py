"""A comparison shown: as JSON, text, JUnit's XML and Markdown; and an
error that left nothing to compare, in the same formats."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping
from typing import Final

from robodyn.draw.tables import aligned
from robodyn.errors import RobodynError, escaped
from robodyn.project.compare import Report

_KINDS: Final = ("mul", "add", "div", "total", "sincos")
_HEADS: Final = ("robot", "function", *_KINDS, "change", "budget")


def as_json(shown: Report) -> str:
    """``shown`` as indented JSON."""
    return json.dumps(shown, indent=2, ensure_ascii=False) + "\n"


def as_text(shown: Report) -> str:
    """The counts that changed as a table, and how many did not; lines of a terminal."""
    rows = list(_rows(shown))
    lines = aligned([_HEADS, *rows], left=(0, 1, 7, 8)) if rows else []
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
    lines = [_XML, f"<testsuites {_totals([case for _, cases in suites for case in cases])}>"]
    for name, cases in suites:
        lines.append(f"  <testsuite name={quoteattr(name)} {_totals(cases)}>")
        for case, faults in cases:
            head = f"    <testcase classname={quoteattr(name)} name={quoteattr(case)}"
            failure = f"      <failure message={quoteattr('; '.join(faults))}/>"
            lines += [f"{head}>", failure, "    </testcase>"] if faults else [f"{head}/>"]
        lines.append("  </testsuite>")
    return "\n".join([*lines, "</testsuites>"]) + "\n"


_XML: Final = '<?xml version="1.0" encoding="UTF-8"?>'


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
            pairs = [counts for counts in (each["locked"], each["count"]) if counts is not None]
            cells = (  # 262, or 260 -> 262 where it was another
                " -> ".join(dict.fromkeys(str(counts.get(kind, 0)) for counts in pairs)) for kind in _KINDS
            )
            budget = ", ".join(f"{kind} {most}" for kind, most in (each["budget"] or {}).items()) or "-"
            yield name, function, *cells, each["status"], budget + " over" * ((name, function) in over)


def _summary(shown: Report) -> str:
    robots = [robot for robot in shown["robots"] if not robot["gone"]]
    functions = [each for robot in robots for each in robot["functions"] if each["count"] is not None]
    total = sum(each["count"]["total"] for each in functions)
    changed = sum(each["status"] != "same" for robot in shown["robots"] for each in robot["functions"])
    packages = sum(robot["package"] is not None for robot in robots)
    amounts = {"robot": len(robots) - packages, "package": packages, "function": len(functions)}
    amounts["operation"] = total
    texts = [
        f"{amount} {noun}{'s' * (amount != 1)}"
        for noun, amount in amounts.items()
        if amount or noun != "package"
    ]
    return f"{', '.join(texts)}; {f'{changed} changed' if changed else 'no count changed'}"


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
    "json": lambda error: as_json({"error": error.to_dict()}),
    "junit": error_as_junit,
    "markdown": lambda error: f"### robodyn: nothing was compared\n\n- {_escaped(error.message())}\n",
}
