"""Stiffness of a thin spherical shell under inner pressure against a small point force.

k = 4 pi sqrt(D E h) / R sqrt(tau^2 - 1) / arccosh(tau), tau = p R^2 / (4 sqrt(D E h)), D = E h^3 / (12 (1 - nu^2))
(Vella, Ajdari, Vaziri and Boudaoud 2012); at tau = 0 Reissner's 8 sqrt(D E h) / R (1946).
"""
from __future__ import annotations

import numpy as np


def bending_stiffness(youngs_modulus: float, thickness: float, poisson_ratio: float) -> float:
    return youngs_modulus * thickness**3 / (12 * (1 - poisson_ratio**2))


def relative_stiffness(tau: float) -> float:
    """k over 8 sqrt(D E h) / R."""
    if abs(tau - 1) < 1e-9:
        return np.pi / 2
    root, angle = (np.sqrt(tau**2 - 1), np.arccosh(tau)) if tau > 1 else (np.sqrt(1 - tau**2), np.arccos(tau))
    return float(np.pi / 2 * root / angle)


def point_stiffness(radius, thickness, youngs_modulus, poisson_ratio, pressure) -> float:
    """Newton per metre."""
    scale = np.sqrt(bending_stiffness(youngs_modulus, thickness, poisson_ratio) * youngs_modulus * thickness)
    return 8 * scale / radius * relative_stiffness(pressure * radius**2 / (4 * scale))
