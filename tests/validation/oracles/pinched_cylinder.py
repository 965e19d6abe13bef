"""A thin cylinder between diaphragms under two opposite small forces half way: Fourier series for the equations of Koiter
and Sanders. Lindberg, Olson and Cowper 1969 have 164.24 force / (modulus thickness) for a length of twice the radius, a
hundredth of it as thickness and a ratio of 0.3."""
from __future__ import annotations

import numpy as np

# Of walls of a hundredth of the radius shorter waves add less than 1e-4 of the sum.
WAVES = 600


def stiffness(alpha: np.ndarray, n: np.ndarray, radius: float, thickness: float, modulus: float, ratio: float) -> np.ndarray:
    """(... x 3 x 3), newton / metre^3: of u = cos(alpha x) cos(n angle) along, v = sin(alpha x) sin(n angle) around and
    w = sin(alpha x) cos(n angle) outwards, twice the energy of an area over the mean of each squared wave."""
    zero, one = np.zeros_like(alpha), np.ones_like(alpha)

    def row(u: np.ndarray, v: np.ndarray, w: np.ndarray) -> np.ndarray:
        return np.stack([u, v, w], axis=-1)

    strains = np.stack([row(-alpha, zero, zero), row(zero, n / radius, one / radius), row(-n / radius, alpha, zero)], axis=-2)
    bends = np.stack([row(zero, zero, alpha**2), row(zero, n / radius**2, n**2 / radius**2),
                      row(n / (2 * radius**2), 3 * alpha / (2 * radius), 2 * alpha * n / radius)], axis=-2)
    plane = modulus * thickness / (1 - ratio**2) * np.array([[1, ratio, 0], [ratio, 1, 0], [0, 0, (1 - ratio) / 2]])
    return (np.swapaxes(strains, -1, -2) @ plane @ strains
            + np.swapaxes(bends, -1, -2) @ (thickness**2 / 12 * plane) @ bends)


def way_of_the_force(force: float, radius: float, length: float, thickness: float, modulus: float, ratio: float) -> float:
    """Metres, inwards, of the place where one of the forces (newton) presses."""
    m, n = np.meshgrid(np.arange(1.0, WAVES, 2), np.arange(0.0, WAVES, 2), indexing="ij")
    # The mean of a squared wave is a quarter, of one that does not go around a half.
    area = 2 * np.pi * radius * length * np.where(n == 0, 0.5, 0.25)
    matrices = area[..., None, None] * stiffness(m * np.pi / length, n, radius, thickness, modulus, ratio)
    matrices[n == 0, 1, 1] = 1  # without waves around nothing goes around
    loads = np.zeros(m.shape + (3, 1))
    loads[..., 2, 0] = 2 * force  # both press on a wave that is even around
    return float(np.sum(np.linalg.solve(matrices, loads)[..., 2, 0]))
