"""A balloon of two round films that are joined at their rims. Filled, it draws its rim in, and the films wrinkle towards it:
there they bear tension along the meridians only (Paulsen 1994 for films that do not stretch). Axisymmetric membrane
equations, St. Venant-Kirchhoff's law with Poisson's ratio 0.3, with tension field; lengths in the films' radius."""
from __future__ import annotations

from dataclasses import dataclass
from math import cos, sin

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

POISSON_RATIO = 0.3


@dataclass(frozen=True)
class Balloon:
    rim: float  # radius
    half_height: float


def _stretch(tension: float, lateral: float, stiffness: float) -> float:
    """Along, that gives this nominal tension: stiffness (e + lateral) l, where e = (l^2 - 1) / 2."""
    stretch = 1.5 + tension / stiffness  # above the root, where the curve bends upwards: Newton comes down to it
    for _ in range(40):
        excess = stiffness * (stretch**2 / 2 - 0.5 + lateral) * stretch - tension
        change = excess / (stiffness * (1.5 * stretch**2 - 0.5 + lateral))
        stretch -= change
        if abs(change) < 1e-14:
            break
    return stretch


def _respond(tension: float, across: float) -> tuple[float, float]:
    """Stretch along and nominal tension across, over modulus times thickness, under the nominal tension along."""
    strain, biaxial = (across**2 - 1) / 2, 1 / (1 - POISSON_RATIO**2)
    along = _stretch(tension, POISSON_RATIO * strain, biaxial)
    hoop = biaxial * (strain + POISSON_RATIO * (along**2 - 1) / 2) * across
    return (along, hoop) if hoop > 0 else (_stretch(tension, 0, 1), 0.0)


def _meridian(load: float, pole: float):
    """From the middle outwards: slope below the level, radius, height and nominal tension along by place, until the slope is
    upright."""

    def slopes(place, y):
        slope, radius, _, pull = y
        along, hoop = _respond(pull / place, radius / place)
        return [(load * radius * along - hoop * sin(slope)) / pull, along * cos(slope), -along * sin(slope),
                hoop * cos(slope)]

    def upright(_, y):
        return y[0] - np.pi / 2

    upright.terminal = True
    start, tension = 1e-4, (pole**2 - 1) / 2 * pole / (1 - POISSON_RATIO)
    begin = [load * pole**2 * start / (2 * tension), pole * start, 0.0, tension * start]
    return solve_ivp(slopes, (start, 2.0), begin, rtol=1e-6, atol=1e-9, events=upright, max_step=0.02)


def inflated(load: float) -> Balloon:
    """`load`: pressure times the films' radius over modulus times thickness."""
    poles = 1 + load * np.geomspace(2.0, 0.2, 12)
    ends = [_meridian(load, pole).t[-1] for pole in poles]
    first = next(k for k in range(len(poles)) if ends[k + 1] < 1 < ends[k])
    pole = brentq(lambda each: _meridian(load, each).t[-1] - 1, poles[first + 1], poles[first], xtol=1e-8)
    path = _meridian(load, pole)
    return Balloon(float(path.y[1, -1]), float(-path.y[2, -1]))
