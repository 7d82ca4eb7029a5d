"""MISRA C:2012 by cppcheck's addon: every finding, and whether the kernel explains it."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass

from robodyn.certify.tools import Done, last_lines
from robodyn.emit.unit import Unit, calls
from robodyn.errors import ToolError

_FORMAT = "{file}|{line}|{id}|{message}"
OPTIONS = (
    "--addon=misra",
    "--enable=all",
    "--std=c99",
    "--quiet",
    "--suppress=missingIncludeSystem",
    "--suppress=unusedFunction",
    f"--template={_FORMAT}",
)
#: For choices within choices: to follow values through them takes cppcheck hours, and no rule needs it.
_FEW_VALUES = "--valueflow-max-iterations=0"
#: A file that breaks two rules on purpose: the checker must see it, else it sees nothing at all.
CONTROL = "int broken(int x);\nint broken(int x)\n{\n    goto end;\nend:\n    return x + 010;\n}\n"
_CONTROL_RULES = {"7.1", "15.1"}
_LINE = re.compile(r"([^|\n]+)\|([0-9]+)\|([^|\n]+)\|(.*)")
_RULE = re.compile(r"misra-c2012-([0-9]+\.[0-9]+)\Z")


@dataclass(frozen=True, slots=True)
class Check:
    """``rules``: how often each rule is broken. ``others``: whatever else cppcheck says, word by word."""

    rules: dict[str, int]
    others: tuple[str, ...]


def options(unit: Unit) -> tuple[str, ...]:
    """What cppcheck is called with for the kernel of ``unit``."""
    return (*OPTIONS, _FEW_VALUES) if "select" in calls(unit) else OPTIONS


def read(done: Done) -> Check:
    """What cppcheck said.

    Raises
    ------
    ToolError: cppcheck failed.
    """
    if done.code != 0:
        raise ToolError("cppcheck does not come to an end", found=last_lines(done.output))
    rules: Counter[str] = Counter()
    others: list[str] = []
    for line in done.output.splitlines():
        match = _LINE.match(line)
        if match is None:
            if line.strip():
                others.append(line.strip())
            continue
        rule = _RULE.match(match[3])
        if rule:
            rules[rule[1]] += 1
        else:
            others.append(f"{match[1]}:{match[2]}: {match[4]} [{match[3]}]")
    return Check(dict(sorted(rules.items(), key=lambda item: _order(item[0]))), tuple(others))


def check_control(done: Done) -> None:
    """Make sure that the checker sees what is there.

    Raises
    ------
    ToolError: it does not.
    """
    missed = _CONTROL_RULES - set(read(done).rules)
    if missed:
        raise ToolError(
            "cppcheck's MISRA addon does not see what is wrong in a control file",
            found=last_lines(done.output),
            expected=f"rules {', '.join(sorted(_CONTROL_RULES))}",
            remedy="install the addons of cppcheck and Python",
        )


def _order(rule: str) -> tuple[int, ...]:
    return tuple(map(int, rule.split(".")))
