"""Tools of a size against membranes."""
from __future__ import annotations

import numpy as np
from scipy.optimize import brentq

from oracles import axisymmetric_membrane, drum, wall_laws
from suite.case import Case, Comparison, Quantity
from suite.program import Program

FINEST_HEMISPHERE = 16384


def compare_hemisphere(program: Program, triangles: int) -> Comparison:
    coarse = program.run("hemisphere", triangles=triangles)
    fine = program.run("hemisphere", triangles=FINEST_HEMISPHERE)
    probe, finest = coarse.tool("probe"), fine.tool("probe")
    steps = np.flatnonzero(finest["depth_m"] > 0.9e-3)
    depth = 1e3 * finest["depth_m"][steps]
    # The crown is a vertex of every mesh, so all meshes are touched at the same time.
    return Comparison([
        Quantity("force", "depth, mm", "N", depth, probe["fz_N"][steps], finest["fz_N"][steps],
                 scale=float(finest["fz_N"][steps[-1]])),
        Quantity("pressure", "depth, mm", "Pa", depth, coarse.body("organ")["pressure_Pa"][steps],
                 fine.body("organ")["pressure_Pa"][steps])])


def compare_drum(program: Program, triangles: int) -> Comparison:
    ball = program.run("drum_under_ball", mesh=f"meshes/drum_{triangles}.obj").tool("ball")
    radius = 400e-3
    pull = drum.tension(50e3, 0.5e-3, 1.3)

    def contact(depth: float) -> float:
        return brentq(lambda c: drum.indentation(radius, radius, pull, c)[0] - depth, 1e-6, 0.2 * radius)

    first, last = (drum.indentation(radius, radius, pull, part * radius)[0] for part in (0.04, 0.1))
    steps = np.flatnonzero((ball["depth_m"] >= first) & (ball["depth_m"] <= last))
    depths = ball["depth_m"][steps]
    radii = np.array([contact(depth) for depth in depths])
    forces = np.array([drum.indentation(radius, radius, pull, c)[1] for c in radii])
    across = 0.1 / (np.sinh(4 / np.sqrt(triangles / 6)) / np.sinh(4))
    return Comparison(
        [Quantity("force", "depth, mm", "N", 1e3 * depths, ball["fz_N"][steps], forces),
         Quantity("contact radius", "depth, mm", "mm", 1e3 * depths, 1e3 * np.sqrt(ball["contact_area_m2"][steps] / np.pi),
                  1e3 * radii)],
        [f"{across:.1f} elements along the largest contact radius, {0.4 * across:.1f} along the smallest. The reference is "
         "that of small slopes and constant tension."])


def compare_ball_between_plates(program: Program, triangles: int) -> Comparison:
    records = program.run("ball_between_plates", mesh=f"meshes/ball_{triangles}.obj")
    plate, body = records.tool("upper"), records.body("ball")
    radius, inflated, c1_h = 30e-3, 33e-3, 20e3 * 0.5e-3
    closeness = 1 - plate["z_m"] / inflated
    steps = np.flatnonzero(closeness > 0.049)
    exact = axisymmetric_membrane.ball_between_plates(wall_laws.neo_hookean(2.0), 1.1, list(closeness[steps]))
    forces, pressures = ([getattr(ball, name) for ball in exact] for name in ("force", "pressure"))
    contacts = np.sqrt(plate["contact_area_m2"][steps] / np.pi) / inflated
    return Comparison([
        Quantity("force over c1 h r", "1 - gap / diameter", "", closeness[steps], plate["fz_N"][steps] / (c1_h * radius),
                 np.array(forces)),
        Quantity("pressure over c1 h / r", "1 - gap / diameter", "", closeness[steps],
                 body["pressure_Pa"][steps] * radius / c1_h, np.array(pressures)),
        Quantity("contact radius over inflated radius", "1 - gap / diameter", "", closeness[steps], contacts,
                 np.array([ball.contact_radius / 1.1 for ball in exact]), judged=False)],
        ["The mesh is twice as fine under the plates. On an even mesh of 5 120 triangles the force is 1.05 % low at 5 %: its "
         "chords lie up to 0.1 % of the radius inside the sphere, which is nearly 2 % of the way that the plates have come by then; on "
         "an even mesh of the sphere's volume, whose vertices stand out, it is 1.1 % high."])


CASES = [
    Case("ball_between_plates", "Ball between two plates", "Feng and Yang 1973, axisymmetric equations solved",
         "force and pressure from 5 % to 50 %", 0.01, (320, 1280, 5120), compare_ball_between_plates),
    Case("drum_under_ball", "Pretensioned drum under a ball", "closed form, small slopes",
         "force for c/R from 0.04 to 0.10, growth of the contact", 0.02, (1536, 3456, 7776), compare_drum, quick=(3456,)),
    Case("hemisphere", "The published hemisphere", "own finest mesh (16 384 triangles)",
         "force and pressure under a ball, to 4 mm", None, (64, 256, 1024, 4096), compare_hemisphere),
]
