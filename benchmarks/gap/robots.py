"""The arms with real logs that may be shipped, and how their logs are filtered."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from benchmarks.gap.recordings import Motion, motion, read

from robodyn.robot import load
from robodyn.robot.model import Robot

_EXAMPLES = Path(__file__).parents[2] / "examples"


@dataclass(frozen=True, slots=True)
class RealArm:
    """An arm with its logs in ``folder``: a ``description``, the ``logs`` by pattern, the ``cutoff`` [Hz] of
    the yardstick's low-pass and, where samples are uneven, its ``raster`` [s]."""

    folder: Path
    description: str
    logs: str
    cutoff: float
    raster: float | None = None

    def robot(self) -> Robot:
        """The description, without what is missing in it."""
        return load(str(self.folder / self.description), warn=lambda _: None)

    def paths(self) -> list[Path]:
        """Its logs, in order."""
        return sorted(self.folder.glob(self.logs))

    def motions(self) -> list[Motion]:
        """Its logs by the yardstick's rule."""
        return [motion(read(path), self.cutoff, self.raster) for path in self.paths()]


ARMS = {
    "kr300": RealArm(_EXAMPLES / "real" / "kr300", "kr300.yaml", "kr300_?.csv", 10.0),
    "ur10_bag": RealArm(_EXAMPLES / "real" / "ur10_bag", "ur10_bag.yaml", "ur10_bag.csv", 8.0),
    "panda_bag": RealArm(_EXAMPLES / "real" / "panda_bag", "panda_bag.yaml", "panda_bag.csv", 3.0),
    "servo": RealArm(_EXAMPLES / "real" / "servo", "xl330.yaml", "xl330_kp*[!d].csv", 15.0, 0.005),
    "tx40": RealArm(_EXAMPLES / "tx40", "tx40.yaml", "tx40.csv", 20.0),
}
