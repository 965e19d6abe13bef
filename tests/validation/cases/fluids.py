"""What the enclosed fluid does: compression."""
from __future__ import annotations

from oracles import fluids
from suite.case import Case, Comparison, Quantity
from suite.program import Program


def compare_compressible(program: Program, triangles: int) -> Comparison:
    body = program.run("compressible_sphere", triangles=triangles).body("balloon")
    volume = body["volume_m3"]
    exact = fluids.compressible_pressure(300, 20e3, body["fluid_volume_m3"], volume)
    return Comparison([Quantity("pressure", "volume, ml", "Pa", 1e6 * volume, body["pressure_Pa"], exact)])


CASES = [
    Case("compressible_sphere", "Compressible fluid", "closed form", "pressure against volume", 0.001, (320, 1280),
         compare_compressible, quick=(320,)),
]
