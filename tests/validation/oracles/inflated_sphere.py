"""Pressure in a thin spherical balloon: p = h dW/dl(l, l) 2 / (r l^2) with dW/dl along one axis (Adkins and Rivlin 1952)."""
from __future__ import annotations

from scipy.optimize import minimize_scalar

from .wall_laws import Law, tension


def pressure(law: Law, thickness: float, radius: float, stretch: float) -> float:
    """Pascal; thickness and radius of the stress-free balloon, metres."""
    return 2 * thickness * tension(law, stretch, stretch) / (radius * stretch**2)


def limit_point(law: Law) -> float:
    """The stretch at which the pressure has its first maximum."""
    return float(minimize_scalar(lambda l: -pressure(law, 1, 1, l), bounds=(1.05, 2.5), method="bounded",
                                 options={"xatol": 1e-10}).x)
