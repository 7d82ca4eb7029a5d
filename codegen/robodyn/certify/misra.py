"""MISRA C:2012 by cppcheck's addon: every finding, and whether the kernel explains it."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

from robodyn.certify.plan import Finding, ProofOptions, Subject, Tell, last_lines, not_run, run, version
from robodyn.emit.unit import Unit, calls, misra_deviations
from robodyn.errors import ToolError
from robodyn.toolchain.running import Finished
from robodyn.tools.programs import CPPCHECK

_FORMAT = "{file}|{line}|{id}|{message}"
OPTIONS = (
    "--addon=misra", "--enable=all", "--std=c99", "--quiet", "--suppress=missingIncludeSystem",
    "--suppress=unusedFunction", f"--template={_FORMAT}",
)  # fmt: skip
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


def cppcheck_options(unit: Unit) -> tuple[str, ...]:
    """What cppcheck is called with for the kernel of ``unit``."""
    return (*OPTIONS, _FEW_VALUES) if "select" in calls(unit) else OPTIONS


def read(done: Finished) -> Check:
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
    ordered = sorted(rules, key=lambda rule: [int(number) for number in rule.split(".")])
    return Check({rule: rules[rule] for rule in ordered}, tuple(others))


def check_control(done: Finished) -> None:
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


def prove_misra(subject: Subject, proofs: ProofOptions, folder: Path, tell: Tell) -> Finding:
    """Every finding of MISRA C:2012 that is left is explained in the kernel."""
    cppcheck = CPPCHECK.path()
    if cppcheck is None:
        return not_run("misra", CPPCHECK)
    tell("MISRA C:2012")
    unit = subject.generated.unit
    source, control = f"{unit.robot.name}.c", f"{unit.robot.name}_control.c"
    (folder / control).write_text(CONTROL, encoding="utf-8", newline="\n")
    check_control(run([cppcheck, *OPTIONS, control], folder))
    options = cppcheck_options(unit)
    done = run([cppcheck, *options, source], folder)
    report = read(done)
    explained = misra_deviations(unit)
    open_ = sorted(set(report.rules) - set(explained))
    lines = [
        f"rule {rule}, {count} times: "
        + (f"explained in {source}: {explained[rule]}" if rule in explained else "NOT EXPLAINED")
        for rule, count in report.rules.items()
    ]
    lines += [f"besides: {text}" for text in report.others[:10]]
    return Finding(
        "misra",
        "failed" if open_ or report.others else "proved",
        f"MISRA C:2012, rules that cppcheck's addon checks: every finding in {source} and its header is "
        f"explained in the head of {source}.",
        tuple(lines or ["no finding"]),
        {"rules": report.rules, "explained": explained, "unexplained": open_, "others": list(report.others)},
        (version(CPPCHECK),),
        (" ".join(["cppcheck", *(f"'{o}'" if "|" in o else o for o in options), source]),),
        {"misra.txt": done.output},
    )
