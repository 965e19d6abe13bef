"""Strain energies of thin walls, from which tensions follow by complex-step differentiation.

A law is a function W(l1, l2) of the in-plane principal stretches, joule per cubic metre of stress-free wall; the third
stretch of an incompressible wall is 1 / (l1 l2). Laws accept complex stretches.
"""
from __future__ import annotations

from typing import Callable

import numpy as np

Law = Callable[[complex, complex], complex]


def _first_invariant(l1, l2):
    return l1**2 + l2**2 + (l1 * l2) ** -2


def st_venant_kirchhoff(youngs_modulus: float, poisson_ratio: float) -> Law:
    def energy(l1, l2):
        e1, e2 = (l1**2 - 1) / 2, (l2**2 - 1) / 2
        return youngs_modulus / (2 * (1 - poisson_ratio**2)) * (e1**2 + e2**2 + 2 * poisson_ratio * e1 * e2)

    return energy


def neo_hookean(shear_modulus: float) -> Law:
    return lambda l1, l2: shear_modulus / 2 * (_first_invariant(l1, l2) - 3)


def mooney_rivlin(c1: float, c2: float) -> Law:
    def energy(l1, l2):
        second_invariant = l1**-2 + l2**-2 + (l1 * l2) ** 2
        return c1 * (_first_invariant(l1, l2) - 3) + c2 * (second_invariant - 3)

    return energy


def gent(shear_modulus: float, limit: float) -> Law:
    """Gent 1996: the first invariant stays below 3 + limit."""
    return lambda l1, l2: -shear_modulus * limit / 2 * np.log(1 - (_first_invariant(l1, l2) - 3) / limit)


def ogden(terms: list[tuple[float, float]]) -> Law:
    """Ogden 1972: terms of (modulus, exponent); the shear modulus at small strain is half the sum of their products."""

    def energy(l1, l2):
        return sum(m / a * (l1**a + l2**a + (l1 * l2) ** -a - 3) for m, a in terms)

    return energy


def fung(c: float, a1: float, a2: float, a3: float) -> Law:
    """Fung, Fronek and Patitucci 1979, principal stretches along the axes of the law."""

    def energy(l1, l2):
        e1, e2 = (l1**2 - 1) / 2, (l2**2 - 1) / 2
        return c / 2 * (np.exp(a1 * e1**2 + a2 * e2**2 + 2 * a3 * e1 * e2) - 1)

    return energy


def holzapfel(shear_modulus: float, k1: float, k2: float, dispersion: float, angle: float) -> Law:
    """Gasser, Ogden and Holzapfel 2006: two families at +-angle (radian) to the first axis; fibres bear no compression."""

    def energy(l1, l2):
        along = (l1 * np.cos(angle)) ** 2 + (l2 * np.sin(angle)) ** 2
        stretch = dispersion * (_first_invariant(l1, l2) - 3) + (1 - 3 * dispersion) * (along - 1)
        fibres = k1 / k2 * (np.exp(k2 * stretch**2) - 1) if np.real(stretch) > 0 else 0
        return shear_modulus / 2 * (_first_invariant(l1, l2) - 3) + fibres

    return energy


def tension(law: Law, l1: float, l2: float) -> float:
    """Force in direction 1 per stress-free length and thickness, dW/dl1, pascal."""
    step = 1e-30
    return float(np.imag(law(l1 + 1j * step, l2)) / step)


def tensions(law: Law, l1: float, l2: float) -> tuple[float, float]:
    """dW/dl1 and dW/dl2, pascal."""
    step = 1e-30
    return float(np.imag(law(l1 + 1j * step, l2)) / step), float(np.imag(law(l1, l2 + 1j * step)) / step)


def tension_slopes(law: Law, l1: float, l2: float) -> tuple[float, float]:
    """d2W/dl1^2 and d2W/dl1 dl2, pascal: central differences of complex steps, ten digits."""
    step = 1e-5
    return ((tension(law, l1 + step, l2) - tension(law, l1 - step, l2)) / (2 * step),
            (tension(law, l1, l2 + step) - tension(law, l1, l2 - step)) / (2 * step))
