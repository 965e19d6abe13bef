"""A fluid-filled half cylinder in plane strain under a straight edge along its crown.

Each half of the section is a membrane under even pressure, so its tension T is constant and it is an arc of a circle of
radius T / p through the base edge (R, 0) and the crown (0, R - depth). The fluid keeps the area pi R^2 / 4 of a half:
triangle plus circular segment. The stretch is l = arc / (pi R / 2), T = h dW/dl(l, 1), and the two halves hold the force
per length F = 2 T sin(rise), the angle of the arc at the crown.
"""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from .wall_laws import Law, tension


@dataclass(frozen=True)
class Section:
    force: float  # newton per metre of length
    pressure: float  # pascal
    radius: float  # metres, of the arcs
    centre: tuple[float, float]  # (x, z) of the arc on the side x > 0, metres
    stretch: float


def section(law: Law, thickness: float, radius: float, depth: float) -> Section:
    crown = radius - depth
    chord = np.hypot(radius, crown)

    def surplus(half: float) -> float:
        arc_radius = chord / (2 * np.sin(half))
        return radius * crown / 2 + arc_radius**2 * (half - np.sin(half) * np.cos(half)) - np.pi * radius**2 / 4

    half = brentq(surplus, 1e-6, np.pi - 1e-3, xtol=1e-14, rtol=1e-14)
    arc_radius = chord / (2 * np.sin(half))
    stretch = 2 * half * arc_radius / (np.pi * radius / 2)
    pull = thickness * tension(law, stretch, 1.0)
    fall = np.arctan2(crown, radius)
    along = np.array([-radius, crown]) / chord
    centre = np.array([radius, crown]) / 2 + arc_radius * np.cos(half) * np.array([-along[1], along[0]])
    return Section(force=2 * pull * np.sin(half - fall), pressure=pull / arc_radius, radius=arc_radius,
                   centre=(float(centre[0]), float(centre[1])), stretch=stretch)
