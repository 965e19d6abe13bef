"""Writes the surfaces of scenes/validation that are no shapes of the scenario format."""
from __future__ import annotations

from pathlib import Path

import numpy as np

MESHES = Path(__file__).resolve().parents[2] / "scenes" / "validation" / "meshes"


def write(name: str, points: np.ndarray, triangles: list[tuple[int, int, int]], told: str) -> None:
    lines = [f"# {told}"]
    lines += ["v " + " ".join(f"{value:.9g}" for value in point) for point in points]
    lines += ["f " + " ".join(str(corner + 1) for corner in triangle) for triangle in triangles]
    MESHES.mkdir(exist_ok=True)
    (MESHES / name).write_text("\n".join(lines) + "\n", encoding="utf-8")


def drum(rings: int) -> None:
    """A disc of radius 20, its triangles 27 times smaller in the middle than at the rim, and the more regular."""
    grading, points, triangles = 4.0, [np.zeros(3)], []
    rows = [[0]]
    for ring in range(1, rings + 1):
        reach = 20 * np.sinh(grading * ring / rings) / np.sinh(grading)
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
    write(f"drum_{len(triangles)}.obj", np.array(points), triangles, "A disc of radius 20, fine in the middle; millimetres")


def main() -> None:
    for rings in (16, 24, 36):
        drum(rings)


if __name__ == "__main__":
    main()
