"""A flat ring stretched at its outer circle, free at its hole (Rivlin and Thomas 1951).

With the stress-free distance R from the middle, the deformed one r(R), l1 = r', l2 = r / R and N = h dW/dl:
(R N1)' = N2, and N1 = 0 at the hole.
"""
from __future__ import annotations

from typing import Callable

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from .wall_laws import Law, tension_slopes, tensions


def radii(law: Law, hole: float, rim: float, stretched_rim: float) -> Callable[[np.ndarray], np.ndarray]:
    """Deformed distances from the middle by stress-free ones, for a ring from `hole` to `rim` drawn to `stretched_rim`."""

    def rates(s, y):
        r, l1 = y
        l2 = r / s
        n1, n2 = tensions(law, l1, l2)
        n11, n12 = tension_slopes(law, l1, l2)
        return [l1, ((n2 - n1) - n12 * (l1 - l2)) / (s * n11)]

    def solution(around: float):
        thinned = brentq(lambda l1: tensions(law, l1, around)[0], 0.5 * around**-0.5, 1.5)
        return solve_ivp(rates, (hole, rim), [around * hole, thinned], rtol=1e-10, atol=1e-14, dense_output=True)

    whole = stretched_rim / rim
    around = brentq(lambda l2: solution(l2).y[0, -1] - stretched_rim, 1 + 1e-9, 3 * whole**2, xtol=1e-13)
    found = solution(around).sol
    return lambda s: found(np.asarray(s))[0]
