"""The section of a long tube that outer pressure flattens: an inextensible ring bent in its plane, in the lengths of its
radius R and the pressures D / R^3 of its bending stiffness D per width (Flaherty, Keller and Rubinow 1972). It buckles
at 3, and its sides touch at 5.247."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_bvp


@dataclass(frozen=True)
class Section:
    pressure: float
    area: float  # over that of the circle
    half_gap: float  # between the sides that come nearer


def _slopes(pressure: float):
    """A quarter from the side that comes nearer (x = 0) to the bend (z = 0): x, z, angle of the tangent below x,
    curvature, and the force (along x and z) of what follows on what lies before."""

    def slopes(_, y):
        _, _, angle, curvature, along, up = y
        cosine, sine = np.cos(angle), np.sin(angle)
        return np.array([cosine, -sine, curvature, cosine * up + sine * along, pressure * sine, pressure * cosine])

    return slopes


def sections(last: float, pull: float = 0.0) -> list[Section]:
    """From the pressure 3.05 to `last`; `pull`: outward force per width on each bend, in D / R^2."""

    def borders(start, end):
        return np.array([start[0], start[2], start[5], end[1], end[2] - np.pi / 2, end[4] - pull / 2])

    places = np.linspace(0, np.pi / 2, 101)
    angle = places - 0.1 * np.sin(2 * places)
    step = places[1]
    x, z = np.cumsum(np.cos(angle)) * step, -np.cumsum(np.sin(angle)) * step
    guess = np.array([x - x[0], z - z[-1], angle, 1 - 0.2 * np.cos(2 * places), -3 * np.cos(angle), 3 * np.sin(angle)])
    found = []
    for pressure in np.append(np.arange(3.05, last - 0.05, 0.15), last):
        solution = solve_bvp(_slopes(pressure), borders, places, guess, tol=1e-6, max_nodes=2000)
        if not solution.success:
            raise ValueError(f"no section at the pressure {pressure:.3f}: {solution.message}")
        places, guess = solution.x, solution.y
        x, z, angle = solution.sol(np.linspace(0, np.pi / 2, 2001))[:3]
        quarter = np.trapz(z * np.cos(angle), np.linspace(0, np.pi / 2, 2001))
        found.append(Section(pressure=float(pressure), area=float(quarter / (np.pi / 4)), half_gap=float(z[0])))
    return found
