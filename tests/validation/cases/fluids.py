"""What the enclosed fluid does: compression, flow between chambers, weight."""
from __future__ import annotations

import numpy as np

from oracles import axisymmetric_membrane, fluids, inflated_sphere, wall_laws
from suite.case import Case, Comparison, Quantity
from suite.program import Program


def enclosed(positions: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """Volumes (steps) within closed triangles."""
    a, b, c = (positions[:, triangles[:, k]] for k in range(3))
    return np.einsum("sti,sti->s", a, np.cross(b, c)) / 6


def compare_compressible(program: Program, triangles: int) -> Comparison:
    records = program.run("compressible_sphere", triangles=triangles)
    body, surface = records.body("balloon"), records.surface("balloon")
    volume = enclosed(surface.positions, surface.triangles)
    exact = fluids.compressible_pressure(300, 20e3, body["fluid_volume_m3"][0], volume)
    return Comparison([Quantity("pressure", "volume, ml", "Pa", 1e6 * volume, body["pressure_Pa"], exact)],
                      ["The volume is that of the recorded positions, which are single precision."])


def compare_two_chambers(program: Program, triangles: int) -> Comparison:
    surface = program.run("two_chambers", mesh=f"meshes/two_balloons_{triangles}.obj").surface("balloons")
    law, thickness = wall_laws.neo_hookean(40e3), 0.5e-3
    full = surface.rest[surface.triangles[:, 0], 0] < 0
    volumes = [enclosed(surface.positions - centre, surface.triangles[part])
               for part, centre in ((full, [-30e-3, 0, 0]), (~full, [30e-3, 0, 0]))]
    corners = surface.rest[surface.triangles[full]] - np.array([-30e-3, 0, 0])
    area = np.sum(np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)) / 2
    rest = float(np.sum(np.einsum("ti,ti->t", corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))) / 6)

    def pressure(volume: float) -> float:
        # An even polyhedron is as stiff as the sphere of radius 3 V / A.
        return inflated_sphere.pressure(law, thickness, 3 * rest / area, np.cbrt(volume / rest))

    later = surface.time > 1e-9
    exact = fluids.two_chambers((pressure, pressure), (volumes[0][0], volumes[1][0]), 4e-6, 0.61, 1000.0,
                                surface.time[later])
    return Comparison([Quantity(f"volume of the {name} chamber", "time, s", "ml", surface.time[later],
                                1e6 * volume[later], 1e6 * reference)
                       for name, volume, reference in zip(("first", "second"), volumes, exact)])


def compare_tank(program: Program, triangles: int) -> Comparison:
    records = program.run("tank", triangles=triangles)
    surface, body = records.surface("tank"), records.body("tank")
    radius = 20e-3
    pull, middle, points = fluids.tank_with_membrane_side(wall_laws.neo_hookean(20e3), 1e-3, radius, 9.81e3, 1.3)
    positions = surface.positions[-1]
    top = positions[:, 2] > 1e-6
    # The bulge is the distance from the half circle along the same radius.
    angles = np.arctan2(points[1], points[0])
    order = np.argsort(angles)
    model_angles = np.arctan2(positions[top, 2], positions[top, 0])
    exact = np.interp(model_angles, angles[order], np.hypot(*points)[order])
    model = np.hypot(positions[top, 0], positions[top, 2])
    return Comparison([
        Quantity("bulge", "angle from below, degrees", "mm", 180 - np.degrees(model_angles), 1e3 * (model - radius),
                 1e3 * (exact - radius), scale=1e3 * float(np.max(exact - radius)),
                 curve=(180 - np.degrees(angles[order]), 1e3 * (np.hypot(*points)[order] - radius))),
        Quantity("pressure in the middle", "one value", "Pa", np.array([0.0]), body["pressure_Pa"][-1:], np.array([middle]),
                 drawn=False)],
        [f"The membrane bears {pull:.3f} N/m everywhere; the pressure changes by {9.81e3 * 2 * radius:.0f} Pa from top to "
         "bottom."])


