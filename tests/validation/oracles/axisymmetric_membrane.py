"""Large axisymmetric deformation of membranes: balls between plates, drums under balls, inflated discs, drops on a plane.

The meridian is told by the arc length S of the stress-free membrane, whose distance from the axis is R(S). With the
deformed distance rho, height z, angle theta of the meridian above the horizontal, stretches l1 = ds/dS and l2 = rho / R
and N = h dW/dl:

    rho' = l1 cos theta,  z' = l1 sin theta,  (R N1)' = N2 cos theta,  R N1 theta' = -p rho l1 - N2 sin theta,

the outer normal being (-sin theta, cos theta): force balance of a ring (Green and Adkins 1960; Feng and Yang 1973).
"""
from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Optional

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, fsolve

from .inflated_sphere import pressure as sphere_pressure
from .wall_laws import Law, tension_slopes, tensions

RHO, Z, THETA, STRETCH, VOLUME = range(5)
_FIRST = 1e-5  # where integration leaves the axis, in parts of the length


@dataclass(frozen=True)
class Meridian:
    """A membrane of thickness 1 whose stress-free distance from the axis is R(S); `slope` is R'."""

    law: Law
    distance: Callable[[float], float]
    slope: Callable[[float], float]

    def rates(self, s: float, y: np.ndarray, pressure: Callable[[float], float], lies_on: Optional[float]) -> list[float]:
        """`lies_on`: the curvature of what the membrane lies on, none where it is free."""
        rho, z, theta, l1, _ = y
        around = self.distance(s)
        l2 = rho / around
        n1, n2 = tensions(self.law, l1, l2)
        n11, n12 = tension_slopes(self.law, l1, l2)
        n1_rate = (n2 * np.cos(theta) - self.slope(s) * n1) / around
        l2_rate = (l1 * np.cos(theta) - l2 * self.slope(s)) / around
        if lies_on is not None:
            turn = l1 * lies_on
        else:
            turn = (-pressure(z) * rho * l1 - n2 * np.sin(theta)) / (around * n1)
        return [l1 * np.cos(theta), l1 * np.sin(theta), turn, (n1_rate - n12 * l2_rate) / n11,
                -np.pi * rho**2 * l1 * np.sin(theta)]

    def from_axis(self, pole_stretch: float, lies_to: float, end: float, pressure: Callable[[float], float],
                  height: float = 0.0, lies_on: float = 0.0):
        """From the axis to S = end; up to S = lies_to on a ball of curvature `lies_on`, or on a plate. Gives the solution
        of the last part."""
        s = _FIRST * end
        curvature = 0.0
        if lies_to <= s:
            n1, _ = tensions(self.law, pole_stretch, pole_stretch)
            curvature = -pressure(height) * pole_stretch**2 / (2 * n1)  # d theta / dS
        start = [pole_stretch * s, height + pole_stretch * curvature * s**2 / 2, curvature * s, pole_stretch, 0.0]
        if lies_to > s:
            start = self._integrate(s, lies_to, start, pressure, lies_on).y[:, -1]
            s = lies_to
        return self._integrate(s, end, start, pressure, None)

    def _integrate(self, begin, end, start, pressure, lies_on):
        return solve_ivp(lambda s, y: self.rates(s, y, pressure, lies_on), (begin, end), start, rtol=1e-9, atol=1e-11)


def _ball(law: Law) -> Meridian:
    return Meridian(law, np.sin, np.cos)


@dataclass(frozen=True)
class SqueezedBall:
    force: float  # in (law's unit) h r0
    pressure: float  # in (law's unit) h / r0
    contact_radius: float  # in r0


