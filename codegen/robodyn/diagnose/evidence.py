"""What the report tells of a diagnosis beside its findings: what was tried, what was shaded, what could be
seen at all."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict

from robodyn.counts.count import Count, count
from robodyn.diagnose.limits import MOST_TRIED
from robodyn.diagnose.result import Finding, Tried, Window
from robodyn.diagnose.select.limits import PRACTICAL
from robodyn.diagnose.select.outcome import Outcome
from robodyn.effects.catalogue import CATALOGUE
from robodyn.gate.gate import Gate
from robodyn.robot.model import Robot

#: Flags of motions that show little.
_POOR = frozenset({"motionless", "one_way", "narrow", "few_reversals"})


def tried(outcome: Outcome, findings: Sequence[Finding]) -> tuple[Tried, ...]:
    """The best candidates of the last look that were not named, each effect and joint once."""
    known = {(f.effect, f.joint) for f in findings}
    candidates: list[Tried] = []
    for one in sorted(outcome.last, key=lambda one: -one.gain):
        key = one.family.key
        if key in known or one.gain <= 0:
            continue
        known.add(key)
        reason = (
            "too small to matter beside the noise and the torque"
            if one.drop < PRACTICAL
            else "not there in enough parts of the log"
            if one.is_possible
            else "with numbers that it cannot have"
        )
        candidates.append(Tried(*key, one.gain, one.gain / max(one.error, 1e-300), reason))
        if len(candidates) == MOST_TRIED:
            break
    return tuple(candidates)


def windows(gate: Gate, findings: Sequence[Finding], shown: Mapping[str, str]) -> tuple[Window, ...]:
    """Contacts in the logs that are ``shown`` (names of series by hash), and gaps in the first, ``gate``."""
    stretches = []
    for finding in findings:
        name = shown.get(str(finding.parameters["log"].value)) if "log" in finding.parameters else None
        if CATALOGUE[finding.effect].place == "outside" and name is not None:
            start, end = (float(finding.parameters[edge].value) for edge in ("start", "end"))
            stretches.append(Window(name, start, end, "contact"))
    for before, after in zip(gate.segments, gate.segments[1:], strict=False):
        times = float(gate.log.t[before.stop - 1]), float(gate.log.t[after.start])
        stretches.append(Window("train", *times, "gap"))
    return tuple(stretches)


def operations(robot: Robot) -> Count:
    """The operations of the inverse dynamics."""
    from robodyn.kernels.generate import program

    return count(program(robot, "inverse_dynamics"))


def by_kind(counted: Count) -> Mapping[str, int]:
    """Of which kinds there are how many."""
    return {name: amount for name, amount in asdict(counted).items() if amount}


def log_facts(gate: Gate) -> dict[str, str]:
    """How long a log is, and how often it was sampled."""
    length = sum(part.stop - part.start for part in gate.segments) * gate.period
    return {
        "duration": f"{length:.4g} s",
        "rate": f"{1 / gate.period:.4g} Hz",
        "samples": f"{gate.log.samples}",
    }


def to_record(robot: Robot, gates: Sequence[Gate]) -> str | None:
    """What to record where the motion of the logs is too little to tell much."""
    poor = [flag for gate in gates for flag in gate.flags if flag.kind in _POOR]
    if not poor:
        return None
    seen = "; ".join(dict.fromkeys(f"{flag.where}: {flag.text}" for flag in poor))
    return f"a motion that shows more ({seen}), as `robodyn excite {robot.name}` designs it"


def doubtful(gates: Sequence[Gate]) -> bool:
    """Whether the gate suspects signs or the order of joints: then no name is to be trusted."""
    return any(flag.kind.startswith("perhaps") for gate in gates for flag in gate.flags)
