"""A flat circular membrane, clamped, under even pressure: centre deflection w = K (q a^4 / (E h))^(1/3).

Foppl's equations with q = a = E h = 1 and n the radial tension: n r w' = -r^2 / 2 and n'' + 3 n'/r + 1 / (8 n^2) = 0; an
even centre, n'(0) = 0, and no radial motion of the rim, n' + (1 - nu) n = 0 (Hencky 1915).
"""
from __future__ import annotations

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq


def _solve(centre_tension: float):
    first = 1e-4
    # n = n0 + n2 r^2: 2 n2 + 6 n2 + 1 / (8 n0^2) = 0.
    second = -1 / (64 * centre_tension**2)
    start = [centre_tension + second * first**2, 2 * second * first, first**2 / (4 * centre_tension)]
    return solve_ivp(lambda r, y: [y[1], -3 * y[1] / r - 1 / (8 * y[0] ** 2), r / (2 * y[0])], (first, 1), start,
                     rtol=1e-11, atol=1e-13).y[:, -1]


def factor(poisson_ratio: float) -> float:
    """K."""

    def rim(centre_tension: float) -> float:
        n, slope, _ = _solve(centre_tension)
        return slope + (1 - poisson_ratio) * n

    centre_tension = brentq(rim, 0.3, 1.2, xtol=1e-12)
    return float(_solve(centre_tension)[2])


def centre_deflection(pressure: float, radius: float, youngs_modulus: float, thickness: float, poisson_ratio: float):
    """Metres."""
    return factor(poisson_ratio) * np.cbrt(pressure * radius**4 / (youngs_modulus * thickness))
