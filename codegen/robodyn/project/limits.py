"""Numbers that decide about a project."""

from __future__ import annotations

from typing import Final

#: A robodyn.toml or robodyn.lock with more bytes is refused [bytes]: thousands of robots need less.
LARGEST_FILE: Final = 8 << 20
#: Of a committed file no more is compared [bytes]; kernels of a hundred joints have a tenth of it.
LARGEST_OUTPUT: Final = 64 << 20
#: A budget beyond this is a slip of the keyboard [operations].
LARGEST_BUDGET: Final = 10**9
