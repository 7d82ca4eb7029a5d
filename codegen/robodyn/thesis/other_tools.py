"""What other tools need for the inverse dynamics of bundled robots, as robodyn's authors measured it.

One machine, the same numbers of the robots, the same counting (every binary ``*``, ``/``, ``+`` and ``-``;
factors of 1 and -1 free; sine and cosine apart). Sums of angles count as additions. The tools' versions were
not written down.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

SOURCE: Final = "measured by robodyn's authors, same machine, same counting"


@dataclass(frozen=True, slots=True)
class Peer:
    """A tool's operations for a robot; of some only the total was kept."""

    tool: str
    total: int
    mul: int | None = None
    add: int | None = None

    def to_dict(self) -> dict[str, object]:
        """As ``tables --json`` prints it."""
        return {"tool": self.tool, "mul": self.mul, "add": self.add, "total": self.total, "source": SOURCE}


OPENSYMORO: Final = "OpenSYMORO, base parameters"
_TOOLS: Final = (
    "SymPy, Newton-Euler and cse",
    "wrenfold",
    "CasADi SX, textbook Newton-Euler",
    "SymPyBotics",
    "SymForce",
    OPENSYMORO,
)


def _row(*figures: tuple[int, int] | None) -> tuple[Peer, ...]:
    return tuple(
        Peer(tool, mul + add, mul, add)
        for tool, (mul, add) in (
            (tool, figure) for tool, figure in zip(_TOOLS, figures, strict=True) if figure is not None
        )
    )


PEERS: Final[dict[str, tuple[Peer, ...]]] = {
    "puma560_3dof_d3": _row((134, 82), (117, 74), (107, 70), (107, 70), (98, 64), (85, 57)),
    "puma560_d2": _row((399, 277), (346, 239), (257, 179), (255, 178), (231, 161), (192, 139)),
    "stanford_3dof_d3": _row((80, 42), (65, 42), (77, 48), (71, 44), (59, 38), (46, 26)),
    "stanford_d3": _row((376, 249), (313, 226), (226, 157), (229, 155), (196, 137), (142, 96)),
    "ur10": _row(None, (365, 250), (267, 187), None, (238, 167), (184, 134)),
    "puma560_rotor_in_link": (Peer(OPENSYMORO, 368),),
    "puma560_full": (Peer(OPENSYMORO, 568),),
    "stanford_full": (Peer(OPENSYMORO, 473),),
    "rx90": (Peer(OPENSYMORO, 513),),
    "panda": (Peer(OPENSYMORO, 649),),
    "iiwa": (Peer(OPENSYMORO, 624),),
}
"""By the name of the bundled robot."""
