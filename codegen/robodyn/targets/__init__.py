"""Processors, one table: compiler flags, costs of operations, registers, clock, board.

>>> target_named("cortex-m4").name                      # an older name of the same processor
'cortex-m4f'
"""

from robodyn.targets.target import (
    TARGETS,
    Architecture,
    Board,
    Chip,
    Contraction,
    Costs,
    Region,
    Target,
    all_targets,
    compiled_targets,
    firmware_targets,
    planned_targets,
    target_named,
)  # fmt: skip

__all__ = [
    "TARGETS", "Architecture", "Board", "Chip", "Contraction", "Costs", "Region", "Target", "all_targets",
    "compiled_targets", "firmware_targets", "planned_targets", "target_named",
]  # fmt: skip
