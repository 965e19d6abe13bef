"""Airbags, square and round: they rise only as far as their wrinkles let them."""
from __future__ import annotations

import numpy as np

from oracles import film_balloon
from suite.case import Case, Comparison, Quantity
from suite.program import Program

# Metres; as the tables of Zhang and Kiendl 2025 (arXiv:2504.03400) gather them, on 8 x 8 and 10 x 10 elements. Known
# from a transcription of these tables.
PUBLISHED = (0.2050, 0.2140, 0.2163, 0.2166, 0.2167)
RISE = 0.217  # metres, of the middle


def compare(program: Program, triangles: int) -> Comparison:
    records = program.run("airbag", triangles=triangles)
    middle, edge = records.point("sheet", "middle"), records.point("sheet", "edge")
    corner = records.point("sheet", "corner")
    rises = 1e3 * middle["uz_m"]
    later = middle["time_s"] > 0.15
    return Comparison(
        [Quantity("rise of the middle at 5 kPa", "pressure, kPa", "mm", np.array([5.0]), rises[-1:], np.array([1e3 * RISE]),
                  drawn=False),
         Quantity("rise of the middle", "pressure, kPa", "mm", 5 * middle["time_s"][later], rises[later],
                  np.full(np.sum(later), 1e3 * RISE), judged=False, reference_name="later authors, at 5 kPa")],
        [f"At 5 kPa the middle rises by {rises[-1]:.1f} mm, the middle of an edge is drawn in by {-1e3 * edge['ux_m'][-1]:.1f} "
         f"mm, the corner by {-1e3 * corner['ux_m'][-1]:.1f} mm along x and {-1e3 * corner['uy_m'][-1]:.1f} mm along y. "
         f"Published rises found: {1e3 * PUBLISHED[0]:.1f} to {1e3 * PUBLISHED[-1]:.1f} mm (8 x 8 and 10 x 10 elements, as "
         "gathered by Zhang and Kiendl 2025, known from a transcription of their tables)."])


def compare_film_balloon(program: Program, triangles: int) -> Comparison:
    records = program.run("film_balloon", triangles=triangles)
    radius, load = 0.1, 100.0 * 0.1 / (5e6 * 0.05e-3)
    surface, middle = records.surface("film"), records.point("film", "middle")
    rim = np.hypot(surface.rest[:, 0], surface.rest[:, 1]) > 0.999 * radius
    reach = np.hypot(surface.positions[-1, rim, 0], surface.positions[-1, rim, 1])
    exact = film_balloon.inflated(load)
    return Comparison(
        [Quantity("mean radius of the rim, rise of the middle", "which", "mm", np.array([1.0, 2.0]),
                  1e3 * np.array([reach.mean(), middle["uz_m"][-1]]), 1e3 * radius * np.array([exact.rim, exact.half_height]))],
        [f"The rim is uneven, as on such balloons: from {1e3 * reach.min():.1f} to {1e3 * reach.max():.1f} mm (reference "
         f"{1e3 * radius * exact.rim:.1f}). Films that do not stretch would have 76.3 mm and rise by 45.7 mm; "
         f"this one rises by {1e3 * middle['uz_m'][-1]:.2f} mm (reference {1e3 * radius * exact.half_height:.2f})."])


CASES = [
    Case("airbag", "Square airbag", "Contri and Schrefler 1988; later authors' 217 mm", "rise of the middle at 5 kPa", 0.03,
         (136, 496, 1118), compare, quick=(136,), tells_order=False),
    Case("film_balloon", "A balloon of two round films", "Paulsen 1994; axisymmetric equations with tension field solved",
         "radius of the rim, rise of the middle", 0.005, (300, 1200), compare_film_balloon, quick=(300,), quick_bar=0.01,
         tells_order=False),
]
