"""What a case is, and how its error is told."""
from __future__ import annotations

import time
import traceback
from dataclasses import dataclass, field
from typing import Callable, Optional

import numpy as np

from .program import Program, RunFailed


ROUNDING = 1e-6  # errors below come from tolerances of the solver, or from positions in single precision


@dataclass(frozen=True)
class Quantity:
    """A model's values beside those of the reference, along something."""

    name: str
    along: str  # what the values are told along, with its unit
    unit: str
    places: np.ndarray  # (values), in the unit that `along` names
    model: np.ndarray  # (values), in `unit`
    reference: np.ndarray  # (values), in `unit`
    scale: Optional[float] = None  # errors are parts of it; of each reference value when absent
    curve: Optional[tuple[np.ndarray, np.ndarray]] = None  # the reference drawn finely: places, values
    judged: bool = True  # shown only, when not
    allowance: float = 1.0  # how many times the case's bar this quantity may be off
    drawn: bool = True  # told in the table only, when not
    reference_name: str = "reference"

    def errors(self) -> np.ndarray:
        return np.abs(self.model - self.reference) / np.abs(self.reference if self.scale is None else self.scale)

    def error(self) -> float:
        return float(np.max(self.errors()))


@dataclass(frozen=True)
class Comparison:
    quantities: list[Quantity]
    notes: list[str] = field(default_factory=list)  # what a reader should know of this run

    def error(self) -> float:
        """The largest, each as a part of what the quantity is allowed over the case's bar."""
        judged = [quantity.error() / quantity.allowance for quantity in self.quantities if quantity.judged]
        return float(np.max(judged)) if judged else 0.0  # not `max`, which may lose what is no number


@dataclass(frozen=True)
class Case:
    name: str  # of the scenario file too, unless `scenario` says otherwise
    title: str
    source: str  # of the reference
    compares: str
    bar: Optional[float]  # largest error at the finest size; absent: shown only
    sizes: tuple[int, ...]  # triangles (or what `size_name` says), coarse to fine
    compare: Callable[[Program, int], Comparison]
    quick: tuple[int, ...] = ()  # sizes of the short set; none: left out of it
    quick_bar: Optional[float] = None  # of the short set's coarser finest size; the bar when absent
    size_name: str = "triangles"
    size_dimension: int = 2  # the error is drawn over size^(-1 / dimension)
    tells_order: bool = True  # not when the reference has too few digits
    known_miss: str = ""  # why the bar is not met, told in the report
    scenario: str = ""  # file in scenes/validation, without its ending; the case's name when empty


@dataclass(frozen=True)
class Result:
    case: Case
    sizes: list[int]
    comparisons: list[Comparison]
    failure: str  # empty when all sizes ran
    seconds: float
    bar: Optional[float]

    def errors(self) -> list[float]:
        return [comparison.error() for comparison in self.comparisons]

    def verdict(self) -> str:
        if self.failure:
            return "failed"
        if self.bar is None:
            return "shown"
        # A size that gives no number has not met a bar.
        return "met" if self.errors()[-1] <= self.bar else "missed"

    def good(self) -> bool:
        return self.verdict() in ("met", "shown") or bool(self.case.known_miss)

    def order(self) -> Optional[float]:
        """By the two finest sizes: error ~ (edge length)^order; none where only rounding and tolerances are left."""
        errors = self.errors()
        if not self.case.tells_order or len(errors) < 2 or min(errors[-2:]) < ROUNDING:
            return None
        finer = self.sizes[len(errors) - 1] / self.sizes[len(errors) - 2]
        return float(np.log(errors[-2] / errors[-1]) / np.log(finer) * self.case.size_dimension)


def assess(case: Case, program: Program, quick: bool) -> Result:
    sizes = list(case.quick if quick else case.sizes)
    begin = time.monotonic()
    comparisons, failure = [], ""
    for size in sizes:
        try:
            comparisons.append(case.compare(program, size))
        except RunFailed as error:
            failure = f"{case.size_name} {size}: {error}"
        except Exception:  # a case that cannot be judged is reported, and the others go on
            failure = f"{case.size_name} {size}: {traceback.format_exc(limit=-2)}"
        if failure:
            break
    bar = case.quick_bar if quick and case.quick_bar is not None else case.bar
    return Result(case, sizes, comparisons, failure, time.monotonic() - begin, bar)
