"""Prony series: G(t) = 1 - sum f (1 - exp(-t / tau)), in parts of the stress at once."""
from __future__ import annotations

import numpy as np

Terms = list[tuple[float, float]]  # fraction, time (seconds)


def relaxation(terms: Terms, time):
    return 1 - sum(f * (1 - np.exp(-time / tau)) for f, tau in terms)


def storage_and_loss(terms: Terms, frequency: float) -> tuple[float, float]:
    """In parts of the modulus at once; frequency in hertz."""
    omega = 2 * np.pi * frequency
    turns = [(f, omega * tau) for f, tau in terms]
    storage = 1 - sum(f for f, _ in turns) + sum(f * w**2 / (1 + w**2) for f, w in turns)
    return storage, sum(f * w / (1 + w**2) for f, w in turns)


def creep(fraction: float, time_constant: float, time):
    """Compliance under a constant load of one term, in parts of the compliance at once: 1 / (1 - f) less a decay with
    tau / (1 - f)."""
    end = 1 / (1 - fraction)
    return end - (end - 1) * np.exp(-time * (1 - fraction) / time_constant)


def creep_after_ramp(fraction: float, time_constant: float, ramp: float, time):
    """Strain under a load that grows evenly over `ramp` seconds and stays, at times from then on, in parts of the strain at
    once under all of it: the convolution of `creep` with the load's rate."""
    end, slow = 1 / (1 - fraction), time_constant / (1 - fraction)
    return end - (end - 1) * np.exp(-time / slow) * slow / ramp * np.expm1(ramp / slow)
