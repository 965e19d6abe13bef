"""A long closed tube that is filled: a bulge that runs along it does so at Maxwell's pressure, at which the work on the way
from the narrow part's state to that of the bulge is what the wall takes up (Chater and Hutchinson 1984; Kyriakides and
Chang 1991)."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq

from .wall_laws import Law, tensions


@dataclass(frozen=True)
class Uniform:
    """A uniform tube that bears its end caps. Stretches; the pressure over thickness by radius, pascal; the volume over
    the stress-free one."""

    around: float
    along: float
    pressure: float
    volume: float


def uniform(law: Law, around: float) -> Uniform:
    def unborne(along: float) -> float:
        hoop, axial = tensions(law, around, along)
        return axial - hoop * around / (2 * along)  # the pressure on a cap pulls at its rim

    along = brentq(unborne, 0.5, 8.0, xtol=1e-13)
    hoop = tensions(law, around, along)[0]
    return Uniform(around, along, hoop / (around * along), around**2 * along)


def maxwell(law: Law, largest: float) -> tuple[Uniform, Uniform]:
    """The narrow part and the bulge, of a law whose pressure rises, falls and rises again until `largest` around."""
    states = [uniform(law, around) for around in np.linspace(1.001, largest, 1500)]
    around, pressure, volume = (np.array([getattr(state, name) for state in states])
                                for name in ("around", "pressure", "volume"))
    turns = np.flatnonzero(np.diff(np.sign(np.diff(pressure)))) + 1
    if len(turns) != 2:
        raise ValueError(f"the pressure has {len(turns)} turns")
    peak, valley = turns
    work = CubicSpline(volume, pressure).antiderivative()

    def state_at(level: float, low: float, high: float) -> Uniform:
        return uniform(law, brentq(lambda each: uniform(law, each).pressure - level, low, high, xtol=1e-12))

    def both(level: float) -> tuple[Uniform, Uniform]:
        return (state_at(level, around[0], around[peak]), state_at(level, around[valley], around[-1]))

    def excess(level: float) -> float:
        narrow, wide = both(level)
        return float(work(wide.volume) - work(narrow.volume) - level * (wide.volume - narrow.volume))

    lowest, highest = pressure[valley], min(pressure[peak], pressure[-1])
    margin = 1e-3 * (highest - lowest)
    return both(brentq(excess, lowest + margin, highest - margin, xtol=1e-10 * highest))
