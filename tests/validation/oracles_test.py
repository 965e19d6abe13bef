"""Check values of the reference solutions: closed forms, other authors' figures, limits that must hold. Those of shells
are in shell_oracles_test.py."""
from __future__ import annotations

import sys
import unittest
from pathlib import Path

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq

sys.path.insert(0, str(Path(__file__).resolve().parent))

from oracles import (axisymmetric_membrane, belt, bulging_tube, drum, film_balloon, fingerpad, fluids,  # noqa: E402
                     four_pulls, hencky, inflated_sphere, ring, slit, stretched_ring, strips, viscoelasticity, wall_laws)

# mu = 2 makes c1 = mu / 2 the unit.
RUBBER = wall_laws.neo_hookean(2.0)


class WallLaws(unittest.TestCase):
    def test_tensions_are_those_worked_out_by_hand(self):
        self.assertAlmostEqual(wall_laws.tension(RUBBER, 1.3, 1.1), 2 * (1.3 - 1.3**-3 * 1.1**-2), 13)
        c1, c2, l = 16.0, 2.0, 1.2
        self.assertAlmostEqual(wall_laws.tension(wall_laws.mooney_rivlin(c1, c2), l, 1.0), 2 * (c1 + c2) * (l - l**-3), 12)

    def test_laws_agree_where_one_is_a_limit_of_the_other(self):
        ogden = wall_laws.ogden([(2.0, 2.0)])
        stiffening = wall_laws.gent(2.0, 1e7)
        for stretches in [(1.3, 0.9), (2.0, 1.5)]:
            self.assertAlmostEqual(wall_laws.tension(ogden, *stretches), wall_laws.tension(RUBBER, *stretches), 12)
            self.assertAlmostEqual(wall_laws.tension(stiffening, *stretches), wall_laws.tension(RUBBER, *stretches), 5)


class InflatedSphere(unittest.TestCase):
    def test_neo_hookean_limit_point(self):
        self.assertAlmostEqual(inflated_sphere.limit_point(RUBBER), 7 ** (1 / 6), 6)

    def test_pressure_is_the_closed_form(self):
        law = wall_laws.mooney_rivlin(16e3, 2e3)
        closed = 4 * 0.5e-3 / 30e-3 * (1 / 1.5 - 1.5**-7) * (16e3 + 2e3 * 1.5**2)
        self.assertAlmostEqual(inflated_sphere.pressure(law, 0.5e-3, 30e-3, 1.5) / closed, 1, 12)


class BulgingTube(unittest.TestCase):
    LAW = staticmethod(wall_laws.ogden([(6.3, 1.3), (0.012, 5.0), (-0.1, -2.0)]))

    def test_a_slight_pressure_widens_a_tube_as_hooke_says(self):
        # Hoop stress s, axial s / 2, Poisson's ratio 1/2: no stretch along, 3/4 s / E around.
        state = bulging_tube.uniform(RUBBER, 1 + 1e-5)
        self.assertAlmostEqual(state.along, 1, 8)
        self.assertAlmostEqual(state.pressure / (4 / 3 * 6 * 1e-5), 1, 3)

    def test_both_parts_bear_the_same_pressure_and_enthalpy(self):
        narrow, wide = bulging_tube.maxwell(self.LAW, 8.0)
        self.assertGreater(wide.around, 2 * narrow.around)
        self.assertAlmostEqual(narrow.pressure / wide.pressure, 1, 10)
        enthalpies = [float(self.LAW(each.around, each.along)) - each.pressure * each.volume / 2 for each in (narrow, wide)]
        self.assertAlmostEqual(enthalpies[0] / enthalpies[1], 1, 6)


class FourPulls(unittest.TestCase):
    def test_a_square_branches_where_equal_growth_becomes_unstable(self):
        c1, c2 = 20e3, 10e3
        law = wall_laws.mooney_rivlin(c1, c2)
        # Where d2W/dl1^2 = d2W/dl1 dl2: c1 (l^6 + 1) = c2 (l^8 - 3 l^2).
        critical = brentq(lambda l: c1 * (l**6 + 1) - c2 * (l**8 - 3 * l**2), 1.1, 3)
        pulls = [part * wall_laws.tension(law, critical, critical) for part in (0.5, 0.98, 1.02)]
        found = four_pulls.stretches(law, 1.0, [(pull * (1 + 1e-7), pull) for pull in pulls])
        self.assertAlmostEqual(found[1, 0], found[1, 1], 3)
        self.assertGreater(found[2, 0], 1.2 * found[2, 1])


