"""A light belt between two ends, bent round a rod that presses it: straight beside the rod, on a circle on it."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass
class Sides:
    first: float  # newton, tension between the rod and the first end
    second: float  # newton
    wrap: float  # radians, round which the belt lies on the rod


def tangent(centre: np.ndarray, radius: float, end: np.ndarray, side: int) -> np.ndarray:
    """Unit vector along the belt from the rod to an end; `side` 1 where the rod is to the left of it, else -1."""
    way = end - centre
    along = np.arctan2(way[1], way[0]) + side * np.arcsin(radius / np.hypot(*way))
    return np.array([np.cos(along), np.sin(along)])


def sides(centre: np.ndarray, radius: float, ends: tuple[np.ndarray, np.ndarray], force: np.ndarray) -> Sides:
    """From the belt's force on the rod (newton), which both tensions make up; lengths in metres, in the belt's plane.
    The first end is to the right of the rod, which lies above the belt."""
    first, second = tangent(centre, radius, ends[0], 1), tangent(centre, radius, ends[1], -1)
    tensions = np.linalg.solve(np.column_stack([first, second]), force)
    return Sides(tensions[0], tensions[1], np.pi - np.arccos(first @ second))


def sliding_ratio(coefficient: float, wrap: float) -> float:
    """Of the tension behind a rod that slides to the one ahead of it, Euler and Eytelwein."""
    return float(np.exp(coefficient * wrap))
