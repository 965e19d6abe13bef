"""Tables of Sze, Liu and Lo, Popular benchmark problems for geometric nonlinear analysis of shells, Finite Elements in
Analysis and Design 40 (2004) 1551-1569. Loads in parts of the largest load; displacements in the lengths of the paper."""
from __future__ import annotations

# Cantilever under end shear (3.1): load, -U at the tip, W at the tip.
CANTILEVER = [(0.1, 0.103, 1.309), (0.2, 0.381, 2.493), (0.3, 0.763, 3.488), (0.5, 1.604, 4.933),
              (0.7, 2.370, 5.855), (1.0, 3.286, 6.698)]

# Slit annular plate under a lifting line force: load, W at the inner corner A, W at the outer corner B.
SLIT_ANNULUS = [(0.025, 1.305, 1.789), (0.1, 4.277, 5.876), (0.3, 8.340, 11.213), (0.5, 10.468, 13.768),
                (0.7, 11.970, 15.469), (1.0, 13.891, 17.528)]

# Pinched cylinder with end diaphragms: load, -W under the force, U at the side.
PINCHED_CYLINDER = [(0.1, 23.164, -2.391), (0.5, 73.790, 25.381), (1.0, 83.102, 34.272)]


def roll_up(bending_stiffness: float, length: float, moment_per_width: float) -> float:
    """Curvature times length of a strip under an end moment: 2 pi is a full circle. Without strain across its width."""
    return moment_per_width * length / bending_stiffness
