"""From a robot to the folder of a proof."""

from __future__ import annotations

import hashlib
import json
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from robodyn.certify.bounds import prove_bounds
from robodyn.certify.eva import prove_eva
from robodyn.certify.misra import prove_misra
from robodyn.certify.plan import PROOFS, Finding, ProofOptions, Subject, Tell, subject
from robodyn.certify.stack import prove_stack
from robodyn.emit.markdown import Markdown, markdown_environment
from robodyn.kernels.generate import Options
from robodyn.robot.model import Robot

_PARTS = {"gappa": prove_bounds, "eva": prove_eva, "stack": prove_stack, "misra": prove_misra}
assert tuple(_PARTS) == PROOFS


@dataclass(frozen=True, slots=True)
class Proof:
    """What was proven of a kernel, and the files that say so."""

    subject: Subject
    findings: tuple[Finding, ...]

    @property
    def failed(self) -> list[str]:
        """Proofs that failed."""
        return [f.name for f in self.findings if f.status == "failed"]

    @property
    def missing(self) -> dict[str, str]:
        """Proofs that were not run, and how to get what they need."""
        return {f.name: f.data["remedy"] for f in self.findings if f.status == "not run"}

    def to_dict(self) -> dict[str, Any]:
        """For JSON."""
        generated = self.subject.generated
        return {
            "robot": generated.unit.robot.name,
            "scalar": self.subject.scalar,
            "trig": generated.options.trig,
            "functions": [s.function for s in generated.signatures],
            "files": {
                name: hashlib.sha256(text.encode()).hexdigest() for name, text in self.subject.files.items()
            },
            "ranges": self._ranges(),
            "proved": not self.failed and not self.missing,
            "proofs": [f.to_dict() for f in self.findings],
        }

    def files(self) -> dict[str, str]:
        """Kernel, scripts, logs, PROOF.md and proof.json, text by path. Times are not in them: the same proof
        gives the same bytes."""
        files = dict(self.subject.files)
        for finding in self.findings:
            files |= finding.files
        data = _without_times(self.to_dict())
        template = markdown_environment().get_template("prove/PROOF.md.j2")
        context = {
            **data,
            "robot": Markdown(data["robot"]),
            "title": self.subject.robot.title,
        }  # an identifier
        files["PROOF.md"] = template.render(context, findings=self.findings)
        files["proof.json"] = json.dumps(data, indent=2, ensure_ascii=False, allow_nan=False) + "\n"
        return files

    def _ranges(self) -> list[dict[str, Any]]:
        """The limits of each joint that the bounds hold within, as text that reads back exactly."""
        rows = []
        for i, link in enumerate(self.subject.robot.links, 1):
            limits = link.joint.limits
            q, qd, qdd = limits.position or (0, 0), limits.velocity or 0, limits.acceleration or 0
            row = {"joint": i, "q": [str(float(x)) for x in q]}
            rows.append({**row, "qd": str(float(qd)), "qdd": str(float(qdd))})
        return rows


def prove(
    robot: Robot, ranged: Robot, options: Options, proofs: ProofOptions, tell: Tell = lambda _: None
) -> Proof:
    """Generate the kernel of ``robot`` and run ``proofs``; ``ranged`` is the robot with the ranges
    as its limits. Nothing is written but to a temporary folder.

    Raises
    ------
    InputError: an option or a number of the robot.
    ToolError: a tool does not work as it should.
    """
    plan = subject(robot, ranged, options)
    findings = []
    for name in PROOFS:
        if name in proofs.only:
            with tempfile.TemporaryDirectory(prefix="robodyn-") as place:
                folder = Path(place)
                for path, text in plan.files.items():
                    (folder / path).write_text(text, encoding="utf-8", newline="\n")
                findings.append(_PARTS[name](plan, proofs, folder, tell))
    return Proof(plan, tuple(findings))


def _without_times(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _without_times(x) for key, x in value.items() if key != "seconds"}
    return [_without_times(x) for x in value] if isinstance(value, list) else value