class FilmBalloon(unittest.TestCase):
    def test_films_that_hardly_stretch_make_the_published_shape(self):
        # Closed forms by the gamma function, for films that do not stretch at all.
        for name, published in [("rim", 0.76276), ("half_height", 0.45695)]:
            more, less = (getattr(film_balloon.inflated(load), name) - published for load in (4e-3, 5e-4))
            self.assertLess(0, less)
            self.assertLess(less, 0.6 * more)
            self.assertLess(less, 2e-3)


class Fingerpad(unittest.TestCase):
    def test_force_worked_out_by_hand(self):
        self.assertAlmostEqual(10e-3 * fingerpad.section(wall_laws.neo_hookean(20e3), 1e-3, 10e-3, 4e-3).force, 0.12665, 5)

    def test_no_depth_leaves_the_circle(self):
        untouched = fingerpad.section(wall_laws.neo_hookean(20e3), 1e-3, 10e-3, 1e-9)
        self.assertAlmostEqual(untouched.radius, 10e-3, 8)
        self.assertLess(abs(untouched.force), 1e-6)


class StretchedRing(unittest.TestCase):
    def test_small_stretch_is_that_of_a_linear_ring(self):
        # u = A r + B / r with no radial stress at the hole: A (1 + nu) = B (1 - nu) / b^2, nu = 1/2.
        hole, rim, drawn = 1.0, 4.0, 4.0004
        factor = (drawn - rim) / (rim + 3 * hole**2 / rim)
        expected = factor * (hole + 3 * hole)
        found = stretched_ring.radii(RUBBER, hole, rim, drawn)
        self.assertAlmostEqual((float(found(hole)) - hole) / expected, 1, 3)

    def test_the_virial_of_its_forces_is_that_of_its_tensions(self):
        # Work of the rim's tension on a motion of all places away from the middle.
        law, hole, rim, drawn = wall_laws.mooney_rivlin(0.8, 0.2), 5.0, 20.0, 40.0
        found = stretched_ring.radii(law, hole, rim, drawn)
        places = np.linspace(hole, rim, 20001)
        r = found(places)
        l1, l2 = np.gradient(r, places, edge_order=2), r / places
        n = np.array([wall_laws.tensions(law, a, b) for a, b in zip(l1, l2)])
        inner = np.trapz((n[:, 0] * l1 + n[:, 1] * l2) * places, places)
        self.assertAlmostEqual(inner / (n[-1, 0] * rim * drawn), 1, 5)


class Hencky(unittest.TestCase):
    def test_factor_is_the_published_one(self):
        for poisson_ratio, published in [(0, 0.7183), (0.3, 0.6534), (0.4, 0.6263)]:
            self.assertAlmostEqual(hencky.factor(poisson_ratio), published, delta=6e-5)


class Drum(unittest.TestCase):
    def test_first_frequency_by_the_first_zero(self):
        self.assertAlmostEqual(drum.frequencies(1, 4, 1)[0], 2.404825557695773 * 2 / (2 * np.pi), 12)

    def test_pull_is_that_of_the_law(self):
        law = wall_laws.neo_hookean(20e3)
        self.assertAlmostEqual(drum.tension(20e3, 1e-3, 1.3), 1e-3 * wall_laws.tension(law, 1.3, 1.3) / 1.3, 12)


class Ring(unittest.TestCase):
    def test_two_waves_have_the_published_factor(self):
        # Love: 6 / sqrt(5) times the root of E I / (m a^4).
        self.assertAlmostEqual(ring.frequencies(1, np.sqrt(12), 1, 1, np.array([2.0]))[0] * 2 * np.pi, 6 / np.sqrt(5), 12)

    def test_short_waves_are_those_of_a_straight_beam(self):
        waves, beam = 1000.0, 1000.0**2 / (2 * np.pi)
        self.assertAlmostEqual(ring.frequencies(1, np.sqrt(12), 1, 1, np.array([waves]))[0] / beam, 1, 5)


