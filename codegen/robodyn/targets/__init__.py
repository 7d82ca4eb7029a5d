"""Processors, one table: compiler flags, costs of operations, registers, clock, board.

>>> target_named("cortex-m4").name                      # an older name of the same processor
'cortex-m4f'
"""

from robodyn.targets.table import (
    TARGETS,
    all_targets,
    compiled_targets,
    firmware_targets,
    planned_targets,
    target_named,
)
from robodyn.targets.target import Architecture, Board, Chip, Contraction, Costs, Region, Target

__all__ = [
    "TARGETS",
    "Architecture",
    "Board",
    "Chip",
    "Contraction",
    "Costs",
    "Program",
    "Region",
    "Target",
    "all_targets",
    "compiled_targets",
    "firmware_targets",
    "planned_targets",
    "target_named",
]
