"""Writes the surfaces of scenes/validation that are no shapes of the scenario format."""
from __future__ import annotations

from pathlib import Path
from typing import Optional

import numpy as np

MESHES = Path(__file__).resolve().parents[2] / "scenes" / "validation" / "meshes"


def geodesic_sphere(divisions: int) -> tuple[np.ndarray, list[tuple[int, int, int]]]:
    """A unit sphere: an icosahedron whose triangles are halved `divisions` times."""
    golden = (1 + 5**0.5) / 2
    points = [np.array(p) / np.hypot(1, golden) for p in (
        (-1, golden, 0), (1, golden, 0), (-1, -golden, 0), (1, -golden, 0), (0, -1, golden), (0, 1, golden),
        (0, -1, -golden), (0, 1, -golden), (golden, 0, -1), (golden, 0, 1), (-golden, 0, -1), (-golden, 0, 1))]
    triangles = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2),
                 (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11),
                 (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(divisions):
        middles: dict[tuple[int, int], int] = {}

        def middle(a: int, b: int) -> int:
            key = (min(a, b), max(a, b))
            if key not in middles:
                between = points[a] + points[b]
                points.append(between / np.linalg.norm(between))
                middles[key] = len(points) - 1
            return middles[key]

        finer = []
        for a, b, c in triangles:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        triangles = finer
    return np.array(points), triangles


Triangles = list[tuple[int, int, int]]


def write(name: str, points: np.ndarray, triangles: Triangles, told: str,
          groups: Optional[dict[str, Triangles]] = None) -> None:
    lines = [f"# {told}"]
    lines += ["v " + " ".join(f"{value:.9g}" for value in point) for point in points]
    lines += ["f " + " ".join(str(corner + 1) for corner in triangle) for triangle in triangles]
    for group, members in (groups or {}).items():
        lines.append(f"g {group}")
        lines += ["f " + " ".join(str(corner + 1) for corner in triangle) for triangle in members]
    MESHES.mkdir(exist_ok=True)
    (MESHES / name).write_text("\n".join(lines) + "\n", encoding="utf-8")


def two_balloons(divisions: int) -> None:
    points, triangles = geodesic_sphere(divisions)
    both = np.vstack([20 * points - [30, 0, 0], 20 * points + [30, 0, 0]])
    shifted = [tuple(corner + len(points) for corner in triangle) for triangle in triangles]
    write(f"two_balloons_{len(triangles)}.obj", both, triangles + shifted,
          "Two spheres of radius 20, their centres 60 apart; millimetres")


def ball(divisions: int) -> None:
    """A sphere of radius 30, twice as fine at its poles, where plates press it, as a geodesic one."""
    points, triangles = geodesic_sphere(divisions)
    upright = points[1]  # a vertex of the icosahedron becomes a pole
    first = np.cross(upright, [0.0, 0.0, 1.0])
    first /= np.linalg.norm(first)
    points = points @ np.array([first, np.cross(upright, first), upright]).T
    from_pole = np.arccos(np.clip(points[:, 2], -1, 1))
    nearer = from_pole - np.sin(2 * from_pole) / 4
    around = np.arctan2(points[:, 1], points[:, 0])
    moved = np.column_stack([np.sin(nearer) * np.cos(around), np.sin(nearer) * np.sin(around), np.cos(nearer)])
    write(f"ball_{len(triangles)}.obj", 30 * moved, triangles, "A sphere of radius 30, fine at its poles; millimetres")


def disc(reaches: np.ndarray) -> tuple[np.ndarray, list[tuple[int, int, int]]]:
    """Rings of 6, 12, 18 ... vertices at these distances (rings) from the middle, which is vertex 0."""
    points, triangles = [np.zeros(3)], []
    rows = [[0]]
    for ring, reach in enumerate(reaches, start=1):
        row = []
        for turn in 2 * np.pi * np.arange(6 * ring) / (6 * ring):
            points.append(reach * np.array([np.cos(turn), np.sin(turn), 0]))
            row.append(len(points) - 1)
        inner = rows[-1]
        for sector in range(6):
            shorter = [inner[(sector * (ring - 1) + k) % len(inner)] for k in range(ring)]
            longer = [row[(sector * ring + k) % len(row)] for k in range(ring + 1)]
            for k in range(ring):
                triangles.append((shorter[k], longer[k], longer[k + 1]))
                if k + 1 < ring:
                    triangles.append((shorter[k], longer[k + 1], shorter[k + 1]))
        rows.append(row)
    return np.array(points), triangles


def graded(rings: int, grading: float) -> np.ndarray:
    return np.sinh(grading * np.arange(1, rings + 1) / rings) / np.sinh(grading)


def drum(rings: int) -> None:
    """A disc of radius 20, its triangles 27 times smaller in the middle than at the rim, and the more regular."""
    points, triangles = disc(20 * graded(rings, 4.0))
    write(f"drum_{len(triangles)}.obj", points, triangles, "A disc of radius 20, fine in the middle; millimetres")


def disc_on_cone(rings: int) -> None:
    """A disc of radius 50, half as coarse in its middle as at its rim, closed below by a cone."""
    points, triangles = disc(50 * graded(rings, 1.3))
    rim = list(range(len(points) - 6 * rings, len(points)))
    tip = len(points)
    below = [(tip, rim[(k + 1) % len(rim)], corner) for k, corner in enumerate(rim)]
    write(f"disc_on_cone_{len(triangles)}.obj", np.vstack([points, [0, 0, -20]]), triangles,
          "A disc of radius 50 above a cone; millimetres", {"cone": below})


def squares(along: int, across: int) -> list[tuple[int, int, int]]:
    """Rows of across + 1 vertices joined by squares, which are cut along one diagonal and the other in turn."""
    triangles = []
    for i in range(along):
        for j in range(across):
            a, b = i * (across + 1) + j, (i + 1) * (across + 1) + j
            if (i + j) % 2 == 0:
                triangles += [(a, b, b + 1), (a, b + 1, a + 1)]
            else:
                triangles += [(a, b, a + 1), (b, b + 1, a + 1)]
    return triangles


def roof(divisions: int) -> None:
    """A part of a cylinder of radius 2540 about y, 0.2 rad wide and 508 long, with a vertex in the middle of the crown."""
    points = []
    for i in range(divisions + 1):
        angle = 0.2 * (i / divisions - 0.5)
        for j in range(divisions + 1):
            points.append((2540 * np.sin(angle), 508 * (j / divisions - 0.5), 2540 * np.cos(angle)))
    triangles = squares(divisions, divisions)
    write(f"roof_{len(triangles)}.obj", np.array(points), triangles, "A cylindrical roof, crown at z = 2540; millimetres")


def cap(rings: int) -> None:
    """A cap of half a radian of a sphere of radius 1, its triangles 27 times smaller at the pole than at the rim."""
    points, triangles = disc(graded(rings, 4.0))
    reach = np.hypot(points[:, 0], points[:, 1])
    polar = np.sin(0.5 * reach) / np.maximum(reach, 1e-30)
    sphere = np.column_stack([polar * points[:, 0], polar * points[:, 1], np.cos(0.5 * reach)])
    write(f"cap_{len(triangles)}.obj", sphere, triangles, "A cap of a sphere of radius 1, fine at the pole")


def octant(divisions: int, growth: float = 1, name: str = "octant") -> None:
    """A quarter of the upper half of a cylinder of radius 100 about y: x from 0 to 100, y from 0 to 100. Lines lie at
    powers `growth` of even parts: beyond 1 triangles grow with the distance from the crown's middle."""
    points = []
    for i in range(divisions + 1):
        angle = 0.5 * np.pi * (i / divisions) ** growth
        for j in range(divisions + 1):
            along = 100 * (j / divisions) ** growth
            points.append((100 * np.sin(angle) if i else 0, along, 100 * np.cos(angle) if i < divisions else 0))
    triangles = squares(divisions, divisions)
    write(f"{name}_{len(triangles)}.obj", np.array(points), triangles, "An octant of a cylinder; metres")


def pierced_hemisphere(divisions: int) -> None:
    """A quarter of a hemisphere of radius 10 whose top is left out, as a hole of 18 degrees around the axis."""
    points = []
    for i in range(divisions + 1):
        height = np.radians(72) * i / divisions
        for j in range(divisions + 1):
            turn = 0.5 * np.pi * j / divisions
            points.append((10 * np.cos(height) * np.cos(turn), 10 * np.cos(height) * np.sin(turn), 10 * np.sin(height)))
    triangles = squares(divisions, divisions)
    write(f"pierced_hemisphere_{len(triangles)}.obj", np.array(points), triangles,
          "A quarter of a hemisphere with a hole; metres")


def twisted_strip(across: int) -> None:
    """A strip along x, 12 long and 1.1 wide, turned by a quarter about x from its beginning to its end."""
    along = 12 * across
    points = []
    for i in range(along + 1):
        turn = 0.5 * np.pi * i / along
        for j in range(across + 1):
            reach = 1.1 * (j / across - 0.5)
            points.append((12 * i / along, reach * np.cos(turn), reach * np.sin(turn)))
    triangles = squares(along, across)
    write(f"twisted_strip_{len(triangles)}.obj", np.array(points), triangles, "A strip twisted by a quarter turn; metres")


def slit_sheet(segments: int) -> None:
    """A sheet within an ellipse, its vertices on confocal ellipses and hyperbolas, 2 x - 1 = cosh u cos v and
    2 y = sinh u sin v. The line from focus to focus is a row of edges. For a slit there the plane solution is smooth in u
    and v, so that these triangles, small at the tips and large far away, suit it."""
    around, step, outermost = 2 * segments, np.pi / segments, np.arccosh(40)
    growth = 2 / segments  # rings grow outwards, where the solution fades
    rings = int(np.ceil(np.log1p(growth * outermost / step) / np.log1p(growth)))
    reach = outermost * ((1 + growth) ** np.arange(rings + 1) - 1) / ((1 + growth) ** rings - 1)
    places = [(0.0, step * k) for k in range(segments + 1)]
    places += [(u, step * k) for u in reach[1:] for k in range(around)]
    points = [((1 + np.cosh(u) * np.cos(v)) / 2, np.sinh(u) * np.sin(v) / 2, 0) for u, v in places]

    def vertex(ring: int, k: int) -> int:
        k %= around
        return segments + 1 + (ring - 1) * around + k if ring else min(k, around - k)

    triangles = []
    for ring in range(rings):
        for k in range(around):
            a, b, c, d = vertex(ring, k), vertex(ring + 1, k), vertex(ring + 1, k + 1), vertex(ring, k + 1)
            rises = (k // (segments // 2)) % 2 == 0  # a mirror image of itself in both axes
            triangles += [(a, b, c), (a, c, d)] if rises else [(a, b, d), (b, c, d)]
    write(f"slit_sheet_{len(triangles)}.obj", np.array(points), triangles,
          "A sheet within an ellipse; a row of edges from 0 to 1 on the x axis joins its foci; it is 40 wide")


def long_tube(around: int, rows_per_radius: float) -> None:
    """A tube of radius 10 about y, 500 long, closed by half spheres. Its vertices stand out, so that area over length
    around is that of the cylinder: an even prism bears pressure as the cylinder within it."""
    rows, quarter = round(50 * rows_per_radius), around // 4
    rim = [(10 * np.cos(angle), 250 + 10 * np.sin(angle)) for angle in 0.5 * np.pi * np.arange(1, quarter) / quarter]
    profile = [(reach, -y) for reach, y in reversed(rim)]
    profile += [(10.0, 500 * (row / rows - 0.5)) for row in range(rows + 1)] + rim
    points = [(0.0, -260.0, 0.0)]
    for reach, y in profile:
        outer = reach / np.cos(np.pi / around)
        points += [(outer * np.cos(turn), y, outer * np.sin(turn)) for turn in 2 * np.pi * np.arange(around) / around]
    points.append((0.0, 260.0, 0.0))

    def vertex(row: int, k: int) -> int:
        return 1 + row * around + k % around

    triangles = []
    for k in range(around):
        triangles += [(0, vertex(0, k), vertex(0, k + 1)),
                      (len(points) - 1, vertex(len(profile) - 1, k + 1), vertex(len(profile) - 1, k))]
        for row in range(len(profile) - 1):
            a, b, c, d = vertex(row, k), vertex(row, k + 1), vertex(row + 1, k + 1), vertex(row + 1, k)
            triangles += [(a, d, c), (a, c, b)] if (row + k) % 2 else [(a, d, b), (b, d, c)]
    write(f"long_tube_{len(triangles)}.obj", np.array(points), triangles, "A closed tube of radius 10; millimetres")


def main() -> None:
    for divisions in (16, 32, 48):
        roof(divisions)
    for divisions in (24, 32, 48):
        octant(divisions)
        octant(divisions, 1.5, "graded_octant")
    for divisions in (16, 32, 48):
        pierced_hemisphere(divisions)
    for across in (2, 4, 8):
        twisted_strip(across)
    for rings in (16, 24, 36):
        cap(rings)
    for rings in (16, 24, 36):
        drum(rings)
    for divisions in (2, 3):
        two_balloons(divisions)
    for divisions in (2, 3, 4):
        ball(divisions)
    for rings in (10, 20, 30):
        disc_on_cone(rings)
    for around, rows_per_radius in ((12, 1), (16, 1.5)):
        long_tube(around, rows_per_radius)
    for segments in (24, 40, 72):
        slit_sheet(segments)


if __name__ == "__main__":
    main()
