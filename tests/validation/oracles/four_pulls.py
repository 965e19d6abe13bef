"""A square sheet of Mooney-Rivlin rubber under forces on its four edges. Equal forces have an equal answer, which is unstable
where the sheet is stretched far: then it is one of two, long along one axis and narrow along the other (Treloar 1948,
Kearsley 1986)."""
from __future__ import annotations

import numpy as np

from . import wall_laws


def stretches(law: wall_laws.Law, thickness: float, pulls: list[tuple[float, float]]) -> np.ndarray:
    """(pulls x 2), of stable equilibria that follow each other from no pull on. `pulls`: newton per metre of stress-free
    edge along both axes."""
    now, found = np.ones(2), []
    for pull in pulls:

        def surplus(at, pull=pull):
            return thickness * np.array(wall_laws.tensions(law, *at)) - pull

        for _ in range(200):
            tangent = np.array([(surplus(now + 1e-6 * axis) - surplus(now - 1e-6 * axis)) / 2e-6 for axis in np.eye(2)])
            values, directions = np.linalg.eigh((tangent + tangent.T) / 2)
            change = -directions @ (directions.T @ surplus(now) / np.abs(values))  # downhill also past a saddle
            now = now + np.clip(change, -0.1, 0.1)
            if np.max(np.abs(change)) < 1e-12:
                break
        else:
            raise ValueError(f"no equilibrium under {pull}")
        found.append(now)
    return np.array(found)
