"""Plots as SVG that take their colours from the page."""
from __future__ import annotations

from dataclasses import dataclass
from html import escape

import numpy as np

WIDTH, HEIGHT = 460, 300
LEFT, RIGHT, TOP, BOTTOM = 62, 12, 14, 44


@dataclass(frozen=True)
class Series:
    label: str
    x: np.ndarray
    y: np.ndarray
    style: str  # "line", "points", "rings" or "dashed"


def _linear_ticks(low: float, high: float) -> list[float]:
    step = 10 ** np.floor(np.log10((high - low) / 4))
    for factor in (1, 2, 5, 10):
        if (high - low) / (factor * step) <= 6:
            break
    step *= factor
    return [k * step for k in range(int(np.ceil(low / step - 1e-9)), int(np.floor(high / step + 1e-9)) + 1)]


def _log_ticks(low: float, high: float) -> list[float]:
    decades = range(int(np.floor(np.log10(low))), int(np.ceil(np.log10(high))) + 1)
    factors = (1,) if high > 300 * low else (1, 2, 5)
    return [f * 10.0**d for d in decades for f in factors if low * 0.999 <= f * 10.0**d <= high * 1.001]


class _Axis:
    def __init__(self, values: np.ndarray, begin: float, end: float, logarithmic: bool):
        self.logarithmic = logarithmic
        low, high = float(np.min(values)), float(np.max(values))
        if logarithmic:
            low, high = low / 1.5, high * 1.5
        else:
            room = 0.06 * (high - low) or abs(high) * 0.1 or 1.0
            low, high = low - room, high + room
        self.ticks = _log_ticks(low, high) if logarithmic else _linear_ticks(low, high)
        self._low, self._high = (np.log(low), np.log(high)) if logarithmic else (low, high)
        self._begin, self._end = begin, end

    def __call__(self, value: float) -> float:
        value = np.log(value) if self.logarithmic else value
        return self._begin + (value - self._low) / (self._high - self._low) * (self._end - self._begin)


def _number(value: float) -> str:
    return f"{value:.6g}"


def _marks(series: Series, index: int, across: _Axis, up: _Axis) -> str:
    places = [(across(x), up(y)) for x, y in zip(series.x, series.y)]
    if series.style in ("points", "rings"):
        mark = f's{index}" r="3.2' if series.style == "points" else f'l{index} ring" r="4'
        return "".join(f'<circle class="{mark}" cx="{x:.1f}" cy="{y:.1f}"/>' for x, y in places)
    dash = ' stroke-dasharray="5 4"' if series.style == "dashed" else ""
    points = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
    return f'<polyline class="l{index}" points="{points}"{dash}/>'


def plot(series: list[Series], x_label: str, y_label: str, logarithmic: bool = False) -> str:
    """An SVG element; series that hold no finite values are left out."""
    usable = []
    for each in series:
        good = np.isfinite(each.x) & np.isfinite(each.y)
        if logarithmic:
            good &= (each.x > 0) & (each.y > 0)
        if good.any():
            usable.append(Series(each.label, each.x[good], each.y[good], each.style))
    if not usable:
        return ""
    across = _Axis(np.concatenate([s.x for s in usable]), LEFT, WIDTH - RIGHT, logarithmic)
    up = _Axis(np.concatenate([s.y for s in usable]), HEIGHT - BOTTOM, TOP, logarithmic)
    parts = [f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="{escape(y_label)} over {escape(x_label)}">']
    for tick in across.ticks:
        x = across(tick)
        parts.append(f'<line class="grid" x1="{x:.1f}" y1="{TOP}" x2="{x:.1f}" y2="{HEIGHT - BOTTOM}"/>'
                     f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 15}" text-anchor="middle">{_number(tick)}</text>')
    for tick in up.ticks:
        y = up(tick)
        parts.append(f'<line class="grid" x1="{LEFT}" y1="{y:.1f}" x2="{WIDTH - RIGHT}" y2="{y:.1f}"/>'
                     f'<text x="{LEFT - 6}" y="{y + 3.5:.1f}" text-anchor="end">{_number(tick)}</text>')
    parts += [_marks(each, index, across, up) for index, each in enumerate(usable)]
    middle = (TOP + HEIGHT - BOTTOM) / 2
    parts.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 8}" text-anchor="middle">{escape(x_label)}</text>'
                 f'<text transform="translate(13 {middle}) rotate(-90)" text-anchor="middle">{escape(y_label)}</text>')
    parts.append("</svg>")
    legend = "".join(f'<span><i class="k{index} {each.style}"></i>{escape(each.label)}</span>'
                     for index, each in enumerate(usable))
    return f'<figure>{"".join(parts)}<figcaption>{legend}</figcaption></figure>'
