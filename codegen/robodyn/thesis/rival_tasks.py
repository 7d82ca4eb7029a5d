"""The tasks that the other columns of Table 4.8 are of: 88 of unequal length, for the same Stanford arm.

Kasahara and Narita 1985 schedule the Newton-Euler equations of the Stanford arm in the tasks that Luh and Lin
1982 have cut them into. The task set is public: ``robot.stg`` of the Standard Task Graph Set (Tobita and
Kasahara 2002, A Standard Task Graph Set for Fair Evaluation of Multiprocessor Scheduling Algorithms, J. of
Scheduling 5), from which times and predecessors are taken here, its two empty tasks left out. What speaks for
its being theirs: all tasks together take 2483 units of 10 us, the 24.83 ms that are printed for one
processor. Which joint a task belongs to is not in it.
"""

from __future__ import annotations

from typing import Final

from robodyn.schedule.graph import TaskGraph

#: Milliseconds a unit of time.
UNIT_MS: Final = 0.01

#: Task by task, from 1: its time in units, and the tasks that it waits for.
_TASKS: Final = """
1 1 5:1 5:1 10:1 28:1,4 5:1 10:1 1:5,6 57:5 66:5 38:5 15:6 24:6 10:6 15:2,7,8 10:2 10:9 24:12,15,17
40:9,18 32:9 57:9 15:9 10:9 38:9 53:9 10:9 12:10,13 39:11,14,19 4:19 24:26,27,30 24:20 15:20 10:21 32:21
57:21 66:21 12:22,23 39:24,25,31 28:31 40:20,34 12:33,36 10:35 57:35 32:35 66:35 15:41 24:41 39:32,37
28:40 40:41,43 12:44,47 111:45 84:45 38:45 39:46,48,50 28:50 69:51 42:51 10:51 24:55,57,60 12:53,58
39:54,59,61 42:63 12:62,64 28:65 24:56 40:56 24:52,66,67 24:49 28:69 40:49,68 40:39,72 38:72 24:42,70,71
36:74,75 10:39 24:38,76,77 10:73 12:29,73 40:16,80 24:29 8:78,79 24:28,82,83 24:80 36:84,85 24:16
24:3,86,87
"""


def rival_graph() -> TaskGraph:
    """The graph of those tasks; all of them belong to link 1, as far as is known."""
    after, lengths = {}, {}
    for task, entry in enumerate(_TASKS.split(), 1):
        length, _, needed = entry.partition(":")
        lengths[task] = int(length)
        after[task] = frozenset(map(int, filter(None, needed.split(","))))
    return TaskGraph(after, dict.fromkeys(after, 1), lengths, dict.fromkeys(after, 1))
