"""Motion above the cutoff of what is compared."""

from __future__ import annotations

import numpy as np

from robodyn.logs.log import Log
from robodyn.logs.signals import low_pass, signals_of

RATE, CUTOFF = 1000.0, 15.0


def test_what_is_measured_once_is_low_passed_once() -> None:
    """A link that rings at 14 Hz: its acceleration is compared with a torque that was not filtered before."""
    t = np.arange(10_000) / RATE
    wave = 2 * np.pi * 14.0
    q = np.stack([np.sin(t) + 1e-3 * np.sin(wave * t)], axis=1)
    q += 1e-6 * np.random.default_rng(1).standard_normal(q.shape)
    log = Log(t, q, None, None, np.zeros_like(q))
    true = -np.sin(t) - 1e-3 * wave**2 * np.sin(wave * t)
    once = low_pass(true, RATE, CUTOFF)[1000:-1000]

    def missed(wider: float) -> float:
        s = signals_of(log, cutoff=CUTOFF, wider=wider)
        ours = s.filtered(s.qdd)[1000 : len(once) + 1000, 0]
        return float(np.sqrt(np.mean((ours - once[: len(ours)]) ** 2) / np.mean(once**2)))

    assert missed(3.0) < 0.02
    assert missed(1.0) > 0.2


def test_where_only_noise_is_above_the_cutoff_the_filter_stays() -> None:
    t = np.arange(10_000) / RATE
    q = np.sin(2 * np.pi * np.round(t[:, None]) * 0)  # a joint that stands
    q = q + 1e-4 * np.random.default_rng(2).standard_normal(q.shape)
    log = Log(t, q, None, None, np.zeros_like(q))
    plain, wide = (signals_of(log, cutoff=CUTOFF, wider=wider).qdd for wider in (1.0, 3.0))
    assert np.std(wide) < 1.2 * np.std(plain)
