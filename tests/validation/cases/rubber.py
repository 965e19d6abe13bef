"""Stretched sheets and balloons."""
from __future__ import annotations

import numpy as np

from oracles import strips, wall_laws
from suite.case import Case, Comparison, Quantity
from suite.program import Program


def compare_strips(program: Program, triangles: int) -> Comparison:
    surface = program.run("strips_in_series", triangles=triangles).surface("strip")
    law = wall_laws.neo_hookean(20e3)
    prestretch, half = 1.3, 20e-3
    rest = half / prestretch
    thick, _, _ = strips.in_series((law, law), (1e-3, 0.4e-3), (rest, rest), 2 * (half - rest), across=prestretch)
    # Stress-free x of the given shape becomes x / prestretch; the thick half begins at -half.
    along = surface.rest[:, 0]
    thin = (2 * half - thick * rest) / rest
    stretched = np.where(along < 0, -half + thick * (along + half) / prestretch, half - thin * (half - along) / prestretch)
    model = surface.positions[-1][:, 0]
    order = np.argsort(along)
    return Comparison([Quantity("motion along the strip", "place, mm", "mm", 1e3 * along[order],
                                1e3 * (model - along)[order], 1e3 * (stretched - along)[order],
                                scale=1e3 * float(np.max(np.abs(stretched - along))))],
                      ["Positions of a take are single precision, 2e-9 m here, of a largest motion of "
                       f"{1e3 * np.max(np.abs(stretched - along)):.3f} mm."])


CASES = [
    Case("strips_in_series", "Two strips in series", "closed form", "motion of every vertex", 1e-6, (200, 800),
         compare_strips, quick=(200,)),
]
