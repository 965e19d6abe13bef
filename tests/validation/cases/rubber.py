"""Stretched sheets, balloons and discs under pressure."""
from __future__ import annotations

from functools import lru_cache

import numpy as np
from scipy.interpolate import CubicSpline

from oracles import (axisymmetric_membrane, bulging_tube, four_pulls, hencky, inflated_sphere, stretched_ring, strips,
                     wall_laws)
from suite.case import Case, Comparison, Quantity
from suite.program import Program, Surface


def compare_strips(program: Program, triangles: int) -> Comparison:
    records = program.run("strips_in_series", triangles=triangles)
    laws = (wall_laws.neo_hookean(20e3), wall_laws.mooney_rivlin(12e3, 4e3))
    prestretch, half = 1.3, 20e-3
    rest = half / prestretch
    thick, thin, _ = strips.in_series(laws, (1e-3, 0.4e-3), (rest, rest), 2 * (half - rest), across=prestretch)
    points = [records.point("strip", name) for name in ("thick_half", "joint", "thin_half")]
    model = np.array([point["ux_m"][-1] for point in points])
    along = np.array([point["x_m"][-1] - point["ux_m"][-1] for point in points])
    # Stress-free x of the given shape becomes x / prestretch; the thick half begins at -half.
    stretched = np.where(along < 0, -half + thick * (along + half) / prestretch, half - thin * (half - along) / prestretch)
    return Comparison([Quantity("motion along the strip", "place, mm", "mm", 1e3 * along, 1e3 * model,
                                1e3 * (stretched - along))])


def compare_stretched_ring(program: Program, triangles: int) -> Comparison:
    surface = program.run("stretched_ring", triangles=triangles).surface("ring")
    given = np.linalg.norm(surface.rest, axis=1)
    now = np.linalg.norm(surface.positions[-1], axis=1)
    # The stress-free ring is the given one shrunk to a half.
    exact = stretched_ring.radii(wall_laws.mooney_rivlin(8e3, 2e3), 5e-3, 20e-3, 40e-3)
    order = np.argsort(given, kind="stable")
    return Comparison([Quantity("distance from the middle", "stress-free, mm", "mm", 500 * given[order], 1e3 * now[order],
                                1e3 * exact(given[order] / 2))],
                      [f"The hole's radius is {1e3 * now.min():.3f} mm (reference {1e3 * float(exact(5e-3)):.3f})."])


RADIUS, THICKNESS = 30e-3, 0.5e-3  # metres, of the balloon


def compare_inflation(scenario: str, law: wall_laws.Law, program: Program, triangles: int) -> Comparison:
    body = program.run(scenario, triangles=triangles).body("balloon")
    volume = body["volume_m3"][1:]
    stretch = np.cbrt(volume / body["volume_m3"][0])
    exact = np.array([inflated_sphere.pressure(law, THICKNESS, RADIUS, each) for each in stretch])
    fine = np.linspace(1.0, stretch[-1], 120)
    curve = np.array([inflated_sphere.pressure(law, THICKNESS, RADIUS, each) for each in fine])
    pressure = body["pressure_Pa"][1:]
    limit, exact_limit = CubicSpline(stretch, pressure).derivative().roots()[0], inflated_sphere.limit_point(law)
    return Comparison(
        [Quantity("pressure", "stretch", "Pa", stretch, pressure, exact, curve=(fine, curve)),
         Quantity("stretch at the limit point", "which", "", np.array([1.0]), np.array([limit]), np.array([exact_limit]),
                  drawn=False)],
        [f"The pressure has its first maximum at a stretch of {limit:.4f} (reference {exact_limit:.4f})."])


def inflation(name: str, title: str, law: wall_laws.Law) -> Case:
    return Case(f"sphere_inflation_{name}", f"Inflation of a sphere, {title}", "closed form, Adkins and Rivlin 1952",
                "pressure to a stretch of 3, through the limit point", 0.003, (320, 1280, 5120),
                lambda program, triangles: compare_inflation(f"sphere_inflation_{name}", law, program, triangles),
                quick=(320, 1280), quick_bar=0.005)


def compare_circular_membrane(program: Program, triangles: int) -> Comparison:
    ratios = np.array([0.0, 0.3, 0.4])
    heights = []
    for ratio in ratios:
        surface = program.run("circular_membrane", triangles=triangles, poisson_ratio=ratio).surface("sheet")
        heights.append(surface.positions[-1][surface.nearest([0, 0, 0]), 2])
    exact = [hencky.centre_deflection(0.1, 0.1, 1e6, 1e-3, ratio) for ratio in ratios]
    return Comparison([Quantity("height of the centre", "Poisson's ratio", "mm", ratios, 1e3 * np.abs(heights),
                                1e3 * np.array(exact))])