class BallBetweenPlates(unittest.TestCase):
    def test_force_pressure_and_contact_are_the_check_values(self):
        checks = {0.05: (0.1693, 1.6085, 0.166), 0.10: (0.4319, 1.6522, 0.262), 0.20: (1.2099, 1.7986, 0.421),
                  0.30: (2.4486, 2.0452, 0.561), 0.50: (8.2858, 3.0481, 0.846)}
        balls = axisymmetric_membrane.ball_between_plates(RUBBER, 1.1, list(checks))
        for ball, (force, pressure, contact) in zip(balls, checks.values()):
            # Refining the integration moves no digit of ours; the check values of the force carry three and a half.
            self.assertAlmostEqual(ball.force, force, delta=6e-4 * force)
            self.assertAlmostEqual(ball.pressure, pressure, delta=1e-4 * pressure)
            self.assertAlmostEqual(ball.contact_radius / 1.1, contact, delta=1e-3)


class DrumUnderBall(unittest.TestCase):
    def test_small_dents_are_those_of_small_slopes(self):
        law = wall_laws.neo_hookean(2.0)
        for contact in (0.02, 0.04):
            depth, force = drum.indentation(1, 1, drum.tension(2.0, 1, 1.3), contact)
            found = axisymmetric_membrane.drum_under_ball(law, 1.3, 1, depth)
            self.assertAlmostEqual(found.force / force, 1, delta=2 * contact**2)
            self.assertAlmostEqual(found.contact_radius / contact, 1, delta=2 * contact**2)


class InflatedDisc(unittest.TestCase):
    def test_height_and_pressure_are_the_check_values(self):
        checks = {1.0525: (0.5, 0.2806), 1.0951: (1.0, 0.3742), 1.2002: (2.0, 0.5312), 1.3932: (3.0, 0.7191)}
        for stretch, (pressure, height) in checks.items():
            found = axisymmetric_membrane.inflated_disc(RUBBER, stretch)
            self.assertAlmostEqual(found[0], pressure, delta=2e-3)
            self.assertAlmostEqual(found[1], height, delta=2e-4)

    def test_heights_are_the_same_by_either_way(self):
        heights = axisymmetric_membrane.disc_heights(RUBBER, [0.5, 1.0, 2.0, 3.0, 3.5])
        for height, expected in zip(heights, (0.2806, 0.3742, 0.5312, 0.7191)):
            # The check values tell pressure, height and stretch of one state with four digits each: 8e-4 seen.
            self.assertAlmostEqual(height / expected, 1, delta=1e-3)
        self.assertGreater(heights[-1], heights[-2])

    def test_path_passes_the_limit_as_single_states_do(self):
        stretches = [1.05, 1.2, 1.4, 1.7, 2.0, 2.2, 2.6]
        path = axisymmetric_membrane.disc_path(RUBBER, stretches)
        for index in (1, 4, 6):
            pressure, height = axisymmetric_membrane.inflated_disc(RUBBER, stretches[index])
            # Both roots are found to 1e-10; the slope of the pressure over the rim's place is of order one.
            self.assertAlmostEqual(path[0, index], pressure, 7)
            self.assertAlmostEqual(path[1, index], height, 7)

    def test_pressure_is_largest_near_a_stretch_of_2_20(self):
        pressures = {l: axisymmetric_membrane.inflated_disc(RUBBER, l)[0] for l in (2.1, 2.2, 2.3)}
        self.assertAlmostEqual(pressures[2.2], 3.758, delta=1e-3)
        self.assertLess(pressures[2.1], pressures[2.2])
        self.assertLess(pressures[2.3], pressures[2.2])


class DropOnPlane(unittest.TestCase):
    def test_floor_bears_the_contents(self):
        drop = axisymmetric_membrane.drop_on_plane(RUBBER, 1.2, 0.8)
        bears = np.pi * drop.contact_radius**2 * drop.pressure_at_floor
        self.assertAlmostEqual(bears / (0.8 * 4 / 3 * np.pi * 1.2**3), 1, 6)

    def test_floor_bears_a_heavy_drop_on_a_real_flat(self):
        drop = axisymmetric_membrane.drop_on_plane(RUBBER, 1.125, 0.785)
        self.assertGreater(drop.contact_radius, 0)
        bears = np.pi * drop.contact_radius**2 * drop.pressure_at_floor
        self.assertAlmostEqual(bears / (0.785 * 4 / 3 * np.pi * 1.125**3), 1, 6)

    def test_light_contents_leave_a_ball(self):
        drop = axisymmetric_membrane.drop_on_plane(RUBBER, 1.2, 1e-3)
        self.assertAlmostEqual(drop.height, 2.4, delta=5e-3)
        self.assertAlmostEqual(drop.largest_radius, 1.2, delta=1e-3)


