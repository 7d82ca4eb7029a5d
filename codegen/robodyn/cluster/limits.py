"""Every number by which work on several processes is done: below each its unit, and what it decides."""

from __future__ import annotations

from typing import Final

MOST_PROCESSES: Final = 1024
"""[-] ``local:N`` has at most so many."""

AHEAD: Final = 3
"""[-] So many pieces of work a process are under way: one in work, the others with the process or on their
way to it, so that it never waits. As many arguments and results are in memory, whatever there is to do."""

MEMORY: Final = 4 << 30
"""[bytes] A process of ``local:N`` that needs more (or more than its share of the machine's memory) is ended,
and its piece begun again."""

DEATHS: Final = 3
"""[-] A piece of work during which more processes than this have ended is tried once more on its own, as
often, and then given up."""

ATTEMPTS: Final = 10
"""[-] A piece whose result was lost so often, because schedulers or workers went, is given up."""

CONNECT: Final = 15.0
"""[s] A scheduler answers within this time, and has a worker,"""

RECONNECT: Final = 120.0
"""[s] or, where it did once, within this time again; then the work ends, and what is done stays done."""

POLL: Final = 0.25
"""[s] So often it is looked whether the scheduler is still there, while nothing is done."""

COUNT: Final = 2.0
"""[s] So often workers are counted."""
