"""How the suite judges: errors, bars, orders, runs that are taken again."""
from __future__ import annotations

import os
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))

from suite.case import Case, Comparison, Quantity, assess  # noqa: E402
from suite.program import Program  # noqa: E402
from suite.report import markdown, page  # noqa: E402


def one_value(model: float, reference: float, **options) -> Quantity:
    return Quantity("value", "place", "", np.array([0.0]), np.array([model]), np.array([reference]), **options)


def result_of(errors: dict[int, float], bar: float = 0.01, **options):
    """Of a case whose model is off by these parts at these sizes."""
    case = Case("name", "Title", "source", "value", bar, tuple(errors),
                lambda program, size: Comparison([one_value(1 + errors[size], 1.0)]), **options)
    return assess(case, None, quick=False)


class Judgement(unittest.TestCase):
    def test_bar_is_for_the_finest_size(self):
        self.assertEqual(result_of({100: 0.5, 400: 0.009}).verdict(), "met")
        self.assertEqual(result_of({100: 0.001, 400: 0.011}).verdict(), "missed")

    def test_what_is_no_number_is_missed_wherever_it_stands(self):
        for values in ([np.nan, 1.0], [1.0, np.nan]):
            case = Case("name", "Title", "source", "value", 0.01, (1,),
                        lambda program, size, values=values: Comparison([one_value(value, 1.0) for value in values]))
            self.assertEqual(assess(case, None, quick=False).verdict(), "missed")

    def test_quantities_may_have_wider_bars(self):
        self.assertAlmostEqual(Comparison([one_value(1.02, 1.0, allowance=4.0), one_value(1.01, 1.0)]).error(), 0.01, 12)

    def test_what_is_only_shown_is_not_judged(self):
        self.assertEqual(Comparison([one_value(9.0, 1.0, judged=False)]).error(), 0.0)

    def test_a_case_that_breaks_is_reported_as_failed(self):
        def compare(program, size):
            raise ValueError("no such thing")

        result = assess(Case("name", "Title", "source", "value", 0.01, (1,), compare), None, quick=False)
        self.assertEqual(result.verdict(), "failed")
        self.assertIn("no such thing", page([result], "version"))
        self.assertIn("did not run", markdown([result]))


class Order(unittest.TestCase):
    def test_errors_that_quarter_with_four_times_the_triangles_are_of_second_order(self):
        self.assertAlmostEqual(result_of({100: 0.08, 400: 0.02}).order(), 2.0, 9)

    def test_errors_that_halve_with_half_the_step_are_of_first_order(self):
        self.assertAlmostEqual(result_of({10: 0.02, 20: 0.01}, size_dimension=1).order(), 1.0, 9)

    def test_tolerances_and_rough_references_have_none(self):
        self.assertIsNone(result_of({100: 1e-5, 400: 1e-9}).order())
        self.assertIsNone(result_of({100: 0.08, 400: 0.02}, tells_order=False).order())


class GoingOn(unittest.TestCase):
    """A program that counts its runs."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.home = Path(self.folder.name)
        self.executable = self.home / "program"
        script = ["#!/bin/sh", 'here=$(dirname "$0")', 'echo run >> "$here/count"', 'while [ "$1" != --out ]; do shift; done',
                  'mkdir -p "$2"', 'echo "{\\"complete\\": $(cat "$here/complete")}" > "$2/manifest.json"', ""]
        self.executable.write_text("\n".join(script), encoding="utf-8")
        self.executable.chmod(0o755)
        os.utime(self.executable, (0, 0))
        self.complete("true")

    def complete(self, word: str):
        (self.home / "complete").write_text(word, encoding="utf-8")

    def runs(self) -> int:
        return len((self.home / "count").read_text(encoding="utf-8").splitlines())

    def run_once(self, go_on: bool):
        Program(self.executable, self.home, go_on).run("creep", step="1 ms")

    def test_runs_are_taken_again_only_when_asked(self):
        self.run_once(go_on=False)
        self.run_once(go_on=True)
        self.assertEqual(self.runs(), 1)
        self.run_once(go_on=False)
        self.assertEqual(self.runs(), 2)

    def test_runs_older_than_the_program_are_made_anew(self):
        self.run_once(go_on=False)
        manifest = next(self.home.rglob("manifest.json"))
        os.utime(self.executable, (manifest.stat().st_mtime + 10,) * 2)
        self.run_once(go_on=True)
        self.assertEqual(self.runs(), 2)

    def test_unfinished_runs_are_made_anew(self):
        self.complete("false")
        self.run_once(go_on=False)
        self.run_once(go_on=True)
        self.assertEqual(self.runs(), 2)


if __name__ == "__main__":
    unittest.main()
