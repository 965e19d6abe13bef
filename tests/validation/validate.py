"""Runs the validation suite: every case through the program, against its reference, into one page and one table."""
from __future__ import annotations

import argparse
import sys
import unittest
from pathlib import Path

HOME = Path(__file__).resolve().parent
sys.path.insert(0, str(HOME))


def test_oracles() -> int:
    import oracles_test

    outcome = unittest.TextTestRunner(verbosity=2).run(unittest.defaultTestLoader.loadTestsFromModule(oracles_test))
    return 0 if outcome.wasSuccessful() and outcome.testsRun > 0 else 1


def main() -> int:
    parser = argparse.ArgumentParser(prog="scripts/validate", description=__doc__)
    parser.add_argument("--oracles", action="store_true", help="test the reference solutions by their check values only")
    parser.add_argument("--program", type=Path, help="use this thinwall instead of building it")
    options = parser.parse_args()
    if options.oracles:
        return test_oracles()
    parser.error("no case to run")


if __name__ == "__main__":
    sys.exit(main())
