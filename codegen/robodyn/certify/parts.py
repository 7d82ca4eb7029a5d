"""The proofs one by one: each runs its tools on the files of a kernel and says what came out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from robodyn.certify import eva, misra, stack
from robodyn.certify.finding import Finding, Tell, not_run
from robodyn.certify.plan import ProofOptions, Subject
from robodyn.certify.tools import run, version
from robodyn.emit.freestanding import freestanding_calls
from robodyn.emit.misra import deviations
from robodyn.emit.render import environment
from robodyn.tools.programs import CPPCHECK, FRAMA_C, GCC

#: How long Eva, a compiler or cppcheck may take [s].
PATIENCE = 600.0


def prove_eva(subject: Subject, proofs: ProofOptions, folder: Path, tell: Tell) -> Finding:
    """No run-time error, whatever the inputs are."""
    frama_c = FRAMA_C.path()
    if frama_c is None:
        return not_run("eva", FRAMA_C)
    name = subject.generated.unit.robot.name
    context = eva.driver_context(name, subject.generated.signatures)
    driver = f"{name}_eva.c"
    text = environment().get_template("prove/eva_driver.c.j2").render(context)
    (folder / driver).write_text(text, encoding="utf-8", newline="\n")
    arguments = [*eva.OPTIONS, f"{name}.c", driver]
    tell("Frama-C Eva")
    done = run([frama_c, *arguments], folder, PATIENCE)
    analysis = eva.read(done, PATIENCE)
    functions = ", ".join(s.function for s in subject.generated.signatures)
    return Finding(
        "eva",
        "proved" if analysis.proved else "failed",
        f"{functions}, sine and cosine: no undefined behaviour for any inputs, infinite ones and NaN among "
        "them, in arrays that are large enough and do not overlap.",
        (
            analysis.reason
            or f"0 alarms; {analysis.statements[0]} of {analysis.statements[1]} statements reached",
        ),
        {
            "alarms": analysis.alarms,
            "said": list(analysis.messages),
            "functions": list(analysis.functions),
            "statements": list(analysis.statements),
            "reason": analysis.reason,
        },
        (f"Frama-C {version(FRAMA_C)}",),
        (" ".join(["frama-c", *arguments]),),
        {driver: text, "eva.txt": done.output},
    )


def prove_stack(subject: Subject, proofs: ProofOptions, folder: Path, tell: Tell) -> Finding:
    """The most stack a call needs, machine by machine."""
    machines = stack.machines(freestanding=bool(freestanding_calls(subject.generated.unit)))
    if all(machine.tool.path() is None for machine in machines):
        return not_run("stack", GCC)
    source = f"{subject.generated.unit.robot.name}.c"
    symbols = [s.symbol for s in subject.generated.signatures]
    lines: list[str] = []
    rows: list[dict[str, Any]] = []
    tools: dict[str, None] = {}
    commands: list[str] = []
    bad = False
    known = 0
    stand_ins = {f"{stack.STAND_IN}/{name}": text for name, text in stack.HEADERS.items()}
    (folder / stack.STAND_IN).mkdir()
    for name, text in stand_ins.items():
        (folder / name).write_text(text, encoding="utf-8", newline="\n")
    for machine in machines:
        if machine.tool.path() is None:
            lines.append(f"{machine.name}: not run, needs {machine.tool.remedy}")
            rows.append(_stack_row(machine, stack.Depth(None, None, (), f"needs {machine.tool.remedy}")))
            continue
        tell(f"stack, {machine.name}")
        usage = stack.measure(machine, source, symbols, folder)
        tools[version(machine.tool)] = None
        commands.append(" ".join(stack.command(machine, source)))
        if isinstance(usage, str):
            bad = True
            lines.append(f"{machine.name}: not compiled: {usage}")
            rows.append(_stack_row(machine, stack.Depth(None, None, (), f"not compiled: {usage}")))
            continue
        for depth in usage:
            known += depth.size is not None and not depth.beyond
            bad = bad or depth.size is None or not depth.only_helpers
            size = "no bound" if depth.size is None else f"{depth.size} B"
            note = f" ({depth.reason})" if depth.reason else ""
            lines.append(f"{machine.name}: {depth.function} {size}{note}")
            rows.append(_stack_row(machine, depth))
    return Finding(
        "stack",
        "proved" if known and not bad else "failed",
        "The most stack that a call needs, with all that it calls: no recursion, no call by a pointer, no "
        "array of a length that is known only at run time.",
        tuple(lines),
        {"stack": rows},
        tuple(tools),
        tuple(commands),
        stand_ins,
    )


def _stack_row(machine: stack.Machine, depth: stack.Depth) -> dict[str, Any]:
    """A row of ``proof.json``: its members are the same where nothing could be measured."""
    return {
        "machine": machine.name,
        "function": depth.function,
        "bytes": depth.size,
        "chain": list(depth.chain),
        "beyond": list(depth.beyond),
        "reason": depth.reason,
    }


def prove_misra(subject: Subject, proofs: ProofOptions, folder: Path, tell: Tell) -> Finding:
    """Every finding of MISRA C:2012 that is left is explained in the kernel."""
    cppcheck = CPPCHECK.path()
    if cppcheck is None:
        return not_run("misra", CPPCHECK)
    source = f"{subject.generated.unit.robot.name}.c"
    tell("MISRA C:2012")
    control = folder / f"{subject.generated.unit.robot.name}_control.c"
    control.write_text(misra.CONTROL, encoding="utf-8", newline="\n")
    misra.check_control(run([cppcheck, *misra.OPTIONS, control.name], folder, PATIENCE))
    options = misra.options(subject.generated.unit)
    done = run([cppcheck, *options, source], folder, PATIENCE)
    report = misra.read(done)
    explained = deviations(subject.generated.unit)
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
