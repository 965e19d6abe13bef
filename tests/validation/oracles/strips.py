"""Two strips joined end to end and drawn apart, held in width: the same force per width in both."""
from __future__ import annotations

from scipy.optimize import brentq

from .wall_laws import Law, tension


def in_series(laws: tuple[Law, Law], thicknesses: tuple[float, float], lengths: tuple[float, float], elongation: float,
              across: float = 1.0):
    """Stretches of both strips and force per width (newton / metre) for a total elongation (metres); `across`
    is the stretch at which the width is held."""

    def second(first: float) -> float:
        return (sum(lengths) + elongation - first * lengths[0]) / lengths[1]

    def force(index: int, stretch: float) -> float:
        return thicknesses[index] * tension(laws[index], stretch, across)

    first = brentq(lambda l: force(0, l) - force(1, second(l)), 0.5, 0.99 * sum(lengths, elongation) / lengths[0],
                   xtol=1e-15, rtol=1e-15)
    return first, second(first), force(0, first)
