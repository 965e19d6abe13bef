"""The square airbag of Contri and Schrefler: it rises only as far as its wrinkles let it."""
from __future__ import annotations

import numpy as np

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


CASES = [
    Case("airbag", "Square airbag", "Contri and Schrefler 1988; later authors' 217 mm", "rise of the middle at 5 kPa", 0.03,
         (136, 496, 1118), compare, quick=(136,), tells_order=False),
]
