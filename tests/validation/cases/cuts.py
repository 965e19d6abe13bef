"""What a cut lets go: the lips of a slit in a stretched sheet, what a strip has stored, the contents of a ball with a hole."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline

from oracles import fluids, slit
from suite.case import Case, Comparison, Quantity
from suite.program import Program

SHEAR, STRETCH, THICKNESS = 20e3, 1.01, 1e-3  # pascal, of the given sheet, metres
MODULUS, STRESS = 3 * SHEAR, slit.stress(SHEAR, STRETCH)  # pascal


@dataclass(frozen=True)
class Slit:
    """A slit that has opened. Lengths in metres, in the sheet as it was stretched before, and as it is."""

    given_places: np.ndarray  # (pairs), of lips opposite to each other, from the middle
    places: np.ndarray  # (pairs)
    half_opening: np.ndarray  # (pairs)
    released: float  # joule

    def given_half(self) -> float:
        return float(np.ptp(self.given_places) / 2)

    def half(self) -> float:
        return float(np.ptp(self.places) / 2)


def cut_slit(program: Program, triangles: int, length: float) -> Slit:
    """`length`: millimetres."""
    records = program.run("slit", mesh=f"meshes/slit_sheet_{triangles}.obj", length=f"{length:g} mm",
                          standoff=f"{length - 0.1:g} mm")
    surface, elastic = records.surface("sheet", after_cuts=True), records.body("sheet")["elastic_J"]
    edges = surface.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    there, back = {tuple(edge) for edge in edges.tolist()}, {tuple(edge) for edge in edges[:, ::-1].tolist()}
    # The sheet is 40 slits wide: what borders it here are the lips.
    border = sorted({corner for edge in there - back for corner in edge
                     if np.linalg.norm(surface.rest[corner]) < 5e-3 * length})
    pairs: dict[tuple, list[int]] = {}
    for vertex in border:
        pairs.setdefault(tuple(surface.rest[vertex]), []).append(vertex)
    order = sorted(pairs.values(), key=lambda pair: surface.rest[pair[0], 0])
    first, second = (surface.positions[-1][[pair[k] for pair in order]] for k in (0, -1))
    given, now = surface.rest[[pair[0] for pair in order], 0], (first[:, 0] + second[:, 0]) / 2
    return Slit(given_places=given - (given[0] + given[-1]) / 2, places=now - (now[0] + now[-1]) / 2,
                half_opening=np.linalg.norm(first - second, axis=1) / 2, released=elastic[0] - elastic[-1])


def compare_with_griffith(program: Program, triangles: int) -> Comparison:
    shorter, longer = (cut_slit(program, triangles, length) for length in (20, 22))
    half = shorter.half()
    mean, grown = (longer.half() + half) / 2, longer.half() - half
    new_area = 2 * grown * THICKNESS / STRETCH**2  # of both tips
    rate = (longer.released - shorter.released) / new_area
    exact_rate = slit.release_rate(STRESS, MODULUS, mean)
    fine = np.linspace(-half, half, 401)
    middle = float(np.max(shorter.half_opening)) / (2 * STRESS / MODULUS * half)
    return Comparison(
        [Quantity("half-opening", "distance from the middle, mm", "mm", 1e3 * shorter.places, 1e3 * shorter.half_opening,
                  1e3 * slit.half_opening(STRESS, MODULUS, half, shorter.places), scale=2e3 * STRESS / MODULUS * half,
                  curve=(1e3 * fine, 1e3 * slit.half_opening(STRESS, MODULUS, half, fine)), reference_name="Griffith"),
         Quantity("energy released per tip and new area", "one value", "J/m^2", np.array([0.0]), np.array([rate]),
                  np.array([exact_rate]), allowance=1.5, drawn=False)],
        [f"Lengths and areas are those of the sheet as it lies in the end; the slit, {2e3 * shorter.given_half():.3f} mm "
         f"long when it is cut, is {2e3 * half:.3f} mm long when it has opened. The energy is what a slit of 22 mm releases more "
         f"than one of 20 mm, each in a sheet 40 times as wide: {rate:.4f} J/m^2, reference {exact_rate:.4f}.",
         f"In the middle it opens by {middle:.4f} of what Griffith found. His sheet is not stretched before it is cut: "
         "1.5 % of the opening and 0.8 % of the energy are that, and no mesh takes them away (next case).",
         "The energy's own bar is 3 %."])


def compare_with_stretched_sheet(program: Program, triangles: int) -> Comparison:
    shorter, longer = (cut_slit(program, triangles, length) for length in (20, 22))
    compliance, half = slit.compliance_of_stretched_sheet(STRETCH), shorter.given_half()
    grown = longer.given_half() - half
    rate = (longer.released - shorter.released) / (2 * grown * THICKNESS / STRETCH**2)
    exact_rate = compliance * slit.release_rate(STRESS, MODULUS, half + grown / 2)
    inner = np.abs(shorter.given_places) < 0.9 * half
    places, fine = shorter.given_places[inner], np.linspace(-half, half, 401)
    return Comparison(
        [Quantity("half-opening, but for a tenth at each tip", "distance from the middle, mm", "mm", 1e3 * places,
                  1e3 * shorter.half_opening[inner], 1e3 * compliance * slit.half_opening(STRESS, MODULUS, half, places),
                  scale=2e3 * compliance * STRESS / MODULUS * half,
                  curve=(1e3 * fine, 1e3 * compliance * slit.half_opening(STRESS, MODULUS, half, fine))),
         Quantity("energy released per tip and new area", "one value", "J/m^2", np.array([0.0]), np.array([rate]),
                  np.array([exact_rate]), drawn=False, judged=False)],
        [f"Lengths and areas are those of the stretched sheet before it is cut; the moduli too, which make a slit open by "
         f"{compliance:.4f} of Griffith's. The energy, which depends on the tip, converges more slowly than the opening: "
         f"{rate:.4f} J/m^2, reference {exact_rate:.4f}."])


STRIP_SHEAR, TOUGHNESS, HEIGHT = 100e3, 1e3, 20e-3  # pascal, J/m^2, metres as the strip is given


def compare_cut_strip(program: Program, triangles: int) -> Comparison:
    stretches = np.array([1.1, 1.2, 1.3])
    felt = []
    for stretch in stretches:
        records = program.run("cut_strip", triangles=triangles, stretch=f"{stretch:g}")
        blade, work = records.tool("blade"), records.body("strip")["tool_work_J"]
        # Two heights away from both ends of the strip, and one from where the cut began.
        steady = np.flatnonzero((blade["phase"] == "cutting") & (np.abs(blade["x_m"]) <= HEIGHT))
        felt.append((work[steady[-1]] - work[steady[0]]) / (blade["x_m"][steady[-1]] - blade["x_m"][steady[0]]))
    released = np.array([slit.release_of_strip(STRIP_SHEAR, stretch, HEIGHT / stretch) for stretch in stretches])
    return Comparison(
        [Quantity("mean force on the blade", "stretch", "N", stretches, np.array(felt), (TOUGHNESS - released) * THICKNESS,
                  reference_name="Lake and Yeoh")],
        ["What cutting and tearing cost together is constant, so that the blade feels toughness times thickness less what the "
         f"strip releases, up to {released[-1] / TOUGHNESS:.0%} of it here. The force is the blade's work over its way: from "
         "triangle to triangle it rises and falls, and forces.csv has it where a step ends, after the cut has gone on."])


DISCHARGE, DENSITY = 0.61, 1010.0  # none, kg/m^3


def compare_leak(program: Program, steps: int) -> Comparison:
    filled = program.run("leak", step="10 ms", leaks="false").body("ball")
    filling = (filled["time_s"] > 0.73) & (filled["time_s"] < 1.205)
    pressure_of_volume = CubicSpline(filled["volume_m3"][filling], filled["pressure_Pa"][filling])

    body = program.run("leak", step=f"{1000 / steps:g} ms", leaks="true").body("ball")
    alone = (body["time_s"] > 1.2 - 1e-6) & (body["pressure_Pa"] > 40)
    time, volume, pressure, area = (body[name][alone] for name in ("time_s", "volume_m3", "pressure_Pa", "open_area_m2"))
    if np.ptp(area) > 1e-9 * area[0]:
        raise ValueError("the opening is not fixed")
    fine = np.linspace(time[0], time[-1], 200)
    exact, drawn = (pressure_of_volume(fluids.leak(pressure_of_volume, volume[0], area[0], DISCHARGE, DENSITY, each))
                    for each in (time, fine))
    return Comparison([Quantity("pressure", "time, s", "Pa", time, pressure, exact, curve=(fine, drawn))],
                      [f"The opening has {1e6 * area[0]:.2f} mm^2; the pressure falls from {pressure[0]:.0f} Pa to a tenth. "
                       "How it follows the volume is taken from the same ball when it is filled and does not leak. Longer "
                       "steps cut a smaller hole, which the reference for them takes too. The crown is held, and "
                       "with it the disc that was cut out of it, which stays where it was."])


CASES = [
    Case("slit", "Slit in a stretched sheet", "Griffith 1921", "opening along the slit, energy released", 0.02,
         (1632, 4480, 14112), compare_with_griffith, quick=(4480,), quick_bar=0.03, tells_order=False),
    Case("slit_in_stretched_sheet", "Slit in a stretched sheet, small on large", "closed form; Biot 1965",
         "opening along the slit", 0.005, (1632, 4480, 14112), compare_with_stretched_sheet, scenario="slit"),
    Case("cut_strip", "Cut through a stretched strip", "Rivlin and Thomas 1953; Lake and Yeoh 1978", "force on the blade", 0.01,
         (500, 1250, 3200), compare_cut_strip, quick=(1250,), tells_order=False),
    Case("leak", "Leak through a fixed opening", "ordinary differential equation", "pressure until a tenth is left", 0.01,
         (25, 50, 100), compare_leak, quick=(50,), size_name="steps a second", size_dimension=1),
]
