"""Compares the engine with published and exact solutions: every case is a scenario of scenes/validation, run by the
program and held against its reference. Leaves one page (index.html) and a Markdown table (table.md)."""
from __future__ import annotations

import argparse
import sys
import unittest
from pathlib import Path

HOME = Path(__file__).resolve().parent
sys.path.insert(0, str(HOME))

from cases import CASES  # noqa: E402
from suite.case import Case, assess  # noqa: E402
from suite.program import ROOT, Program  # noqa: E402
from suite.report import judged, markdown, page, percent, summary  # noqa: E402


def test_oracles() -> int:
    import oracles_test
    import shell_oracles_test
    import suite_test

    modules = (oracles_test, shell_oracles_test, suite_test)
    tests = unittest.TestSuite(unittest.defaultTestLoader.loadTestsFromModule(module) for module in modules)
    outcome = unittest.TextTestRunner(verbosity=2).run(tests)
    return 0 if outcome.wasSuccessful() and outcome.testsRun > 0 else 1


def chosen(options: argparse.Namespace, parser: argparse.ArgumentParser) -> list[Case]:
    unknown = set(options.case) - {case.name for case in CASES}
    if unknown:
        parser.error(f"no case {', '.join(sorted(unknown))}; --list tells them")
    return [case for case in CASES if (case.name in options.case if options.case else not options.quick or case.quick)]


def show(cases: list[Case]) -> int:
    for case in cases:
        bar = "shown" if case.bar is None else f"bar {percent(case.bar)}"
        print(f"{case.name:34} {bar:12} {'quick' if case.quick else '':6} {case.title}")
    return 0


def main() -> int:
    parser = argparse.ArgumentParser(prog="scripts/validate", description=__doc__)
    parser.add_argument("--list", action="store_true", help="tell the cases and end")
    parser.add_argument("--quick", action="store_true", help="the short set: coarser meshes, some cases left out")
    parser.add_argument("--case", action="append", default=[], metavar="NAME", help="this case only; may be repeated")
    parser.add_argument("--out", type=Path, default=ROOT / "out" / "validation", metavar="DIR",
                        help="where page, table and runs are left (out/validation)")
    parser.add_argument("--continue", action="store_true", dest="go_on",
                        help="take the runs that DIR holds already when they are younger than the program and the scenes")
    parser.add_argument("--oracles", action="store_true", help="test the reference solutions by their check values, and how errors are told, only")
    parser.add_argument("--program", type=Path, metavar="FILE", help="use this thinwall instead of building it")
    options = parser.parse_args()
    if options.oracles:
        return test_oracles()
    cases = chosen(options, parser)
    if options.list:
        return show(cases)
    if options.program is None:
        parser.error("--program is needed")

    program = Program(options.program.resolve(), options.out, options.go_on)
    results = []
    for case in cases:
        result = assess(case, program, options.quick and bool(case.quick))
        results.append(result)
        error = result.failure.strip() or judged(result.comparisons[-1]) + f", bar {percent(result.bar)}"
        print(f"{result.verdict():7} {case.name:34} {error} ({result.seconds:.1f} s)", file=sys.stderr, flush=True)
    options.out.mkdir(parents=True, exist_ok=True)
    (options.out / "index.html").write_text(page(results, program.version()), encoding="utf-8")
    (options.out / "table.md").write_text(markdown(results), encoding="utf-8")
    print(f"{summary(results)}: {options.out / 'index.html'}", file=sys.stderr)
    return 0 if results and all(result.good() for result in results) else 1


if __name__ == "__main__":
    sys.exit(main())
