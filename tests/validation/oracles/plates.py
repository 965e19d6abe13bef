"""Thin circular plates under small loads: Kirchhoff's theory, Timoshenko and Woinowsky-Krieger 1959."""
from __future__ import annotations

import numpy as np


def bending_stiffness(modulus: float, thickness: float, ratio: float) -> float:
    return modulus * thickness**3 / (12 * (1 - ratio**2))


def under_traction(traction: float, radius: float, stiffness: float, ratio: float, clamped: bool) -> float:
    """Way of the middle, metres, under an even load (pascal)."""
    return traction * radius**4 / (64 * stiffness) * (1 if clamped else (5 + ratio) / (1 + ratio))


def under_force(force: float, radius: float, stiffness: float, ratio: float, clamped: bool) -> float:
    """Way of the middle, metres, under a force (newton) there."""
    return force * radius**2 / (16 * np.pi * stiffness) * (1 if clamped else (3 + ratio) / (1 + ratio))