def compare_ring_membrane(program: Program, triangles: int) -> Comparison:
    """Schwerin's: with Poisson's ratio 1/3 and u = 0, w = w0 (r^(2/3) - b^(2/3)) / (a^(2/3) - b^(2/3)) solves Föppl's
    equations, under the force pi/3 E h w0^3 / (a^(2/3) - b^(2/3))^3."""
    outer, inner, modulus, thickness, line_force = 100e-3, 25e-3, 1e6, 1e-3, 5e-3
    surface = program.run("ring_membrane", triangles=triangles).surface("ring")
    radii = np.hypot(surface.rest[:, 0], surface.rest[:, 1])
    reach = radii ** (2 / 3) - inner ** (2 / 3)
    whole = outer ** (2 / 3) - inner ** (2 / 3)
    force = line_force * 2 * np.pi * outer
    height = whole * (3 * force / (np.pi * modulus * thickness)) ** (1 / 3)
    vertices = [surface.nearest([x, 0, 0]) for x in np.linspace(inner, outer, 6)[1:]]
    loads = 0.1 + 0.9 * surface.time[1:]
    rim = surface.nearest([outer, 0, 0])
    return Comparison([
        Quantity("height along a radius", "r", "mm", 1e3 * radii[vertices], 1e3 * surface.positions[-1][vertices, 2],
                 1e3 * height * reach[vertices] / whole),
        Quantity("height of the rim", "part of the force", "mm", loads, 1e3 * surface.positions[1:, rim, 2],
                 1e3 * height * loads ** (1 / 3))])


def compare_rubber_disc(program: Program, triangles: int) -> Comparison:
    surface = program.run("rubber_disc", triangles=triangles).surface("disc")
    law, radius = wall_laws.neo_hookean(2.0), 50e-3
    parts = np.arange(0.5, 3.61, 0.5)
    centre = surface.nearest([0, 0, 0])
    steps = [int(np.argmin(np.abs(surface.time - part))) for part in parts]
    heights = np.abs(surface.positions[steps, centre, 2]) / radius

    return Comparison([Quantity("height of the pole over the radius", "p a / (c1 h)", "", parts, heights,
                                np.array(axisymmetric_membrane.disc_heights(law, list(parts))))],
                      ["The most that the disc bears is p a / (c1 h) = 3.758; the load goes to 3.5 of it."])


def stretch_at(surface: Surface, vertex: int) -> np.ndarray:
    """Mean stretch (steps) of the edges at a vertex."""
    corners = surface.triangles[np.any(surface.triangles == vertex, axis=1)]
    around = np.setdiff1d(corners, [vertex])
    rest = np.linalg.norm(surface.rest[around] - surface.rest[vertex], axis=1)
    now = np.linalg.norm(surface.positions[:, around] - surface.positions[:, [vertex]], axis=2)
    return np.mean(now / rest, axis=1)


@lru_cache
def disc_reference() -> tuple[np.ndarray, np.ndarray]:
    """Stretches of the pole, and pressures and heights (2 x stretches) at these."""
    poles = np.concatenate([np.linspace(1.01, 1.2, 12), np.linspace(1.25, 3.8, 52)])
    return poles, axisymmetric_membrane.disc_path(wall_laws.neo_hookean(2.0), list(poles))


def compare_filled_disc(program: Program, triangles: int) -> Comparison:
    records = program.run("rubber_disc_filled", mesh=f"meshes/disc_on_cone_{triangles}.obj")
    surface, height = records.surface("disc"), records.point("disc", "middle")["z_m"] / 50e-3
    pressure = records.body("disc")["pressure_Pa"] / 200  # of c1 h / a
    stretch = stretch_at(surface, surface.nearest([0, 0, 0]))
    poles, path = disc_reference()
    steps = np.flatnonzero((height > 0.25) & (height < path[1, -1]))
    exact_pressure, exact_pole = (CubicSpline(path[1], values)(height[steps]) for values in (path[0], poles))
    most, exact_most = np.argmax(pressure), np.argmax(path[0])
    return Comparison(
        [Quantity("p a / (c1 h)", "height of the pole over the radius", "", height[steps], pressure[steps], exact_pressure,
                  curve=(path[1], path[0])),
         Quantity("stretch of the pole", "height of the pole over the radius", "", height[steps], stretch[steps], exact_pole,
                  curve=(path[1], poles))],
        [f"The largest pressure of the steps is {pressure[most]:.3f} c1 h / a, at a stretch of the pole of {stretch[most]:.2f} "
         f"(reference {path[0, exact_most]:.3f} at {poles[exact_most]:.2f})."])


