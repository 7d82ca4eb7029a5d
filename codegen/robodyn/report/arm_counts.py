"""What the functions of an arm cost, beside the thesis and other tools."""

from __future__ import annotations

from typing import Any, Final

from robodyn.counts import beside, count
from robodyn.counts.peers import TITLES, operations_of_peers, versions_of_peers
from robodyn.dynamics.functions import function_named
from robodyn.kernels.generate import Generated
from robodyn.robot.model import Robot

_OURS: Final = "robodyn"


def counts(robot: Robot, *generated: Generated) -> dict[str, Any]:
    """A record for each function of ``generated``, each once, with the operations of others where there are
    any; and the inverse dynamics of all of them as bars, least first."""
    others = operations_of_peers(robot)
    rows: dict[str, dict[str, Any]] = {}
    for one in generated:
        for signature, program in one.unit.functions:
            counted = count(program)
            printed = beside(robot, signature.function, counted)
            rows.setdefault(
                signature.function,
                {
                    "function": signature.function,
                    "purpose": function_named(signature.function).purpose,
                    **counted.to_dict(),
                    "thesis": None if printed is None else {**printed.to_dict(), "total": printed.total},
                    "peers": others.get(signature.function, {}),
                },
            )
    peers = [tool for tool in TITLES if any(tool in row["peers"] for row in rows.values())]
    return {
        "functions": list(rows.values()),
        "peers": {tool: TITLES[tool] for tool in peers},
        "versions": versions_of_peers() if peers else None,
        "bars": _bars(next(iter(rows.values()))),
    }


def _bars(row: dict[str, Any]) -> list[dict[str, Any]]:
    bars = [{"title": _OURS, "total": row["total"], "ours": True}]
    if row["thesis"] is not None:
        title = f"the thesis, Table {row['thesis']['table']}"
        bars.append({"title": title, "total": row["thesis"]["total"], "ours": False})
    bars += [{"title": TITLES[tool], "total": total, "ours": False} for tool, total in row["peers"].items()]
    return sorted(bars, key=lambda bar: int(bar["total"]))
