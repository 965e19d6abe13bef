"""A slit in a wide sheet of rubber that is stretched alike in all directions, and a cut through a stretched strip."""
from __future__ import annotations

import numpy as np


def stress(shear_modulus: float, stretch: float) -> float:
    """Cauchy stress of a neo-Hookean sheet, pascal."""
    return shear_modulus * (stretch**2 - stretch**-4)


def half_opening(stress: float, youngs_modulus: float, half_length: float, places) -> np.ndarray:
    """Griffith 1921, plane stress: 2 sigma / E sqrt(a^2 - x^2), metres, at distances from the middle."""
    return 2 * stress / youngs_modulus * np.sqrt(np.maximum(0.0, half_length**2 - np.asarray(places)**2))


def release_rate(stress: float, youngs_modulus: float, half_length: float) -> float:
    """Energy per tip and new area, J/m^2: sigma^2 pi a / E."""
    return stress**2 * np.pi * half_length / youngs_modulus


def compliance_of_stretched_sheet(stretch: float) -> float:
    """What a slit opens by and releases over Griffith's, where it opens a little and the sheet is stretched already: small
    deformations on top of a large one (Biot 1965), by the moduli of the neo-Hookean sheet as it is stretched. Lengths are
    those of the sheet before the slit opens; 1 for a stretch of 1."""
    square, inverse = stretch**2, stretch**-4  # moduli over the shear modulus
    ratio, both = square / (3 * inverse), square + inverse
    stiffness = both - (both - 4 * ratio * inverse) * both / (2 * square * (1 + ratio))
    return 1.5 / stiffness


def release_of_strip(shear_modulus: float, stretch: float, height: float) -> float:
    """Energy per new area, J/m^2, of a neo-Hookean strip that is long, held between its long edges and stretched across them
    alone, far from its ends (Rivlin and Thomas 1953): what a part of the strip has stored, of this height without stress."""
    return shear_modulus / 2 * (stretch**2 + stretch**-2 - 2) * height
