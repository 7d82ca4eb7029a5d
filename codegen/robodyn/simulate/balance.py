"""The energy of a simulated robot, and whether it balances with work and loss."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from robodyn.arrays import Floats
from robodyn.drives.coupling import coupler_of
from robodyn.drives.drive import combined, layer_of, rigid_part
from robodyn.dynamics.arm import build_arm, build_motion, trigonometry_at
from robodyn.dynamics.reference import energies
from robodyn.simulate.system import System


@dataclass(frozen=True, slots=True, eq=False)
class Balance:
    """Energies [S] in J at the samples of a run: ``kinetic``, ``potential`` (gravity, springs, couplers,
    ripple); ``work`` done by motors and contacts since the start, ``loss`` to friction and damping."""

    kinetic: Floats
    potential: Floats
    work: Floats
    loss: Floats

    @property
    def residual(self) -> Floats:
        """Stored energy since the start less work plus loss [S] in J: the integration's error."""
        stored = self.kinetic + self.potential
        residual: Floats = stored - stored[0] - self.work + self.loss
        return residual

    @property
    def scale(self) -> float:
        """What the residual is measured by: the largest energy that was moved [J]."""
        stored = self.kinetic + self.potential
        sizes = [np.ptp(stored), np.abs(self.work).max(), np.abs(self.loss).max(), self.kinetic.max()]
        return float(max(sizes))

    @property
    def error(self) -> float:
        """The largest residual, as a share of :attr:`scale`."""
        largest = float(np.abs(self.residual).max())
        return largest / self.scale if self.scale > 0 else largest

    def to_dict(self) -> dict[str, float]:
        """Ends and error, for a log's provenance."""
        return {
            "stored": float((self.kinetic + self.potential)[-1] - (self.kinetic + self.potential)[0]),
            "work": float(self.work[-1]),
            "loss": float(self.loss[-1]),
            "error": self.error,
        }


def stored_energy(
    system: System, y: Floats, v: Floats, parameters: Mapping[str, float]
) -> tuple[Floats, Floats]:
    """Kinetic and potential energy [S] in J at coordinates ``y`` and velocities ``v`` [S, coordinates]."""
    robot, n = system.robot, system.robot.n
    arm = build_arm(rigid_part(robot, bare=True), float, parameters.__getitem__)
    q, qd = list(y[:, :n].T), list(v[:, :n].T)

    kinetic, potential = energies(arm, build_motion(arm, q, qd, [0.0] * n, trigonometry_at(q), float))
    layer = layer_of(robot, float, parameters.__getitem__, bare=True)
    motors = [y[:, k] for k in system.motors]
    speeds = [v[:, k] for k in system.motors]
    for i, drive in enumerate(layer.joints):
        kinetic = kinetic + drive.rotor * speeds[i] ** 2 / 2
        for acting, where in [(a, q[i]) for a in drive.link] + [(a, motors[i]) for a in drive.motor]:
            if acting.effect.potential is not None:
                potential = potential + acting.effect.potential(acting.values, where)
        if drive.coupler is not None:
            twist = motors[i] - q[i]
            potential = potential + coupler_of(drive.coupler).energy(drive.coupler.values, twist)
    for pair in layer.pairs:
        speed = combined(pair, speeds)
        kinetic = kinetic + pair.acting.values["inertia"] * speed**2 / 2
    zeros = np.zeros(len(y))
    return np.asarray(kinetic + zeros), np.asarray(potential + zeros)
