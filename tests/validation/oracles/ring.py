"""A thin elastic ring that swings in its plane."""
from __future__ import annotations

import numpy as np


def frequencies(radius: float, thickness: float, youngs_modulus: float, density: float, waves: np.ndarray) -> np.ndarray:
    """Hertz, of a ring that bends without stretching, its section a rectangle, with these numbers of waves around it
    (Hoppe 1871; Love, A Treatise on the Mathematical Theory of Elasticity, 1927, 293)."""
    bending = youngs_modulus * thickness**2 / (12 * density * radius**4)  # 1 / s^2
    return np.sqrt(bending * waves**2 * (waves**2 - 1.0)**2 / (waves**2 + 1.0)) / (2 * np.pi)