class Viscoelasticity(unittest.TestCase):
    TERMS = [(0.3, 0.2), (0.2, 2.0)]

    def test_moduli_are_the_transform_of_the_relaxation(self):
        frequency = 0.7
        omega = 2 * np.pi * frequency
        time = np.linspace(0, 60, 600001)
        rest = 0.5
        decay = viscoelasticity.relaxation(self.TERMS, time) - rest
        storage, loss = viscoelasticity.storage_and_loss(self.TERMS, frequency)
        self.assertAlmostEqual(storage, rest + omega * np.trapz(decay * np.sin(omega * time), time), 6)
        self.assertAlmostEqual(loss, omega * np.trapz(decay * np.cos(omega * time), time), 6)

    def test_creep_undoes_relaxation(self):
        """The convolution of the relaxation with the rate of creep is a constant stress."""
        f, tau, end = 0.3, 0.2, 0.5
        time = np.linspace(0, end, 100001)
        strain = viscoelasticity.creep(f, tau, time)
        stress = viscoelasticity.relaxation([(f, tau)], end) * strain[0] + np.trapz(
            viscoelasticity.relaxation([(f, tau)], end - time) * np.gradient(strain, time), time)
        self.assertAlmostEqual(stress, 1, 8)


    def test_creep_after_a_ramp_is_the_convolution(self):
        f, tau, ramp, end = 0.3, 0.2, 0.04, 0.3
        rising = np.linspace(0, ramp, 4001)
        summed = np.trapz(viscoelasticity.creep(f, tau, end - rising) / ramp, rising)
        self.assertAlmostEqual(float(viscoelasticity.creep_after_ramp(f, tau, ramp, end)), float(summed), 9)


class Fluids(unittest.TestCase):
    def test_orifice_empties_as_torricelli_says(self):
        """Rising and falling heads of equal slope: the root of the difference falls linearly."""
        slope, area, density = 1e9, 1e-6, 1000.0
        volumes = fluids.two_chambers((lambda v: slope * v, lambda v: slope * v), (2e-6, 1e-6), area, 0.6, density,
                                      np.array([0.2]))
        drop = (np.sqrt(slope * 1e-6) - slope * 0.6 * area * np.sqrt(2 / density) * 0.2) ** 2
        self.assertAlmostEqual(slope * (volumes[0, 0] - volumes[1, 0]) / drop, 1, 6)

    def test_leak_of_a_linear_chamber_lowers_the_root_of_the_pressure_evenly(self):
        stiffness, area, times = 2e7, 3e-6, np.array([0.5, 1.0, 2.0])
        volumes = fluids.leak(lambda volume: stiffness * (volume - 1e-5), 3e-5, area, 0.6, 1000.0, times)
        roots = np.sqrt(stiffness * 2e-5) - 0.5 * stiffness * 0.6 * area * np.sqrt(2 / 1000.0) * (times - 0.5)
        self.assertGreater(roots[-1], 0)
        np.testing.assert_allclose(stiffness * (volumes - 1e-5), roots**2, rtol=1e-7)

    def test_weightless_tank_is_an_arc_of_a_circle_under_even_pressure(self):
        law = wall_laws.neo_hookean(20e3)
        pull, pressure, points = fluids.tank_with_membrane_side(law, 1e-3, 20e-3, 0, 1.3)
        middle = points[1].max() - pull / pressure
        self.assertLess(np.max(np.abs(np.hypot(points[0], points[1] - middle) - pull / pressure)), 1e-9)

    def test_tank_is_held_by_its_edges(self):
        """Gravity on the area and the pull of both edges balance along x: the rigid side pushes along z."""
        law, weight = wall_laws.neo_hookean(20e3), 500.0
        pull, _, points = fluids.tank_with_membrane_side(law, 1e-3, 20e-3, weight, 1.3)
        first = np.diff(points[:, :2]).ravel() / np.linalg.norm(np.diff(points[:, :2]))
        last = np.diff(points[:, -2:]).ravel() / np.linalg.norm(np.diff(points[:, -2:]))
        self.assertAlmostEqual(pull * (first[0] - last[0]) / (weight * 1.3 * np.pi * 20e-3**2 / 2), -1, delta=1e-2)


