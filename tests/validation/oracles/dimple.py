"""The dimple that a point force makes in a thin spherical shell: at first the shell gives way as Reissner's (1946), then the
dimple turns inside out, and its ridge alone resists (Pogorelov 1988). Reissner's equations of 1950 for shells of revolution
whose strains are small and whose rotations are not, solved on a cap that is clamped far from the dimple."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_bvp


@dataclass(frozen=True)
class Shell:
    radius: float
    thickness: float
    youngs_modulus: float
    poisson_ratio: float
    opening: float  # angle from the pole to the clamp

    @property
    def stretching(self) -> float:
        return self.youngs_modulus * self.thickness / (1 - self.poisson_ratio**2)

    @property
    def bending(self) -> float:
        return self.stretching * self.thickness**2 / 12


def _state(shell: Shell, place, y, force):
    """Strains along and around, changes of both curvatures, by the angle from the pole. y: way outwards, angle of the tangent
    below the level, and times the radius at rest the horizontal force and the moment along, both per length."""
    radius = shell.radius * np.sin(place)
    outward, angle, pull, moment = y[:4]
    around, twist = outward / radius, (np.sin(angle) - np.sin(place)) / radius
    along_force = pull / radius * np.cos(angle) - force / (2 * np.pi * radius) * np.sin(angle)
    along = along_force / shell.stretching - shell.poisson_ratio * around
    bend = moment / radius / shell.bending - shell.poisson_ratio * twist
    return along, around, bend, twist


def _slopes(shell: Shell):
    def slopes(place, y, parameters):
        along, around, bend, twist = _state(shell, place, y, parameters[0])
        _, angle, pull, _ = y[:4]
        hoop = shell.stretching * (around + shell.poisson_ratio * along)
        hoop_moment = shell.bending * (twist + shell.poisson_ratio * bend)
        turning = pull * np.sin(angle) + parameters[0] / (2 * np.pi) * np.cos(angle)
        return shell.radius * np.array([(1 + along) * np.cos(angle) - np.cos(place), 1 / shell.radius + bend, hoop,
                                        hoop_moment * np.cos(angle) + (1 + along) * turning,
                                        np.sin(place) - (1 + along) * np.sin(angle)])

    return slopes


def forces(shell: Shell, depths: list[float]) -> list[tuple[float, float]]:
    """Force and stored energy at each of these ways of the pole inwards, which ascend from a small one."""
    places = np.linspace(1e-4 * shell.opening, shell.opening, 600)
    y, force, found = np.array([0 * places, places, 0 * places, 0 * places, 0 * places]), 0.0, []
    for depth in depths:

        def borders(start, end, _, depth=depth):
            return np.array([start[0], start[1] - places[0], start[4] + depth, end[0], end[1] - shell.opening, end[4]])

        solution = solve_bvp(_slopes(shell), borders, places, y, p=[force], tol=1e-4, max_nodes=20000)
        if not solution.success:
            raise ValueError(f"no dimple {depth:.3g} deep: {solution.message}")
        places, y, force = solution.x, solution.y, float(solution.p[0])
        along, around, bend, twist = _state(shell, places, y, force)
        ratio = shell.poisson_ratio
        density = (shell.stretching * (along**2 + around**2 + 2 * ratio * along * around)
                   + shell.bending * (bend**2 + twist**2 + 2 * ratio * bend * twist)) / 2
        energy = np.trapz(density * 2 * np.pi * shell.radius * np.sin(places), shell.radius * places)
        found.append((force, float(energy)))
    return found
