"""Have a tool make functions of an arm: ``python -m benchmarks.functions.worker TOOL FOLDER SECONDS F...``.

The arm's numbers and the states lie in FOLDER (arm.txt, states.npy). A line of JSON for each way to write a
function, as soon as it is there: its operations, its values at the states; and one when a function is done. A
process of its own, as some tools cannot share one; it is ended by the system where a function takes more than
SECONDS of processor time.
"""

from __future__ import annotations

import json
import resource
import sys
import time
from pathlib import Path

import numpy as np
from benchmarks.functions.tools import TOOLS
from benchmarks.peers.generators import parsed


def main(tool: str, place: str, seconds: str, *functions: str) -> int:
    """All ``functions``, one after another."""
    folder = Path(place)
    arm = parsed((folder / "arm.txt").read_text(encoding="utf-8"))
    states = np.load(folder / "states.npy")
    for function in functions:
        limit = int(time.process_time()) + 1 + int(seconds)
        resource.setrlimit(resource.RLIMIT_CPU, (limit, resource.RLIM_INFINITY))
        end: dict[str, object] = {"function": function}
        try:
            for operations, values in TOOLS[tool](arm, function, states, folder):
                count = operations.to_dict()
                print(json.dumps({"count": count, "values": values.tolist()}), flush=True)
        except Exception as error:  # whatever the tool cannot do is a result: it is named in the table
            end["why"] = f"{type(error).__name__}: {error}".splitlines()[0][:200]
        print(json.dumps(end), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