def compare_drop(program: Program, triangles: int) -> Comparison:
    records = program.run("drop_on_plane", triangles=triangles)
    floor, body, surface = records.tool("floor"), records.body("drop"), records.surface("drop")
    radius, thickness, c1, gravity, density = 20e-3, 1e-3, 10e3, 9.81, 2000.0
    volume = body["volume_m3"][0]
    weight = density * gravity * volume
    lift = -floor["fz_N"]
    if lift[-1] < weight:
        raise ValueError("the floor does not come up far enough")

    near = np.clip(np.searchsorted(lift, weight), 1, len(lift) - 2) + np.array([-1, 0, 1])

    def lying(values: np.ndarray) -> np.ndarray:
        """What the values (steps x ...) are where the floor bears the weight: between its neighbours on a parabola."""
        rows = values[near].reshape(3, -1)
        return np.array([1.0, 1.0, 1.0]) @ np.polyfit(lift[near] / weight, rows, 2)

    level = lying(floor["z_m"])[0]
    positions = lying(surface.positions).reshape(-1, 3)
    heights, from_axis = positions[:, 2] - level, np.hypot(positions[:, 0], positions[:, 1])
    model = np.array([heights.max(), from_axis.max(), lying(np.sqrt(floor["contact_area_m2"] / np.pi))[0]])
    exact = axisymmetric_membrane.drop_on_plane(wall_laws.neo_hookean(2.0), np.cbrt(volume / (4 / 3 * np.pi * radius**3)),
                                                density * gravity * radius**2 / (c1 * thickness))
    lengths = radius * np.array([exact.height, exact.largest_radius, exact.contact_radius])
    # The body's pressure is told at the height 0.
    pressure = lying(body["pressure_Pa"])[0] - density * gravity * level
    exact_pressure = exact.pressure_at_floor * c1 * thickness / radius
    # Beside the flat and at the crown the radius changes too steeply over the height to tell an error by it.
    inner = (heights > 0.05 * lengths[0]) & (heights < 0.95 * lengths[0])
    side = np.flatnonzero(inner & (np.abs(surface.rest[:, 1]) < 1e-6) & (surface.rest[:, 0] >= 0))
    side = side[np.argsort(heights[side])]
    return Comparison(
        [Quantity("distance from the axis, mm", "height above the floor, mm", "", 1e3 * heights[side], 1e3 * from_axis[side],
                  1e3 * radius * np.interp(heights[side] / radius, exact.meridian[1], exact.meridian[0]),
                  scale=1e3 * lengths[1], curve=(1e3 * radius * exact.meridian[1], 1e3 * radius * exact.meridian[0]),
                  judged=False),
         *(Quantity(name, "one value", "mm", np.array([0.0]), 1e3 * model[[k]], 1e3 * lengths[[k]], drawn=False)
           for k, name in enumerate(("height", "largest radius", "radius of the flat"))),
         Quantity("pressure at the floor", "one value", "Pa", np.array([0.0]), np.array([pressure]), np.array([exact_pressure]),
                  drawn=False)],
        [f"The drop of {1e6 * volume:.1f} ml weighs {weight:.3f} N: it is {1e3 * model[0]:.2f} mm high (reference "
         f"{1e3 * lengths[0]:.2f}), {2e3 * model[1]:.2f} mm wide ({2e3 * lengths[1]:.2f}), its flat has a radius of "
         f"{1e3 * model[2]:.2f} mm ({1e3 * lengths[2]:.2f}), the pressure at the floor is {pressure:.0f} Pa "
         f"({exact_pressure:.0f})."])


CASES = [
    Case("compressible_sphere", "Compressible fluid", "closed form", "pressure against volume", 0.001, (320, 1280),
         compare_compressible, quick=(320,), tells_order=False),
    Case("two_chambers", "Two chambers with an orifice", "ordinary differential equation",
         "volumes of both over two seconds", 0.001, (320, 1280), compare_two_chambers, quick=(320,)),
    Case("tank", "Tank with a membrane side", "ordinary differential equation", "bulge and pressure", 0.01,
         (250, 1000, 4000), compare_tank, quick=(1000,)),
    Case("drop_on_plane", "Drop on a plane", "axisymmetric membrane equations solved",
         "height, width, flat and pressure at the floor", 0.01, (320, 1280, 5120), compare_drop),
]
