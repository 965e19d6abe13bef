"""A column that stands on a clamp and bends under a load that keeps its direction: Euler's elastica, without stretch."""
from __future__ import annotations

from scipy.special import ellipe, ellipk


def end_of_column(half_angle_sine: float, length: float) -> tuple[float, float]:
    """How far the loaded end has gone aside and down, metres; of the sine of half the angle that it has turned by."""
    whole = ellipk(half_angle_sine**2)
    aside = 2 * half_angle_sine * length / whole
    return float(aside), float(2 * length * (1 - ellipe(half_angle_sine**2) / whole))


def load(half_angle_sine: float, bending_stiffness: float, length: float) -> float:
    """Newton where the stiffness is that of the whole width (newton metre^2); Euler's load where the sine is 0."""
    return float(bending_stiffness * (ellipk(half_angle_sine**2) / length) ** 2)
