"""Fluids in stiff and soft chambers, hydrostatic membranes."""
from __future__ import annotations

from typing import Callable

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve

from .wall_laws import Law, tension


def compressible_pressure(first_pressure: float, bulk_modulus: float, fluid_volume, volume):
    """Pascal: p = p0 + kappa (Vf - V) / Vf, with Vf the volume that the fluid fills at p0."""
    return first_pressure + bulk_modulus * (fluid_volume - volume) / fluid_volume


def two_chambers(pressure_of_volume: tuple[Callable, Callable], volumes: tuple[float, float], area: float,
                 discharge: float, density: float, times) -> np.ndarray:
    """Volumes of two chambers over time (2 x times) that exchange fluid through an orifice:
    V1' = -Cd A sign(p1 - p2) sqrt(2 |p1 - p2| / density)."""

    def rate(_, y):
        drop = pressure_of_volume[0](y[0]) - pressure_of_volume[1](y[1])
        flow = discharge * area * np.sign(drop) * np.sqrt(2 * abs(drop) / density)
        return [-flow, flow]

    return solve_ivp(rate, (0, times[-1]), volumes, t_eval=times, rtol=1e-9, atol=1e-18).y


def leak(pressure_of_volume: Callable, volume: float, area: float, discharge: float, density: float, times) -> np.ndarray:
    """Volumes over time (times) of a chamber with an opening: V' = -Cd A sqrt(2 p / density)."""

    def rate(_, y):
        return [-discharge * area * np.sqrt(2 * max(0.0, float(pressure_of_volume(y[0]))) / density)]

    return solve_ivp(rate, (times[0], times[-1]), [volume], t_eval=times, rtol=1e-10, atol=1e-18).y[0]


def tank_with_membrane_side(law: Law, thickness: float, radius: float, specific_weight: float, filling: float):
    """A tank whose flat rigid side lies on x in [-R, R], z = 0 and whose other side is a membrane, stress-free a half
    circle of radius R about the origin; plane strain, filled to `filling` times pi R^2 / 2 of area, gravity along -x.

    No load acts along the membrane: its tension T = h dW/dl(l, 1) is constant and its curvature is p / T with
    p = p0 - specific_weight x. Gives (T newton/metre, p0 pascal, points (2 x n) of the membrane from x = -R to R)."""
    length0 = np.pi * radius
    samples = np.linspace(0, 1, 401)

    def shape(unknown):
        start_angle, stretch, middle = unknown
        pull = thickness * tension(law, stretch, 1.0)
        length = stretch * length0

        def rate(_, y):  # x, z, angle, area under the curve
            x, z, angle, _ = y
            return [length * np.cos(angle), length * np.sin(angle),
                    -length * (middle - specific_weight * x) / pull, z * length * np.cos(angle)]

        return pull, solve_ivp(rate, (0, 1), [-radius, 0, start_angle, 0], t_eval=samples, rtol=1e-10,
                               atol=1e-13).y

    def misses(unknown):
        x, z, _, area = shape(unknown)[1][:, -1]
        return [x / radius - 1, z / radius, area / (np.pi * radius**2 / 2 * filling) - 1]

    stretch = 1 + 0.6 * (filling - 1)
    guess = [np.pi / 2 + 0.4 * (filling - 1), stretch, thickness * tension(law, stretch, 1.0) / radius]
    full = specific_weight
    for part in (0.0, 0.25, 0.5, 0.75, 1.0):
        specific_weight = full * part
        guess, _, found, message = fsolve(misses, guess, xtol=1e-12, full_output=True)
    unknown = guess
    if found != 1:
        raise ArithmeticError(f"tank with a membrane side: {message}")
    pull, points = shape(unknown)
    return pull, float(unknown[2]), points[:2]
