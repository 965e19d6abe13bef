"""Check values of the reference solutions of shells: closed forms, other authors' figures, limits that must hold."""
from __future__ import annotations

import sys
import unittest
from pathlib import Path

import numpy as np
from scipy.interpolate import CubicSpline

sys.path.insert(0, str(Path(__file__).resolve().parent))

from oracles import (collapsing_tube, dimple, elastica, pinched_cylinder, plates, published_shells,  # noqa: E402
                     spherical_shell)


class CollapsingTube(unittest.TestCase):
    def test_sides_touch_at_the_published_pressure(self):
        sections = collapsing_tube.sections(5.4)
        gaps, pressures = ([getattr(each, name) for each in sections[::-1]] for name in ("half_gap", "pressure"))
        self.assertAlmostEqual(float(CubicSpline(gaps, pressures)(0)), 5.247, 3)

    def test_it_begins_to_buckle_at_three(self):
        first, second = collapsing_tube.sections(3.2)[:2]
        # The area falls with the square of the buckle, and the pressure rises with it.
        begin = first.pressure - (1 - first.area) * (second.pressure - first.pressure) / (first.area - second.area)
        self.assertAlmostEqual(begin, 3, 2)


class Dimple(unittest.TestCase):
    SHELL = dimple.Shell(radius=1.0, thickness=2e-3, youngs_modulus=1e6, poisson_ratio=0.3, opening=0.5)

    def test_a_small_dent_gives_way_as_the_linear_shell(self):
        (force, _), = dimple.forces(self.SHELL, [2e-6])
        self.assertAlmostEqual(force / 2e-6 / spherical_shell.point_stiffness(1.0, 2e-3, 1e6, 0.3, 0), 1, delta=3e-3)

    def test_what_the_force_does_is_stored(self):
        depths = list(np.arange(0.5e-3, 10.1e-3, 0.5e-3))
        forces, energies = np.array(dimple.forces(self.SHELL, depths)).T
        self.assertAlmostEqual((CubicSpline(depths, forces).integrate(2e-3, 10e-3)) / (energies[-1] - energies[3]), 1, 3)


class SphericalShell(unittest.TestCase):
    def test_relative_stiffness_is_the_check_value(self):
        for tau, ratio in [(0, 1), (1, 1.5708), (5, 3.3568)]:
            self.assertAlmostEqual(spherical_shell.relative_stiffness(tau), ratio, 4)
        self.assertAlmostEqual(spherical_shell.relative_stiffness(1.0001), np.pi / 2, 3)


class PublishedShells(unittest.TestCase):
    def test_cantilever_begins_as_the_straight_beam(self):
        """P L^3 / (3 E I) at a tenth of the load; its own bending takes less than two per cent off."""
        linear = 0.4 * 10**3 / (3 * 1.2e6 * 0.1**3 / 12)
        self.assertLess(published_shells.CANTILEVER[0][2] / linear, 1)
        self.assertGreater(published_shells.CANTILEVER[0][2] / linear, 0.98)

    def test_the_twisted_strip_is_between_a_beam_and_one_that_cannot_narrow(self):
        """The moment P (L - x) bends the strip about its width by the square of the cosine of its turn."""
        weak = 29e6 * 1.1 * 3.2e-3**3 / 12
        for published, share in zip(published_shells.TWISTED_STRIP, (1 / 6 + np.pi**-2, 1 / 6 - np.pi**-2)):
            beam = 1e-6 * 12**3 * share / weak
            self.assertLess(published, beam)
            self.assertGreater(published, (1 - 0.22**2) * beam)

    def test_a_moment_of_two_pi_stiffnesses_per_length_closes_the_circle(self):
        self.assertAlmostEqual(published_shells.roll_up(3.0, 12.0, 2 * np.pi * 3.0 / 12.0), 2 * np.pi, 12)


class Elastica(unittest.TestCase):
    def test_column_just_above_eulers_load_hardly_bends(self):
        self.assertAlmostEqual(elastica.load(1e-6, 3.0, 2.0), 3 * (np.pi / 4) ** 2, 9)
        aside, down = elastica.end_of_column(0.01, 1.0)
        self.assertAlmostEqual(down / aside**2, np.pi**2 / 16, 3)  # of a quarter of a sine

    def test_moment_at_the_clamp_is_the_loads_lever_and_ends_the_bend(self):
        """Marched from the free end, which has turned by 100 degrees, along theta'' = - load / stiffness sin theta."""
        turned, steps, length, stiffness = np.radians(100), 20000, 1.5, 0.7
        load = elastica.load(np.sin(turned / 2), stiffness, length)
        theta, curvature, place, step = turned, 0.0, np.zeros(2), length / steps
        for _ in range(steps):
            middle = curvature - 0.5 * step * load / stiffness * np.sin(theta)
            theta += step * middle
            curvature = middle - 0.5 * step * load / stiffness * np.sin(theta)
            place += step * np.array([np.sin(theta - 0.5 * step * middle), np.cos(theta - 0.5 * step * middle)])
        self.assertAlmostEqual(theta, 0, 6)
        self.assertAlmostEqual(-curvature * stiffness, load * place[0], 6)
        aside, down = elastica.end_of_column(np.sin(turned / 2), length)
        self.assertAlmostEqual(aside, place[0], 6)
        self.assertAlmostEqual(down, length - place[1], 6)


class Plates(unittest.TestCase):
    def test_hinges_add_what_the_moment_of_the_clamp_held_back(self):
        """An even moment M along the rim bends a plate by M R^2 / (2 D (1 + nu)) in its middle."""
        radius, stiffness, ratio = 0.3, 2.0, 0.25
        for law, moment in ((plates.under_traction, radius**2 / 8), (plates.under_force, 1 / (4 * np.pi))):
            let_go = law(1.0, radius, stiffness, ratio, False) - law(1.0, radius, stiffness, ratio, True)
            self.assertAlmostEqual(let_go, moment * radius**2 / (2 * stiffness * (1 + ratio)), 12)


class PinchedCylinder(unittest.TestCase):
    def test_it_gives_way_as_published(self):
        """Within what shorter waves than those of 1969, and terms of the order of thickness / radius, make of it."""
        way = pinched_cylinder.way_of_the_force(1.0, 300, 600, 3, 3e6, 0.3)
        self.assertAlmostEqual(way * 3e6 * 3 / 164.24, 1, 2)

    def test_waves_far_longer_than_the_radius_bend_rings_without_stretching_them(self):
        """A ring under cos(n angle) gives way by radius^4 / (D (n^2 - 1)^2) of the load."""
        radius, thickness, n = 2.0, 1e-4, 4.0
        matrix = pinched_cylinder.stiffness(np.array(1e-9), np.array(n), radius, thickness, 1e9, 0.3)
        way = np.linalg.solve(matrix, [0, 0, 1])[2]
        bending = plates.bending_stiffness(1e9, thickness, 0.3)
        self.assertAlmostEqual(way * bending * (n**2 - 1) ** 2 / radius**4, 1, 6)


if __name__ == "__main__":
    unittest.main()
