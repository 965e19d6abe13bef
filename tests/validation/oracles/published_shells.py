"""Published values that shells are held against. But for the twisted strip they are tables of Sze, Liu and Lo, Popular benchmark problems for geometric nonlinear analysis of shells, Finite Elements in
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


# Hinged cylindrical roof, isotropic, thickness 12.7 mm (3.8): load over 3 kN, -W at the middle of the crown.
HINGED_ROOF = [
    (0.0877, 0.693), (0.1980, 1.638), (0.3473, 3.087), (0.4686, 4.477), (0.5647, 5.802), (0.6381, 7.057), (0.6908, 8.237),
    (0.7246, 9.339), (0.7412, 10.358), (0.7421, 11.293), (0.7286, 12.141), (0.7023, 12.903), (0.6649, 13.583),
    (0.6182, 14.188), (0.5643, 14.728), (0.5055, 15.217), (0.4442, 15.676), (0.3830, 16.125), (0.3245, 16.590),
    (0.2717, 17.094), (0.2272, 17.657), (0.1940, 18.299), (0.1750, 19.028), (0.1729, 19.852), (0.1905, 20.771),
    (0.2303, 21.780), (0.2950, 22.875), (0.3871, 24.049), (0.4443, 24.663), (0.5093, 25.293), (0.5826, 25.940),
    (0.6644, 26.601), (0.7551, 27.276), (0.8549, 27.964)]

# A strip twisted by a quarter turn, thickness 3.2 mm (Simo, Fox and Rifai 1989, after MacNeal and Harder 1985): way of the
# end under a force of 1e-6 N in its plane there, and across it, metres.
TWISTED_STRIP = (5.256e-3, 1.294e-3)


def roll_up(bending_stiffness: float, length: float, moment_per_width: float) -> float:
    """Curvature times length of a strip under an end moment: 2 pi is a full circle. Without strain across its width."""
    return moment_per_width * length / bending_stiffness


# Hemisphere with a hole of 18 degrees (Sze, Liu and Lo 2004): ways of the points that are pulled out and pressed in, over parts of the load.
PINCHED_HEMISPHERE = [
    (0.05, 0.855, 0.955), (0.10, 1.499, 1.840), (0.15, 1.969, 2.604), (0.20, 2.321, 3.261), (0.25, 2.596, 3.833),
    (0.30, 2.819, 4.339), (0.35, 3.002, 4.790), (0.40, 3.158, 5.196), (0.45, 3.291, 5.565), (0.50, 3.406, 5.902),
    (0.55, 3.508, 6.212), (0.60, 3.598, 6.497), (0.65, 3.678, 6.761), (0.70, 3.750, 7.006), (0.75, 3.816, 7.234),
    (0.80, 3.875, 7.448), (0.85, 3.929, 7.647), (0.90, 3.979, 7.835), (0.95, 4.025, 8.011), (1.00, 4.067, 8.178),
]
