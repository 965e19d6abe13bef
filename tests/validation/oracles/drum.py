"""A circular sheet held stretched at its rim."""
from __future__ import annotations

import numpy as np
from scipy.special import jn_zeros


def tension(shear_modulus: float, thickness: float, prestretch: float) -> float:
    """Newton per metre of a neo-Hookean sheet of stress-free thickness, stretched evenly in its plane."""
    return shear_modulus * thickness * (1 - prestretch**-6)


def frequencies(radius: float, pull: float, mass_per_area: float) -> list[float]:
    """The three lowest frequencies, hertz, with no, one and two nodal diameters: zeros of Bessel functions (Rayleigh)."""
    speed = np.sqrt(pull / mass_per_area)
    return [float(jn_zeros(order, 1)[0]) * speed / (2 * np.pi * radius) for order in (0, 1, 2)]


def indentation(drum_radius: float, ball_radius: float, pull: float, contact_radius: float) -> tuple[float, float]:
    """Depth (metres) and force (newton) of a frictionless rigid ball at small slopes and constant tension.

    Outside the contact the sheet is w = (c^2 / R) ln(a / r); inside it lies on the ball.
    """
    c = contact_radius
    depth = c**2 / (2 * ball_radius) + c**2 / ball_radius * np.log(drum_radius / c)
    return depth, 2 * np.pi * pull * c**2 / ball_radius
