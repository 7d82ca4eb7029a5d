"""What a proof came to."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Literal

from robodyn.tools import Tool

#: Is told how far a proof is.
Tell = Callable[[str], None]
#: ``proved``: what it says holds. ``failed``: it does not, or could not be shown. ``not run``: a tool is
#: missing.
Status = Literal["proved", "failed", "not run"]


@dataclass(frozen=True, slots=True)
class Finding:
    """One proof: ``claim`` is what it shows in one sentence, ``lines`` what came out, for people; ``data``
    the same for programs. ``commands``, run in the folder of the proof, run it again."""

    name: str
    status: Status
    claim: str
    lines: tuple[str, ...] = ()
    data: dict[str, Any] = field(default_factory=dict)
    tools: tuple[str, ...] = ()
    commands: tuple[str, ...] = ()
    files: dict[str, str] = field(default_factory=dict)

    def to_dict(self) -> dict[str, Any]:
        """For JSON; files are left out."""
        return {
            "proof": self.name,
            "status": self.status,
            "claim": self.claim,
            "tools": list(self.tools),
            "commands": list(self.commands),
            **self.data,
        }


def not_run(name: str, tool: Tool) -> Finding:
    """The finding of a proof whose tool is missing."""
    remedy = f"needs {tool.remedy}"
    return Finding(name, "not run", f"not run: {remedy}", data={"remedy": remedy})