def ball_between_plates(law: Law, inflation: float, closeness: list[float]) -> list[SqueezedBall]:
    """A fluid-filled ball (radius and thickness 1), inflated to the stretch `inflation`, sealed, squeezed between two
    frictionless plates. closeness: 1 - gap / inflated diameter, growing."""
    ball = _ball(law)
    volume = 2 / 3 * np.pi * inflation**3
    guess = np.array([inflation, 0.1, sphere_pressure(law, 1, 1, inflation)])
    results = []
    for delta in closeness:
        height = inflation * (1 - delta)

        def misses(unknown):
            pole, lies_to, p = unknown
            y = ball.from_axis(pole, abs(lies_to), np.pi / 2, lambda z: p).y[:, -1]
            return [y[THETA] + np.pi / 2, y[Z] + height, y[VOLUME] / volume - 1]

        guess, _, found, message = fsolve(misses, guess, xtol=1e-10, full_output=True)
        if found != 1:
            raise ArithmeticError(f"ball between plates at {delta}: {message}")
        pole, lies_to, p = guess
        contact = ball.from_axis(pole, abs(lies_to), abs(lies_to) * (1 + 1e-9), lambda z: p).y[RHO, 0]
        results.append(SqueezedBall(force=np.pi * p * contact**2, pressure=p, contact_radius=contact))
    return results


def inflated_disc(law: Law, pole_stretch: float) -> tuple[float, float]:
    """Pressure (in law's unit h / a) and height of the pole (in a) of a flat disc of radius a clamped at its rim."""
    disc = Meridian(law, lambda s: s, lambda s: 1.0)

    def rim(p: float) -> float:
        return disc.from_axis(pole_stretch, 0, 1, lambda z: p).y[RHO, -1] - 1

    pressures = np.linspace(0.02, 8, 60)
    low = pressures[0]
    for high in pressures[1:]:  # the first root: a larger pressure curls the meridian
        if rim(low) * rim(high) < 0:
            p = brentq(rim, low, high, xtol=1e-11)
            return p, -float(disc.from_axis(pole_stretch, 0, 1, lambda z: p).y[Z, -1])
        low = high
    raise ArithmeticError(f"no pressure holds the stretch {pole_stretch}")


def disc_heights(law: Law, pressures: list[float]) -> list[float]:
    """Heights of the pole of the disc of `inflated_disc` at pressures that grow from small ones to less than the limit."""
    disc = Meridian(law, lambda s: s, lambda s: 1.0)
    heights, pole = [], 1.05
    for p in pressures:
        found, _, good, message = fsolve(
            lambda unknown: disc.from_axis(unknown[0], 0, 1, lambda z: p).y[RHO, -1] - 1, [pole], full_output=True)
        if good != 1:
            raise ArithmeticError(f"disc at {p}: {message}")
        pole = float(found[0])
        heights.append(-float(disc.from_axis(pole, 0, 1, lambda z: p).y[Z, -1]))
    return heights


def disc_path(law: Law, pole_stretches: list[float]) -> np.ndarray:
    """Pressures and heights (2 x stretches) of the disc of `inflated_disc` at stretches of the pole that grow slowly from
    small ones, through the limit of the pressure."""
    disc = Meridian(law, lambda s: s, lambda s: 1.0)
    pressure = inflated_disc(law, pole_stretches[0])[0]
    states = []
    for pole in pole_stretches:
        found, _, good, message = fsolve(lambda unknown: disc.from_axis(pole, 0, 1, lambda z: unknown[0]).y[RHO, -1] - 1,
                                         [pressure], xtol=1e-10, full_output=True)
        if good != 1:
            raise ArithmeticError(f"disc at a stretch of {pole}: {message}")
        pressure = float(found[0])
        states.append((pressure, -float(disc.from_axis(pole, 0, 1, lambda z: pressure).y[Z, -1])))
    return np.array(states).T


@dataclass(frozen=True)
class IndentedDrum:
    force: float  # in (law's unit) h a
    contact_radius: float  # in a