class Slit(unittest.TestCase):
    def test_unstretched_sheet_is_that_of_griffith(self):
        self.assertAlmostEqual(slit.compliance_of_stretched_sheet(1.0), 1, 13)

    def test_stretched_half_plane_yields_as_its_waves_do(self):
        """Displacements U exp(i k x - s k y) of the half plane y > 0 that a normal traction on its border makes."""
        stretch, kronecker = 1.1, np.eye(2)
        # Second derivatives of mu/2 (F:F + det F^-2) in the stretched sheet, mu = 1: A[i, p, j, q] d_p u_i d_q u_j.
        moduli = stretch**2 * np.einsum("ij,pq->ipjq", kronecker, kronecker) + stretch**-4 * (
            2 * np.einsum("ip,jq->ipjq", kronecker, kronecker) + np.einsum("iq,jp->ipjq", kronecker, kronecker))
        forth, cross, side = moduli[:, 0, :, 0], moduli[:, 0, :, 1] + moduli[:, 1, :, 0], moduli[:, 1, :, 1]
        companion = np.block([[np.zeros((2, 2)), kronecker],
                              [np.linalg.solve(side, forth), np.linalg.solve(side, 1j * cross)]])
        decays, waves = np.linalg.eig(companion)
        fading = decays.real > 0
        decays, waves = decays[fading], waves[:2, fading]
        tractions = np.column_stack([moduli[:, 1, :, 0] @ wave * 1j - decay * moduli[:, 1, :, 1] @ wave
                                     for decay, wave in zip(decays, waves.T)])
        yields = waves @ np.linalg.solve(tractions, [0, -1])
        # A sheet of modulus 3 mu that is not stretched yields by 2 / (3 mu k).
        # Both waves fade alike, so that they are told apart by the root of the rounding.
        self.assertAlmostEqual(yields[1].real / (2 / 3), slit.compliance_of_stretched_sheet(stretch), 6)


    def test_strip_releases_the_work_that_stretching_it_took(self):
        # The nominal tension of a sheet that is stretched along one axis and held along the other is mu (l - l^-3).
        work = quad(lambda stretch: 20e3 * (stretch - stretch**-3), 1, 1.3)[0]
        self.assertAlmostEqual(slit.release_of_strip(20e3, 1.3, 15e-3) / (work * 15e-3), 1, 12)


class Strips(unittest.TestCase):
    def test_both_bear_the_same_force_and_fill_the_length(self):
        laws = (wall_laws.neo_hookean(20e3), wall_laws.mooney_rivlin(30e3, 5e3))
        first, second, force = strips.in_series(laws, (1e-3, 0.5e-3), (20e-3, 30e-3), 15e-3)
        self.assertAlmostEqual(20 * first + 30 * second, 65, 10)
        self.assertAlmostEqual(force / (0.5e-3 * 70e3 * (second - second**-3)), 1, 10)


class Belt(unittest.TestCase):
    def test_even_tensions_bear_the_rod(self):
        """A rod without radius 3 below the ends, which are 4 to either side: each tension bears 3/5 of itself."""
        found = belt.sides(np.array([0.0, -3.0]), 0.0, (np.array([4.0, 0.0]), np.array([-4.0, 0.0])), np.array([0.0, 6.0]))
        self.assertAlmostEqual(found.first, 5, 12)
        self.assertAlmostEqual(found.second, 5, 12)
        self.assertAlmostEqual(found.wrap, 2 * np.arctan2(3, 4), 12)

    def test_belt_meets_the_rod_at_right_angles_to_its_radius(self):
        centre, end, radius = np.array([1.0, -2.0]), np.array([5.0, 0.0]), 0.7
        along = belt.tangent(centre, radius, end, 1)
        touched = end - along * np.sqrt((end - centre) @ (end - centre) - radius**2)
        self.assertAlmostEqual(np.linalg.norm(touched - centre), radius, 12)
        self.assertAlmostEqual((touched - centre) @ along, 0, 12)
        self.assertLess(touched[1], centre[1])

    def test_half_a_turn_of_a_ships_rope(self):
        self.assertAlmostEqual(belt.sliding_ratio(0.3, np.pi), 2.5663, 4)


if __name__ == "__main__":
    unittest.main()