OGDEN = wall_laws.ogden([(617e3, 1.3), (1.86e3, 5.0), (-9.79e3, -2.0)])


def compare_bulging_tube(program: Program, triangles: int) -> Comparison:
    records = program.run("bulging_tube", mesh=f"meshes/long_tube_{triangles}.obj")
    body, surface = records.body("tube"), records.surface("tube")
    filled, pressure = body["volume_m3"] / body["volume_m3"][0], body["pressure_Pa"]
    _, bulge = bulging_tube.maxwell(OGDEN, 7.0)
    level = 0.02 * bulge.pressure  # of thickness over radius
    runs, rises = filled > 8.5, filled > 1.05
    widest, at_rest = (np.max(np.hypot(place[:, 0], place[:, 2])) for place in (surface.positions[-1], surface.rest))
    return Comparison(
        [Quantity("pressure while the bulge runs", "volume over that at rest", "Pa", filled[runs], pressure[runs],
                  np.full(np.sum(runs), level), reference_name="Maxwell"),
         Quantity("pressure", "volume over that at rest", "Pa", filled[rises], pressure[rises], np.full(np.sum(rises), level),
                  judged=False, reference_name="Maxwell")],
        [f"Maxwell's pressure is {level:.0f} Pa, the largest that comes up {np.max(pressure):.0f}. A bulge without end would be "
         f"{bulge.around:.2f} times as wide as the tube at rest, this one is in the end {widest / at_rest:.2f} times."])


def compare_four_pulls(program: Program, triangles: int) -> Comparison:
    records = program.run("four_pulls", triangles=triangles)
    right, left, far, near = (records.point("sheet", name) for name in ("right", "left", "far", "near"))
    along, across = (right["x_m"] - left["x_m"]) / 40e-3, (far["y_m"] - near["y_m"]) / 40e-3
    parts = right["time_s"]
    exact = four_pulls.stretches(wall_laws.mooney_rivlin(20e3, 10e3), 1e-3, [(250 * part, 249.75 * part) for part in parts])
    return Comparison([Quantity("stretch along x", "part of the pull", "", parts, along, exact[:, 0]),
                       Quantity("stretch along y", "part of the pull", "", parts, across, exact[:, 1])],
                      ["Pulls along y are a thousandth smaller, which decides along which axis it grows."])


CASES = [
    inflation("neo_hookean", "neo-Hookean", wall_laws.neo_hookean(40e3)),
    inflation("mooney_rivlin", "Mooney–Rivlin", wall_laws.mooney_rivlin(16e3, 2e3)),
    Case("circular_membrane", "Circular membrane under small pressure", "Hencky 1915, Föppl's equations solved",
         "height of the centre at three Poisson's ratios", 0.01, (150, 384, 600), compare_circular_membrane, quick=(150,),
         quick_bar=0.03),
    Case("ring_membrane", "Ring membrane under a force at its rim", "Schwerin 1929, closed form at Poisson's ratio 1/3",
         "height along a radius, height of the rim over the force", 0.005, (400, 1600, 6400), compare_ring_membrane,
         quick=(1600,)),
    Case("rubber_disc", "Clamped rubber disc under follower pressure", "axisymmetric membrane equations solved",
         "height of the pole to near the limit point", 0.005, (150, 600, 2400), compare_rubber_disc, quick=(600,),
         quick_bar=0.015),
    Case("rubber_disc_filled", "Clamped rubber disc, filled through its limit point", "axisymmetric membrane equations solved",
         "pressure and stretch of the pole over the height of the pole", 0.005, (600, 2400, 5400), compare_filled_disc),
    Case("stretched_ring", "Ring stretched to twice its size", "Rivlin and Thomas 1951, ordinary differential equation",
         "distances from the middle, the hole's too", 0.005, (600, 2400, 9600), compare_stretched_ring, quick=(2400,)),
    Case("strips_in_series", "Two strips in series", "closed form", "motion of the joint and of both halves", 1e-6, (200, 800),
         compare_strips, quick=(200,)),
    Case("bulging_tube", "A bulge that runs along a tube", "Maxwell's rule; Kyriakides and Chang 1991",
         "pressure while the bulge runs", 0.01, (1320, 2624), compare_bulging_tube, quick=(1320,), tells_order=False),
    Case("four_pulls", "A square under four equal pulls", "closed form of the law; Treloar 1948, Kearsley 1986",
         "stretches along both axes, through the branching", 1e-6, (60, 600), compare_four_pulls, quick=(60,),
         tells_order=False),
]