def drum_under_ball(law: Law, prestretch: float, ball_radius: float, depth: float) -> IndentedDrum:
    """A sheet (radius 1 as held, thickness 1 stress-free), stretched evenly, under a frictionless rigid ball at its middle."""
    drum = Meridian(law, lambda s: s, lambda s: 1.0)
    end = 1 / prestretch

    def solution(unknown):
        pole, lies_to = unknown
        return drum.from_axis(pole, abs(lies_to), end, lambda z: 0.0, lies_on=1 / ball_radius)

    def misses(unknown):
        y = solution(unknown).y[:, -1]
        return [y[RHO] - 1, (y[Z] - depth) / depth]

    # Small slopes: c^2 (1 / 2 + ln(1 / c)) = depth times the radius of the ball.
    contact = brentq(lambda c: c**2 * (0.5 - np.log(c)) - depth * ball_radius, 1e-6, 0.9)
    guess, _, found, message = fsolve(misses, [prestretch, contact / prestretch], xtol=1e-11, full_output=True)
    if found != 1:
        raise ArithmeticError(f"drum under a ball: {message}")
    lies_to = abs(guess[1])
    rho, _, theta, l1, _ = solution(guess).y[:, 0]
    n1, _ = tensions(law, l1, rho / lies_to)
    return IndentedDrum(force=2 * np.pi * lies_to * n1 * np.sin(theta), contact_radius=rho)


@dataclass(frozen=True)
class Drop:
    height: float  # in r0
    contact_radius: float
    largest_radius: float
    pressure_at_floor: float  # in law's unit h / r0
    meridian: np.ndarray  # (2 x points), from the edge of the flat to the crown: distance from the axis, height, in r0


def drop_on_plane(law: Law, inflation: float, weight: float) -> Drop:
    """A ball (radius and thickness 1) filled to the stretch `inflation`, whose contents weigh on a frictionless floor;
    the wall is light. weight: density g r0^2 / (law's unit h)."""
    ball = _ball(law)
    volume = 4 / 3 * np.pi * inflation**3

    def halves(unknown):
        low_pole, lies_to, high_pole, height, p = unknown
        # Both halves start at a pole with the outer normal up: the lower one is seen upside down.
        lower = ball.from_axis(low_pole, abs(lies_to), np.pi / 2, lambda z: p + weight * z).y[:, -1]
        upper = ball.from_axis(high_pole, 0, np.pi / 2, lambda z: p - weight * z, height).y[:, -1]
        return lower, upper

    def misses(unknown):
        lower, upper = halves(unknown)
        return [lower[RHO] - upper[RHO], -lower[Z] - upper[Z], lower[THETA] + np.pi + upper[THETA],
                lower[STRETCH] - upper[STRETCH], (lower[VOLUME] + upper[VOLUME]) / volume - 1]

    p = sphere_pressure(law, 1, 1, inflation)
    guess = np.array([inflation, 0.15, inflation, 2 * inflation, p])
    full = weight
    for part in (0.05, 0.2, 0.4, 0.6, 0.8, 1.0):
        weight = full * part
        guess, _, found, message = fsolve(misses, guess, xtol=1e-10, full_output=True)
    if found != 1:
        raise ArithmeticError(f"drop on a plane: {message}")
    low_pole, lies_to, high_pole, height, p = guess
    lies_to = abs(lies_to)  # its sign is free: see `halves`
    contact = ball.from_axis(low_pole, lies_to, lies_to * (1 + 1e-9), lambda z: p).y[RHO, 0]
    lower = ball.from_axis(low_pole, lies_to, np.pi / 2, lambda z: p + weight * z).y[[RHO, Z]]
    upper = ball.from_axis(high_pole, 0, np.pi / 2, lambda z: p - weight * z, height).y[[RHO, Z]]
    meridian = np.hstack([[[1], [-1]] * lower, upper[:, ::-1]])
    return Drop(height=height, contact_radius=contact, largest_radius=meridian[0].max(), pressure_at_floor=p,
                meridian=meridian)
